// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "formula/planar/sums.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "distance/planar_least/sum_map.h"
#include "distance/rotation/rotation_motion.h"
#include "formula/language/evaluate.h"
#include "formula/planar/feasible_near.h"
#include "formula/planar/position_functions.h"
#include "formula/planar/regions.h"
#include "plane/complex/extent.h"
#include "plane/complex/overlay.h"
#include "plane/query/topology.h"

namespace findspace::formula {

using plane::CellComplex;
using plane::Mark;
using plane::PieceBox;

distance::DistanceSum distance_sum(const PreparedWorld& world, std::span<const SumTerm> terms) {
  std::vector<distance::Summand> out;
  for (const SumTerm& t : terms) out.push_back({objective_distance(world, t.distance), t.weight});
  return distance::DistanceSum(std::move(out));
}

std::vector<SumTerm> terms_of(const SignMap& wanted) {
  std::vector<SumTerm> out{{exact::Real(1), wanted.distance}};
  out.insert(out.end(), wanted.more.begin(), wanted.more.end());
  return out;
}

DistanceAt sum_at(const PreparedWorld& world, const SignMap& wanted, std::string text, const exact::RealPoint& p) {
  auto answer = distance_sum(world, terms_of(wanted)).answer(p);
  if (!answer) return distance_at(std::move(text), std::nullopt);
  return distance_at(std::move(text), distance::in_scene(*answer, world.step()));
}

double reach_of(const PreparedWorld& world, std::span<const SumTerm> terms) {
  double out = 2;
  for (const SumTerm& t : terms) {
    const Roles r = world.roles(t.distance);
    for (const auto* names : {&r.names.first, &r.names.second}) out += distance::reach(world.shape(*names));
  }
  return out;
}

namespace {

constexpr double kStrips = 8192;  // of a window: how narrow strips are in which a sign stays open

bool has_sum(const Node& node, const Formula& formula) {
  if (node.op == Node::Op::kAtom) return !formula.atoms()[node.atom].more.empty();
  return std::any_of(node.operands.begin(), node.operands.end(),
                     [&](const Node& operand) { return has_sum(operand, formula); });
}

/// The operands of the outermost `and` without sums, and the others.
std::pair<Formula, Formula> parted(const Formula& formula) {
  std::vector<Formula> plain, others;
  const bool all = formula.root().op == Node::Op::kAnd;
  for (const Node& node : all ? formula.root().operands : std::vector<Node>{formula.root()})
    (has_sum(node, formula) ? others : plain).push_back(part_of(formula, node));
  return {conjunction(plain), conjunction(others)};
}

PieceBox outward(const PieceBox& b) {
  return {std::floor(b.x0) - 1, std::floor(b.y0) - 1, std::ceil(b.x1) + 1, std::ceil(b.y1) + 1};
}

/// Where positions are looked at: about the plain region, or about all shapes.
PieceBox window_of(const PreparedWorld& world, const plane::Region& plain, const Formula& others) {
  if (plane::is_bounded(plain)) return outward(plane::extent(plain).value());
  double reach = 0;
  for (const SignMap& m : others.sign_maps()) reach = std::max(reach, 2 * reach_of(world, terms_of(m)));
  return outward({-reach, -reach, reach, reach});
}

RegionBounds in(const plane::Region& plain, const Formula& others, const std::vector<CellComplex>& maps) {
  std::vector<const CellComplex*> operands{&plain};
  for (const CellComplex& m : maps) operands.push_back(&m);
  const CellComplex both = plane::overlay(operands, [&](std::span<const Mark> marks) {
    return marks[0] > 0 ? Mark(certainty(others, marks.subspan(1))) : Mark(0);
  });
  return {plane::remark(both, [](Mark m) { return Mark(m == 2); }),
          plane::remark(both, [](Mark m) { return Mark(m > 0); })};
}

}  // namespace

RegionBounds sum_region_bounds(const Solver& solver, const Formula& formula) {
  const PreparedWorld& world = solver.prepared();
  const auto [known, others] = parted(formula);
  const plane::Region plain = feasible_near(solver, known);
  if (plane::is_empty(plain)) return {plain, plain};
  const PieceBox window = window_of(world, plain, others);
  const double width = std::max(1.0, std::max(window.x1 - window.x0, window.y1 - window.y0) / kStrips);
  std::vector<CellComplex> maps;
  for (const SignMap& m : others.sign_maps()) {
    if (m.more.empty()) {
      const plane::SignMap exact = sign_map(world, m);
      maps.insert(maps.end(), 2, exact);
      continue;
    }
    const distance::DistanceSum sum = distance_sum(world, terms_of(m));
    distance::SumSigns signs = distance::sum_map(sum, m.level / world.step(), window, width);
    maps.push_back(std::move(signs.low));
    maps.push_back(std::move(signs.high));
  }
  return in(plain, others, maps);
}

}  // namespace findspace::formula
