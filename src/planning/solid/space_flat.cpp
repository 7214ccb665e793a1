// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "planning/solid/space_flat.h"

#include <algorithm>

#include "distance/rays/ray_covers.h"
#include "exact/margins/space_distance.h"
#include "space/body/cell_parts.h"
#include "space/rays/piece_rays.h"

namespace findspace::planning {

using exact::Real;
using formula::Atom;
using formula::Formula;
using formula::Kind;
using formula::Node;
using formula::Relation;
using space::HalfSpace;
using space::RealVector;

namespace {

/// The atoms of a conjunction; nothing for other formulas.
std::optional<std::vector<Atom>> conjuncts(const Formula& formula) {
  const Node& root = formula.root();
  const auto is_atom = [](const Node& n) { return n.op == Node::Op::kAtom; };
  const bool all =
      is_atom(root) || (root.op == Node::Op::kAnd && std::all_of(root.operands.begin(), root.operands.end(), is_atom));
  return all ? std::optional(formula.atoms()) : std::nullopt;
}

class Maker {
 public:
  explicit Maker(const SpaceStage& stage) : stage_(stage) {}

  std::optional<FlatPositions> run() {
    const auto atoms = conjuncts(stage_.formula());
    if (!atoms) return std::nullopt;
    for (const Atom& atom : *atoms)
      if (!add(atom)) return std::nullopt;
    if (!bounded_) return std::nullopt;
    return std::move(out_);
  }

 private:
  bool add(const Atom& atom) {
    const formula::Distance d = moving_first(atom.distance, stage_.moving());
    const auto& moving = stage_.moving();
    if (atom.minimum || d.mode != formula::Mode::kPlain || atom.level.sign() != 0 ||
        std::find(moving.begin(), moving.end(), d.first.at(0)) == moving.end())
      return false;
    const bool apart = d.kind == Kind::kGamma1 && atom.relation == Relation::kGreaterEqual;
    const bool within = (d.kind == Kind::kEta1 || d.kind == Kind::kMu) && atom.relation == Relation::kLessEqual;
    if (!apart && (!within || d.second.size() > 1)) return false;
    for (const std::string& b : d.first)
      for (const std::string& a : d.second)
        if (!add_pair(b, a, within)) return false;
    return true;
  }

  bool add_pair(const std::string& moving, const std::string& fixed, bool within) {
    const auto &b = stage_.built(moving).body, &a = stage_.built(fixed).body;
    if (!b || !a || b->round() || a->round() || b->outside || a->outside) return false;
    const std::int64_t scale = space::joint_scale(b->scale, a->scale);
    const space::Body of_b = at_scale(*b, scale), of_a = at_scale(*a, scale);
    const auto cover = within ? distance::outside_sets(of_b, of_a) : distance::overlap_sets(of_b, of_a);
    const Real unit = Real::ratio(1, scale);
    const RealVector& by = stage_.standing(fixed).at;
    for (std::size_t k = 0; k < cover.sets.size(); ++k) add_set(cover.sets[k], cover.extents[k], unit, by);
    if (!within) return true;
    // The box about the positions has a margin of one unit.
    for (std::size_t k = 0; k < 3; ++k) {
      const Real low = (cover.low[k] + Real(1)) * unit + by[k];
      const Real high = (cover.high[k] - Real(1)) * unit + by[k];
      out_.low[k] = bounded_ ? std::max(out_.low[k], low) : low;
      out_.high[k] = bounded_ ? std::min(out_.high[k], high) : high;
    }
    bounded_ = true;
    return true;
  }

  /// {x : x = unit * y + by for a y in the set}.
  void add_set(const std::vector<HalfSpace>& planes, const space::Extent& extent, const Real& unit,
               const RealVector& by) {
    std::vector<HalfSpace> moved;
    for (const HalfSpace& h : planes) moved.emplace_back(h.normal, h.offset * unit - space::dot(h.normal, by));
    const space::Vector shift = space::rounded(by);
    const double factor = unit.to_double(), tolerance = margin::kPlaceNoise * space::size_of(shift);
    const space::Vector margin{tolerance, tolerance, tolerance};
    out_.covered.add({space::plus(space::scaled(factor, extent.low), shift) - margin,
                      space::plus(space::plus(space::scaled(factor, extent.high), shift), margin)},
                     std::move(moved));
  }

  const SpaceStage& stage_;
  FlatPositions out_;
  bool bounded_ = false;
};

}  // namespace

bool FlatPositions::empty_box() const { return high[0] < low[0] || high[1] < low[1] || high[2] < low[2]; }

bool FlatPositions::holds(const RealVector& p) const {
  for (std::size_t k = 0; k < 3; ++k)
    if (p[k] < low[k] || high[k] < p[k]) return false;
  return !covered.covers(p);
}

space::RaySourcePointer FlatPositions::rays(const space::RayGrid& grid) const {
  std::vector<space::LinePiece> pieces;
  for (std::size_t k = 0; k < covered.size(); ++k)
    pieces.push_back(space::polytope_piece(covered.planes(k), covered.extent(k).low, covered.extent(k).high));
  return space::negated_rays(std::make_unique<space::PieceRays>(pieces, 1, grid));
}

std::optional<FlatPositions> flat_positions(const SpaceStage& stage) { return Maker(stage).run(); }

}  // namespace findspace::planning
