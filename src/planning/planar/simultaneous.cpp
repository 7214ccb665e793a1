// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "planning/planar/simultaneous.h"

#include <algorithm>
#include <array>

#include "findspace/error.h"
#include "plane/complex/overlay.h"
#include "plane/query/topology.h"
#include "plane/walk/unite.h"
#include "planning/order/alternatives.h"
#include "planning/order/convex_cells.h"
#include "planning/planar/corner_search.h"
#include "planning/planar/pair_system.h"
#include "planning/planar/sequential.h"

namespace findspace::planning {

using plane::CellComplex;
using plane::Region;

namespace {

class Simultaneous {
 public:
  Simultaneous(const Relations& relations, const Limit& limit)
      : relations_(relations),
        problem_(relations.problem()),
        limit_(limit),
        alternatives_(alternatives(problem_.conditions)) {}

  SimultaneousPlacement run() {
    SimultaneousPlacement out;
    Poses fixed(problem_.bodies.size());
    out.positions = projections(fixed);
    out.unproven = unproven_;
    out.begin(fixed.size());
    if (!possible(out.positions)) {
      if (unproven_) try_sequence(out);
      return out;
    }
    std::vector<std::vector<AtAngle>> left = out.positions;
    const auto& goals = problem_.goals;
    on_lines_ = std::any_of(goals.begin(), goals.end(), [](const formula::Goal& g) { return g.equals.has_value(); });
    for (std::size_t b = 0; b < fixed.size(); ++b) {
      if (b > 0 || on_lines_) left = projections(fixed);
      if (!possible(left)) {  // something is undecided, or a condition on coordinates is kept nowhere
        out.unproven = unproven_;
        return out;
      }
      const Chosen chosen = choose(relations_, b, left[b], fixed, Pick::kAny);
      if (!chosen.pose) {
        if (b > 0)
          out.unproven = "a condition on coordinates leaves a shape no position after the choices for those before it";
        return out;
      }
      fixed[b] = chosen.pose;
      out.attained[b] = chosen.attained;
    }
    out.witness = std::move(fixed);
    return out;
  }

 private:
  static bool possible(const std::vector<std::vector<AtAngle>>& positions) {
    return std::all_of(positions.begin(), positions.end(), [](const auto& of_body) {
      return std::any_of(of_body.begin(), of_body.end(), [](const AtAngle& p) { return !plane::is_empty(p.region); });
    });
  }

  /// Where nothing is decided one after another may still succeed; then each body may stand wherever it can among the
  /// others.
  void try_sequence(SimultaneousPlacement& out) {
    SequentialPlacement found = place_sequentially(relations_, limit_);
    if (!std::all_of(found.poses.begin(), found.poses.end(), [](const auto& p) { return p.has_value(); })) {
      auto corners = search_corners(relations_, limit_);
      if (!corners) return;
      found.poses = std::move(*corners);
    }
    for (std::size_t b = 0; b < found.poses.size(); ++b)
      for (AtAngle& p : out.positions[b]) {
        Poses poses = found.poses;
        poses[b]->angle = p.angle;
        std::vector<Region> sets;
        for (const Condition& c : problem_.conditions) {
          const auto bodies = bodies_of(*c.formula, c.roles);
          if (bodies.empty() || std::find(bodies.begin(), bodies.end(), b) != bodies.end())
            sets.push_back(relations_.allowed(c, b, poses));
        }
        std::vector<const Region*> all;
        for (const Region& r : sets) all.push_back(&r);
        p.region = plane::intersect(all);
      }
    out.witness = std::move(found.poses);
  }

  /// P of every body at every angle, some bodies standing already.
  std::vector<std::vector<AtAngle>> projections(const Poses& fixed) {
    std::vector<std::vector<AtAngle>> out(problem_.bodies.size());
    for (std::size_t b = 0; b < out.size(); ++b)
      for (std::size_t a = 0; a < problem_.bodies[b].angles.size(); ++a) out[b].push_back({a, CellComplex::uniform(0)});
    for (const Alternative& alternative : alternatives_) {
      Poses poses(problem_.bodies.size());
      add_angles(alternative, fixed, poses, 0, out);
    }
    return out;
  }

  /// Every combination of angles, one body after another.
  void add_angles(const Alternative& alternative, const Poses& fixed, Poses& poses, std::size_t body,
                  std::vector<std::vector<AtAngle>>& out) {
    if (body == poses.size()) return add(alternative, fixed, poses, out);
    for (std::size_t a = 0; a < problem_.bodies[body].angles.size(); ++a) {
      if (fixed[body] && fixed[body]->angle != a) continue;
      poses[body] = Pose{a, {}};
      if (plane::is_empty(own(alternative, fixed, poses, body))) continue;
      add_angles(alternative, fixed, poses, body + 1, out);
    }
  }

  Region own(const Alternative& alternative, const Poses& fixed, const Poses& poses, std::size_t body) const {
    std::vector<BoxedPointer> sets;
    for (const Condition& c : alternative) {
      const auto bodies = bodies_of(*c.formula, c.roles);
      if (bodies.empty() || (bodies.size() == 1 && bodies[0] == body)) sets.push_back(relations_.set(c, poses));
    }
    std::vector<const Region*> all;
    for (const auto& s : sets) all.push_back(&s->region);
    Region at = CellComplex::uniform(1);
    if (fixed[body]) at = convex_region(std::span(&fixed[body]->at, 1), true);
    all.push_back(&at);
    Region both = plane::intersect(all);
    return on_lines_ && plane::is_bounded(both) ? keeping_conditions(problem_, std::move(both)) : both;
  }

  void add(const Alternative& alternative, const Poses& fixed, const Poses& poses,
           std::vector<std::vector<AtAngle>>& out) {
    if (limit_.over()) {
      unproven_ = "the time limit came before all combinations were tried";
      return;
    }
    PairSystem system;
    for (std::size_t b = 0; b < poses.size(); ++b) system.own.push_back(own(alternative, fixed, poses, b));
    for (const Condition& c : alternative) {
      const auto bodies = bodies_of(*c.formula, c.roles);
      if (bodies.size() < 2) continue;
      const Region& region = relations_.set(c, poses)->region;
      auto [entry, fresh] = system.between.try_emplace({bodies[0], bodies[1]}, region);
      if (fresh) continue;
      std::array<const Region*, 2> both{&entry->second, &region};
      entry->second = plane::intersect(both);
    }
    Projections found = project(std::move(system), limit_);
    if (!found.exact) unproven_ = found.reason;
    for (std::size_t b = 0; b < poses.size(); ++b) {
      Region& sum = out[b][poses[b]->angle].region;
      std::array<const Region*, 2> both{&sum, &found.positions[b]};
      sum = plane::unite(both);
    }
  }

  const Relations& relations_;
  const Problem& problem_;
  const Limit& limit_;
  std::vector<Alternative> alternatives_;
  std::optional<std::string> unproven_;
  bool on_lines_ = false;  // the projections keep the conditions on coordinates
};

}  // namespace

SimultaneousPlacement place_simultaneously(const Relations& relations, const Limit& limit) {
  return Simultaneous(relations, limit).run();
}

}  // namespace findspace::planning
