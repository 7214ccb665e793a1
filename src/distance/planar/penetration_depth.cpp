// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/planar/penetration_depth.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "exact/margins/planar_distance.h"
#include "plane/base/subdivide.h"
#include "plane/query/topology.h"

namespace findspace::distance {

using exact::RealPoint;
using plane::GridBox;
using plane::Mark;
using plane::Nearest;

namespace {

constexpr std::size_t kFewCurves = 100;     // arranged at once
constexpr std::size_t kManyCurves = 20000;  // not counted further
constexpr std::int64_t kSmallest = 4;       // of a box, in grid steps
constexpr std::size_t kCornersTried = 32;   // of each shape
constexpr int kVainHalvings = 2;            // that leave nearly all curves in both halves: they run along each other
constexpr std::size_t kFewLooks = 200, kTimesUsualLooks = 4;
constexpr std::size_t kCurvesOfMap = 10000;      // a map of fewer is cheap
constexpr std::size_t kCurvesOfArcMap = 2000;    // with arcs, or where one shape could go round a hole of the other
constexpr std::size_t kCurvesCounted = 500'000;  // a map of so many is not made
constexpr std::size_t kPairsOfMap = 5000;        // of edges: there are no more curves
// What a map costs, in boxes: the square of the number of curves, in these.
constexpr double kCurvesPerBox = 1000, kCurvesPerArcBox = 500;

/// The vertex farthest from p among those whose mark is not negative.
std::optional<Nearest> farthest_vertex(const plane::SignMap& map, const RealPoint& p) {
  const double x = near_value(p.x), y = near_value(p.y);
  double most = -1, scale = std::abs(x) + std::abs(y);
  auto number = [&](const plane::Vertex& v) {
    const exact::Point& q = map.geometry.points[v.point];
    scale = std::max({scale, std::abs(q.x), std::abs(q.y)});
    return std::hypot(q.x - x, q.y - y);
  };
  for (const plane::Vertex& v : map.vertices)
    if (v.mark >= 0) most = std::max(most, number(v));
  std::optional<Nearest> best;
  for (plane::Index k = 0; k < map.vertices.size(); ++k) {
    const plane::Vertex& v = map.vertices[k];
    if (v.mark < 0 || number(v) < most - (scale + most) * margin::kDepthTolerance) continue;
    RealPoint at = map.geometry.exact(v.point);
    exact::Real dx = at.x - p.x, dy = at.y - p.y, d = sqrt(dx * dx + dy * dy);
    if (!best || d > best->distance) best = Nearest{d, at, {0, k}};
  }
  return best;
}

/// Curves of the boundary of grid polygons, arranged.
class GridPlaces {
 public:
  using Curves = std::vector<plane::ConvolutionIndex::Curve>;
  GridPlaces(const plane::LocalSum& sum, const RealPoint& p) : sum_(sum), p_(p) {}

  /// Whether there are so many, where that is seen without looking at them.
  bool surely_has(std::size_t curves, const GridBox& w) const { return sum_.surely_has(curves, w); }
  Curves curves_in(const GridBox& w, std::size_t most) const { return plane::curves_in(sum_.index(), w, most); }
  Curves curves_in(const GridBox& w, const Curves& among) const { return plane::curves_in(sum_.index(), w, among); }
  std::optional<Nearest> best(const GridBox& w, const Curves& curves, bool far,
                              const plane::FreePlaces::Certain& certain) const {
    const plane::SignMap map =
        sum_.map(w, curves, [&](const exact::Point& q) { return certain.held(q.x, q.y, q.error); });
    return far ? farthest_vertex(map, p_)
               : nearest(
                     map, [](Mark m) { return m >= 0; }, p_);
  }

 private:
  const plane::LocalSum& sum_;
  const RealPoint& p_;
};

/// Contact curves of sets of any kind, their meetings tried.
class CurvePlaces {
 public:
  using Curves = plane::FreePlaces::Curves;
  CurvePlaces(const plane::FreePlaces& places, const RealPoint& p) : places_(places), from_(places, p) {}

  static bool surely_has(std::size_t, const GridBox&) { return false; }
  Curves curves_in(const GridBox& w, std::size_t most) const { return places_.curves_in(w, most); }
  Curves curves_in(const GridBox& w, const Curves& among) const { return places_.curves_in(w, among); }
  std::optional<Nearest> best(const GridBox& w, const Curves& curves, bool far,
                              const plane::FreePlaces::Certain& certain) const {
    return from_.best(w, curves, far, certain);
  }

 private:
  const plane::FreePlaces& places_;
  plane::FreePlaces::From from_;
};

template <class Curves>
struct Box {
  GridBox window;
  double bound;     // no position in it is better: the least distance from p, or minus the greatest
  int vain = 0;     // vain halvings in a row, before the one that made it
  GridBox other{};  // the other half of the box it is a half of
  std::shared_ptr<const Curves> among = nullptr;  // all curves of the box it is a half of, if there are not many
  bool operator<(const Box& o) const { return bound > o.bound; }  // the best on top
  void draw(plane::ObservedCells& seen) const {
    seen.add_box({double(window.x0), double(window.y0), 0}, {double(window.x1), double(window.y1), 0});
  }
};

bool is_wide(const GridBox& w) { return w.x1 - w.x0 >= w.y1 - w.y0; }

/// Left and right halves, or lower and upper ones.
std::array<GridBox, 2> halves(const GridBox& w, bool across_x) {
  std::array<GridBox, 2> out{w, w};
  if (across_x)
    out[0].x1 = out[1].x0 = w.x0 + (w.x1 - w.x0) / 2;
  else
    out[0].y1 = out[1].y0 = w.y0 + (w.y1 - w.y0) / 2;
  return out;
}

double bound(const GridBox& w, double x, double y, bool far) {
  const double left = double(w.x0) - x, right = x - double(w.x1), low = double(w.y0) - y, high = y - double(w.y1);
  const double tolerance =
      (std::abs(x) + std::abs(y) + std::abs(double(w.x0)) + std::abs(double(w.y0))) * margin::kDepthTolerance;
  if (far) return -std::hypot(std::min(left, right), std::min(low, high)) - tolerance;
  return std::max(0.0, std::hypot(std::max({left, right, 0.0}), std::max({low, high, 0.0})) - tolerance);
}

/// A step more on every side: the map of a window says nothing certain about its border.
GridBox grown(const GridBox& w) { return {w.x0 - 1, w.y0 - 1, w.x1 + 1, w.y1 + 1}; }

/// One of the vertices that stand for the pieces of a shape's boundary, moved by (dx, dy), lies deeper than `margin` in
/// the other shape (or outside it, if not `inside`).
bool has_vertex_deep(const FeatureTree& of, const FeatureTree& in, double dx, double dy, double margin, bool inside) {
  const auto candidates = inside ? of.representatives_in(in, dx, dy) : of.representatives();
  return std::any_of(candidates.begin(), candidates.end(), [&](plane::Index v) {
    const exact::Point& p = of.region().point(v);
    auto depth = depth_in(in, p.x + dx, p.y + dy);
    return depth && (inside ? *depth : -*depth) > margin;
  });
}

bool is_near(const FeatureTree& boundary, double x, double y, double reach) {
  bool near = false;
  boundary.for_near(x, y, reach, [&](plane::Index) { return !(near = true); });
  return near;
}

/// The same of some corners among all, always the same ones. Steps are odd: teeth repeat by even numbers.
bool has_corner_deep(const FeatureTree& of, const FeatureTree& in, double dx, double dy, double margin, bool inside) {
  const auto all = of.features();
  const std::size_t step = (all.size() / kCornersTried) | 1;
  for (std::size_t k = 0; k < all.size(); k += step) {
    const double x = all[k].x0 + dx, y = all[k].y0 + dy;
    if (is_near(in, x, y, margin)) continue;
    const auto depth = depth_in(in, x, y);
    if (depth && (inside ? *depth : -*depth) > margin) return true;
  }
  return false;
}

}  // namespace

PenetrationDepth::PenetrationDepth(const FeatureTree& moving, const FeatureTree& fixed, Of of, Sum sum,
                                   std::int64_t boxes)
    : moving_(moving),
      fixed_(fixed),
      of_(of),
      sum_(std::move(sum)),
      moving_disc_(inner_disc(moving)),
      fixed_disc_(inner_disc(fixed)),
      boxes_left_(boxes) {}

std::unique_ptr<const PenetrationDepth> PenetrationDepth::make(const FeatureTree& moving, const FeatureTree& fixed,
                                                               Of of, When when) {
  const plane::Region &a = fixed.region(), &b = moving.region();
  const bool always = when == When::kAlways, contact = of == Of::kContact;
  const auto made = [&](Sum sum, std::size_t curves, double per_box) {
    const auto boxes =
        always ? std::numeric_limits<std::int64_t>::max() : std::int64_t(std::pow(double(curves) / per_box, 2)) + 1;
    return std::unique_ptr<const PenetrationDepth>(new PenetrationDepth(moving, fixed, of, std::move(sum), boxes));
  };
  auto grid = contact ? plane::LocalSum::contact(a, b) : plane::LocalSum::containment(a, b);
  if (grid && !grid->index().may_be_unresolved()) {
    const std::size_t curves = grid->index().convex_count();
    if (!always && grid->bounds() && curves < kCurvesOfMap) return nullptr;
    return made(std::move(grid), curves, kCurvesPerBox);
  }
  using Keep = plane::FreePlaces::Keep;
  if (moving.features().size() * fixed.features().size() < kPairsOfMap && !always) return nullptr;
  auto places = plane::FreePlaces::make(a, b, contact ? Keep::kApart : Keep::kInside);
  if (!places) return nullptr;
  const std::size_t curves = places->curve_count(kCurvesCounted);
  if (!always && curves < kCurvesOfArcMap) return nullptr;
  return made(std::move(places), curves, kCurvesPerArcBox);
}

bool PenetrationDepth::holds(const RealPoint& p) const {
  if (const auto* grid = std::get_if<Grid>(&sum_)) return (*grid)->holds(p);
  return !std::get<Places>(sum_)->is_free(p);
}

bool PenetrationDepth::sticks_out(double x, double y, const Moves& by) const {
  if (of_ == Of::kContact || !plane::is_bounded(fixed_.region()) || fixed_.empty() || moving_.empty()) return false;
  const FeatureBox &a = fixed_.nodes()[0].box, &b = moving_.nodes()[0].box;
  return std::max(a.x0 - (b.x0 + x), b.x1 + x - a.x1) > by.x || std::max(a.y0 - (b.y0 + y), b.y1 + y - a.y1) > by.y;
}

std::size_t PenetrationDepth::Patience::usual() const {
  return found_ == 0 ? kFewLooks : std::max(kFewLooks, kTimesUsualLooks * looks_of_found_ / found_);
}

void PenetrationDepth::Patience::ended(const CutSearch& search) {
  if (search.found) {
    ++found_;
    looks_of_found_ += search.looks;
  } else if (search.cut) {
    looks_of_cut_ += search.looks;
  } else if (search.looks > usual()) {
    looks_of_whole_ = search.looks;
    looks_of_cut_ = 0;
  }
}

bool PenetrationDepth::edges_cross(double x, double y, const Moves& by, Patience& patience) const {
  const CutSearch search = certainly_cross(fixed_, moving_, x, y, by, patience.most());
  patience.ended(search);
  return search.found;
}

bool PenetrationDepth::certainly_holds(double x, double y, const Moves& by, Patience& patience) const {
  const double slack = (moving_.scale() + fixed_.scale() + std::abs(x) + std::abs(y)) * margin::kDepthTolerance;
  const double margin = std::hypot(by.x, by.y) + slack;
  const Moves moves{by.x + slack, by.y + slack};
  const bool contact = of_ == Of::kContact;
  auto meets = [&](const InnerDisc& d, const FeatureTree& other, double dx, double dy, bool inside) {
    auto depth = d.radius > 0 ? depth_in(other, d.x + dx, d.y + dy) : std::nullopt;
    return depth && (inside ? *depth : -*depth) + d.radius > margin;
  };
  return sticks_out(x, y, moves) || meets(moving_disc_, fixed_, x, y, contact) ||
         (contact && meets(fixed_disc_, moving_, -x, -y, true)) ||
         has_corner_deep(moving_, fixed_, x, y, margin, contact) ||
         has_corner_deep(fixed_, moving_, -x, -y, margin, true) || edges_cross(x, y, moves, patience) ||
         has_vertex_deep(moving_, fixed_, x, y, margin, contact) ||
         has_vertex_deep(fixed_, moving_, -x, -y, margin, true);
}

bool PenetrationDepth::certainly_free(double x, double y, double margin) const {
  if (!certainly_apart(fixed_, moving_, x, y, margin)) return false;
  // Boundaries that do not meet: what one vertex of a piece does, all the piece does.
  const auto lie = [](const FeatureTree& of, const FeatureTree& in, double dx, double dy, bool inside) {
    const auto tried = inside ? of.representatives() : of.representatives_in(in, dx, dy);
    return std::all_of(tried.begin(), tried.end(), [&](plane::Index v) {
      const exact::Point& p = of.region().point(v);
      auto depth = depth_in(in, p.x + dx, p.y + dy);
      return depth && (*depth > 0) == inside;
    });
  };
  return lie(moving_, fixed_, x, y, of_ == Of::kContainment) && lie(fixed_, moving_, -x, -y, false);
}

bool PenetrationDepth::certainly_holds(const GridBox& w, Patience& patience) const {
  return certainly_holds((double(w.x0) + double(w.x1)) / 2, (double(w.y0) + double(w.y1)) / 2,
                         {double(w.x1 - w.x0) / 2, double(w.y1 - w.y0) / 2}, patience);
}

bool PenetrationDepth::halves_across_x(const GridBox& w, Patience& patience) const {
  // Across a step or two it would come back as its own half.
  if (std::min(w.x1 - w.x0, w.y1 - w.y0) <= kSmallest) return is_wide(w);
  const double x = (double(w.x0) + double(w.x1)) / 2, y = (double(w.y0) + double(w.y1)) / 2;
  const bool row = certainly_holds(x, y, {double(w.x1 - w.x0) / 2, 0}, patience);
  const bool column = certainly_holds(x, y, {0, double(w.y1 - w.y0) / 2}, patience);
  return row == column ? is_wide(w) : column;
}

PenetrationDepth::Found PenetrationDepth::search(const RealPoint& p, bool far) const {
  if (const auto* grid = std::get_if<Grid>(&sum_)) return search(GridPlaces(**grid, p), (*grid)->bounds(), p, far);
  const Places& places = std::get<Places>(sum_);
  return search(CurvePlaces(*places, p), places->bounds(), p, far);
}

template <class Boundary>
PenetrationDepth::Found PenetrationDepth::search(const Boundary& boundary, const std::optional<GridBox>& bounds,
                                                 const RealPoint& p, bool far) const {
  using Curves = typename Boundary::Curves;
  Patience patience;
  const plane::FreePlaces::Certain certain{
      [&](double qx, double qy, double error) {
        return certainly_holds(qx, qy, {error, error}, patience);
      },
      [&](double qx, double qy, double margin) { return certainly_free(qx, qy, margin); }};
  const double x = near_value(p.x), y = near_value(p.y);
  std::optional<Nearest> best;
  plane::Subdivision<Box<Curves>> boxes("boxes of the nearest position on the boundary of a sum", true);
  if (bounds) boxes.push({*bounds, bound(*bounds, x, y, far)});
  bool spent = false;
  const auto settled = [&](const Box<Curves>& box) {
    if (best) {
      const double d = best->distance.to_double();
      if (box.bound > (far ? -d : d) + d * margin::kDepthTolerance) return true;
    }
    spent = --boxes_left_ < 0;
    return spent;
  };
  const auto halve = [&](const GridBox& w, int vain, const std::shared_ptr<const Curves>& curves) {
    const auto [first, second] = halves(w, halves_across_x(w, patience));
    boxes.push({first, bound(first, x, y, far), vain, second, curves});
    boxes.push({second, bound(second, x, y, far), vain, first, curves});
  };
  // How many halvings up to this half of a box left nearly all curves in both halves; what leaves them in one counts
  // for nothing, as the other one may hold none.
  const auto vain_halvings = [&](const Box<Curves>& box, std::size_t count) {
    const auto nearly_all = [&](std::size_t curves) { return curves * 5 > box.among->size() * 4; };
    if (!box.among || !nearly_all(count)) return 0;
    return box.vain + int(nearly_all(boundary.curves_in(grown(box.other), *box.among).size()));
  };
  const auto look = [&](const Box<Curves>& box) {
    const GridBox& w = box.window;
    if (certainly_holds(w, patience)) return;
    const bool small = std::max(w.x1 - w.x0, w.y1 - w.y0) <= kSmallest;
    const std::size_t most = small ? SIZE_MAX : kManyCurves;
    if (!box.among && !small && boundary.surely_has(most, grown(w))) return halve(w, 0, nullptr);
    auto curves = std::make_shared<const Curves>(box.among ? boundary.curves_in(grown(w), *box.among)
                                                           : boundary.curves_in(grown(w), most));
    const std::size_t count = curves->size();
    const int vain = vain_halvings(box, count);
    if (count < kFewCurves || vain == kVainHalvings || small) {
      auto found = boundary.best(grown(w), *curves, far, certain);
      if (found && (!best || (far ? found->distance > best->distance : found->distance < best->distance)))
        best = std::move(found);
      return;
    }
    halve(w, vain, count == most ? nullptr : curves);
  };
  boxes.run(settled, look);
  if (spent) return {false, std::nullopt};
  return {true, std::move(best)};
}

}  // namespace findspace::distance
