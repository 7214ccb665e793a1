// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "io/read/read_dxf_entities.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <numbers>

#include "findspace/error.h"

namespace findspace::io {
namespace {

using exact::Real;
using std::numbers::pi;

/// An angle less than this short of a full one is a full one: it is written with few digits.
constexpr double kFullTurn = 2 * pi - 1.0 / 100000;

/// How far it is from one angle to the other, counter-clockwise, in radians: more than 0, and a full turn at most.
double turn(double from, double to) {
  constexpr double kMost = 2000 * pi;  // a thousand turns
  if (!(std::abs(from) <= kMost && std::abs(to) <= kMost))
    throw Error(ErrorCode::kBadValue, "an angle of more than a thousand turns");
  double sweep = to - from;
  while (sweep <= 0) sweep += 2 * pi;
  return std::min(sweep, 2 * pi);
}

class EntityDrawer {
 public:
  EntityDrawer(const DxfDocument& document, const DxfEntity& entity, const Affine& map, Outline& outline)
      : document_(document), e_(entity), map_(map), outline_(outline) {}

  bool draw() {
    struct Kind {
      std::string_view type;
      void (EntityDrawer::*draw)();
      bool own_plane;  // its numbers are those of its own plane
    };
    static constexpr std::array<Kind, 10> kKinds{{{"LINE", &EntityDrawer::line, false},
                                                  {"CIRCLE", &EntityDrawer::circle, true},
                                                  {"ARC", &EntityDrawer::arc, true},
                                                  {"ELLIPSE", &EntityDrawer::ellipse, false},
                                                  {"SPLINE", &EntityDrawer::spline, false},
                                                  {"POINT", &EntityDrawer::point, false},
                                                  {"LWPOLYLINE", &EntityDrawer::light_polyline, true},
                                                  {"POLYLINE", &EntityDrawer::polyline, true},
                                                  {"SOLID", &EntityDrawer::solid, true},
                                                  {"TRACE", &EntityDrawer::solid, true}}};
    const auto kind = std::find_if(kKinds.begin(), kKinds.end(), [&](const Kind& k) { return k.type == e_.type; });
    if (kind == kKinds.end()) return false;
    if (kind->own_plane && !is_in_space()) map_ = map_ * dxf_plane(document_, e_);
    (this->*kind->draw)();
    return true;
  }

 private:
  struct Vertex {
    Real x, y, bulge;
  };

  /// A polyline in space, of which a plane of its own has no meaning.
  bool is_in_space() const {
    constexpr int kSpace = 8;
    return e_.type == "POLYLINE" && (document_.flags(e_, 70) & kSpace) != 0;
  }

  Real number(int code) const { return document_.number(e_, code); }
  Placed out() const { return {map_, outline_}; }

  void line() {
    Placed to = out();
    to.move_to(number(10), number(20));
    to.line_to(number(11), number(21));
    to.finish();
  }

  void circle() { out().circle(number(10), number(20), number(40)); }
  void point() { out().point(number(10), number(20)); }

  void arc() {
    Real x = number(10), y = number(20), r = number(40), from = number(50), to = number(51);
    if (r.sign() <= 0) throw Error(ErrorCode::kBadValue, "a radius must be more than 0");
    Real sweep = to - from;
    sweep = sweep - Real(360) * Real(floor(sweep / Real(360)));
    Placed placed = out();
    if (sweep.sign() == 0 || sweep.to_double() * (pi / 180) > kFullTurn) return placed.circle(x, y, r);
    Direction a = direction(from), b = direction(to);
    placed.move_to(x + r * a.cosine, y + r * a.sine);
    placed.arc_to(r, Real(180) < sweep, true, x + r * b.cosine, y + r * b.sine);
    placed.finish();
  }

  void ellipse() {
    const Real ux = number(11), uy = number(21), ratio = number(40);
    if (ux.sign() == 0 && uy.sign() == 0) throw Error(ErrorCode::kBadValue, "an ellipse without a major axis");
    if (ratio.sign() <= 0) throw Error(ErrorCode::kBadValue, "the ratio of an ellipse's axes must be more than 0");
    const int up = dxf_plane(document_, e_).mirrors ? -1 : 1;
    EllipseArc arc{{{number(10), number(20)}, {ux, uy}, {-uy * ratio * Real(up), ux * ratio * Real(up)}}};
    arc.first = document_.number(e_, 41, 0).to_double();
    arc.sweep = turn(arc.first, document_.number(e_, 42, Real::from_double(2 * pi)).to_double());
    Placed placed = out();
    if (arc.sweep > kFullTurn) {
      arc.sweep = 2 * pi;
      return placed.ellipse(arc);
    }
    const plane::CurvePoint from = ellipse_point(arc, 0), to = ellipse_point(arc, arc.sweep);
    placed.move_to(from.x, from.y);
    placed.ellipse_to(arc, to.x, to.y);
    placed.finish();
  }

  void spline() {
    constexpr int kClosed = 1;
    plane::Spline s;
    s.degree = static_cast<std::size_t>(document_.flags(e_, 71));
    bool fitted = false;
    for (const DxfGroup& g : e_.groups) {
      if (g.code == 40) s.knots.push_back(document_.number(g));
      if (g.code == 41) s.weights.push_back(document_.number(g));
      if (g.code == 10) s.points.push_back({document_.number(g), Real(0)});
      if (g.code == 20 && !s.points.empty()) s.points.back().y = document_.number(g);
      fitted = fitted || g.code == 11;
    }
    if (s.points.empty() && fitted)
      throw Error(ErrorCode::kUnsupported,
                  "a SPLINE that states only the points it goes through leaves open how it runs between them; "
                  "save it with control points, or as arcs");
    if (std::all_of(s.weights.begin(), s.weights.end(), [](const Real& w) { return w == Real(1); })) s.weights.clear();
    out().spline(std::move(s), (document_.flags(e_, 70) & kClosed) != 0);
  }

  void run(const std::vector<Vertex>& v, bool closed) {
    if (v.empty()) throw Error(ErrorCode::kGeometry, "a polyline without vertices");
    Placed placed = out();
    placed.move_to(v[0].x, v[0].y);
    if (v.size() == 1) {  // draws nothing
      placed.line_to(v[0].x, v[0].y);
      return placed.finish();
    }
    for (std::size_t i = 1; i < v.size(); ++i) placed.bulge_to(v[i - 1].bulge, v[i].x, v[i].y);
    if (!closed) return placed.finish();
    if (v.back().bulge.sign() != 0) placed.bulge_to(v.back().bulge, v[0].x, v[0].y);
    placed.close();
  }

  void light_polyline() {
    std::vector<Vertex> v;
    for (const DxfGroup& group : e_.groups) {
      if (group.code == 10) v.push_back({document_.number(group), 0, 0});
      if (v.empty()) continue;
      if (group.code == 20) v.back().y = document_.number(group);
      if (group.code == 42) v.back().bulge = document_.number(group);
    }
    run(v, (document_.flags(e_, 70) & 1) != 0);
  }

  /// Of fitted curves the vertices that were made by the fit.
  void polyline() {
    constexpr int kMesh = 16 | 64, kFrame = 16;
    const int flags = document_.flags(e_, 70);
    if ((flags & kMesh) != 0) throw Error(ErrorCode::kUnsupported, "a POLYLINE that is a mesh");
    std::vector<Vertex> v;
    for (const DxfEntity& vertex : e_.vertices) {
      if ((document_.flags(vertex, 70) & kFrame) != 0) continue;
      v.push_back({document_.number(vertex, 10), document_.number(vertex, 20), document_.number(vertex, 42, 0)});
    }
    run(v, (flags & 1) != 0);
  }

  /// Corners in the order 1 2 4 3; the last may be the third again.
  void solid() {
    std::vector<Vertex> v;
    for (int k : {0, 1, 3, 2}) {
      if (k == 3 && e_.find(13) == nullptr) continue;
      v.push_back({number(10 + k), number(20 + k), 0});
    }
    run(v, true);
  }

  const DxfDocument& document_;
  const DxfEntity& e_;
  Affine map_;
  Outline& outline_;
};

/// The groups of a HATCH in their order.
class HatchDrawer {
 public:
  HatchDrawer(const DxfDocument& document, const DxfEntity& entity, const Affine& map, Outline& outline)
      : document_(document), e_(entity), placed_(map * dxf_plane(document, entity), outline) {}

  void draw() {
    const std::size_t loops = count(91);
    constexpr int kPolyline = 2;
    for (std::size_t i = 0; i < loops; ++i) {
      if ((static_cast<int>(count(92)) & kPolyline) != 0)
        polyline();
      else
        edges();
    }
  }

 private:
  /// The next group of this code; those before it are passed over.
  const DxfGroup& next(int code) {
    while (at_ < e_.groups.size() && e_.groups[at_].code != code) ++at_;
    if (at_ == e_.groups.size())
      throw Error(ErrorCode::kSyntax, fmt::format("the loops of a HATCH end before a group {}", code));
    return e_.groups[at_++];
  }
  bool follows(int code) const { return at_ < e_.groups.size() && e_.groups[at_].code == code; }
  Real number(int code) { return document_.number(next(code)); }
  std::size_t count(int code) {
    const auto n = number(code).integer();
    if (!n || *n < 0 || *n > 1 << 20) throw Error(ErrorCode::kBadValue, fmt::format("group {} is not a count", code));
    return static_cast<std::size_t>(*n);
  }
  plane::CurvePoint point(int code) {
    Real x = number(code);
    return {std::move(x), number(code + 10)};
  }

  void polyline() {
    count(72);  // whether there are bulges
    count(73);  // closed; a loop always is
    const std::size_t n = count(93);
    Real bulge;
    for (std::size_t i = 0; i < n; ++i) {
      const plane::CurvePoint p = point(10);
      if (i == 0)
        placed_.move_to(p.x, p.y);
      else
        placed_.bulge_to(bulge, p.x, p.y);
      if (i == 0) first_ = p;
      bulge = follows(42) ? number(42) : Real(0);
    }
    if (bulge.sign() != 0) placed_.bulge_to(bulge, first_.x, first_.y);
    placed_.close();
  }

  void edges() {
    const std::size_t n = count(93);
    begun_ = false;
    for (std::size_t i = 0; i < n; ++i) {
      switch (count(72)) {
        case 1:
          line();
          break;
        case 2:
          arc(false);
          break;
        case 3:
          arc(true);
          break;
        default:
          spline();
      }
    }
    if (begun_) placed_.close();
  }

  void begin(const plane::CurvePoint& p) {
    if (!begun_) placed_.move_to(p.x, p.y);
    begun_ = true;
  }

  void line() {
    begin(point(10));
    const plane::CurvePoint to = point(11);
    placed_.line_to(to.x, to.y);
  }

  /// Angles of clockwise ones are measured clockwise.
  void arc(bool elliptical) {
    EllipseArc a;
    a.frame.center = point(10);
    if (elliptical) a.frame.u = point(11);
    const Real r = number(40);
    if (!elliptical) a.frame.u = {r, Real(0)};
    const Real ratio = elliptical ? r : Real(1);
    a.frame.v = {-a.frame.u.y * ratio, a.frame.u.x * ratio};
    const double from = number(50).to_double() * (pi / 180), to = number(51).to_double() * (pi / 180);
    const int way = count(73) == 0 ? -1 : 1;
    a.first = from * way;
    a.sweep = turn(from, to);
    if (a.sweep > kFullTurn && !begun_) {
      if (!elliptical) return placed_.circle(a.frame.center.x, a.frame.center.y, r);
      a.sweep = 2 * pi;
      return placed_.ellipse(a);
    }
    a.sweep *= way;
    begin(ellipse_point(a, 0));
    const plane::CurvePoint end = ellipse_point(a, a.sweep);
    if (elliptical) return placed_.ellipse_to(a, end.x, end.y);
    placed_.arc_to(r, std::abs(a.sweep) > pi, way > 0, end.x, end.y);
  }

  void spline() {
    plane::Spline s;
    s.degree = count(94);
    const bool rational = count(73) != 0;
    count(74);
    const std::size_t knots = count(95), points = count(96);
    for (std::size_t i = 0; i < knots; ++i) s.knots.push_back(number(40));
    for (std::size_t i = 0; i < points; ++i) {
      s.points.push_back(point(10));
      if (rational) s.weights.push_back(number(42));
    }
    plane::check_spline(s);
    begin(plane::spline_end(s, false));
    placed_.spline_to(std::move(s));
  }

  const DxfDocument& document_;
  const DxfEntity& e_;
  Placed placed_;
  std::size_t at_ = 0;
  bool begun_ = false;
  plane::CurvePoint first_;
};

}  // namespace

bool draw_dxf_entity(const DxfDocument& document, const DxfEntity& entity, const Affine& map, Outline& outline) {
  return EntityDrawer(document, entity, map, outline).draw();
}

void draw_dxf_hatch(const DxfDocument& document, const DxfEntity& entity, const Affine& map, Outline& outline) {
  HatchDrawer(document, entity, map, outline).draw();
}

Affine dxf_plane(const DxfDocument& document, const DxfEntity& entity) {
  const Real z = document.number(entity, 230, 1);
  const bool flat = document.number(entity, 210, 0).sign() == 0 && document.number(entity, 220, 0).sign() == 0;
  if (flat && z.sign() > 0) return {};
  if (flat && z.sign() < 0) return Affine::scaling(-1, 1);
  throw Error(ErrorCode::kUnsupported, "its plane is slanted (extrusion direction other than 0, 0, 1 or 0, 0, -1)");
}

namespace {

/// Whether a group of these codes, of the entity or of one of its vertices, is not 0.
bool states(const DxfDocument& document, const DxfEntity& entity, std::initializer_list<int> codes) {
  const auto counts = [&](const DxfGroup& g) {
    return std::find(codes.begin(), codes.end(), g.code) != codes.end() && document.number(g).sign() != 0;
  };
  return std::any_of(entity.groups.begin(), entity.groups.end(), counts) ||
         std::any_of(entity.vertices.begin(), entity.vertices.end(),
                     [&](const DxfEntity& v) { return states(document, v, codes); });
}

}  // namespace

bool is_raised(const DxfDocument& document, const DxfEntity& entity) {
  return states(document, entity, {30, 31, 32, 33, 38});
}

bool has_width(const DxfDocument& document, const DxfEntity& entity) {
  const bool line = entity.type == "LWPOLYLINE" || entity.type == "POLYLINE";
  return line && states(document, entity, {40, 41, 43});
}

}  // namespace findspace::io
