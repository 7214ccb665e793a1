// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/shape/rotated_shape.h"

#include <findspace/error.h>

#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "space/convolution/ray_solids.h"
#include "space/mesh/mesh.h"

namespace findspace::space {
namespace {

using exact::Real;
using Kind = plane::Shape::Kind;

class Rotator {
 public:
  Rotator(const Rotation& rotation, plane::Rounding& rounding) : rounding_(rounding) {
    for (std::size_t k = 0; k < 3; ++k) rows_[k] = intervals(rotation.rows[k]);
  }

  plane::ShapePtr shape(const plane::Shape& s, const Rotation& r) {
    if (const Solid* primitive = solid_of(s)) {
      plane::Shape out = s;
      out.solid = std::make_shared<const Solid>(solid(s, *primitive, r));
      return std::make_shared<const plane::Shape>(std::move(out));
    }
    if (const auto known = done_.find({&s, r.by}); known != done_.end()) {
      rounding_.points += known->second.points;
      return known->second.shape;
    }
    const std::int64_t before = rounding_.points;
    plane::ShapePtr made = s.kind == Kind::kTranslate ? translated(s, r) : over_children(s, r);
    done_.emplace(std::pair(&s, r.by), Done{made, rounding_.points - before});
    return made;
  }

 private:
  /// A node of the tree, and the points that were put on the grid below it.
  struct Done {
    plane::ShapePtr shape;
    std::int64_t points;
  };

  plane::ShapePtr over_children(const plane::Shape& s, const Rotation& r) {
    plane::Shape out = s;
    Rotation first = r, others = r;
    // Of a sum only one operand moves; -x turns into -(turn x - by).
    if (s.kind == Kind::kMinkowskiSum || s.kind == Kind::kMinkowskiDifference) others.by = RealVector{};
    if (s.kind == Kind::kMirror) first.by = negated(r.by);
    for (std::size_t k = 0; k < s.children.size(); ++k)
      out.children[k] = shape(*s.children[k], k == 0 ? first : others);
    return std::make_shared<const plane::Shape>(std::move(out));
  }

  plane::ShapePtr translated(const plane::Shape& s, Rotation r) {
    const RealVector shift{Real(s.points[0].x), Real(s.points[0].y), Real(s.lift)};
    r.by = plus(r.by, r.linear(shift));
    plane::Shape out = *shape(*s.children[0], r);
    if (!s.name.empty()) out.name = s.name;
    return std::make_shared<const plane::Shape>(std::move(out));
  }

  Point rounded(const RealVector& p) {
    std::array<std::int64_t, 3> c{};
    double square = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const int128 whole = exact::round(p[k]);
      if (whole > kCoordinateLimit || whole < -kCoordinateLimit)
        throw Error(ErrorCode::kOutOfRange, "a rotated shape leaves the grid: a coordinate exceeds 2^40 grid steps");
      c[k] = static_cast<std::int64_t>(whole);
      const double rest = (p[k] - Real(whole)).to_double();
      square += rest * rest;
    }
    rounding_.note(std::sqrt(square));
    return {c[0], c[1], c[2]};
  }

  using Intervals = std::array<exact::Interval, 3>;
  static Intervals intervals(const RealVector& v) { return {v[0].interval(), v[1].interval(), v[2].interval()}; }

  /// Where intervals tell the grid point, that the point moves, and less far than the farthest so far.
  std::optional<Point> rounded_nearly(const Point& p, const Intervals& by) {
    const Intervals at{exact::enclose(p.x), exact::enclose(p.y), exact::enclose(p.z)};
    const exact::Interval half{0.5, 0.5}, most = exact::enclose(kCoordinateLimit);
    exact::Interval square;
    std::array<std::int64_t, 3> c{};
    bool moves = false;
    for (std::size_t k = 0; k < 3; ++k) {
      const exact::Interval x = rows_[k][0] * at[0] + rows_[k][1] * at[1] + rows_[k][2] * at[2] + by[k];
      if (exact::certain_sign(most - x) <= 0 || exact::certain_sign(most + x) <= 0) return std::nullopt;
      c[k] = std::llround(x.lo);
      const exact::Interval rest = x - exact::enclose(c[k]);
      if (exact::certain_sign(half - rest) <= 0 || exact::certain_sign(half + rest) <= 0) return std::nullopt;
      moves = moves || exact::certain_sign(rest) != 0;
      square = square + rest * rest;
    }
    const exact::Interval largest{rounding_.largest, rounding_.largest};
    if (!moves || exact::certain_sign(largest - sqrt(square)) <= 0) return std::nullopt;
    ++rounding_.points;
    return Point{c[0], c[1], c[2]};
  }

  std::vector<Point> rounded(const std::vector<Point>& points, const Rotation& r) {
    const Intervals by = intervals(r.by);
    std::vector<Point> out;
    for (const Point& p : points) {
      const std::optional<Point> near = rounded_nearly(p, by);
      out.push_back(near ? *near : rounded(r(real(p))));
    }
    return out;
  }

  /// About z by quarters a prism stays one, arcs and all.
  Solid upright(Solid s, const Rotation& r) {
    for (plane::Contour& contour : s.contours) {
      for (plane::ContourEdge& edge : contour) {
        const Point at = rounded(r({Real(edge.start.x), Real(edge.start.y), Real(0)}));
        edge.start = {at.x, at.y};
        if (!edge.arc) continue;
        const RealVector center = r({edge.arc->cx, edge.arc->cy, Real(0)});
        edge.arc = std::make_shared<const plane::ArcCircle>(plane::ArcCircle{center[0], center[1], edge.arc->r});
      }
    }
    const Point low = rounded(r({Real(0), Real(0), Real(s.low)})), high = rounded(r({Real(0), Real(0), Real(s.high)}));
    s.low = low.z;
    s.high = high.z;
    return s;
  }

  Solid solid(const plane::Shape& s, const Solid& given, const Rotation& r) {
    Solid out = given;
    if (given.form == Solid::Form::kPrism && r.keeps_z()) return upright(given, r);
    if (given.form == Solid::Form::kPolytope || given.form == Solid::Form::kBall) {
      out.mesh.vertices = rounded(given.mesh.vertices, r);
      return out;
    }
    if (given.form == Solid::Form::kMesh && r.keeps_axes()) {
      out.mesh.vertices = rounded(given.mesh.vertices, r);
      return out;
    }
    const Triangles surface = ray_solids(s)[0].surface;
    Mesh mesh{surface.points, {}};
    for (const auto& f : surface.faces) mesh.faces.push_back({f[0], f[1], f[2]});
    const bool convex = is_convex(mesh);
    out = Solid{};
    out.step = given.step;
    out.mesh = {rounded(mesh.vertices, r), {}};
    if (convex) return out;  // the hull of its vertices
    out.form = Solid::Form::kMesh;
    out.mesh.faces = std::move(mesh.faces);
    clean(out.mesh, 1);
    return out;
  }

  plane::Rounding& rounding_;
  std::array<Intervals, 3> rows_;                                    // of the rotation, whatever the shift
  std::map<std::pair<const plane::Shape*, RealVector>, Done> done_;  // by the shift: sums share their operands
};

}  // namespace

plane::ShapePtr rotated(const plane::Shape& shape, const Rotation& rotation, plane::Rounding& rounding) {
  return Rotator(rotation, rounding).shape(shape, rotation);
}

}  // namespace findspace::space
