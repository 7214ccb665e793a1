// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "rounded.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepGProp.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <algorithm>
#include <cmath>
#include <gp_Circ.hxx>
#include <gp_Cylinder.hxx>
#include <gp_Pln.hxx>
#include <gp_Sphere.hxx>
#include <limits>
#include <vector>

#include "exact/margins/cad.h"

namespace findspace::cad {
namespace {

constexpr std::size_t kMostCentres = 64;

/// The greatest (x - base) . way over an edge; infinite where it is no line and no circle.
double most_along(const TopoDS_Edge& edge, const gp_XYZ& way, const gp_XYZ& base) {
  if (BRep_Tool::Degenerated(edge)) return -std::numeric_limits<double>::infinity();
  const BRepAdaptor_Curve curve(edge);
  const double from = curve.FirstParameter(), to = curve.LastParameter();
  const auto at = [&](const gp_Pnt& p) { return (p.XYZ() - base).Dot(way); };
  const double ends = std::max(at(curve.Value(from)), at(curve.Value(to)));
  if (curve.GetType() == GeomAbs_Line) return ends;
  if (curve.GetType() != GeomAbs_Circle) return std::numeric_limits<double>::infinity();
  const gp_Circ circle = curve.Circle();
  const double x = circle.XAxis().Direction().XYZ().Dot(way), y = circle.YAxis().Direction().XYZ().Dot(way);
  const double turn = 2 * std::acos(-1.0), top = std::atan2(y, x);
  const double first = top + turn * std::ceil((from - top) / turn);  // the first such parameter from `from` on
  if (first > to) return ends;
  return at(circle.Location()) + circle.Radius() * std::hypot(x, y);
}

class Rounded {
 public:
  explicit Rounded(const TopoDS_Shape& solid) {
    int shells = 0;
    for (TopExp_Explorer at(solid, TopAbs_SHELL); at.More(); at.Next()) ++shells;
    for (TopExp_Explorer at(solid, TopAbs_FACE); at.More(); at.Next()) faces_.push_back(TopoDS::Face(at.Current()));
    fits_ = shells == 1 && take_centres();
  }

  std::optional<io::CadRounded> result() const {
    if (!fits_ || !std::all_of(faces_.begin(), faces_.end(), [&](const TopoDS_Face& f) { return lies(f); }))
      return std::nullopt;
    io::CadRounded out;
    out.radius = radius_;
    for (const gp_XYZ& c : centres_) out.centers.push_back({c.X(), c.Y(), c.Z()});
    return out;
  }

 private:
  bool take_centres() {
    for (const TopoDS_Face& face : faces_) {
      const BRepAdaptor_Surface surface(face, false);
      if (surface.GetType() != GeomAbs_Sphere) continue;
      const gp_XYZ c = surface.Sphere().Location().XYZ();
      if (centres_.empty()) radius_ = surface.Sphere().Radius();
      size_ = std::max({size_, std::abs(c.X()), std::abs(c.Y()), std::abs(c.Z()), radius_});
      if (!same(surface.Sphere().Radius(), radius_)) return false;
      const bool known =
          std::any_of(centres_.begin(), centres_.end(), [&](const gp_XYZ& d) { return same((c - d).Modulus(), 0); });
      if (!known) centres_.push_back(c);
      if (centres_.size() > kMostCentres) return false;
    }
    return !centres_.empty();
  }

  bool same(double a, double b) const { return std::abs(a - b) <= margin::kRoundedSolid * size_; }
  bool below(double a, double b) const { return a <= b + margin::kRoundedSolid * size_; }

  template <class Holds>
  static bool all_edges(const TopoDS_Face& face, Holds holds) {
    for (TopExp_Explorer at(face, TopAbs_EDGE); at.More(); at.Next())
      if (!holds(TopoDS::Edge(at.Current()))) return false;
    return true;
  }

  bool lies(const TopoDS_Face& face) const {
    const BRepAdaptor_Surface surface(face, false);
    switch (surface.GetType()) {
      case GeomAbs_Sphere:
        return on_sphere(face, surface.Sphere());
      case GeomAbs_Cylinder:
        return on_cylinder(face, surface.Cylinder());
      case GeomAbs_Plane:
        return on_plane(face, surface.Plane());
      default:
        return false;
    }
  }

  bool on_sphere(const TopoDS_Face& face, const gp_Sphere& sphere) const {
    const gp_XYZ c = sphere.Location().XYZ();
    for (const gp_XYZ& other : centres_) {
      const gp_XYZ way = other - c;
      if (same(way.Modulus(), 0)) continue;
      const gp_XYZ unit = way / way.Modulus();
      if (!all_edges(face, [&](const TopoDS_Edge& e) { return below(most_along(e, unit, c), 0); })) return false;
      if (!turned_from(face, c, unit)) return false;
    }
    return true;
  }

  /// Whether a face of the sphere, whose edges turn from that direction, does so too: else it holds the half that
  /// turns towards it, is larger than that, and so is its moment.
  bool turned_from(const TopoDS_Face& face, const gp_XYZ& center, const gp_XYZ& way) const {
    const double half = 2 * std::acos(-1.0) * radius_ * radius_;
    GProp_GProps area;
    BRepGProp::SurfaceProperties(face, area);
    return area.Mass() < 1.25 * half && (area.CentreOfMass().XYZ() - center).Dot(way) < 0;
  }

  bool on_cylinder(const TopoDS_Face& face, const gp_Cylinder& cylinder) const {
    if (!same(cylinder.Radius(), radius_)) return false;
    const gp_XYZ axis = cylinder.Axis().Direction().XYZ(), base = cylinder.Location().XYZ();
    const auto along = [&](const gp_XYZ& c) { return (c - base).Dot(axis); };
    std::vector<double> on;
    std::vector<gp_XYZ> beside;  // from the axis
    for (const gp_XYZ& c : centres_) {
      const gp_XYZ off = c - base - axis * along(c);
      if (same(off.Modulus(), 0))
        on.push_back(along(c));
      else
        beside.push_back(off / off.Modulus());
    }
    if (on.size() < 2) return false;
    const auto [low, high] = std::minmax_element(on.begin(), on.end());
    return all_edges(face, [&, least = *low, most = *high](const TopoDS_Edge& e) {
      return below(most_along(e, axis, base), most) && below(most_along(e, axis * -1, base), -least) &&
             std::all_of(beside.begin(), beside.end(),
                         [&](const gp_XYZ& way) { return below(most_along(e, way, base), 0); });
    });
  }

  bool on_plane(const TopoDS_Face& face, const gp_Pln& plane) const {
    gp_XYZ normal = plane.Axis().Direction().XYZ();
    if (!plane.Direct()) normal.Reverse();
    if (face.Orientation() == TopAbs_REVERSED) normal.Reverse();
    const double height = plane.Location().XYZ().Dot(normal) - radius_;
    std::vector<gp_XYZ> top;
    for (const gp_XYZ& c : centres_) {
      if (!below(c.Dot(normal), height)) return false;
      if (same(c.Dot(normal), height)) top.push_back(c);
    }
    if (top.size() < 3) return false;
    for (const gp_XYZ& a : top)
      for (const gp_XYZ& b : top) {
        gp_XYZ outward = (b - a).Crossed(normal);
        if (same(outward.Modulus(), 0)) continue;
        outward /= outward.Modulus();
        const bool side =
            std::all_of(top.begin(), top.end(), [&](const gp_XYZ& c) { return below((c - a).Dot(outward), 0); });
        if (side && !all_edges(face, [&](const TopoDS_Edge& e) { return below(most_along(e, outward, a), 0); }))
          return false;
      }
    return true;
  }

  std::vector<TopoDS_Face> faces_;
  std::vector<gp_XYZ> centres_;
  double radius_ = 0, size_ = 1;
  bool fits_ = false;
};

}  // namespace

std::optional<io::CadRounded> rounded_of(const TopoDS_Shape& solid) { return Rounded(solid).result(); }

}  // namespace findspace::cad
