// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What a layout of solids in a container of given floor has to keep to, as rows of a linear program over the positions
// of all copies and the height. Always: the floor, the walls, the lid; equal parts stand in the order of their heights.
// And of each two convex parts of two copies one plane of their Phi-function. Guarantee: the factors enclose the exact
// ones, and every feasible layout, with equal parts exchanged, satisfies the rows, if of each choice one is taken.
// Gaps and conditions of pairs are left out. Cost: a Phi-function for each two kinds. Source: phi.md 2. Keywords:
// disjunctive constraints, big-M free formulation.
#pragma once

#include <vector>

#include "packing/solid_depth/solid_table.h"
#include "packing/solid_proof/growing_program.h"
#include "space/phi/contact_surface.h"

namespace findspace::packing {

/// Of two convex parts: the row of each plane that can separate them. The row after it is its other side.
struct Choice {
  std::vector<std::size_t> rows;
};

class HeightChoices {
 public:
  /// Of layouts of at most this height, in which the copies stand as these variants, without balls; those of the same
  /// variant follow each other. Both must live as long.
  HeightChoices(const SolidProblem& problem, const SolidTable& table, std::vector<std::size_t> copies, double height);

  const CertainRows& rows() const { return rows_; }
  /// The rows that hold in every layout.
  const std::vector<std::size_t>& always() const { return always_; }
  const std::vector<Choice>& choices() const { return choices_; }
  /// Of the floor.
  double size() const { return table_.size(); }

  /// How deep two parts overlap at the vertex; below 0 apart.
  double overlap(const Choice& choice, const std::vector<double>& vertex) const;
  std::vector<SolidPose> poses(const std::vector<double>& vertex) const;

 private:
  std::vector<exact::Interval> bounds(double height) const;
  const SolidForm& form_of(std::size_t variant) const;
  void add_lids();
  void add_orders();
  void add_choices();
  void add_choice(std::size_t a, std::size_t b, const space::ContactSurface& surface, double unit);

  const SolidProblem& problem_;
  const SolidTable& table_;
  std::vector<std::size_t> copies_;  // the variant of each; columns 3 i to 3 i + 2 are its position
  CertainRows rows_;                 // the last column is the height
  std::vector<std::size_t> always_;
  std::vector<Choice> choices_;
};

}  // namespace findspace::packing
