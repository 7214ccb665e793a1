// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/rotation/rough_contact.h"

#include <algorithm>
#include <cmath>

#include "exact/margins/plane.h"

namespace findspace::plane {
namespace {

RoughPoint rounded_point(const RealVector& v) { return {v.x.to_double(), v.y.to_double()}; }

double square_away(RoughPoint at, RoughPoint p, RoughPoint q) {
  const RoughPoint way = q - p;
  const double whole = std::norm(way), part = whole > 0 ? std::clamp(dot(at - p, way) / whole, 0.0, 1.0) : 0.0;
  return std::norm(at - p - part * way);
}

}  // namespace

RoughContact::RoughContact(const RotatedNet& rotating, const RotatedNet& fixed) {
  vertices_.reserve(rotating.vertex_count());
  for (Index v = 0; v < rotating.vertex_count(); ++v) vertices_.push_back(rounded_point(rotating.vertex(v)));
  std::vector<char> on_edge(fixed.vertex_count(), 0);
  lines_.reserve(fixed.edges().size());
  for (const RoughPoint& v : vertices_) reach_ = std::max(reach_, length(v));
  for (const Index k : fixed.edges()) {
    const RotatedEdge e = fixed.edge(k);
    lines_.push_back({rounded_point(e.p), rounded_point(e.q), box_of(e), e.arc});
    reach_ = std::max({reach_, length(lines_.back().p), length(lines_.back().q)});
    on_edge[e.v0] = on_edge[e.v1] = 1;
  }
  for (Index v = 0; v < fixed.vertex_count(); ++v) {
    if (on_edge[v]) continue;
    alone_.push_back(rounded_point(fixed.vertex(v)));
    reach_ = std::max(reach_, length(alone_.back()));
  }
}

void RoughContact::set(const exact::ExactAngle& angle, const RealVector& shift) {
  shift_ = rounded_point(shift);
  rotation_ = {angle.cos.to_double(), angle.sin.to_double()};
  tolerance_ = margin::kRotatedPoint * (reach_ + length(shift_));
}

bool RoughContact::is_near(const Line& f, RoughPoint at) const {
  const RoughBox& b = f.box;
  if (at.real() < b.x0 - tolerance_ || at.real() > b.x1 + tolerance_ || at.imag() < b.y0 - tolerance_ ||
      at.imag() > b.y1 + tolerance_)
    return false;
  return f.arc || square_away(at, f.p, f.q) <= tolerance_ * tolerance_;
}

std::optional<RoughPoint> RoughContact::clear(Index vertex) const {
  const RoughPoint at = now(vertex);
  for (const Line& f : lines_)
    if (is_near(f, at)) return std::nullopt;
  for (const RoughPoint& p : alone_)
    if (std::norm(at - p) <= tolerance_ * tolerance_) return std::nullopt;
  return at;
}

std::optional<std::vector<Index>> RoughContact::crossed(const Edge& e) const {
  if (e.half != 0) return std::nullopt;
  const RoughPoint p = now(e.v0), q = now(e.v1), d = q - p;
  const RoughBox box{std::min(p.real(), q.real()) - tolerance_, std::min(p.imag(), q.imag()) - tolerance_,
                     std::max(p.real(), q.real()) + tolerance_, std::max(p.imag(), q.imag()) + tolerance_};
  for (const RoughPoint& a : alone_)
    if (square_away(a, p, q) <= tolerance_ * tolerance_) return std::nullopt;
  const double r = tolerance_ * length(d);
  std::vector<Index> out;
  for (Index k = 0; k < lines_.size(); ++k) {
    const Line& f = lines_[k];
    if (box.apart(f.box)) continue;
    if (f.arc) return std::nullopt;
    const double a = cross(d, f.p - p), b = cross(d, f.q - p);
    if ((a > r && b > r) || (a < -r && b < -r)) continue;
    const RoughPoint g = f.q - f.p;
    const double s = tolerance_ * length(g), u = cross(g, p - f.p), v = cross(g, q - f.p);
    if ((u > s && v > s) || (u < -s && v < -s)) continue;
    if (std::abs(a) <= r || std::abs(b) <= r || std::abs(u) <= s || std::abs(v) <= s) return std::nullopt;
    out.push_back(k);
  }
  return out;
}

}  // namespace findspace::plane
