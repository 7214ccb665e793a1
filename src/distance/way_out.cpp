// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/way_out.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

#include "distance/site_pairs.h"

namespace findspace::distance {

using exact::RealPoint;
using plane::GridBox;
using plane::Mark;
using plane::Nearest;

namespace {

constexpr std::size_t kFewCurves = 100;      // arranged at once
constexpr std::size_t kManyCurves = 20000;   // not counted further
constexpr std::int64_t kSmallest = 4;        // of a box, in grid steps
constexpr int kVainHalvings = 4;             // that leave nearly all curves in the box: they run along each other
constexpr std::size_t kCurvesOfMap = 10000;  // a map of fewer is cheap
// What a map costs, in boxes: the square of the number of curves, in these.
constexpr double kCurvesPerBox = 1000;
constexpr double kRoom = 0x1p-40;  // of the coordinates: more than doubles lose, no sign

using Curves = std::vector<plane::ConvolutionIndex::Curve>;

struct Box {
  GridBox window;
  double distance;                                // from p, at most the true one
  std::size_t before;                             // curves of the box it is a half of
  int vain = 0;                                   // halvings in a row that left nearly all curves
  std::shared_ptr<const Curves> among = nullptr;  // all curves of the box it is a half of, if there are not many
  bool operator<(const Box& o) const { return distance > o.distance; }  // the nearest on top
};

/// Halves across the longer side.
std::array<GridBox, 2> halves(const GridBox& w) {
  std::array<GridBox, 2> out{w, w};
  if (w.x1 - w.x0 >= w.y1 - w.y0)
    out[0].x1 = out[1].x0 = w.x0 + (w.x1 - w.x0) / 2;
  else
    out[0].y1 = out[1].y0 = w.y0 + (w.y1 - w.y0) / 2;
  return out;
}

double distance_to(const GridBox& w, double x, double y) {
  double dx = std::max({double(w.x0) - x, x - double(w.x1), 0.0});
  double dy = std::max({double(w.y0) - y, y - double(w.y1), 0.0});
  double scale = std::abs(x) + std::abs(y) + std::abs(double(w.x0)) + std::abs(double(w.y0));
  return std::max(0.0, std::hypot(dx, dy) - scale * kRoom);
}

/// One of the vertices that stand for the pieces of a shape's boundary, moved by (dx, dy), lies deeper than `margin` in
/// the other shape (or outside it, if not `inside`).
bool has_vertex_deep(const SiteTree& of, const SiteTree& in, double dx, double dy, double margin, bool inside) {
  return std::any_of(of.representatives().begin(), of.representatives().end(), [&](plane::Index v) {
    const exact::Point& p = of.region().point(v);
    auto depth = depth_in(in, p.x + dx, p.y + dy);
    return depth && (inside ? *depth : -*depth) > margin;
  });
}

}  // namespace

WayOut::WayOut(const SiteTree& moving, const SiteTree& fixed, Of of, std::shared_ptr<const plane::LocalSum> sum,
               std::int64_t boxes)
    : moving_(moving),
      fixed_(fixed),
      of_(of),
      sum_(std::move(sum)),
      moving_disc_(inner_disc(moving)),
      fixed_disc_(inner_disc(fixed)),
      boxes_left_(boxes) {}

std::unique_ptr<const WayOut> WayOut::make(const SiteTree& moving, const SiteTree& fixed, Of of, When when) {
  const plane::Region &a = fixed.region(), &b = moving.region();
  auto sum = of == Of::kContact ? plane::LocalSum::contact(a, b) : plane::LocalSum::containment(a, b);
  if (!sum) return nullptr;
  const std::size_t curves = sum->index().convex_count();
  if (when == When::kPaying && sum->bounds() && curves < kCurvesOfMap) return nullptr;
  auto boxes = when == When::kAlways ? std::numeric_limits<std::int64_t>::max()
                                     : std::int64_t(std::pow(double(curves) / kCurvesPerBox, 2)) + 1;
  return std::unique_ptr<const WayOut>(new WayOut(moving, fixed, of, std::move(sum), boxes));
}

bool WayOut::certainly_holds(double x, double y, double reach) const {
  const double margin = reach + (moving_.scale() + fixed_.scale() + std::abs(x) + std::abs(y)) * kRoom;
  const bool contact = of_ == Of::kContact;
  auto meets = [&](const InnerDisc& d, const SiteTree& other, double dx, double dy, bool inside) {
    auto depth = d.radius > 0 ? depth_in(other, d.x + dx, d.y + dy) : std::nullopt;
    return depth && (inside ? *depth : -*depth) + d.radius > margin;
  };
  return meets(moving_disc_, fixed_, x, y, contact) || (contact && meets(fixed_disc_, moving_, -x, -y, true)) ||
         certainly_cross(fixed_, moving_, x, y, margin) || has_vertex_deep(moving_, fixed_, x, y, margin, contact) ||
         has_vertex_deep(fixed_, moving_, -x, -y, margin, true);
}

bool WayOut::certainly_holds(const GridBox& w) const {
  return certainly_holds((double(w.x0) + double(w.x1)) / 2, (double(w.y0) + double(w.y1)) / 2,
                         std::hypot(double(w.x1 - w.x0), double(w.y1 - w.y0)) / 2);
}

WayOut::Answer WayOut::nearest(const RealPoint& p) const {
  const double x = near_value(p.x), y = near_value(p.y);
  std::optional<Nearest> best;
  std::priority_queue<Box> boxes;
  if (sum_->bounds()) boxes.push({*sum_->bounds(), distance_to(*sum_->bounds(), x, y), kManyCurves});
  while (!boxes.empty()) {
    Box box = boxes.top();
    boxes.pop();
    if (best && box.distance > best->distance.to_double() * (1 + kRoom)) break;
    if (--boxes_left_ < 0) return {false, std::nullopt};
    if (certainly_holds(box.window)) continue;
    const GridBox& w = box.window;
    // A step more on every side: the map of a window says nothing certain about its border.
    const GridBox grown{w.x0 - 1, w.y0 - 1, w.x1 + 1, w.y1 + 1};
    auto curves = std::make_shared<const Curves>(box.among ? curves_in(sum_->index(), grown, *box.among)
                                                           : curves_in(sum_->index(), grown, kManyCurves));
    const std::size_t count = curves->size();
    const int vain = count < kManyCurves && count * 5 > box.before * 4 ? box.vain + 1 : 0;
    const bool small = std::max(w.x1 - w.x0, w.y1 - w.y0) <= kSmallest;
    if (count == kManyCurves)
      curves = small ? std::make_shared<const Curves>(curves_in(sum_->index(), grown, SIZE_MAX)) : nullptr;
    if (count < kFewCurves || vain == kVainHalvings || small) {
      plane::SignMap map =
          sum_->map(grown, *curves, [&](const exact::Point& q) { return certainly_holds(q.x, q.y, q.error); });
      auto near = plane::nearest(
          map, [](Mark m) { return m >= 0; }, p);
      if (near && (!best || near->distance < best->distance)) best = std::move(near);
      continue;
    }
    for (const GridBox& half : halves(w)) boxes.push({half, distance_to(half, x, y), count, vain, curves});
  }
  return {true, std::move(best)};
}

}  // namespace findspace::distance
