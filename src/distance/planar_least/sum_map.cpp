// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/planar_least/sum_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "distance/planar_least/sum_curve.h"
#include "exact/margins/planar_distance.h"
#include "exact/margins/rounding.h"
#include "plane/base/parallel.h"
#include "plane/complex/overlay.h"
#include "plane/complex/primitives.h"

namespace findspace::distance {

using exact::Real;
using exact::RealPoint;
using plane::CellComplex;
using plane::Mark;
using plane::PieceBox;

namespace {

constexpr std::size_t kFewForms = 16, kMostMapBoxes = 2000;
constexpr Mark kOpen = 2, kNothing = 3;  // not known; not in the box

/// A function nx * x + ny * y + c of positions relative to a box's middle.
struct Plane {
  double nx, ny, c;
  double at(double x, double y) const { return nx * x + ny * y + c; }
};

struct Corner {
  double x, y;
};

/// The part of a convex polygon where the plane is not negative.
std::vector<Corner> clipped(const std::vector<Corner>& polygon, const Plane& f) {
  std::vector<Corner> out;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Corner &p = polygon[k], &q = polygon[(k + 1) % polygon.size()];
    const double a = f.at(p.x, p.y), b = f.at(q.x, q.y);
    if (a >= 0) out.push_back(p);
    if ((a < 0) != (b < 0)) out.push_back({p.x + a / (a - b) * (q.x - p.x), p.y + a / (a - b) * (q.y - p.y)});
  }
  return out;
}

class SumMap {
 public:
  SumMap(const DistanceSum& f, const Real& level, double width) : f_(f), level_(level), width_(width) {}

  /// Marks: the sign, kOpen, or outside of the window kNothing. All boxes of a size are looked at before smaller ones,
  /// so that what has to stay open, where there are too many, is spread along the curve.
  CellComplex run(const PieceBox& window) {
    std::vector<Part> level{{window}};
    std::size_t count = 1;
    while (!level.empty()) {
      plane::parallel_for(level.size(), [&](std::size_t k) { level[k].signs = solved(level[k].box, false); });
      std::vector<PieceBox> smaller;
      for (const Part& part : level)
        if (!part.signs)
          for (const PieceBox& b : quarters(part.box)) smaller.push_back(b);
      count += smaller.size();
      if (count > kMostMapBoxes)
        plane::parallel_for(level.size(), [&](std::size_t k) {
          if (!level[k].signs) level[k].signs = solved(level[k].box, true);
        });
      for (Part& part : level) parts_.push_back(std::move(part));
      level.clear();
      if (count <= kMostMapBoxes)
        for (const PieceBox& b : smaller) level.push_back({b});
    }
    return joined();
  }

 private:
  static CellComplex in_box(CellComplex signs, const PieceBox& b) {
    const CellComplex box = filled_box(b);
    return plane::overlay(std::array<const CellComplex*, 2>{&box, &signs},
                          [](std::span<const Mark> m) { return m[0] > 0 ? m[1] : kNothing; });
  }
  static CellComplex whole(const PieceBox& b, Mark mark) {
    return plane::remark(filled_box(b), [mark](Mark m) { return m > 0 ? mark : kNothing; });
  }

  /// Where all forms are one, and its level curve is a line or a circle.
  std::optional<CellComplex> exactly(const DistanceSum::Forms& forms, const PieceBox& b) const {
    std::vector<LevelCurve> curves;
    for (const auto& of_one : forms.summands) {
      std::optional<LevelCurve> one;
      for (const SmoothForm& f : of_one) {
        if (!f.curve) return std::nullopt;
        LevelCurve curve = f.curve();
        if (!one)
          one = std::move(curve);
        else if (!same(*one, curve))
          return std::nullopt;
      }
      curves.push_back(*std::move(one));
    }
    auto signs = sign_of_forms(f_.summands(), curves, level_, b);
    if (!signs) return std::nullopt;
    return in_box(*std::move(signs), b);
  }

  static bool same(const LevelCurve& f, const LevelCurve& g) {
    if (f.circle != g.circle) return false;
    if (f.circle) return f.a == g.a && f.b == g.b && f.c == g.c && f.k == g.k;
    return f.a * g.k == g.a * f.k && f.b * g.k == g.b * f.k && f.c * g.k == g.c * f.k;
  }

  /// Half planes on which the sign is certain, if the strip between them is narrow.
  std::optional<CellComplex> certain(const DistanceSum::Forms& forms, const PieceBox& b, double level, double noise,
                                     bool last) const {
    double widest = 0;
    std::vector<Plane> above, below;
    for (const DistanceSum::Form& form : forms.all) {
      const SmoothForm& s = form.sum;
      const double slope = plain_length(s.gx, s.gy);
      const double room = noise + 2 * (std::abs(s.gx) + std::abs(s.gy));  // corners are put on the grid
      above.push_back({s.gx, s.gy, s.value - level + s.below - room});
      below.push_back({-s.gx, -s.gy, level - s.value - s.above - room});
      widest = std::max(widest, slope > 0 ? (s.above - s.below + 2 * room) / slope : exact::kInfinity);
    }
    const PieceBox at{b.x0 - (b.x0 + b.x1) / 2, b.y0 - (b.y0 + b.y1) / 2, b.x1 - (b.x0 + b.x1) / 2,
                      b.y1 - (b.y0 + b.y1) / 2};
    std::vector<Corner> plus{{at.x0, at.y0}, {at.x1, at.y0}, {at.x1, at.y1}, {at.x0, at.y1}}, minus = plus;
    if (widest > width_ && !last) return std::nullopt;
    for (const Plane& p : above) plus = clipped(plus, p);
    for (const Plane& p : below) minus = clipped(minus, p);
    const CellComplex box = filled_box(b), high = on_grid(plus, b), low = on_grid(minus, b);
    return plane::overlay(std::array<const CellComplex*, 3>{&box, &high, &low}, [](std::span<const Mark> m) {
      return m[0] <= 0 ? kNothing : m[1] > 0 ? Mark(1) : m[2] > 0 ? Mark(-1) : kOpen;
    });
  }

  static CellComplex on_grid(const std::vector<Corner>& polygon, const PieceBox& b) {
    plane::Contour ring;
    for (const Corner& c : polygon) {
      const plane::GridPoint p{std::llround(c.x + (b.x0 + b.x1) / 2), std::llround(c.y + (b.y0 + b.y1) / 2)};
      if (ring.empty() || (!(ring.back().start == p) && !(ring.front().start == p))) ring.push_back({p});
    }
    double area = 0;
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const plane::GridPoint &p = ring[k].start, &q = ring[(k + 1) % ring.size()].start;
      area += (double(p.x) - b.x0) * (double(q.y) - b.y0) - (double(q.x) - b.x0) * (double(p.y) - b.y0);
    }
    if (ring.size() < 3 || area < 2) return CellComplex::uniform(0);
    return plane::region_of_rings({&ring, 1});
  }

  static std::vector<PieceBox> quarters(const PieceBox& b) {
    const double x = std::floor((b.x0 + b.x1) / 2), y = std::floor((b.y0 + b.y1) / 2);
    std::vector<PieceBox> out;
    for (const auto& [x0, x1] : {std::pair{b.x0, x}, {x, b.x1}})
      for (const auto& [y0, y1] : {std::pair{b.y0, y}, {y, b.y1}})
        if (x0 < x1 && y0 < y1) out.push_back({x0, y0, x1, y1});
    return out;
  }

  /// The box's signs, if it need not be halved; `last`: it is not halved any more.
  std::optional<CellComplex> solved(const PieceBox& b, bool last) const {
    const RealPoint middle{Real::from_double((b.x0 + b.x1) / 2), Real::from_double((b.y0 + b.y1) / 2)};
    const double radius = std::hypot(b.x1 - b.x0, b.y1 - b.y0) / 2 * margin::kUpward;
    const ValueRange range = f_.range(middle, radius);
    const double level = near_value(level_), off = (std::abs(level) + 1) * margin::kMaxMinNoise;
    if (range.low > level + off) return whole(b, 1);
    if (range.high < level - off) return whole(b, -1);
    last = last || std::max(b.x1 - b.x0, b.y1 - b.y0) <= width_;
    if (const auto forms = f_.forms(middle, radius, kFewForms)) {
      if (auto exact = exactly(*forms, b)) return exact;
      if (auto strip = certain(*forms, b, level, f_.noise(middle, radius), last)) return strip;
    }
    return last ? std::optional(whole(b, kOpen)) : std::nullopt;
  }

  /// A part with its quarters; these follow level by level, in order.
  CellComplex joined() {
    std::size_t next = 1;
    std::vector<std::vector<std::size_t>> of(parts_.size());
    for (std::size_t k = 0; k < parts_.size(); ++k) {
      if (parts_[k].signs) continue;
      for (std::size_t q = quarters(parts_[k].box).size(); q > 0; --q) of[k].push_back(next++);
    }
    for (std::size_t k = parts_.size(); k-- > 0;) {
      if (of[k].empty()) continue;
      std::vector<const CellComplex*> operands;
      for (const std::size_t q : of[k]) operands.push_back(&*parts_[q].signs);
      parts_[k].signs = plane::overlay(operands, [](std::span<const Mark> marks) {
        Mark out = kNothing;
        for (const Mark m : marks)
          if (m < kOpen || out == kNothing) out = m == kNothing ? out : m;
        return out;
      });
    }
    return *std::move(parts_.front().signs);
  }

  struct Part {
    PieceBox box;
    std::optional<CellComplex> signs{};  // nothing: it is quartered
  };

  const DistanceSum& f_;
  const Real& level_;
  double width_;
  std::vector<Part> parts_{};
};

}  // namespace

SumSigns sum_map(const DistanceSum& f, const Real& level, const PieceBox& window, double width) {
  const auto infinite = f.infinite({});
  if (infinite && *infinite != 0) {
    const CellComplex all = CellComplex::uniform(Mark(*infinite));
    return {all, all};
  }
  const CellComplex signs = SumMap(f, level, width).run(window);
  return {plane::remark(signs, [](Mark m) { return m >= kOpen ? Mark(-1) : m; }),
          plane::remark(signs, [](Mark m) { return m >= kOpen ? Mark(1) : m; })};
}

}  // namespace findspace::distance
