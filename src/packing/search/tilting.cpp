// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "packing/search/tilting.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "exact/margins/packing.h"
#include "packing/compaction/finish.h"
#include "packing/compaction/tilting_moves.h"

namespace findspace::packing {
namespace {

constexpr double kTrust = 0.02;  // of the height
constexpr int kMostPrograms = 200;
constexpr std::int64_t kAnglesInDegree = 1000000;
constexpr double kDegree = std::numbers::pi / 180;

/// An item at an angle and a position in the row.
struct Tilted {
  std::size_t part = 0;
  Fraction angle;
  bool mirrored = false;
  Vec at;
};

/// A problem whose parts have the angles of a layout, and what the programs need of it.
struct Setting {
  Setting(Problem of, const std::vector<std::size_t>& sheets)
      : problem(std::move(of)), table(problem), row(problem, table, sheets) {}

  const Problem problem;
  const FieldTable table;
  const Row row;
};

TiltRange range_of(const Part& part, const Fraction& angle) {
  const Fraction off = part.nearest_angle(angle).by;
  return {std::min(0.0, -(part.tilt + off).to_double()) * kDegree,
          std::max(0.0, (part.tilt - off).to_double()) * kDegree};
}

/// On a grid of angles, and within the tilt.
Fraction rotated_by(const Part& part, const Fraction& angle, double by) {
  const std::int64_t steps = std::llround(by / kDegree * double(kAnglesInDegree));
  const Part::Off off = part.nearest_angle(angle);
  const Fraction wanted = off.by + Fraction(steps, kAnglesInDegree);
  return part.angles[off.angle] + std::clamp(wanted, Fraction() - part.tilt, part.tilt);
}

void add_angle(Part& part, const Fraction& angle) {
  if (std::find(part.angles.begin(), part.angles.end(), angle) == part.angles.end()) part.angles.push_back(angle);
}

class Tilting {
 public:
  Tilting(const Problem& problem, Layout layout) : problem_(problem), layout_(std::move(layout)) {
    Problem now = problem_;
    for (Part& part : now.parts) part.angles.clear();
    for (const Placed& item : layout_.items) add_angle(now.parts[item.part], item.angle);
    setting_ = settle(std::move(now));
  }

  const Layout& layout() const { return layout_; }
  double length() const { return layout_.length.to_double(); }

  /// Whether the layout has become shorter.
  bool step(double trust) {
    const std::vector<const Placed*> items = movable_items(problem_, setting_->table, layout_);
    const std::vector<Pose> poses = poses_of(setting_->problem, setting_->table, setting_->row, layout_);
    std::vector<TiltRange> ranges;
    for (const Placed* item : items) ranges.push_back(range_of(problem_.parts[item->part], item->angle));
    const double length = length_of(poses);
    const auto moves = TiltingMoves(setting_->table, setting_->row).shorten(poses, ranges, length, trust * height());
    if (!moves) return false;
    std::vector<Tilted> tilted;
    for (std::size_t i = 0; i < items.size(); ++i) {
      const Variant& v = setting_->table.variants()[poses[i].variant];
      const auto& [at, angle] = (*moves)[i];
      tilted.push_back({v.part, rotated_by(problem_.parts[v.part], v.angle, angle), v.mirrored, at});
    }
    return take(tilted, length);
  }

 private:
  double height() const { return setting_->table.height(); }

  double length_of(const std::vector<Pose>& poses) const {
    double length = setting_->row.fixed_end();
    for (const Pose& pose : poses)
      length = std::max(length, pose.at.x + setting_->table.variants()[pose.variant].high.x);
    return length;
  }

  std::unique_ptr<const Setting> settle(Problem problem) const {
    for (std::size_t p = 0; p < problem.parts.size(); ++p)
      if (problem.parts[p].angles.empty()) problem.parts[p].angles = problem_.parts[p].angles;  // of what is left out
    return std::make_unique<const Setting>(std::move(problem), layout_.sheets);
  }

  /// Overlaps that the rotations left are taken away, as far as the length allows.
  bool take(const std::vector<Tilted>& items, double length) {
    Problem next = problem_;
    for (Part& part : next.parts) part.angles.clear();
    for (const Tilted& item : items) add_angle(next.parts[item.part], item.angle);
    auto setting = settle(std::move(next));
    std::vector<Pose> poses;
    for (const Tilted& item : items)
      poses.push_back(setting->table.pose_of(item.part, item.angle, item.mirrored, item.at));
    LinearMoves moves(setting->table, setting->row);
    double reached = length;
    if (!moves.separate(poses, reached, length)) return false;
    reached = moves.shorten(poses, reached);
    if (length - reached < margin::kCompactionGain * length) return false;
    std::optional<Layout> made = finished(setting->problem, setting->table, setting->row, poses, reached);
    if (!made || made->sheets != layout_.sheets || !(made->length < layout_.length)) return false;
    made->left_out = layout_.left_out;
    layout_ = std::move(*made);
    setting_ = std::move(setting);
    return true;
  }

  const Problem& problem_;
  Layout layout_;
  std::unique_ptr<const Setting> setting_;
};

}  // namespace

bool may_tilt(const Problem& problem) {
  return std::any_of(problem.parts.begin(), problem.parts.end(), [](const Part& part) { return part.tilt > 0; });
}

Problem with_angles_of(const Problem& problem, const Layout& layout) {
  Problem result = problem;
  for (const Placed& item : layout.items)
    if (problem.parts[item.part].allows(item.angle, item.mirrored)) add_angle(result.parts[item.part], item.angle);
  return result;
}

Layout tilted(const Problem& problem, Layout layout, const std::function<void(const Layout&)>& better,
              const std::function<bool()>& is_over) {
  Tilting tilting(problem, std::move(layout));
  double trust = kTrust, begun = tilting.length();  // of a round: from large steps to small ones
  for (int program = 0; program < kMostPrograms && !is_over(); ++program) {
    const double before = tilting.length();
    if (tilting.step(trust)) better(tilting.layout());
    if (before - tilting.length() >= margin::kTiltGain * before) continue;
    trust /= 2;
    if (trust >= margin::kLeastTilt) continue;
    if (begun - tilting.length() < margin::kTiltRoundGain * begun) break;
    trust = kTrust;
    begun = tilting.length();
  }
  return tilting.layout();
}

}  // namespace findspace::packing
