// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A part of the tree of a branch and bound over the planes that separate pairs of convex parts: what is left of it, and
// the next nodes, depth first. At a node the planes of all pairs that overlap or are near are tried. One whose program
// comes too high is struck out: its other side holds from there on. A pair with one plane left has chosen it, one
// without ends the node. Then the pair is divided whose planes promise the fewest nodes; the other sides of planes seen
// before hold in later branches. Guarantee: no layout of this part is lower than bound(). Cost: some ten
// microseconds a plane tried. Keywords: strong branching, disjoint branching, depth first search.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "packing/solid_proof/height_choices.h"

namespace findspace::packing {

class HeightTree {
 public:
  /// The whole. The choices must live as long.
  explicit HeightTree(const HeightChoices& choices);

  /// Visits up to so many nodes, looking for layouts lower than `below`. Ends early where one is found.
  void visit(double below, std::size_t nodes);
  /// This part in parts of its own, but for the node that it was at: bound() and what was found there stay.
  std::vector<HeightTree> divided(double below);

  bool is_over() const { return frames_.empty() && !begins_; }
  /// Infinite where no layout is left; what was not visited counts by its parents.
  double bound() const;
  /// A layout in doubles that was found since it was last taken: its vertex, the height last. Else empty.
  std::vector<double> take_found() { return std::exchange(found_, {}); }
  const HeightChoices& choices() const { return *choices_; }
  std::uint64_t programs() const { return programs_; }

 private:
  struct Branch {
    GrowingProgram program;
    std::vector<std::vector<std::size_t>> open;  // of each choice the rows that are left; none: it is made
  };
  /// A branch that is divided, and the rows of the planes that are still to come.
  struct Frame {
    Branch branch;
    std::vector<std::size_t> rows;  // the next one last
  };
  /// What the planes of a choice come to.
  struct Look {
    double size = 0;                                     // how large a tree they promise
    std::vector<std::pair<double, std::size_t>> planes;  // bounds and rows, lowest first
  };

  HeightTree(const HeightChoices& choices, Branch branch);
  /// Of the last frame; nothing where it is over: then it is no more.
  std::optional<Branch> next(double below);
  void enter(Branch branch, double below);
  /// The choices that are near, deepest overlap first; none where nothing overlaps.
  std::vector<std::size_t> near(const Branch& branch) const;
  Look look(Branch& branch, std::size_t choice, double below);

  const HeightChoices* choices_;
  std::optional<Branch> begins_;
  std::vector<Frame> frames_;
  std::vector<double> found_;
  double least_ = exact::kInfinity;  // of nodes where a layout was found
  std::uint64_t programs_ = 0;
};

}  // namespace findspace::packing
