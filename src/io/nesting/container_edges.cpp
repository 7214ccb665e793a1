// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "io/nesting/container_edges.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "io/draw/draw_view.h"
#include "space/convolution/ray_body.h"

namespace findspace::io {
namespace {

using space::Vector;

Point3d shown(const Vector& p) { return {p.x, p.y, p.z}; }
Vector vector_of(const Point3d& p) { return {p[0], p[1], p[2]}; }

/// The creases of a surface; those between two faces that are seen lie in front.
std::vector<DrawnEdge> edges_of_surface(double x, const space::Triangles& surface, double steps) {
  const space::RayBody body(surface);
  const auto corner = [&](int k) {
    const space::Point& p = body.points[std::size_t(k)];
    return Point3d{x + double(p.x) / steps, double(p.y) / steps, double(p.z) / steps};
  };
  const auto is_seen = [&](int face) {
    const auto& n = body.normal_approx[std::size_t(face)];
    return dot({n.x, n.y, n.z}, kTowards) > 0;
  };
  std::vector<DrawnEdge> edges;
  for (const space::RayEdge& e : body.edges)
    if (e.bend != 0) edges.push_back({corner(e.from), corner(e.to), is_seen(e.left) && is_seen(e.right)});
  return edges;
}

/// unit . x + shift <= 0, in units.
struct FlatSide {
  Vector unit;
  double shift;
  double at(const Vector& p) const { return space::dot(unit, p) + shift; }
};

/// Edges of parts, cut at the planes of the others. Whether a piece lies on a crease of the union is looked up at
/// places round its middle.
class UnionEdges {
 public:
  UnionEdges(double x, const space::Body& body, double steps) : body_(body), x_(x), steps_(steps * double(body.scale)) {
    for (const space::BodyPart& part : body.parts) {
      std::vector<FlatSide>& sides = parts_.emplace_back();
      for (const space::HalfSpace& h : part.planes()) sides.push_back({h.unit, h.shift / steps_});
      for (const space::Point& p : part.vertices()) size_ = std::max(size_, space::length(in_units(p)));
    }
  }

  std::vector<DrawnEdge> all() {
    for (const space::BodyPart& part : body_.parts)
      for (const space::HalfEdge& h : part.core->half_edges())
        if (h.origin < h.target)
          add(in_units(part.core->vertices()[std::size_t(h.origin)]),
              in_units(part.core->vertices()[std::size_t(h.target)]));
    return std::move(edges_);
  }

 private:
  static constexpr int kPlaces = 48;
  static constexpr double kAside = 1e-5;  // no sign: of the size, in a picture

  Vector in_units(const space::Point& p) const { return space::scaled(1 / steps_, exact::approx(p)); }

  void add(const Vector& from, const Vector& to) {
    std::vector<double> ends{0, 1};
    for (const std::vector<FlatSide>& sides : parts_) {
      if (are_beyond(sides, from, to)) continue;
      for (const FlatSide& side : sides) {
        const double first = side.at(from), last = side.at(to);
        if ((first < 0) != (last < 0)) ends.push_back(first / (first - last));
      }
    }
    std::sort(ends.begin(), ends.end());
    const Vector way = to - from;
    const auto at = [&](double t) { return space::plus(from, space::scaled(t, way)); };
    const double least = 4 * kAside * size_ / space::length(way);
    for (std::size_t k = 0; k + 1 < ends.size(); ++k)
      if (ends[k + 1] - ends[k] > least) add_piece(at(ends[k]), at(ends[k + 1]));
  }

  void add_piece(const Vector& from, const Vector& to) {
    const Vector way = to - from, middle = space::scaled(0.5, space::plus(from, to));
    const Vector other = std::abs(way.x) > std::abs(way.y) ? Vector{0, 1, 0} : Vector{1, 0, 0};
    const Vector across = unit_of(space::cross(way, other)), up = unit_of(space::cross(way, across));
    const auto about = [&](double place, double quarter) {
      const double angle = 2 * std::numbers::pi * (place + 0.37) / kPlaces + quarter * std::numbers::pi / 2;
      return space::plus(space::scaled(std::cos(angle), across), space::scaled(std::sin(angle), up));
    };
    std::array<bool, kPlaces> is_inside{};
    int inside = 0, faces = 0;
    for (int k = 0; k < kPlaces; ++k)
      inside += is_inside[std::size_t(k)] = holds(space::plus(middle, space::scaled(kAside * size_, about(k, 0))));
    bool all_seen = true;
    for (int k = 0; k < kPlaces; ++k) {
      const bool here = is_inside[std::size_t(k)], next = is_inside[std::size_t((k + 1) % kPlaces)];
      if (here == next) continue;
      ++faces;
      const Vector outward = about(k + 0.5, here ? 1 : -1);
      all_seen &= dot(shown(outward), kTowards) > 0;
    }
    const bool flat = faces == 2 && std::abs(inside - kPlaces / 2) <= 1;
    if (faces == 0 || flat) return;
    const Vector aside{x_, 0, 0};
    edges_.push_back({shown(space::plus(from, aside)), shown(space::plus(to, aside)), all_seen});
  }

  static Vector unit_of(const Vector& v) { return space::scaled(1 / space::length(v), v); }

  /// Whether one side of a part has both points, and what is near them, outside.
  bool are_beyond(const std::vector<FlatSide>& part, const Vector& p, const Vector& q) const {
    const double aside = 2 * kAside * size_;
    return std::any_of(part.begin(), part.end(),
                       [&](const FlatSide& side) { return side.at(p) > aside && side.at(q) > aside; });
  }

  bool holds(const Vector& p) const {
    return std::any_of(parts_.begin(), parts_.end(), [&](const std::vector<FlatSide>& sides) {
      return std::all_of(sides.begin(), sides.end(), [&](const FlatSide& side) { return side.at(p) <= 0; });
    });
  }

  const space::Body& body_;
  double x_, steps_, size_ = 0;
  std::vector<std::vector<FlatSide>> parts_;
  std::vector<DrawnEdge> edges_;
};

/// A circle in pieces; in front where it looks towards the eye.
void add_circle(const Vector& center, const Vector& first, const Vector& second, std::vector<DrawnEdge>& edges) {
  constexpr int kPieces = 96;
  const auto arm = [&](double k) {
    const double angle = 2 * std::numbers::pi * k / kPieces;
    return space::plus(space::scaled(std::cos(angle), first), space::scaled(std::sin(angle), second));
  };
  const double rim = 1e-9 * space::length(first);  // no sign: the outline itself lies behind
  for (int k = 0; k < kPieces; ++k)
    edges.push_back({shown(space::plus(center, arm(k))), shown(space::plus(center, arm(k + 1))),
                     dot(shown(arm(k + 0.5)), kTowards) > rim});
}

/// Of what the box and balls have in common, or convex parts, without what is lacking: outlines and equators of balls,
/// and the circles in which they meet each other, the box, and flat faces of what is lacking.
class CutEdges {
 public:
  CutEdges(double x, const packing::SolidContainer& container, double steps)
      : high_{container.width.to_double(), container.depth.to_double(), container.height.to_double()} {
    const auto add = [&](const packing::SolidForm& form, bool holds) {
      const double unit = steps * double(form.body.scale);
      for (const space::BodyPart& part : form.body.parts)
        if (!part.core)
          balls_.push_back(
              {space::scaled(1 / unit, exact::approx(part.center)), part.radius.to_double() / unit, holds});
        else if (!holds)
          add_part(part, unit);
    };
    add(*container.inside, true);
    if (container.lacks) add(*container.lacks, false);
    if (!container.inside->has_balls()) edges_ = UnionEdges(0, container.inside->body, steps).all();
    add_circles();
    std::erase_if(edges_, [&](const DrawnEdge& e) { return !is_on_boundary(middle_of(e)); });
    for (DrawnEdge& e : edges_) {
      e.from[0] += x;
      e.to[0] += x;
    }
  }

  std::vector<DrawnEdge> all() { return std::move(edges_); }

 private:
  static constexpr double kOff = 1e-3;  // no sign: what chords are off, of a radius

  struct Ball {
    Vector center;
    double radius;
    bool holds;  // else it is lacking
    double beyond(const Vector& p) const { return (space::length(p - center) / radius - 1) * (holds ? 1 : -1); }
    bool is_seen(const Vector& p) const { return (dot(shown(p - center), kTowards) > 0) == holds; }
  };
  static Vector middle_of(const DrawnEdge& e) {
    return space::scaled(0.5, space::plus(vector_of(e.from), vector_of(e.to)));
  }

  void add_part(const space::BodyPart& part, double unit) {
    std::vector<FlatSide>& sides = lacking_.emplace_back();
    for (const space::HalfSpace& h : part.planes()) sides.push_back({h.unit, h.shift / unit});
  }

  void add_circles() {
    const std::vector<FlatSide> box{{{1, 0, 0}, -high_.x}, {{-1, 0, 0}, 0},       {{0, 1, 0}, -high_.y},
                                    {{0, -1, 0}, 0},       {{0, 0, 1}, -high_.z}, {{0, 0, -1}, 0}};
    for (std::size_t k = 0; k < balls_.size(); ++k) {
      const Ball& ball = balls_[k];
      add_circle(ball.center, space::scaled(ball.radius, vector_of(kRight)), space::scaled(ball.radius, vector_of(kUp)),
                 edges_);
      add_circle(ball.center, {ball.radius, 0, 0}, {0, ball.radius, 0}, edges_);
      for (const FlatSide& face : box) add_section(ball, face, nullptr, dot(shown(face.unit), kTowards) > 0);
      for (const std::vector<FlatSide>& part : lacking_)
        for (const FlatSide& face : part) add_section(ball, face, &part, dot(shown(face.unit), kTowards) < 0);
      for (std::size_t l = 0; l < k; ++l) add_common(ball, balls_[l]);
    }
  }

  /// The circle in which a ball meets a plane; of a part only what lies on it.
  void add_section(const Ball& ball, const FlatSide& face, const std::vector<FlatSide>* part, bool is_face_seen) {
    const double far = face.at(ball.center), square = ball.radius * ball.radius - far * far;
    if (square <= kOff * ball.radius * ball.radius) return;
    const Vector aside = std::abs(face.unit.x) > std::abs(face.unit.y) ? Vector{0, 1, 0} : Vector{1, 0, 0};
    const Vector way = space::cross(face.unit, aside);
    const Vector first = space::scaled(std::sqrt(square) / space::length(way), way);
    std::vector<DrawnEdge> pieces;
    add_circle(ball.center - space::scaled(far, face.unit), first, space::cross(face.unit, first), pieces);
    for (DrawnEdge& piece : pieces) {
      const Vector p = middle_of(piece);
      if (part != nullptr && !is_within(*part, p, kOff * ball.radius)) continue;
      piece.is_in_front = is_face_seen && ball.is_seen(p);
      edges_.push_back(piece);
    }
  }

  void add_common(const Ball& a, const Ball& b) {
    const Vector way = b.center - a.center;
    const double apart = space::length(way);
    if (apart <= std::abs(a.radius - b.radius)) return;
    const double far = (apart * apart + a.radius * a.radius - b.radius * b.radius) / (2 * apart);
    const Vector unit = space::scaled(1 / apart, way);
    const std::size_t first = edges_.size();
    add_section(a, {unit, -space::dot(unit, a.center) - far}, nullptr, true);
    for (std::size_t k = first; k < edges_.size(); ++k) edges_[k].is_in_front &= b.is_seen(middle_of(edges_[k]));
  }

  /// In the box, not outside of a ball, and not within what is lacking.
  bool is_on_boundary(const Vector& p) const {
    const double off = kOff * std::max({high_.x, high_.y, high_.z});
    if (p.x < -off || p.y < -off || p.z < -off) return false;
    if (p.x > high_.x + off || p.y > high_.y + off || p.z > high_.z + off) return false;
    return std::none_of(balls_.begin(), balls_.end(), [&](const Ball& ball) { return ball.beyond(p) > kOff; }) &&
           std::none_of(lacking_.begin(), lacking_.end(),
                        [&](const std::vector<FlatSide>& part) { return is_within(part, p, -off); });
  }

  static bool is_within(const std::vector<FlatSide>& part, const Vector& p, double wider) {
    return std::all_of(part.begin(), part.end(), [&](const FlatSide& side) { return side.at(p) < wider; });
  }

  Vector high_;
  std::vector<Ball> balls_;
  std::vector<std::vector<FlatSide>> lacking_;
  std::vector<DrawnEdge> edges_;
};

}  // namespace

std::vector<DrawnEdge> edges_of_box(double x, const Point3d& sides) {
  constexpr std::array<std::array<int, 2>, 12> kEdges{
      {{0, 1}, {0, 2}, {0, 4}, {1, 3}, {2, 3}, {1, 5}, {2, 6}, {4, 5}, {4, 6}, {3, 7}, {5, 7}, {6, 7}}};
  const auto corner = [&](int k) {
    return Point3d{x + ((k & 1) != 0 ? sides[0] : 0), (k & 2) != 0 ? sides[1] : 0, (k & 4) != 0 ? sides[2] : 0};
  };
  std::vector<DrawnEdge> edges;
  for (const auto& [from, to] : kEdges) edges.push_back({corner(from), corner(to), to == 7});
  return edges;
}

std::vector<DrawnEdge> edges_of_container(double x, const packing::SolidProblem& problem,
                                          const packing::SolidContainer& c) {
  if (!c.inside) return edges_of_box(x, {c.width.to_double(), c.depth.to_double(), c.height.to_double()});
  const double steps = double(problem.steps());
  if (!c.inside->surface.empty()) return edges_of_surface(x, c.inside->surface[0].surface, steps);
  if (c.inside->has_balls() || c.lacks->has_balls()) return CutEdges(x, c, steps).all();
  return UnionEdges(x, c.inside->body, steps).all();
}

}  // namespace findspace::io
