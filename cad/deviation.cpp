// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "deviation.h"

#include <Geom2dConvert_BSplineCurveToBezierCurve.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_BezierCurve.hxx>
#include <Geom2d_Circle.hxx>
#include <Geom2d_Ellipse.hxx>
#include <Geom2d_Line.hxx>
#include <Geom2d_TrimmedCurve.hxx>
#include <GeomConvert_BSplineCurveToBezierCurve.hxx>
#include <GeomConvert_BSplineSurfaceToBezierSurface.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_Circle.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Ellipse.hxx>
#include <Geom_Line.hxx>
#include <Geom_OffsetSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <algorithm>
#include <cmath>
#include <gp_Ax1.hxx>

namespace findspace::cad {
namespace {

constexpr double kRaised = 1.01;

/// The greatest |cos| and |sin| over an interval.
double most_cos(double from, double to) {
  const double pi = std::acos(-1.0);
  if (std::floor(to / pi) >= std::ceil(from / pi)) return 1;
  return std::max(std::abs(std::cos(from)), std::abs(std::cos(to)));
}
double most_sin(double from, double to) {
  const double quarter = std::acos(0.0);
  return most_cos(from - quarter, to - quarter);
}

class FixedBounds : public SurfaceBounds {
 public:
  explicit FixedBounds(const Derivatives& d) : d_(d) {}
  Derivatives over(const Range&) const override { return d_; }

 private:
  Derivatives d_;
};

class ConeBounds : public SurfaceBounds {
 public:
  ConeBounds(double radius, double angle) : radius_(radius), sine_(std::abs(std::sin(angle))), angle_(angle) {}
  Derivatives over(const Range& r) const override {
    const double at0 = radius_ + r.v0 * std::sin(angle_), at1 = radius_ + r.v1 * std::sin(angle_);
    const double radius = std::max(std::abs(at0), std::abs(at1));
    return {.u = radius, .v = 1, .uu = radius, .uv = sine_, .vv = 0};
  }

 private:
  double radius_, sine_, angle_;
};

class SphereBounds : public SurfaceBounds {
 public:
  explicit SphereBounds(double radius) : radius_(radius) {}
  Derivatives over(const Range& r) const override {
    const double c = radius_ * most_cos(r.v0, r.v1), s = radius_ * most_sin(r.v0, r.v1);
    return {.u = c, .v = radius_, .uu = c, .uv = s, .vv = radius_};
  }

 private:
  double radius_;
};

class TorusBounds : public SurfaceBounds {
 public:
  TorusBounds(double major, double minor) : major_(major), minor_(minor) {}
  Derivatives over(const Range& r) const override {
    const double reach = major_ + minor_ * most_cos(r.v0, r.v1), s = minor_ * most_sin(r.v0, r.v1);
    return {.u = reach, .v = minor_, .uu = reach, .uv = s, .vv = minor_};
  }

 private:
  double major_, minor_;
};

/// Of a curve in space over its whole range: first and second derivative, and about an axis the reach and how fast it
/// changes.
struct CurveBounds {
  double first = 0, second = 0, reach = 0, radial = 0;
};

double length(const gp_XYZ& v) { return v.Modulus(); }

/// Of a Bezier curve by its control points and weights, over parameters of length `span`. A point of the curve is N /
/// w.
template <class Vector, class Length>
CurveBounds bezier_bounds(const std::vector<Vector>& points, const std::vector<double>& weights, double span,
                          Length length_of) {
  const auto degree = double(points.size()) - 1;
  Vector center = points[0];
  for (std::size_t i = 1; i < points.size(); ++i) center += points[i];
  center *= 1 / double(points.size());
  double n0 = 0, n1 = 0, n2 = 0, w1 = 0, w2 = 0, least = weights[0];
  const auto n = [&](std::size_t i) { return (points[i] - center) * weights[i]; };
  for (std::size_t i = 0; i < points.size(); ++i) {
    n0 = std::max(n0, length_of(points[i] - center));
    least = std::min(least, weights[i]);
    if (i + 1 < points.size()) {
      n1 = std::max(n1, length_of(n(i + 1) - n(i)));
      w1 = std::max(w1, std::abs(weights[i + 1] - weights[i]));
    }
    if (i + 2 < points.size()) {
      n2 = std::max(n2, length_of(n(i + 2) - n(i + 1) * 2.0 + n(i)));
      w2 = std::max(w2, std::abs(weights[i + 2] - 2 * weights[i + 1] + weights[i]));
    }
  }
  const double f1 = degree / span, f2 = degree * (degree - 1) / (span * span);
  n1 *= f1;
  w1 *= f1;
  n2 *= f2;
  w2 *= f2;
  const double first = (n1 + w1 * n0) / least;
  return {first, (n2 + 2 * w1 * first + w2 * n0) / least, 0, 0};
}

std::optional<CurveBounds> bounds_of_curve(Handle(Geom_Curve) curve, const gp_Ax1* axis) {
  const auto reach = [&](const gp_Pnt& p) {
    return axis == nullptr ? 0 : gp_Vec(axis->Location(), p).Crossed(gp_Vec(axis->Direction())).Magnitude();
  };
  double from = curve->FirstParameter(), to = curve->LastParameter();
  if (const auto trimmed = Handle(Geom_TrimmedCurve)::DownCast(curve)) curve = trimmed->BasisCurve();
  if (!Handle(Geom_Line)::DownCast(curve).IsNull()) {
    if (axis == nullptr) return CurveBounds{1, 0, 0, 0};
    if (std::abs(from) > 1e50 || std::abs(to) > 1e50) return std::nullopt;  // no sign: no end
    const gp_Dir way = Handle(Geom_Line)::DownCast(curve)->Lin().Direction();
    return CurveBounds{1, 0, std::max(reach(curve->Value(from)), reach(curve->Value(to))),
                       way.XYZ().Crossed(axis->Direction().XYZ()).Modulus()};
  }
  if (const auto circle = Handle(Geom_Circle)::DownCast(curve))
    return CurveBounds{circle->Radius(), circle->Radius(), reach(circle->Location()) + circle->Radius(),
                       circle->Radius()};
  if (const auto ellipse = Handle(Geom_Ellipse)::DownCast(curve)) {
    const double a = ellipse->MajorRadius();
    return CurveBounds{a, a, reach(ellipse->Location()) + a, a};
  }
  Handle(Geom_BSplineCurve) spline = Handle(Geom_BSplineCurve)::DownCast(curve);
  std::vector<Handle(Geom_BezierCurve)> pieces;
  std::vector<double> spans;
  if (!spline.IsNull()) {
    if (!spline->IsCN(1)) return std::nullopt;
    spline = Handle(Geom_BSplineCurve)::DownCast(spline->Copy());
    if (spline->IsPeriodic()) spline->SetNotPeriodic();
    GeomConvert_BSplineCurveToBezierCurve convert(spline);
    TColStd_Array1OfReal knots(1, convert.NbArcs() + 1);
    convert.Knots(knots);
    for (int i = 1; i <= convert.NbArcs(); ++i) {
      pieces.push_back(convert.Arc(i));
      spans.push_back(knots(i + 1) - knots(i));
    }
  } else if (const auto bezier = Handle(Geom_BezierCurve)::DownCast(curve)) {
    pieces.push_back(bezier);
    spans.push_back(1);
  } else {
    return std::nullopt;
  }
  CurveBounds out;
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    std::vector<gp_XYZ> points;
    std::vector<double> weights;
    for (int i = 1; i <= pieces[k]->NbPoles(); ++i) {
      points.push_back(pieces[k]->Pole(i).XYZ());
      weights.push_back(pieces[k]->Weight(i));
      out.reach = std::max(out.reach, reach(pieces[k]->Pole(i)));
    }
    const CurveBounds one = bezier_bounds(points, weights, spans[k], length);
    out.first = std::max(out.first, one.first);
    out.second = std::max(out.second, one.second);
    if (axis == nullptr) continue;
    const gp_XYZ along = axis->Direction().XYZ();
    for (gp_XYZ& p : points) p -= along * p.Dot(along);
    out.radial = std::max(out.radial, bezier_bounds(points, weights, spans[k], length).first);
  }
  return out;
}

class Net {
 public:
  explicit Net(const Handle(Geom_BezierSurface) & surface)
      : rows_(std::size_t(surface->NbUPoles())), columns_(std::size_t(surface->NbVPoles())) {
    gp_XYZ center;
    for (std::size_t i = 0; i < rows_; ++i)
      for (std::size_t j = 0; j < columns_; ++j) center += surface->Pole(int(i) + 1, int(j) + 1).XYZ();
    center /= double(rows_ * columns_);
    least_ = surface->Weight(1, 1);
    for (std::size_t i = 0; i < rows_; ++i)
      for (std::size_t j = 0; j < columns_; ++j) {
        const double w = surface->Weight(int(i) + 1, int(j) + 1);
        const gp_XYZ p = surface->Pole(int(i) + 1, int(j) + 1).XYZ() - center;
        least_ = std::min(least_, w);
        size_ = std::max(size_, p.Modulus());
        weights_.push_back(w);
        points_.push_back(p * w);
      }
  }

  Derivatives bounds(double du, double dv) const {
    const auto p = double(rows_) - 1, q = double(columns_) - 1;
    const auto [nu, wu] = most(1, 0, p / du);
    const auto [nv, wv] = most(0, 1, q / dv);
    const auto [nuu, wuu] = most(2, 0, p * (p - 1) / (du * du));
    const auto [nuv, wuv] = most(1, 1, p * q / (du * dv));
    const auto [nvv, wvv] = most(0, 2, q * (q - 1) / (dv * dv));
    Derivatives d;
    d.u = (nu + wu * size_) / least_;
    d.v = (nv + wv * size_) / least_;
    d.uu = (nuu + 2 * wu * d.u + wuu * size_) / least_;
    d.uv = (nuv + wu * d.v + wv * d.u + wuv * size_) / least_;
    d.vv = (nvv + 2 * wv * d.v + wvv * size_) / least_;
    return d;
  }

 private:
  /// The longest difference of that order of the control net, and of the weights, times the factor.
  std::array<double, 2> most(std::size_t a, std::size_t b, double factor) const {
    std::array<double, 2> out{0, 0};
    static constexpr std::array<std::array<double, 3>, 3> kSigns{{{1, 0, 0}, {-1, 1, 0}, {1, -2, 1}}};
    for (std::size_t i = 0; i + a < rows_; ++i)
      for (std::size_t j = 0; j + b < columns_; ++j) {
        gp_XYZ point;
        double weight = 0;
        for (std::size_t k = 0; k <= a; ++k)
          for (std::size_t l = 0; l <= b; ++l) {
            const std::size_t at = (i + k) * columns_ + j + l;
            point += points_[at] * (kSigns[a][k] * kSigns[b][l]);
            weight += weights_[at] * (kSigns[a][k] * kSigns[b][l]);
          }
        out[0] = std::max(out[0], point.Modulus() * factor);
        out[1] = std::max(out[1], std::abs(weight) * factor);
      }
    return out;
  }

  std::size_t rows_, columns_;
  std::vector<gp_XYZ> points_;  // times their weights, from the centre
  std::vector<double> weights_;
  double size_ = 0, least_ = 1;
};

/// Patches in rows and columns of parameters.
class PatchBounds : public SurfaceBounds {
 public:
  PatchBounds(std::vector<double> us, std::vector<double> vs, std::vector<Derivatives> all, bool periodic)
      : us_(std::move(us)), vs_(std::move(vs)), patches_(std::move(all)), periodic_(periodic) {
    for (const Derivatives& d : patches_) all_.raise(d);
  }
  Derivatives over(const Range& r) const override {
    if (periodic_) return all_;
    const auto [i0, i1] = met(us_, r.u0, r.u1);
    const auto [j0, j1] = met(vs_, r.v0, r.v1);
    Derivatives out;
    for (std::size_t i = i0; i <= i1; ++i)
      for (std::size_t j = j0; j <= j1; ++j) out.raise(patches_[i * (vs_.size() - 1) + j]);
    return out;
  }

 private:
  /// The first and the last interval between knots that [low, high] meets, ends included.
  static std::pair<std::size_t, std::size_t> met(const std::vector<double>& knots, double low, double high) {
    const std::size_t last = knots.size() - 2;
    const auto first = std::size_t(std::lower_bound(knots.begin() + 1, knots.end() - 1, low) - knots.begin()) - 1;
    const auto end = std::size_t(std::upper_bound(knots.begin() + 1, knots.end() - 1, high) - knots.begin()) - 1;
    return {std::min(first, last), std::min(std::max(first, end), last)};
  }

  std::vector<double> us_, vs_;
  std::vector<Derivatives> patches_;
  bool periodic_;
  Derivatives all_;
};

/// Parts of a patch have nets nearer to the surface: into how many each is cut both ways, where there are so many.
int parts_of(std::size_t patches) {
  constexpr double kAll = 4096, kMost = 8;
  return int(std::clamp(std::sqrt(kAll / double(patches)), 1.0, kMost));
}

std::vector<double> divided(const std::vector<double>& knots, int parts) {
  std::vector<double> out;
  for (std::size_t k = 0; k + 1 < knots.size(); ++k)
    for (int part = 0; part < parts; ++part) out.push_back(knots[k] + (knots[k + 1] - knots[k]) * part / parts);
  out.push_back(knots.back());
  return out;
}

/// Of part (k, l) of a patch.
Derivatives part_bounds(const Handle(Geom_BezierSurface) & patch, int k, int l, int parts, double wide, double high) {
  const Handle(Geom_BezierSurface) part = Handle(Geom_BezierSurface)::DownCast(patch->Copy());
  part->Segment(double(k) / parts, double(k + 1) / parts, double(l) / parts, double(l + 1) / parts);
  return Net(part).bounds(wide / parts, high / parts);
}

/// `patch_at(i, j)`: from 0.
template <class PatchAt>
std::unique_ptr<const SurfaceBounds> of_patches(const std::vector<double>& us, const std::vector<double>& vs,
                                                PatchAt patch_at, bool periodic) {
  const int parts = parts_of((us.size() - 1) * (vs.size() - 1));
  const std::vector<double> fine_us = divided(us, parts), fine_vs = divided(vs, parts);
  const std::size_t rows = fine_vs.size() - 1;
  std::vector<Derivatives> all((fine_us.size() - 1) * rows);
  for (std::size_t i = 0; i + 1 < us.size(); ++i)
    for (std::size_t j = 0; j + 1 < vs.size(); ++j) {
      const Handle(Geom_BezierSurface) patch = patch_at(i, j);
      for (int k = 0; k < parts; ++k)
        for (int l = 0; l < parts; ++l)
          all[(i * std::size_t(parts) + std::size_t(k)) * rows + j * std::size_t(parts) + std::size_t(l)] =
              part_bounds(patch, k, l, parts, us[i + 1] - us[i], vs[j + 1] - vs[j]);
    }
  return std::make_unique<PatchBounds>(fine_us, fine_vs, std::move(all), periodic);
}

std::unique_ptr<const SurfaceBounds> of_spline(Handle(Geom_BSplineSurface) surface) {
  if (!surface->IsCNu(1) || !surface->IsCNv(1)) return nullptr;
  const bool periodic = surface->IsUPeriodic() || surface->IsVPeriodic();
  if (periodic) {
    surface = Handle(Geom_BSplineSurface)::DownCast(surface->Copy());
    if (surface->IsUPeriodic()) surface->SetUNotPeriodic();
    if (surface->IsVPeriodic()) surface->SetVNotPeriodic();
  }
  GeomConvert_BSplineSurfaceToBezierSurface convert(surface);
  TColStd_Array1OfReal us(1, convert.NbUPatches() + 1), vs(1, convert.NbVPatches() + 1);
  convert.UKnots(us);
  convert.VKnots(vs);
  const auto values = [](const TColStd_Array1OfReal& array) { return std::vector<double>(array.begin(), array.end()); };
  return of_patches(
      values(us), values(vs), [&](std::size_t i, std::size_t j) { return convert.Patch(int(i) + 1, int(j) + 1); },
      periodic);
}

std::unique_ptr<const SurfaceBounds> of_swept(const Handle(Geom_Surface) & surface) {
  if (const auto extruded = Handle(Geom_SurfaceOfLinearExtrusion)::DownCast(surface)) {
    const auto c = bounds_of_curve(extruded->BasisCurve(), nullptr);
    if (!c) return nullptr;
    return std::make_unique<FixedBounds>(Derivatives{.u = c->first, .v = 1, .uu = c->second});
  }
  if (const auto turned = Handle(Geom_SurfaceOfRevolution)::DownCast(surface)) {
    const gp_Ax1 axis = turned->Axis();
    const auto c = bounds_of_curve(turned->BasisCurve(), &axis);
    if (!c) return nullptr;
    return std::make_unique<FixedBounds>(
        Derivatives{.u = c->reach, .v = c->first, .uu = c->reach, .uv = c->radial, .vv = c->second});
  }
  return nullptr;
}

Handle(Geom_Surface) untrimmed(Handle(Geom_Surface) surface) {
  while (const auto trimmed = Handle(Geom_RectangularTrimmedSurface)::DownCast(surface))
    surface = trimmed->BasisSurface();
  return surface;
}

/// Over parameters of length 1 the second differences bound the curve; of the whole piece.
std::optional<std::array<double, 2>> spline_chord(const Handle(Geom2d_BSplineCurve) & given, double from, double to) {
  Handle(Geom2d_BSplineCurve) spline = Handle(Geom2d_BSplineCurve)::DownCast(given->Copy());
  if (spline->IsPeriodic()) spline->SetNotPeriodic();
  from = std::max(from, spline->FirstParameter());
  to = std::min(to, spline->LastParameter());
  if (!(to > from)) return std::array<double, 2>{0, 0};
  spline->Segment(from, to);
  // The control points, in the measure of distance from the chord: the curve lies in their hull.
  const gp_XY a = spline->StartPoint().XY(), b = spline->EndPoint().XY(), way = b - a;
  std::array<double, 2> out{0, 0};
  for (int i = 1; i <= spline->NbPoles(); ++i) {
    const gp_XY p = spline->Pole(i).XY() - a;
    const double along = way.SquareModulus() > 0 ? std::clamp(p.Dot(way) / way.SquareModulus(), 0.0, 1.0) : 0;
    const gp_XY off = p - way * along;
    out[0] = std::max(out[0], std::abs(off.X()));
    out[1] = std::max(out[1], std::abs(off.Y()));
  }
  return out;
}

}  // namespace

void Range::hold(double u, double v) {
  u0 = std::min(u0, u);
  u1 = std::max(u1, u);
  v0 = std::min(v0, v);
  v1 = std::max(v1, v);
}

void Derivatives::raise(const Derivatives& other) {
  u = std::max(u, other.u);
  v = std::max(v, other.v);
  uu = std::max(uu, other.uu);
  uv = std::max(uv, other.uv);
  vv = std::max(vv, other.vv);
}

std::unique_ptr<const SurfaceBounds> SurfaceBounds::of(const Handle(Geom_Surface) & given) {
  const Handle(Geom_Surface) surface = untrimmed(given);
  if (!Handle(Geom_Plane)::DownCast(surface).IsNull())
    return std::make_unique<FixedBounds>(Derivatives{.u = 1, .v = 1});
  if (const auto s = Handle(Geom_CylindricalSurface)::DownCast(surface))
    return std::make_unique<FixedBounds>(Derivatives{.u = s->Radius(), .v = 1, .uu = s->Radius()});
  if (const auto s = Handle(Geom_ConicalSurface)::DownCast(surface))
    return std::make_unique<ConeBounds>(s->RefRadius(), s->SemiAngle());
  if (const auto s = Handle(Geom_SphericalSurface)::DownCast(surface))
    return std::make_unique<SphereBounds>(s->Radius());
  if (const auto s = Handle(Geom_ToroidalSurface)::DownCast(surface))
    return std::make_unique<TorusBounds>(s->MajorRadius(), s->MinorRadius());
  if (const auto s = Handle(Geom_BSplineSurface)::DownCast(surface)) return of_spline(s);
  if (const auto s = Handle(Geom_BezierSurface)::DownCast(surface))
    return of_patches(
        {0, 1}, {0, 1}, [&](std::size_t, std::size_t) { return s; }, false);
  return of_swept(surface);
}

std::string kind_of(const Handle(Geom_Surface) & given) {
  const Handle(Geom_Surface) surface = untrimmed(given);
  if (surface.IsNull()) return "face without a surface";
  if (!Handle(Geom_Plane)::DownCast(surface).IsNull()) return "plane";
  if (!Handle(Geom_CylindricalSurface)::DownCast(surface).IsNull()) return "cylinder";
  if (!Handle(Geom_ConicalSurface)::DownCast(surface).IsNull()) return "cone";
  if (!Handle(Geom_SphericalSurface)::DownCast(surface).IsNull()) return "sphere";
  if (!Handle(Geom_ToroidalSurface)::DownCast(surface).IsNull()) return "torus";
  if (const auto s = Handle(Geom_BSplineSurface)::DownCast(surface))
    return s->IsCNu(1) && s->IsCNv(1) ? "B-spline surface" : "B-spline surface with a crease";
  if (!Handle(Geom_BezierSurface)::DownCast(surface).IsNull()) return "Bezier surface";
  if (!Handle(Geom_SurfaceOfRevolution)::DownCast(surface).IsNull()) return "surface of revolution";
  if (!Handle(Geom_SurfaceOfLinearExtrusion)::DownCast(surface).IsNull()) return "surface of extrusion";
  if (!Handle(Geom_OffsetSurface)::DownCast(surface).IsNull()) return "offset surface";
  return "surface of another kind";
}

namespace {

/// The squared sides, from corner k to the next, by a diagonal form that bounds the second derivative.
std::array<double, 3> sides(const Derivatives& d, const std::array<std::array<double, 2>, 3>& corners) {
  std::array<std::array<double, 2>, 3> edge{};
  double most_u = 0, most_v = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    edge[k] = {corners[(k + 1) % 3][0] - corners[k][0], corners[(k + 1) % 3][1] - corners[k][1]};
    most_u = std::max(most_u, std::abs(edge[k][0]));
    most_v = std::max(most_v, std::abs(edge[k][1]));
  }
  // 2 |du dv| <= c du^2 + dv^2 / c
  double a = d.uu, b = d.vv;
  if (d.uv > 0 && most_u > 0 && most_v > 0) {
    a += d.uv * most_v / most_u;
    b += d.uv * most_u / most_v;
  }
  std::array<double, 3> q{};
  for (std::size_t k = 0; k < 3; ++k) q[k] = a * edge[k][0] * edge[k][0] + b * edge[k][1] * edge[k][1];
  return q;
}

}  // namespace

int longest_side(const Derivatives& d, const std::array<std::array<double, 2>, 3>& corners) {
  const std::array<double, 3> q = sides(d, corners);
  return int(std::max_element(q.begin(), q.end()) - q.begin());
}

double triangle_bound(const Derivatives& d, const std::array<std::array<double, 2>, 3>& corners) {
  std::array<double, 3> q = sides(d, corners);
  std::sort(q.begin(), q.end());
  const double area = 2 * (q[0] * q[1] + q[1] * q[2] + q[2] * q[0]) - q[0] * q[0] - q[1] * q[1] - q[2] * q[2];
  // No triangle's variance is above a third of its longest squared side.
  const double wide = q[2] / 3;
  const double variance = q[2] >= q[0] + q[1] ? q[2] / 4 : area > 0 ? std::min(q[0] * q[1] * q[2] / area, wide) : wide;
  return kRaised * variance / 2;
}

std::optional<std::array<double, 2>> chord_bound(const Handle(Geom2d_Curve) & given, double from, double to) {
  Handle(Geom2d_Curve) curve = given;
  while (const auto trimmed = Handle(Geom2d_TrimmedCurve)::DownCast(curve)) curve = trimmed->BasisCurve();
  if (from > to) std::swap(from, to);
  const double span = to - from;
  if (!Handle(Geom2d_Line)::DownCast(curve).IsNull()) return std::array<double, 2>{0, 0};
  double second = -1;
  if (const auto circle = Handle(Geom2d_Circle)::DownCast(curve)) second = circle->Radius();
  if (const auto ellipse = Handle(Geom2d_Ellipse)::DownCast(curve)) second = ellipse->MajorRadius();
  if (second >= 0) {
    const double off = kRaised * second * span * span / 8;
    return std::array<double, 2>{off, off};
  }
  if (const auto spline = Handle(Geom2d_BSplineCurve)::DownCast(curve)) {
    auto off = spline_chord(spline, from, to);
    if (off)
      for (double& o : *off) o *= kRaised;
    return off;
  }
  return std::nullopt;
}

}  // namespace findspace::cad
