// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "planning/solid/space_simultaneous.h"

#include <algorithm>

#include "findspace/error.h"
#include "planning/order/relations.h"
#include "planning/solid/difference_boxes.h"
#include "planning/solid/space_on_boxes.h"
#include "planning/solid/space_stage.h"

namespace findspace::planning {

using space::BoxComplex;
using space::Interval;
using space::IntervalBox;
using space::RealVector;

namespace {

using Boxes = std::vector<IntervalBox>;

constexpr const char* kStopped = "the time limit came before all choices were looked at";

/// The difference of two positions lies in one of the boxes; the origin is number 0, body b number b + 1.
struct Choice {
  std::size_t first = 0, second = 0;
  Boxes boxes;
};

bool is_in(const Interval& a, const Interval& b) {
  const int low = !b.from ? 1 : !a.from ? -1 : compare(*a.from, *b.from);
  const int high = !b.to ? -1 : !a.to ? 1 : compare(*a.to, *b.to);
  return (low > 0 || (low == 0 && (b.from_in || !a.from_in))) && (high < 0 || (high == 0 && (b.to_in || !a.to_in)));
}

bool is_in(const IntervalBox& a, const IntervalBox& b) {
  return is_in(a[0], b[0]) && is_in(a[1], b[1]) && is_in(a[2], b[2]);
}

/// All that the choices leave to each body.
class TogetherSearch {
 public:
  TogetherSearch(std::vector<Choice> choices, std::size_t bodies, const Limit& limit)
      : choices_(std::move(choices)), found_(bodies), limit_(limit) {}

  std::vector<Boxes> run() {
    choose(0, DifferenceBoxes(found_.size() + 1));
    return found_;
  }
  bool stopped() const { return stopped_; }

 private:
  void choose(std::size_t depth, const DifferenceBoxes& so_far) {
    stopped_ = stopped_ || limit_.over();
    if (stopped_ || adds_nothing(so_far)) return;
    if (depth == choices_.size()) {
      for (std::size_t b = 0; b < found_.size(); ++b) add(found_[b], so_far.range(b + 1, 0));
      return;
    }
    for (const IntervalBox& box : choices_[depth].boxes) {
      DifferenceBoxes next = so_far;
      next.demand(choices_[depth].first, choices_[depth].second, box);
      if (!next.empty()) choose(depth + 1, next);
    }
  }

  static bool holds(const Boxes& all, const IntervalBox& box) {
    return std::any_of(all.begin(), all.end(), [&](const IntervalBox& b) { return is_in(box, b); });
  }

  static void add(Boxes& all, const IntervalBox& box) {
    if (holds(all, box)) return;
    std::erase_if(all, [&](const IntervalBox& b) { return is_in(b, box); });
    all.push_back(box);
  }

  bool adds_nothing(const DifferenceBoxes& so_far) const {
    for (std::size_t b = 0; b < found_.size(); ++b)
      if (!holds(found_[b], so_far.range(b + 1, 0))) return false;
    return true;
  }

  std::vector<Choice> choices_;
  std::vector<Boxes> found_;
  const Limit& limit_;
  bool stopped_ = false;
};

/// The problem with those conditions alone that are for these bodies.
SpaceProblem part_of(const SpaceProblem& problem, const std::vector<std::size_t>& bodies) {
  SpaceProblem out = problem;
  std::erase_if(out.conditions, [&](const Condition& c) {
    std::vector<std::size_t> asked = bodies_of(*c.formula, c.roles);
    std::sort(asked.begin(), asked.end());
    return asked != bodies && !(asked.empty() && bodies.size() == 1);
  });
  return out;
}

Boxes positions_of(const SpaceProblem& problem, const SpacePoses& others, std::size_t body) {
  const SpaceStage stage(problem, others, body, 0);
  return formula::SpaceSolver(stage.world()).feasible(stage.formula()).boxes();
}

void require_pairs(const SpaceProblem& problem) {
  for (const Body& b : problem.bodies)
    if (b.angles.size() > 1)
      throw Error(ErrorCode::kUnsupported, "in 3D shapes placed all at once stand at one angle each");
  for (const Condition& c : problem.conditions) {
    const std::size_t n = bodies_of(*c.formula, c.roles).size();
    if (n > 2 || (n == 2 && !is_single(c)))
      throw Error(ErrorCode::kUnsupported,
                  "in 3D a condition of a placement all at once is between two shapes, and speaks of nothing else");
  }
}

std::vector<Choice> choices_of(const SpaceProblem& problem) {
  const std::size_t n = problem.bodies.size();
  std::vector<Choice> out;
  for (std::size_t b = 0; b < n; ++b) out.push_back({b + 1, 0, positions_of(part_of(problem, {b}), SpacePoses(n), b)});
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 1; j < n; ++j) {
      const SpaceProblem pair = part_of(problem, {i, j});
      if (pair.conditions.empty()) continue;
      SpacePoses other(n);
      other[i] = SpacePose{};
      out.push_back({j + 1, i + 1, positions_of(pair, other, j)});
    }
  }
  return out;
}

IntervalBox point_box(const RealVector& p) {
  IntervalBox out;
  for (std::size_t k = 0; k < 3; ++k) out[k] = {p[k], p[k], true, true};
  return out;
}

/// Body after body at its best place, or at any where none is best, the sets of the others made anew each time.
void take_witness(const SpaceProblem& problem, std::vector<Choice> choices, std::vector<Boxes> left, const Limit& limit,
                  SpaceSimultaneous& out) {
  const std::size_t n = problem.bodies.size();
  SpacePoses poses(n);
  bool stopped = false;
  const auto narrow = [&] {
    TogetherSearch search(choices, n, limit);
    left = search.run();
    stopped = stopped || search.stopped();
  };
  if (space_goals(problem, 0).has_fixed()) {
    for (std::size_t b = 0; b < n; ++b) choices[b].boxes = with_fixed(choices[b].boxes, space_goals(problem, b));
    narrow();
  }
  for (std::size_t b = 0; b < n; ++b) {
    if (b > 0) narrow();
    const BoxComplex positions = BoxComplex::of_boxes(left[b]).checked().or_throw();
    const SpaceGoals goals = space_goals(problem, b);
    SpaceBest best = best_on_boxes(positions, goals, problem.step, Pick::kAny);
    if (!best.at) {
      if (stopped) out.unproven = kStopped;
      return;
    }
    goals.put_on_grid(best.at, [&](const RealVector& p) { return positions.mark(p) != 0; });
    poses[b] = SpacePose{0, *best.at};
    out.attained[b] = best.attained;
    choices[b].boxes = {point_box(*best.at)};
  }
  out.witness = poses;
}

}  // namespace

SpaceSimultaneous place_together_in_space(const SpaceProblem& problem, const Limit& limit) {
  require_pairs(problem);
  const std::vector<Choice> choices = choices_of(problem);
  TogetherSearch search(choices, problem.bodies.size(), limit);
  const std::vector<Boxes> found = search.run();
  SpaceSimultaneous out;
  out.begin(problem.bodies.size());
  if (search.stopped()) out.unproven = kStopped;
  for (const Boxes& boxes : found)
    out.positions.push_back(BoxComplex::of_boxes(boxes).checked().or_throw().simplified());
  if (std::none_of(found.begin(), found.end(), [](const Boxes& b) { return b.empty(); }))
    take_witness(problem, choices, found, limit, out);
  return out;
}

}  // namespace findspace::planning
