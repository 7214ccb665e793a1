// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "situation/feasible_near.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "distance/signed_distance.h"
#include "plane/extent.h"
#include "plane/overlay.h"
#include "plane/parallel.h"
#include "plane/simplify.h"
#include "plane/topology.h"
#include "situation/evaluate.h"

namespace findspace::situation {
namespace {

using exact::Real;
using plane::CellComplex;
using plane::Index;
using plane::Mark;
using plane::PieceBox;
using plane::Region;

/// A node of a formula as a formula of its own.
Node taken(const Node& node, const Formula& from, std::vector<Atom>& atoms) {
  Node out{node.op, 0, {}};
  if (node.op == Node::Op::kAtom) {
    out.atom = atoms.size();
    atoms.push_back(from.atoms()[node.atom]);
  }
  for (const Node& operand : node.operands) out.operands.push_back(taken(operand, from, atoms));
  return out;
}

bool is_plain(const Distance& d) { return d.mode == Mode::kPlain && d.prefix == Extremum::kNone; }

/// Cells of a closed set that meet a box, each with its boundary: the set as it is within the box.
Region within(const Region& a, const PieceBox& window) {
  std::vector<PieceBox> edge_box;
  edge_box.reserve(a.edges.size());
  for (const plane::Edge& e : a.edges) {
    const exact::Point &p = a.geometry.points[a.vertices[e.v0].point], &q = a.geometry.points[a.vertices[e.v1].point];
    PieceBox box{std::min(p.x, q.x), std::min(p.y, q.y), std::max(p.x, q.x), std::max(p.y, q.y)};
    if (e.half != 0) {
      const exact::Carrier& k = a.geometry.carriers[e.carrier];
      const double top = k.y.value + e.half * k.z.value;
      box.y0 = std::min(box.y0, top), box.y1 = std::max(box.y1, top);
    }
    edge_box.push_back(box);
  }
  Region out = a;
  for (plane::Vertex& v : out.vertices) v.mark = 0;
  for (plane::Edge& e : out.edges) e.mark = 0;
  const auto keep_edge = [&](Index e) {
    out.edges[e].mark = a.edges[e].mark;
    for (Index v : {a.edges[e].v0, a.edges[e].v1}) out.vertices[v].mark = a.vertices[v].mark;
  };
  for (Index f = 1; f < a.faces.size(); ++f) {
    if (a.faces[f].mark <= 0) continue;
    const Index outer = a.faces[f].outer;
    PieceBox all = edge_box[outer / 2];
    for (Index h = a.next(outer); h != outer; h = a.next(h)) {
      const PieceBox& b = edge_box[h / 2];
      all = {std::min(all.x0, b.x0), std::min(all.y0, b.y0), std::max(all.x1, b.x1), std::max(all.y1, b.y1)};
    }
    if (!all.meets(window)) out.faces[f].mark = 0;
  }
  for (Index e = 0; e < a.edges.size(); ++e) {
    const bool of_face = out.faces[a.face(2 * e)].mark > 0 || out.faces[a.face(2 * e + 1)].mark > 0;
    if (a.edges[e].mark > 0 && (of_face || edge_box[e].meets(window))) keep_edge(e);
  }
  for (Index v = 0; v < a.vertices.size(); ++v)
    if (a.vertices[v].out == plane::kNone) out.vertices[v].mark = a.vertices[v].mark;
  return plane::simplify(out);
}

class Near {
 public:
  Near(const Solver& solver, const Formula& formula) : solver_(solver), formula_(formula) {}

  Region run() {
    const Node& root = formula_.root();
    if (root.op != Node::Op::kAnd) return solver_.feasible(formula_);
    std::vector<Formula> bounding, near;
    std::vector<const Node*> others;
    for (const Node& operand : root.operands) {
      if (bounds(operand))
        bounding.push_back(alone(operand));
      else
        others.push_back(&operand);
    }
    if (bounding.empty() || others.empty()) return solver_.feasible(formula_);
    Region room = solver_.feasible(conjunction(bounding));
    if (plane::is_empty(room)) return room;
    if (!plane::is_bounded(room)) return solver_.feasible(formula_);
    box_ = *plane::extent(room);
    for (const Node* n : others) {
      const std::optional<bool> all_over = where_all_is_far(*n);
      if (!all_over) near.push_back(alone(*n));
      if (all_over && !*all_over) return CellComplex::uniform(0);
    }
    std::vector<std::optional<Region>> sets(near.size());
    plane::parallel_for(near.size(), [&](std::size_t k) { sets[k] = set(near[k]); });
    std::vector<const Region*> all{&room};
    for (const auto& s : sets)
      if (s) all.push_back(&*s);
    return plane::intersect(all);
  }

 private:
  Formula alone(const Node& node) const {
    std::vector<Atom> atoms;
    Node copy = taken(node, formula_, atoms);
    return Formula(std::move(copy), std::move(atoms));
  }

  /// The truth of an atom of gamma1 whose shapes are too far away to touch, everywhere in the box.
  std::optional<bool> where_all_is_far(const Node& node) {
    if (node.op != Node::Op::kAtom) return std::nullopt;
    const Atom& atom = formula_.atoms()[node.atom];
    const Distance& d = atom.distance;
    if (atom.minimum || !is_plain(d) || d.kind != Kind::kGamma1 || atom.level.sign() < 0) return std::nullopt;
    const bool first = moves(d.first[0]);
    if (!first && !moves(d.second[0])) return std::nullopt;
    if (const auto& b = first ? d.first : d.second; b != reaching_) reaching_ = b, reach_ = plane::extent(united(b));
    if (!reach_) return std::nullopt;
    const PieceBox window = window_of(*reach_, atom.level / solver_.world().step);
    for (const std::string& name : first ? d.second : d.first) {
      const Region& a = solver_.world().shapes.at(name);
      const auto box = plane::extent(a);
      if (!plane::is_bounded(a) || (box && box->meets(window))) return std::nullopt;
    }
    return holds(atom, 1);
  }

  bool moves(const std::string& name) const {
    const auto& moving = solver_.world().moving;
    return std::find(moving.begin(), moving.end(), name) != moving.end();
  }

  /// "inside a container": eta1 at most something, of the moving shape.
  bool bounds(const Node& node) const {
    if (node.op != Node::Op::kAtom) return false;
    const Atom& atom = formula_.atoms()[node.atom];
    return !atom.minimum && is_plain(atom.distance) && atom.distance.kind == Kind::kEta1 &&
           moves(atom.distance.first[0]) && (atom.relation == Relation::kLess || atom.relation == Relation::kLessEqual);
  }

  /// The positions where the formula holds, right within the box only; nothing: everywhere there.
  std::optional<Region> set(const Formula& formula) const {
    std::vector<plane::SignMap> maps;
    bool varies = false;
    for (const SignMap& m : formula.sign_maps()) {
      maps.push_back(sign_map(m));
      varies = varies || !maps.back().vertices.empty();
    }
    std::vector<Mark> signs;
    for (const auto& m : maps) signs.push_back(m.faces[0].mark);
    if (!varies) return evaluate(formula, signs) ? std::nullopt : std::optional(CellComplex::uniform(0));
    std::vector<const CellComplex*> operands;
    for (const auto& m : maps) operands.push_back(&m);
    return plane::overlay(operands, [&](std::span<const Mark> marks) { return Mark(evaluate(formula, marks)); });
  }

  plane::SignMap sign_map(const SignMap& wanted) const {
    const Real level = wanted.level / solver_.world().step;
    const Distance d = moving_first(wanted.distance, solver_.world().moving);
    if (wanted.minimum) {
      distance::Extremum e = solver_.least(wanted.distance);
      if (!e.exists) return CellComplex::uniform(1);
      return plane::remark(std::move(e.at), [](Mark k) { return Mark(k > 0 ? 0 : 1); });
    }
    const bool local = is_plain(d) && d.kind == Kind::kGamma1 && level.sign() >= 0 && moves(d.first[0]);
    if (!local) return solver_.function(wanted.distance)->sign_map(level);
    const Region b = united(d.first);
    const auto reach = plane::extent(b);
    if (!reach) return solver_.function(wanted.distance)->sign_map(level);
    const PieceBox window = window_of(*reach, level);
    std::vector<Region> parts;
    for (const std::string& name : d.second) {
      const Region& a = solver_.world().shapes.at(name);
      const auto box = plane::extent(a);
      if (!plane::is_bounded(a)) return solver_.function(wanted.distance)->sign_map(level);
      if (box && box->meets(window)) parts.push_back(within(a, window));
    }
    std::vector<const Region*> all;
    for (const Region& p : parts) all.push_back(&p);
    if (all.empty()) return CellComplex::uniform(1);
    const Region a = all.size() == 1 ? std::move(parts[0]) : plane::unite(all);
    if (plane::is_empty(a)) return CellComplex::uniform(1);
    return distance::SignedDistance::gamma1(b, a).sign_map(level);
  }

  Region united(const std::vector<std::string>& names) const {
    std::vector<const Region*> all;
    for (const std::string& n : names) all.push_back(&solver_.world().shapes.at(n));
    return all.size() == 1 ? *all[0] : plane::unite(all);
  }

  /// Where a shape with that extent can come within the level of something, from the positions of the box.
  PieceBox window_of(const PieceBox& reach, const Real& level) const {
    return grown({box_.x0 + reach.x0, box_.y0 + reach.y0, box_.x1 + reach.x1, box_.y1 + reach.y1}, level);
  }

  /// By the level and by more than all rounding.
  static PieceBox grown(const PieceBox& b, const Real& level) {
    const double size = std::max({std::abs(b.x0), std::abs(b.y0), std::abs(b.x1), std::abs(b.y1)});
    const double by = level.interval().hi + 2 + size * 0x1p-40;
    return {b.x0 - by, b.y0 - by, b.x1 + by, b.y1 + by};
  }

  const Solver& solver_;
  const Formula& formula_;
  PieceBox box_{};
  std::vector<std::string> reaching_;  // shapes, and what they extend over
  std::optional<PieceBox> reach_;
};

}  // namespace

Region feasible_near(const Solver& solver, const Formula& formula) { return Near(solver, formula).run(); }

}  // namespace findspace::situation
