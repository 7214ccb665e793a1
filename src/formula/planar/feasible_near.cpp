// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "formula/planar/feasible_near.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <utility>

#include "distance/planar/signed_distance.h"
#include "exact/margins/formula.h"
#include "formula/language/evaluate.h"
#include "formula/planar/least_values.h"
#include "formula/planar/position_functions.h"
#include "formula/planar/regions.h"
#include "plane/base/parallel.h"
#include "plane/base/stage_observer.h"
#include "plane/build/cut_to_window.h"
#include "plane/complex/extent.h"
#include "plane/complex/overlay.h"
#include "plane/complex/primitives.h"
#include "plane/query/topology.h"
#include "plane/walk/unite.h"

namespace findspace::formula {
namespace {

using exact::Real;
using plane::CellComplex;
using plane::Index;
using plane::Mark;
using plane::PieceBox;
using plane::Region;

bool is_plain(const Distance& d) { return d.mode == Mode::kPlain; }

class Near {
 public:
  Near(const PreparedWorld& world, const Formula& formula) : world_(world), formula_(formula) {
    const Node& root = formula_.root();
    const bool several = root.op == Node::Op::kAnd;
    for (const Node& operand : several ? std::span<const Node>(root.operands) : std::span<const Node>(&root, 1)) {
      if (bounds(operand))
        bounding_.push_back(alone(operand));
      else
        others_.push_back(&operand);
    }
  }

  bool bounds_positions() const { return !bounding_.empty() && !others_.empty() && !world_.world().instant; }

  Region run() {
    if (!bounds_positions()) return feasible(world_, formula_);
    Region tolerance = feasible(world_, conjunction(bounding_));
    if (plane::is_empty(tolerance)) return tolerance;
    if (!plane::is_bounded(tolerance)) return feasible(world_, formula_);
    return within(std::move(tolerance));
  }

  /// What holds in a window depends on what is near it, but for what bounds the positions.
  bool all_local() const {
    if (world_.world().instant) return false;
    return std::all_of(others_.begin(), others_.end(), [&](const Node* other) {
      const Formula alone = this->alone(*other);
      return std::all_of(alone.sign_maps().begin(), alone.sign_maps().end(),
                         [&](const SignMap& m) { return is_local(m); });
    });
  }

  /// The positions of the window where the formula holds.
  Region in_window(const Region& window) {
    if (bounding_.empty()) return within(window);
    // What bounds the positions is the same for every window.
    if (!tolerance_) tolerance_ = feasible(world_, conjunction(bounding_));
    const std::array<const Region*, 2> both{&*tolerance_, &window};
    return within(plane::intersect(both));
  }

 private:
  struct Mover {
    plane::SharedRegion shape;
    std::optional<PieceBox> box;  // none of an unbounded one
  };
  using Names = std::vector<std::string>;

  /// Of these positions, the ones where all others hold.
  Region within(Region tolerance) {
    if (plane::is_empty(tolerance)) return tolerance;
    box_ = *plane::extent(tolerance);
    std::vector<Formula> near;
    for (const Node* other : others_) {
      const std::optional<bool> far = if_far(*other);
      if (!far) near.push_back(alone(*other));
      if (far && !*far) return CellComplex::uniform(0);
    }
    std::vector<std::optional<Region>> sets(near.size());
    plane::parallel_for(near.size(), [&](std::size_t k) { sets[k] = set(near[k]); });
    std::vector<const Region*> all{&tolerance};
    for (const auto& s : sets)
      if (s) all.push_back(&*s);
    Region region = plane::intersect(all);
    if (plane::StageObserver* observer = plane::stage_observer())
      observer->cells("region", "positions at which the formula holds", region);
    return region;
  }

  Formula alone(const Node& node) const { return part_of(formula_, node); }

  bool moves(const std::string& name) const {
    const auto& moving = world_.world().moving;
    return std::find(moving.begin(), moving.end(), name) != moving.end();
  }

  /// "inside a container": eta1 at most something, of the moving shape.
  bool bounds(const Node& node) const {
    if (node.op != Node::Op::kAtom) return false;
    const Atom& atom = formula_.atoms()[node.atom];
    return !atom.minimum && atom.more.empty() && is_plain(atom.distance) && atom.distance.kind == Kind::kEta1 &&
           moves(atom.distance.first[0]) && (atom.relation == Relation::kLess || atom.relation == Relation::kLessEqual);
  }

  /// The positions where the formula holds, right within the box only; nothing: everywhere there.
  std::optional<Region> set(const Formula& formula) const {
    if (auto levels = set_of_levels(formula)) return levels;
    std::vector<plane::SignMap> maps;
    bool varies = false;
    for (const SignMap& m : formula.sign_maps()) {
      maps.push_back(observed(m, sign_map(m)));
      varies = varies || !maps.back().vertices.empty();
    }
    std::vector<Mark> signs;
    for (const auto& m : maps) signs.push_back(m.faces[0].mark);
    if (!varies) return evaluate(formula, signs) ? std::nullopt : std::optional(CellComplex::uniform(0));
    return region_of(formula, std::move(maps));
  }

  /// The same of a formula of one distance, by levels of what is near enough for the greatest of them: so all are
  /// levels of one function. Nothing for another formula.
  std::optional<Region> set_of_levels(const Formula& formula) const {
    const std::vector<SignMap>& all = formula.sign_maps();
    const auto local = [&](const SignMap& m) { return is_local(m); };
    if (!std::all_of(all.begin(), all.end(), local)) return std::nullopt;
    const auto greatest = [](const SignMap& a, const SignMap& b) { return a.level < b.level; };
    return region_of_levels(formula, [&](const SignMap& m) {
      return sign_map(m, std::max_element(all.begin(), all.end(), greatest)->level);
    });
  }

  /// Does an atom hold everywhere in the box, or nowhere, because its obstacles are out of reach? Nothing: they are
  /// not, or it is another kind of condition.
  std::optional<bool> if_far(const Node& node) {
    if (node.op != Node::Op::kAtom) return std::nullopt;
    const Atom& atom = formula_.atoms()[node.atom];
    const Distance d = moving_first(atom.distance, world_.world().moving);
    if (atom.minimum || !atom.more.empty() || !is_plain(d) || d.kind != Kind::kGamma1 || !moves(d.first[0]) ||
        moves(d.second[0]) || atom.level.sign() < 0)
      return std::nullopt;
    auto mover = movers_.find(d.first);
    if (mover == movers_.end()) mover = movers_.emplace(d.first, made(d.first)).first;
    if (!mover->second.box) return std::nullopt;
    const PieceBox window = reached(*mover->second.box, d, atom.level / world_.step());
    for (const std::string& name : d.second) {
      const PieceBox* box = world_.box(name);
      if (!box || box->meets(window)) return std::nullopt;
    }
    return holds(atom, 1);
  }

  /// gamma1 from level 0 on, of bounded shapes.
  bool is_local(const SignMap& wanted) const {
    const Distance d = moving_first(wanted.distance, world_.world().moving);
    return !wanted.minimum && wanted.more.empty() && is_plain(d) && d.kind == Kind::kGamma1 &&
           wanted.level.sign() >= 0 && moves(d.first[0]) &&
           std::all_of(d.second.begin(), d.second.end(),
                       [&](const std::string& name) { return world_.box(name) != nullptr; });
  }

  plane::SignMap sign_map(const SignMap& wanted) const { return sign_map(wanted, wanted.level); }
  /// From what is near enough for level `farthest`.
  plane::SignMap sign_map(const SignMap& wanted, const Real& farthest) const {
    const Real level = wanted.level / world_.step();
    const Distance d = moving_first(wanted.distance, world_.world().moving);
    if (!wanted.more.empty()) return formula::sign_map(world_, wanted);
    if (wanted.minimum) return minimiser_map(least(world_, wanted.distance));
    if (!is_local(wanted)) return position_function(world_, wanted.distance)->sign_map(level);
    const auto known = movers_.find(d.first);
    const Mover b = known == movers_.end() ? made(d.first) : known->second;
    if (!b.box) return position_function(world_, wanted.distance)->sign_map(level);
    const PieceBox window = reached(*b.box, d, farthest / world_.step());
    std::vector<plane::SharedRegion> parts;
    for (const std::string& name : d.second)
      if (world_.box(name)->meets(window)) parts.push_back(part(name, window));
    std::vector<const Region*> all;
    for (const Region& p : parts) all.push_back(&p);
    if (all.empty()) return CellComplex::uniform(1);
    plane::SharedRegion a = all.size() == 1 ? std::move(parts[0]) : plane::SharedRegion(plane::unite(all));
    if (plane::is_empty(a)) return CellComplex::uniform(1);
    const auto pair =
        std::make_shared<distance::SignedDistance>(distance::SignedDistance::gamma1(b.shape, std::move(a)));
    return over_its_time(world_, d, pair)->sign_map(level);
  }

  /// A shape as it is within the window: what is near of those that lie apart, and of a large one no more than that.
  plane::SharedRegion part(const std::string& name, const PieceBox& window) const {
    plane::SharedRegion near = near_components(name, window);
    if (auto cut = plane::cut_to_window(near, window)) near = *std::move(cut);
    return near;
  }

  /// One of a single face is as it is, without a copy.
  plane::SharedRegion near_components(const std::string& name, const PieceBox& window) const {
    const plane::SharedRegion& whole = world_.world().shapes.at(name);
    if (whole->faces.size() == 2) return whole;
    const plane::BoundaryComponents* boundary_components = world_.boundary_components(name);
    if (boundary_components) return plane::within(boundary_components->near(whole, window), window);
    return plane::within(whole, window);
  }

  Mover made(const Names& names) const {
    plane::SharedRegion shape = world_.shape(names);
    const auto box = plane::is_bounded(shape) ? plane::extent(shape) : std::nullopt;
    return {std::move(shape), box};
  }

  /// What a shape with this box comes within the level of, from the positions in question, at any time.
  PieceBox reached(const PieceBox& shape, const Distance& d, const Real& level) const {
    std::optional<PieceBox> all;
    for (const exact::RealPoint& at : way(world_, d)) {
      const PieceBox here = plane::moved(shape, at);
      all = all ? plane::joined(*all, here) : here;
    }
    return grown({box_.x0 + all->x0, box_.y0 + all->y0, box_.x1 + all->x1, box_.y1 + all->y1}, level);
  }

  /// By the level and by more than all rounding.
  static PieceBox grown(const PieceBox& b, const Real& level) {
    const double size = std::max({std::abs(b.x0), std::abs(b.y0), std::abs(b.x1), std::abs(b.y1)});
    const double by = level.interval().hi + 2 + size * margin::kOutOfReach;
    return {b.x0 - by, b.y0 - by, b.x1 + by, b.y1 + by};
  }

  const PreparedWorld& world_;
  const Formula& formula_;
  std::vector<Formula> bounding_;      // operands that bound the positions
  std::vector<const Node*> others_;    // the other ones
  std::optional<Region> tolerance_{};  // where all that bound hold
  PieceBox box_{};                     // of the positions in question
  std::map<Names, Mover> movers_;      // known so far
};

/// Half the sides of the windows: of the first one, and what none is to pass.
struct WindowSizes {
  double first, most;
};

/// The first window is a few times as large as what moves, and the last one holds a quarter of everything.
std::optional<WindowSizes> window_sizes(const PreparedWorld& world) {
  std::optional<PieceBox> all, moving;
  const auto join = [](std::optional<PieceBox>& to, const PieceBox& box) { to = to ? plane::joined(*to, box) : box; };
  for (const auto& [name, shape] : world.world().shapes)
    if (const PieceBox* box = world.box(name)) join(all, *box);
  for (const std::string& name : world.world().moving)
    if (const PieceBox* box = world.box(name)) join(moving, *box);
  if (!all || !moving) return std::nullopt;
  const auto size = [](const PieceBox& b) { return std::max(b.x1 - b.x0, b.y1 - b.y0); };
  return WindowSizes{2 * size(*moving) + 2, size(*all) / 4};
}

}  // namespace

Region feasible_near(const Solver& solver, const Formula& formula) { return Near(solver.prepared(), formula).run(); }

bool is_solved_near(const Solver& solver, const Formula& formula) {
  return Near(solver.prepared(), formula).bounds_positions();
}

std::optional<plane::NearestInClosure> nearest_in_windows(const PreparedWorld& world, const Formula& formula,
                                                          const exact::RealPoint& p, const Real& least) {
  constexpr double kLargest = 0x1p38;  // no sign: in grid steps, what is beyond is not a coordinate
  const double x = distance::near_value(p.x), y = distance::near_value(p.y);
  const auto sizes = window_sizes(world);
  Near near(world, formula);
  if (!sizes || !near.all_local()) return std::nullopt;
  // A window that holds no more than what is too near would be made in vain.
  for (double half = std::max(sizes->first, 1.5 * distance::near_value(least)); half < sizes->most; half *= 2) {
    if (std::max(std::abs(x), std::abs(y)) + half > kLargest) return std::nullopt;
    const std::int64_t x0 = std::llround(x - half), y0 = std::llround(y - half), x1 = std::llround(x + half),
                       y1 = std::llround(y + half);
    const plane::Contour ring{{.start = {x0, y0}}, {.start = {x1, y0}}, {.start = {x1, y1}}, {.start = {x0, y1}}};
    const Region inside = near.in_window(plane::region_of_rings({&ring, 1})), closed = plane::closure(inside);
    const auto found = plane::nearest_in_closure(inside, closed, p);
    // What is nearer than the window's sides is what it is without the window.
    if (found && found->nearest.distance.to_double() < half - 1) return found;
  }
  return std::nullopt;
}

}  // namespace findspace::formula
