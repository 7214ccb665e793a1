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
  explicit Sequence(const Relations& relations)
      : relations_(relations), problem_(relations.problem()), poses_(problem_.bodies.size()) {
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

  const Poses& poses() const { return poses_; }

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
  struct Room {
    Region region;
    std::vector<char> minded;  // by body: it stands, and the region knows
  };

  Region region(std::size_t body, std::size_t angle) {
    if (problem_.bodies[body].copy == 0) return tolerance(body, angle, nullptr).region;
    auto& known = rooms_[{problem_.bodies[body].name, angle}];
    known = std::make_unique<Room>(tolerance(body, angle, known.get()));
    return known->region;
  }

  Room tolerance(std::size_t body, std::size_t angle, const Room* known) const {
    Poses poses = poses_;
    poses[body] = Pose{angle, {}};
    Room out{known ? known->region : own_room(body, poses), {}};
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

  bool all_minded(std::size_t condition, std::size_t body, const Room& tolerance) const {
    return std::all_of(bodies_[condition].begin(), bodies_[condition].end(),
                       [&](std::size_t b) { return b == body || tolerance.minded[b]; });
  }

  /// Where the body may stand alone: this says where the others matter.
  Region own_room(std::size_t body, const Poses& poses) const {
    std::vector<Region> own;
    for (std::size_t c = 0; c < bodies_.size(); ++c)
      if (bodies_[c].size() <= 1 && counts(c, body))
        own.push_back(relations_.allowed(problem_.conditions[c], body, poses));
    return intersection(std::move(own));
  }

  const Relations& relations_;
  const Problem& problem_;
  std::vector<std::vector<std::size_t>> bodies_;  // by condition
  Poses poses_;
  std::map<std::pair<std::string, std::size_t>, std::unique_ptr<Room>> rooms_;  // of copies, by name and angle
};

}  // namespace

SequentialPlacement place_sequentially(const Relations& relations, const Limit& limit) {
  SequentialPlacement out;
  Sequence sequence(relations);
  StepTimes times;
  for (std::size_t body = 0; body < relations.problem().bodies.size(); ++body) {
    if (times.next_is_late(limit)) {
      out.limit_reached = true;
      break;
    }
    times.begin();
    out.steps.push_back(sequence.place(body));
    times.end();
  }
  out.poses = sequence.poses();
  return out;
}

}  // namespace findspace::planning
