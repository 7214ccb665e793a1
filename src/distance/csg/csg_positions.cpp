// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The positions p at which a body B + p and a solid A that convex sets are cut out of have no interior in common, and
// the one nearest to a position: the depth of B in A, and, of the solid that others leave, how far B is from fitting
// among them: a provider of position_set.h. What a part of B has in common with a part of A that nothing is cut out of
// has slack that is concave in p (meet_slack.h), so the boundary search (boundary_search.h) takes it as it is. Else
// each place x of A, with a plane between it and what is cut out, says a convex subset of A, and so a concave function
// below the slack that is the slack itself where x is the deepest place: each cell of the search makes those that it
// needs (LazyConstraints), right to the square of its size. Guarantee: doubles; the place is one at which common slack
// is at most 2^-42 of the sizes, no such position is nearer than `bound`; the search may end before (`complete`), so
// where edges of B lie on edges of what is cut out. Sets may be anything convex with interior.
// Cost: some hundred cells, each some dozen slacks. Keywords: penetration depth, reverse convex programming, cutting
// planes.
#include <algorithm>
#include <cmath>
#include <deque>

#include "distance/csg/csg_part.h"
#include "distance/search/boundary_search.h"
#include "exact/margins/space_distance.h"
#include "exact/number/interval.h"
#include "plane/base/search_work.h"

namespace findspace::distance {

using space::BodyPart;
using space::Vector;

namespace {

constexpr int kTimes = 4;  // that a place is made deeper
constexpr long kMostCellsInAll = 200000;
constexpr std::size_t kRecent = 8, kMostCuts = 8;

/// A tetrahedron about the box.
Tetrahedron about_box(const space::Extent& box) {
  const Vector wide = space::scaled(3.0625, box.high - box.low),
               from = box.low - space::scaled(margin::kAroundTetrahedron, box.high - box.low);
  return {from, space::plus(from, {wide.x, 0, 0}), space::plus(from, {0, wide.y, 0}),
          space::plus(from, {0, 0, wide.z})};
}

Tetrahedron moved(Tetrahedron t, const Vector& by) {
  for (Vector& v : t) v = space::plus(v, by);
  return t;
}

}  // namespace

namespace {

/// A part of B and one of A.
struct CsgPosition {
  std::vector<MeetSet> moving, fixed;
  Tetrahedron about;                    // holds the part of B
  space::Extent box;                    // likewise
  TouchingConstraint in;                // the part of B
  std::vector<TouchingConstraint> out;  // what is cut out, negative inside
  const CsgPartSearch* part = nullptr;
};
struct CsgPositions {
  std::vector<CsgPosition> pairs;
  double size = 1;
};

/// Of one search.
class CsgConstraints : public LazyConstraints {
 public:
  explicit CsgConstraints(std::shared_ptr<const CsgPositions> all) : all_(std::move(all)) {
    for (const CsgPosition& pair : all_->pairs)
      common_.push_back(pair.part->places.also_in([this, &pair](const Vector& x) { return pair.in(x - at_); }));
  }

  /// Those of the pairs that nothing is cut out of as they are.
  Constraints constraints() override {
    Constraints out;
    out.more = this;
    for (std::size_t k = 0; k < all_->pairs.size(); ++k) {
      if (!all_->pairs[k].out.empty()) continue;
      const int number = static_cast<int>(cuts_.size());
      cuts_.push_back({k, {}, all_->pairs[k].part->box().low, 0});
      out.reverse_convex.push_back([this, number](const Vector& x) { return beyond(number, x); });
    }
    return out;
  }

  bool spent() const override { return cells_ > kMostCellsInAll; }

  double beyond(int number, const Vector& x) const override {
    return -slack(cuts_[static_cast<std::size_t>(number)], x).value;
  }

  std::vector<int> near(const Tetrahedron& cell, double edge, std::span<const int> known) override {
    const Vector middle = centre(cell);
    std::vector<int> out;
    for (std::size_t k = 0; k < all_->pairs.size(); ++k) {
      if (all_->pairs[k].out.empty() || apart(k, middle, edge)) continue;
      std::vector<Deep> cuts = moved_to(k, middle, edge, known);
      double checked = last_checked(k, known);
      const double deep = cuts.empty() ? 0 : cuts[0].slack;
      if (!apart(k, middle) && deep < edge && (cuts.empty() || edge < margin::kDeeperAgain * checked)) {
        checked = edge;
        const double enough = cuts.empty() ? -edge : cuts[0].slack;
        const Slack found = most(k, middle, {enough, 1, margin::kSlackOfCell * edge});
        if (found.value > enough) cuts.insert(cuts.begin(), {through(k, found.place), found.value});
      }
      for (Deep& cut : cuts) {
        out.push_back(static_cast<int>(cuts_.size()));
        cut.cut.checked = checked;
        cuts_.push_back(std::move(cut.cut));
        if (cut.slack > edge) return {out.back()};  // the cell is in it
      }
    }
    return out;
  }

  bool allows(const Vector& x, std::span<const int> known) const override {
    const double least = margin::kNoDepth * all_->size;
    for (std::size_t k = 0; k < all_->pairs.size(); ++k) {
      if (all_->pairs[k].out.empty() || apart(k, x)) continue;
      if (overlap(k, x, known)) return false;
    }
    for (std::size_t k = 0; k < all_->pairs.size(); ++k) {
      if (all_->pairs[k].out.empty() || apart(k, x)) continue;
      const Slack found = most(k, x, {least, 0, margin::kSlackOfCell * least});
      if (found.value > least) remember(through(k, found.place));
      if (found.bound > 2 * least) return false;
    }
    return true;
  }

 private:
  /// A convex subset of the part of A of a pair: what is beyond a plane for each set that is cut out.
  struct Cut {
    std::size_t pair = 0;
    std::vector<MeetSet> planes;
    Vector place;
    double checked = exact::kInfinity;  // the size of the cell in which deeper places than known were looked for
  };
  struct Deep {
    Cut cut;
    double slack = 0;
  };

  double last_checked(std::size_t k, std::span<const int> known) const {
    double least = exact::kInfinity;
    for (const int i : known) {
      const Cut& cut = cuts_[static_cast<std::size_t>(i)];
      if (cut.pair == k) least = std::min(least, cut.checked);
    }
    return least;
  }

  /// By more than `edge`, or touching.
  bool apart(std::size_t k, const Vector& p, double edge = 0) const {
    const CsgPosition& pair = all_->pairs[k];
    const Vector by{edge, edge, edge}, low = space::plus(pair.box.low, p) - by, high = space::plus(pair.box.high, p),
                                       &from = pair.part->box().low, to = space::plus(pair.part->box().high, by);
    return high.x <= from.x - edge || high.y <= from.y - edge || high.z <= from.z - edge || to.x <= low.x + edge ||
           to.y <= low.y + edge || to.z <= low.z + edge;
  }

  /// It costs about what a cell does.
  MeetSlack slack(const Cut& cut, const Vector& p) const {
    plane::count_cell();
    const CsgPosition& pair = all_->pairs[cut.pair];
    std::vector<MeetSet> sets;
    sets.reserve(pair.moving.size() + pair.fixed.size() + cut.planes.size());
    for (MeetSet set : pair.moving) {
      if (set.plane())
        set.by -= space::dot(set.at, p);
      else
        set.at = space::plus(set.at, p);
      sets.push_back(set);
    }
    sets.insert(sets.end(), pair.fixed.begin(), pair.fixed.end());
    sets.insert(sets.end(), cut.planes.begin(), cut.planes.end());
    return meet_slack(sets, moved(pair.about, p), cut.place);
  }

  /// What is beyond the tangents at x. A plane that is below a convex function is 0 where that is 0 or more.
  Cut through(std::size_t k, const Vector& x) const {
    Cut out{k, {}, x, exact::kInfinity};
    for (const TouchingConstraint& constraint : all_->pairs[k].out) {
      const Touching at = constraint(x);
      const double long_by = space::length(at.slope);
      if (!(long_by > 0)) continue;  // so deep inside that any plane will do: the place is not one of A
      const Vector away = space::scaled(-1 / long_by, at.slope);
      out.planes.push_back({false, away, -space::dot(away, x) - at.value / long_by});
    }
    return out;
  }

  /// The cut is moved to where it is deeper at p, as far as that goes; the slack.
  double deeper(Cut& cut, const Vector& p, double known) const {
    double best = known;
    for (int times = 0; times < kTimes; ++times) {
      const MeetSlack at = slack(cut, p);
      const bool more = at.value > best * margin::kDeeper;
      best = std::max(best, at.value);
      if (!more) break;
      cut = through(cut.pair, at.place);
    }
    return best;
  }

  /// The cuts that count near p, each where it is deepest there, the deepest one first.
  std::vector<Deep> moved_to(std::size_t k, const Vector& p, double edge, std::span<const int> known) const {
    std::vector<Deep> out;
    const auto look = [&](const Cut& cut, double least) {
      if (cut.pair != k) return;
      const MeetSlack at = slack(cut, p);
      if (at.value <= least) return;
      const auto same = [&](const Deep& d) {
        return space::length(d.cut.place - at.place) < margin::kOneDeepest * edge;
      };
      const auto twin = std::find_if(out.begin(), out.end(), same);
      if (twin == out.end())
        out.push_back({through(k, at.place), at.value});
      else if (twin->slack < at.value)
        *twin = {through(k, at.place), at.value};
    };
    for (const int i : known) look(cuts_[static_cast<std::size_t>(i)], -edge);
    for (const Cut& cut : recent_) look(cut, 0);
    std::sort(out.begin(), out.end(), [](const Deep& a, const Deep& b) { return a.slack > b.slack; });
    if (out.size() > kMostCuts) out.resize(kMostCuts);
    if (!out.empty() && out[0].slack > 0) out[0].slack = deeper(out[0].cut, p, out[0].slack);
    return out;
  }

  /// Whether a known cut, or one like it, tells so.
  bool overlap(std::size_t k, const Vector& p, std::span<const int> known) const {
    const double least = margin::kNoDepth * all_->size;
    const auto deep = [&](const Cut& cut) {
      if (cut.pair != k) return false;
      const MeetSlack at = slack(cut, p);
      if (at.value > least) return true;
      Cut next = through(k, at.place);
      return deeper(next, p, 0) > least;
    };
    return std::any_of(known.begin(), known.end(), [&](int i) { return deep(cuts_[static_cast<std::size_t>(i)]); }) ||
           std::any_of(recent_.begin(), recent_.end(), deep);
  }

  /// What cells do not know: it decided that a place is not allowed.
  void remember(Cut cut) const {
    if (recent_.size() == kRecent) recent_.pop_front();
    recent_.push_back(std::move(cut));
  }

  Slack most(std::size_t k, const Vector& p, const SlackEnd& end) const {
    at_ = p;
    const CsgPosition& pair = all_->pairs[k];
    const Slack out = common_[k].deepest(end, in_both(space::moved(pair.box, p), pair.part->box()));
    cells_ += out.cells;
    return out;
  }

  std::shared_ptr<const CsgPositions> all_;
  std::deque<Cut> cuts_;
  std::vector<PositionSet> common_;  // of what both parts of a pair hold
  mutable std::deque<Cut> recent_;
  mutable long cells_ = 0;  // of searches for deepest places
  mutable Vector at_;       // of B, for the constraints of common_
};

}  // namespace

exact::Tried<PositionSet> free_positions(const space::Body& b, const std::vector<CsgPartSearch>& parts, double size) {
  auto all = std::make_shared<CsgPositions>();
  all->size = size;
  const Vector far{exact::kInfinity, exact::kInfinity, exact::kInfinity};
  PositionSet::Box around{far, space::scaled(-1, far)};
  for (const BodyPart& s : b.parts) {
    const space::Extent box = space::rounded(bounds(space::body_of_part(s)));
    auto moving = meet_sets(s);
    if (!moving) return moving.refusal();
    for (const CsgPartSearch& part : parts) {
      CsgPosition& pair = all->pairs.emplace_back();
      pair.box = box;
      pair.about = about_box(box);
      pair.moving = *moving;
      for (const BodyPart& set : part.sets->within) {
        const auto fixed = meet_sets(set);
        if (!fixed) return fixed.refusal();
        pair.fixed.insert(pair.fixed.end(), fixed->begin(), fixed->end());
      }
      for (const BodyPart& set : part.sets->without) pair.out.push_back(gap_to(set, {}));
      pair.in = convex_constraint(s, {});
      pair.part = &part;
      around.add(space::difference(part.box(), box));
    }
  }
  return PositionSet::lazily(
      [all = std::shared_ptr<const CsgPositions>(std::move(all))] { return std::make_unique<CsgConstraints>(all); },
      around, size);
}

}  // namespace findspace::distance
