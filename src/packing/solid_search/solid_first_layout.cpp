// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "packing/solid_search/solid_first_layout.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

#include "exact/margins/packing.h"
#include "packing/search/box_list.h"
#include "packing/search/random.h"

namespace findspace::packing {
namespace {

constexpr std::size_t kCornersTried = 24, kRandomTried = 8;
constexpr std::size_t kCornersOfAll = 20000;  // fewer of each where parts are many
constexpr int kMostFalls = 6;
constexpr std::size_t kMostForms = 4;
constexpr std::size_t kMostFailures = 4;            // of copies of a part in a room
constexpr double kBoxRoom = 64;                     // for containers as many times as high as the floor is wide
constexpr std::uint64_t kWorkOfFirst = 20'000'000;  // boxes and planes: some tenths of a second
constexpr std::size_t kMostOrders = 32;
constexpr double kFarther = 0.01;  // of the floor: than a condition asks

/// What parts are sorted by: their boxes' volumes, heights, bases, longest sides, values, values for their volume; then
/// the first or the last of these times random factors. Values count where parts may be left out.
std::vector<double> keys_of(const SolidTable& table, const std::vector<double>& values, bool by_value,
                            std::size_t number, Random& random) {
  std::vector<double> keys;
  for (std::size_t part = 0; part < values.size(); ++part) {
    if (table.variants_of(part).empty()) {
      keys.push_back(0);
      continue;
    }
    const SolidVariant& v = table.variants()[table.variants_of(part)[0]];
    const Vector s = v.high - v.low;
    const double volume = s.x * s.y * s.z;
    const std::array<double, 6> fixed{
        volume, s.z, s.x * s.y, std::max({s.x, s.y, s.z}), values[part], values[part] / volume};
    if (number < (by_value ? 6 : 4))
      keys.push_back(fixed[number]);
    else
      keys.push_back((by_value && number % 2 == 1 ? fixed[5] : volume) * random.between(0.3, 1));
  }
  return keys;
}

class SolidBuilder {
 public:
  SolidBuilder(const SolidProblem& problem, const SolidTable& table, const SolidColumn& column, Random& random)
      : problem_(problem),
        table_(table),
        column_(column),
        random_(random),
        shallow_(table.size() * margin::kNoOverlap),
        boxes_(problem.items() + column.obstacles().size()),
        corners_(std::clamp<std::size_t>(kCornersOfAll / std::max<std::size_t>(problem.items(), 1), 2, kCornersTried)) {
    for (const Room<Vector>& room : column.rooms().all()) tops_.push_back(room.low.z);
    result_.layout.length = column.fixed_end();
    for (std::size_t k = 0; k < column.obstacles().size(); ++k) add_obstacle(k);
    first_room_.resize(problem.parts.size());
    failures_.resize(problem.parts.size());
  }

  /// Those of the greatest keys first.
  FirstLayoutOf<SolidPose> build(const std::vector<double>& keys) {
    std::vector<std::size_t> order(problem_.parts.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t p, std::size_t q) { return keys[p] > keys[q]; });
    for (const std::size_t part : order)
      for (int copy = 0; copy < problem_.free_copies(part); ++copy)
        if (!place(part)) result_.left.push_back(part);
    return std::move(result_);
  }
  std::uint64_t work() const { return work_; }

 private:
  void add_obstacle(std::size_t k) {
    const SolidPose& pose = column_.obstacles()[k];
    boxes_.put(problem_.items() + k, box_at(pose.variant, pose.at, shallow_));
    if (k >= column_.fixed_rooms().size()) return;  // walls
    double& top = tops_[column_.fixed_rooms()[k]];
    top = std::max(top, pose.at.z + table_.variants()[pose.variant].high.z);
  }
  /// What has this number among the boxes: parts that stand, then obstacles.
  const SolidPose& standing(std::size_t j) const {
    const std::size_t items = problem_.items();
    return j < items ? result_.layout.poses[j] : column_.obstacles()[j - items];
  }

  /// In the first room that has a place, in the form in which it comes to stand lowest; some of them where there are
  /// many.
  bool place(std::size_t part) {
    std::vector<std::size_t> variants = table_.variants_of(part);
    for (std::size_t k = variants.size(); k > 1; --k) std::swap(variants[k - 1], variants[random_.below(k)]);
    // Where some copies of the part found no place, the next is not tried.
    for (std::size_t room = first_room_[part]; room < tops_.size(); ++room) {
      best_top_ = std::numeric_limits<double>::infinity();
      best_fails_ = true;
      std::size_t forms = 0;
      for (std::size_t k = 0; k < variants.size() && forms < kMostForms; ++k) {
        if (!fits(variants[k], column_.rooms()[room])) continue;
        try_form(variants[k], room);
        if (best_fails_ && table_.has_ties()) try_far(variants[k], room);
        ++forms;
      }
      if (best_top_ == std::numeric_limits<double>::infinity()) {
        if (room == first_room_[part] && ++failures_[part] % kMostFailures == 0) ++first_room_[part];
        continue;
      }
      auto& poses = result_.layout.poses;
      boxes_.put(poses.size(), box_at(best_.variant, best_.at, shallow_));
      poses.push_back(best_);
      rooms_.push_back(room);
      result_.overlaps |= best_fails_;
      tops_[room] = std::max(tops_[room], best_top_);
      result_.layout.length = std::max(result_.layout.length, best_top_);
      return true;
    }
    return false;
  }

  bool fits(std::size_t variant, const Room<Vector>& room) const {
    const SolidVariant& v = table_.variants()[variant];
    const Vector out = (v.high - v.low) - (room.high - room.low);
    return out.x <= shallow_ && out.y <= shallow_ && out.z <= shallow_;
  }

  /// From these coordinates of its origin, as far as the room lets it, it falls.
  void attempt(std::size_t variant, std::size_t room_number, double x, double y, double z) {
    const SolidVariant& v = table_.variants()[variant];
    const Room<Vector>& room = column_.rooms()[room_number];
    const Vector start{std::max(-v.low.x, std::min(x, room.high.x - v.high.x)),
                       std::max(-v.low.y, std::min(y, room.high.y - v.high.y)),
                       std::max(room.low.z - v.low.z, std::min(z, room.high.z - v.high.z))};
    const double floor = room.low.z - v.low.z;
    // Between walls that bend inwards it need not come from above.
    if (column_.has_walls(room_number))
      return attempt_on_line(variant, room, {start.x, start.y, floor}, {0, 0, 1}, room.high.z - v.high.z - floor);
    // Above all that stands it is free.
    if (start.z + v.low.z < tops_[room_number] + table_.gap() && !is_free(variant, start)) return;
    offer_from(variant, room, start);
  }

  /// At the first free place of a line, at + t way, t up to `most`.
  void attempt_on_line(std::size_t variant, const Room<Vector>& room, const Vector& at, const Vector& way,
                       double most) {
    if (const auto t = first_free(variant, at, way, most)) offer_from(variant, room, at + *t * way);
  }

  /// Where walls bend inwards, corners of the box are not free: the first places from its left and back on.
  void attempt_between_walls(std::size_t variant, const Room<Vector>& room, double x, double y) {
    const SolidVariant& v = table_.variants()[variant];
    const Vector low = room.low - v.low, high = room.high - v.high;
    attempt_on_line(variant, room, {low.x, std::clamp(y, low.y, std::max(low.y, high.y)), low.z}, {1, 0, 0},
                    high.x - low.x);
    attempt_on_line(variant, room, {std::clamp(x, low.x, std::max(low.x, high.x)), low.y, low.z}, {0, 1, 0},
                    high.y - low.y);
  }

  /// Where it settles; before it slides a condition may hold that contacts break.
  void offer_from(std::size_t variant, const Room<Vector>& room, const Vector& start) {
    const Vector down = start - Vector{0, 0, free_fall(variant, room, start)};
    if (table_.has_ties()) offer(variant, down);
    offer(variant, settled(variant, room, down));
  }

  void offer(std::size_t variant, const Vector& at) {
    const SolidVariant& v = table_.variants()[variant];
    const double top = at.z + v.high.z;
    const bool fails = table_.has_ties() && !ties_hold({variant, at});
    if (fails && (problem_.in_containers() || !best_fails_)) return;
    if (fails < best_fails_ || top < best_top_ || (top == best_top_ && at.x + at.y < best_.at.x + best_.at.y)) {
      best_fails_ = fails;
      best_top_ = top;
      best_ = {variant, at};
    }
  }

  /// With all that stand already.
  bool ties_hold(const SolidPose& pose) const {
    const auto hold = [&](const SolidPose& other) {
      if (!table_.are_tied(other.variant, pose.variant)) return true;
      work_ += kWorkOfTie;
      return table_.slack(other.variant, pose.variant, pose.at - other.at) >= 0;
    };
    const auto &poses = result_.layout.poses, &obstacles = column_.obstacles();
    return std::all_of(poses.begin(), poses.end(), hold) && std::all_of(obstacles.begin(), obstacles.end(), hold);
  }

  void try_form(std::size_t variant, std::size_t room_number) {
    const SolidVariant& v = table_.variants()[variant];
    const Room<Vector>& room = column_.rooms()[room_number];
    const double top = tops_[room_number] + table_.gap() - v.low.z;
    const auto fall = [&](double x, double y) {
      attempt(variant, room_number, x, y, top);
      if (column_.has_walls(room_number)) attempt_between_walls(variant, room, x, y);
    };
    const Vector middle = 0.5 * (room.low + room.high - v.low - v.high);
    if (column_.is_round(room_number)) fall(middle.x, middle.y);
    fall(-v.low.x, -v.low.y);
    fall(room.high.x, -v.low.y);
    fall(-v.low.x, room.high.y);
    fall(room.high.x, room.high.y);
    const auto& poses = result_.layout.poses;
    for (std::size_t k = 0; k < std::min(poses.size(), corners_); ++k) {
      const std::size_t j = poses.size() <= corners_ ? k : random_.below(poses.size());
      try_beside(variant, room_number, poses[j], rooms_[j]);
    }
    for (std::size_t k = 0; k < column_.fixed_rooms().size(); ++k) {
      try_beside(variant, room_number, column_.obstacles()[k], column_.fixed_rooms()[k]);
      if (column_.fixed_rooms()[k] == room_number) try_below(variant, room_number, column_.obstacles()[k]);
    }
    for (std::size_t k = 0; k < kRandomTried; ++k) {
      const double x = random_.between(-v.low.x, room.high.x - v.high.x);
      fall(x, random_.between(-v.low.y, room.high.y - v.high.y));
    }
  }

  /// As far above all that stands as any condition asks, or under the lid: there solids that must be apart are so.
  void try_far(std::size_t variant, std::size_t room_number) {
    const SolidVariant& v = table_.variants()[variant];
    const Room<Vector>& room = column_.rooms()[room_number];
    const double far = table_.gap() + table_.greatest_level() + kFarther * table_.size();
    const double z = std::min(tops_[room_number] + far - v.low.z, room.high.z - v.high.z);
    for (const double x : {-v.low.x, room.high.x - v.high.x})
      for (const double y : {-v.low.y, room.high.y - v.high.y})
        if (is_free(variant, {x, y, z})) offer(variant, {x, y, z});
  }

  /// Behind or beside the box of what stands in a room.
  void try_beside(std::size_t variant, std::size_t room_number, const SolidPose& other, std::size_t room_of_other) {
    const SolidVariant &v = table_.variants()[variant], &w = table_.variants()[other.variant];
    const Vector low = other.at + w.low - v.low, high = other.at + w.high - v.low;
    const double top = tops_[room_number] + table_.gap() - v.low.z;
    attempt(variant, room_number, high.x, low.y, top);
    attempt(variant, room_number, low.x, high.y, top);
    if (!problem_.in_containers() || room_of_other != room_number || column_.has_walls(room_number)) return;
    // Under the lid: from its floor, and upon it.
    attempt(variant, room_number, high.x + table_.gap(), low.y, low.z);
    attempt(variant, room_number, low.x, high.y + table_.gap(), low.z);
    attempt(variant, room_number, low.x, low.y, high.z + table_.gap());
  }

  /// Under the box of an obstacle, which need not stand on anything: at the room's corner, and at that of the box.
  void try_below(std::size_t variant, std::size_t room_number, const SolidPose& obstacle) {
    const SolidVariant &v = table_.variants()[variant], &w = table_.variants()[obstacle.variant];
    const Vector low = obstacle.at + w.low - v.low;
    const double z = obstacle.at.z + w.low.z - table_.gap() - v.high.z;
    attempt(variant, room_number, -v.low.x, -v.low.y, z);
    attempt(variant, room_number, low.x, low.y, z);
  }

  bool is_free(std::size_t variant, const Vector& at) const {
    return boxes_.for_each_meeting(box_at(variant, at, table_.gap()), work_, [&](std::size_t j) {
      const SolidPose& other = standing(j);
      const auto [pair, sign] = table_.link(other.variant, variant);
      work_ += pair.overlaps.size();
      return pair.depth(sign * (at - other.at), shallow_) <= 0;
    });
  }

  double free_fall(std::size_t variant, const Room<Vector>& room, const Vector& at) const {
    return free_way(variant, at, {0, 0, -1}, at.z + table_.variants()[variant].low.z - room.low.z);
  }

  /// Where it has come down it slides back and left, as long as that lets it fall again.
  Vector settled(std::size_t variant, const Room<Vector>& room, Vector at) const {
    const SolidVariant& v = table_.variants()[variant];
    for (int k = 0; k < kMostFalls; ++k) {
      at = at - Vector{0, free_way(variant, at, {0, -1, 0}, at.y + v.low.y), 0};
      at = at - Vector{free_way(variant, at, {-1, 0, 0}, at.x + v.low.x), 0, 0};
      const double fall = free_fall(variant, room, at);
      if (fall <= table_.size() * margin::kSolidContact) break;
      at = at - Vector{0, 0, fall};
    }
    return at;
  }

  BoxList<3>::Box box_at(std::size_t variant, const Vector& at, double wider) const {
    const SolidVariant& v = table_.variants()[variant];
    const double w = wider + table_.size() * margin::kBoxRounding * kBoxRoom;
    const Vector low = at + v.low, high = at + v.high;
    return {{float(low.x - w), float(low.y - w), float(low.z - w)},
            {float(high.x + w), float(high.y + w), float(high.z + w)}};
  }

  /// The first place of a line, at + t way, at which it is free, of those from 0 to `most`.
  std::optional<double> first_free(std::size_t variant, const Vector& at, const Vector& way, double most) const {
    std::vector<space::LineStretch> taken;
    for_each_stretch(variant, at, way, most, [&](const space::LineStretch& t) { taken.push_back(t); });
    std::sort(taken.begin(), taken.end(), [](const auto& a, const auto& b) { return a.from < b.from; });
    double t = 0;
    for (const space::LineStretch& stretch : taken)
      if (stretch.from < t + shallow_) t = std::max(t, stretch.to);
    return t <= most + shallow_ && is_free(variant, at + t * way) ? std::optional(t) : std::nullopt;
  }

  /// How far it can go from a free place.
  double free_way(std::size_t variant, const Vector& at, const Vector& way, double most) const {
    for_each_stretch(variant, at, way, most, [&](const space::LineStretch& t) {
      if (t.to > shallow_ && t.from < most) most = std::max(t.from, 0.0);
    });
    return std::max(most, 0.0);
  }

  /// Visits where a line of places, of length `most`, overlaps what stands.
  template <class Visit>
  void for_each_stretch(std::size_t variant, const Vector& at, const Vector& way, double most,
                        const Visit& visit) const {
    const BoxList<3>::Box here = box_at(variant, at, table_.gap()),
                          there = box_at(variant, at + most * way, table_.gap());
    BoxList<3>::Box swept;
    for (std::size_t k = 0; k < 3; ++k) {
      swept.low[k] = std::min(here.low[k], there.low[k]);
      swept.high[k] = std::max(here.high[k], there.high[k]);
    }
    boxes_.for_each_meeting(swept, work_, [&](std::size_t j) {
      const SolidPose& other = standing(j);
      const auto [pair, sign] = table_.link(other.variant, variant);
      const Vector u = sign * (at - other.at), along = sign * way;
      for (const ConvexOverlap& overlap : pair.overlaps) {
        const Vector low = overlap.low, high = overlap.high;
        ++work_;
        if (way.x == 0 && !(u.x > low.x && u.x < high.x)) continue;
        if (way.y == 0 && !(u.y > low.y && u.y < high.y)) continue;
        if (way.z == 0 && !(u.z > low.z && u.z < high.z)) continue;
        overlap.for_each_stretch(u, along, 0.5 * shallow_, visit);
      }
      return true;
    });
  }

  const SolidProblem& problem_;
  const SolidTable& table_;
  const SolidColumn& column_;
  Random& random_;
  double shallow_;
  mutable std::uint64_t work_ = 0;
  BoxList<3> boxes_;
  std::size_t corners_;
  std::vector<double> tops_;                        // of what stands in each room
  std::vector<std::size_t> rooms_;                  // of what stands
  std::vector<std::size_t> first_room_, failures_;  // of each part
  SolidPose best_;                                  // of the part that is being placed
  double best_top_ = 0;
  bool best_fails_ = false;  // a condition of pairs
  FirstLayoutOf<SolidPose> result_;
};

}  // namespace

std::vector<double> values_of(const SolidProblem& problem) {
  std::vector<double> values;
  for (const SolidPart& part : problem.parts)
    values.push_back(part.value ? part.value->to_double() : volume_of(problem, part));
  return values;
}

FirstLayoutOf<SolidPose> first_layout(const SolidProblem& problem, const SolidTable& table, const SolidColumn& column,
                                      std::uint64_t seed) {
  Random random(seed);
  const std::vector<double> values = values_of(problem);
  FirstLayoutOf<SolidPose> best;
  double least = 0;
  std::uint64_t work = 0;
  for (std::size_t number = 0; number == 0 || (number < kMostOrders && work < kWorkOfFirst); ++number) {
    SolidBuilder builder(problem, table, column, random);
    FirstLayoutOf<SolidPose> layout = builder.build(keys_of(table, values, problem.in_containers(), number, random));
    work += builder.work();
    double lost = 0;
    for (const std::size_t part : layout.left) lost += values[part];
    const auto worse = [&] {
      if (lost != least) return lost > least;
      if (layout.overlaps != best.overlaps) return layout.overlaps;
      return layout.layout.length >= best.layout.length;
    };
    if (number > 0 && worse()) continue;
    best = std::move(layout);
    least = lost;
  }
  return best;
}

}  // namespace findspace::packing
