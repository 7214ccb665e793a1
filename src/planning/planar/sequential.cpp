// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "planning/planar/sequential.h"

#include <algorithm>
#include <map>
#include <memory>

#include "plane/complex/extent.h"
#include "plane/complex/overlay.h"
#include "plane/query/topology.h"

namespace findspace::planning {

using plane::CellComplex;
using plane::Region;

namespace {

Region intersection(std::vector<Region> sets) {
  if (sets.empty()) return CellComplex::uniform(1);
  if (sets.size() == 1) return std::move(sets[0]);
  std::vector<const Region*> all;
  for (const Region& s : sets) all.push_back(&s);
  return plane::intersect(all);
}

class Sequence {
 public:
  /// `poses`: of the bodies that stand already.
  Sequence(const Relations& relations, Poses& poses)
      : relations_(relations), problem_(relations.problem()), poses_(poses) {
    for (const Condition& c : problem_.conditions) bodies_.push_back(bodies_of(*c.formula, c.roles));
  }

  Step place(std::size_t body) {
    Step step;
    for (std::size_t a = 0; a < problem_.bodies[body].angles.size(); ++a)
      step.positions.push_back({a, region(body, a)});
    step.chosen = choose(relations_, body, step.positions, poses_);
    poses_[body] = step.chosen.pose;
    return step;
  }

 private:
  /// Whether the condition counts for the body now; the other bodies stand.
  bool counts(std::size_t condition, std::size_t body) const {
    const auto& bodies = bodies_[condition];
    bool speaks = bodies.empty();
    for (std::size_t b : bodies) {
      speaks = speaks || b == body;
      if (b != body && !poses_[b]) return false;
    }
    return speaks;
  }

  /// Copies of one body have the same conditions: what the first of them leaves is where the next begins.
  struct Left {
    Region region;
    std::vector<char> minded;  // by body: it stands, and the region knows
    std::size_t body;
  };

  /// Whether each copy that stands is an earlier one of both bodies, or a later one of both.
  bool has_conditions_of(std::size_t before, std::size_t body) const {
    const auto& bodies = problem_.bodies;
    for (std::size_t b = 0; b < bodies.size(); ++b) {
      if (b == before || !poses_[b] || bodies[b].name != bodies[body].name) continue;
      if ((bodies[b].copy < bodies[before].copy) != (bodies[b].copy < bodies[body].copy)) return false;
    }
    return true;
  }

  Region region(std::size_t body, std::size_t angle) {
    if (problem_.bodies[body].copy == 0) return what_is_left(body, angle, nullptr).region;
    auto& known = left_[problem_.bodies[body].variants[angle]];
    if (known && !has_conditions_of(known->body, body)) known.reset();
    known = std::make_unique<Left>(what_is_left(body, angle, known.get()));
    return known->region;
  }

  Left what_is_left(std::size_t body, std::size_t angle, const Left* known) const {
    Poses poses = poses_;
    poses[body] = Pose{angle, {}};
    Left out{known ? known->region : own_region(body, poses), {}, body};
    for (const auto& p : poses_) out.minded.push_back(p.has_value());
    if (plane::is_empty(out.region)) return out;
    const auto where = plane::is_bounded(out.region) ? plane::extent(out.region) : std::nullopt;
    std::vector<Region> sets{std::move(out.region)};
    for (std::size_t c = 0; c < bodies_.size(); ++c) {
      if (bodies_[c].size() <= 1 || !counts(c, body) || (known && all_minded(c, body, *known))) continue;
      if (auto set = relations_.allowed_within(problem_.conditions[c], body, poses, where))
        sets.push_back(std::move(*set));
    }
    out.region = intersection(std::move(sets));
    return out;
  }

  bool all_minded(std::size_t condition, std::size_t body, const Left& known) const {
    return std::all_of(bodies_[condition].begin(), bodies_[condition].end(),
                       [&](std::size_t b) { return b == body || known.minded[b]; });
  }

  /// Where the body may stand alone: this says where the others matter.
  Region own_region(std::size_t body, const Poses& poses) const {
    std::vector<Region> own;
    for (std::size_t c = 0; c < bodies_.size(); ++c)
      if (bodies_[c].size() <= 1 && counts(c, body))
        own.push_back(relations_.allowed(problem_.conditions[c], body, poses));
    return intersection(std::move(own));
  }

  const Relations& relations_;
  const Problem& problem_;
  std::vector<std::vector<std::size_t>> bodies_;  // by condition
  Poses& poses_;
  std::map<std::vector<std::string>, std::unique_ptr<Left>> left_;  // of copies, by their shapes at an angle
};

}  // namespace

SequentialPlacement place_sequentially(const Relations& relations, const Limit& limit) {
  SequentialPlacement out;
  Sequence sequence(relations, out.poses);
  out.place_each(relations.problem().bodies.size(), limit, [&](std::size_t body) { return sequence.place(body); });
  return out;
}

}  // namespace findspace::planning
