// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "packing/search/make_room.h"

#include <findspace/error.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "exact/margins/packing.h"
#include "packing/compaction/finish.h"
#include "packing/search/separation.h"
#include "packing/search/tilting.h"

namespace findspace::packing {
namespace {

constexpr Patience kRoomPatience{100, 2};

class RoomMaker {
 public:
  RoomMaker(const Problem& problem, const Layout& layout, std::size_t item)
      : problem_(problem), table_(problem), row_(problem, table_, layout.sheets) {
    const std::vector<const Placed*> movable = movable_items(problem, table_, layout);
    item_ = std::size_t(std::find(movable.begin(), movable.end(), &layout.items[item]) - movable.begin());
    poses_ = poses_of(problem, table_, row_, layout);
    length_ = problem.on_sheets() ? row_.rooms().end() : (layout.length - problem.edge - problem.edge).to_double();
  }

  /// Whether the item can stand anywhere.
  bool fits() const { return item_ < poses_.size(); }

  /// The layout with its overlaps taken out, in a strip as much longer as that needs.
  std::optional<Layout> separated() const {
    constexpr std::array<double, 7> kLonger{1, 1.02, 1.05, 1.1, 1.25, 1.5, 2};
    for (const double longer : kLonger) {
      std::vector<Pose> poses = inside(length_ * longer);
      LinearMoves moves(table_, row_);
      double reached = length_ * longer;
      if (!moves.separate(poses, reached, length_ * longer)) continue;
      if (auto made = finished(problem_, table_, row_, poses, moves.shorten(poses, reached))) return made;
    }
    return std::nullopt;
  }

  /// The layout with what overlaps the item set behind the end of the strip, then shortened.
  std::optional<Layout> set_aside() const {
    double length = length_;
    std::vector<Pose> poses = poses_;
    poses[item_] = inside(length)[item_];
    const double touching = table_.height() * margin::kNoOverlap;
    for (std::size_t k = 0; k < poses.size(); ++k) {
      if (k == item_ || table_.depth(poses[k], poses[item_]) <= touching) continue;
      const Variant& variant = table_.variants()[poses[k].variant];
      poses[k].at = {length + table_.gap() - variant.low.x, -variant.low.y};
      length = poses[k].at.x + variant.high.x;
    }
    LinearMoves moves(table_, row_);
    return finished(problem_, table_, row_, poses, moves.shorten(poses, length));
  }

  /// On the sheets that are used: as it is, or with its overlaps taken out by small moves, or by a search.
  std::optional<Layout> on_its_sheets() const {
    std::vector<Pose> poses = inside(length_);
    if (auto made = finished(problem_, table_, row_, poses, length_)) return made;
    double reached = length_;
    if (LinearMoves(table_, row_).separate(poses, reached, length_))
      if (auto made = finished(problem_, table_, row_, poses, reached)) return made;
    Random random(1);
    SeparationOf<PlaneKit> separation(table_, row_, inside(length_), length_, random);
    separation.begin(inside(length_), length_, length_);
    using State = SeparationOf<PlaneKit>::State;
    State state = State::kUnderWay;
    while (state == State::kUnderWay) state = separation.pass(kRoomPatience);
    if (state == State::kStuck) return std::nullopt;
    return finished(problem_, table_, row_, separation.free().poses, separation.free().length);
  }

 private:
  std::vector<Pose> inside(double length) const {
    const Arrangement strip(table_, row_, poses_, length);
    std::vector<Pose> poses = poses_;
    for (Pose& pose : poses) pose.at = strip.inside(pose.variant, pose.at);
    return poses;
  }

  const Problem& problem_;
  FieldTable table_;
  Row row_;
  std::size_t item_ = 0;
  std::vector<Pose> poses_;
  double length_ = 0;
};

Fraction on_grid(const Problem& problem, double coordinate) {
  const double steps = std::round(coordinate * double(problem.steps()));
  if (!(std::abs(steps) < margin::kFarthestItem))
    throw Error(ErrorCode::kOutOfRange, "an item cannot be moved that far");
  return Fraction(int128(steps), problem.steps());
}

}  // namespace

std::optional<Layout> with_room(const Problem& problem, const Layout& layout, std::size_t item,
                                std::array<double, 2> at) {
  if (problem.box) {
    Problem strip = problem;
    strip.box = false;
    strip.height = layout.height;
    std::optional<Layout> made = with_room(strip, layout, item, at);
    if (made) made->height = top_of(problem, *made);
    return made;
  }
  Layout moved = layout;
  moved.items[item].x = on_grid(problem, at[0]);
  moved.items[item].y = on_grid(problem, at[1]);
  for (const FixedPart& fixed : problem.fixed)
    if (is_fixed_part(moved, moved.items[item], fixed)) return std::nullopt;
  const Problem standing = with_angles_of(problem, layout);  // of tilted parts
  const RoomMaker maker(standing, moved, item);
  if (!maker.fits()) return std::nullopt;
  if (problem.on_sheets()) return maker.on_its_sheets();
  auto made = maker.separated();
  return made ? made : maker.set_aside();
}

}  // namespace findspace::packing
