// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/surface/surface_field.h"

#include <algorithm>

#include "distance/search/boundary_cells.h"
#include "exact/margins/rounding.h"
#include "exact/margins/space_distance.h"
#include "space/polytope/near_features.h"
#include "space/surface/surface_gap.h"

namespace findspace::distance {

using space::Vector;
using Sheet = space::SurfaceSet::Sheet;

namespace {

/// Triangles nearby that a plane may bound, at most.
constexpr std::size_t kFewBounding = 12;
/// Steps that shrink a ball.
constexpr int kShrinks = 40;

/// + if p is left of the line from a to b, seen from above; 0 where doubles do not tell.
int turn(const Vector& a, const Vector& b, const Vector& p) {
  const double u = (b.x - a.x) * (p.y - a.y), v = (b.y - a.y) * (p.x - a.x);
  const double bound = margin::kFewRoundings * (std::fabs(u) + std::fabs(v));
  return u - v > bound ? 1 : u - v < -bound ? -1 : 0;
}

/// The sign of the volume of three ways that span a tetrahedron; 0 where doubles do not tell.
int volume(const Vector& a, const Vector& b, const Vector& c) {
  const double terms[] = {a.x * b.y * c.z,  a.y * b.z * c.x,  a.z * b.x * c.y,
                          -a.z * b.y * c.x, -a.x * b.z * c.y, -a.y * b.x * c.z};
  double sum = 0, size = 0;
  for (const double t : terms) {
    sum += t;
    size += std::fabs(t);
  }
  return sum > margin::kVolumeNoise * size ? 1 : sum < -margin::kVolumeNoise * size ? -1 : 0;
}

/// Whether x lies in the solid, by the faces above it; nothing where doubles do not tell.
std::optional<bool> seen_inside(const Sheet& sheet, const Vector& x) {
  const auto below = [](double c) { return static_cast<std::int64_t>(std::floor(c)); };
  const space::GridBox column{{below(x.x), below(x.y), below(x.z)},
                              {below(x.x) + 1, below(x.y) + 1, std::int64_t{1} << 45}};
  int sum = 0;
  const bool unclear = sheet.tree.any_meeting(column, [&](int face) {
    const auto corner = [&](int k) { return exact::approx(sheet.body.corner(face, k)); };
    const Vector a = corner(0), b = corner(1), c = corner(2);
    const int ab = turn(a, b, x), bc = turn(b, c, x), ca = turn(c, a, x);
    if (ab * bc < 0 || bc * ca < 0 || ca * ab < 0) return false;
    if (ab == 0 || bc == 0 || ca == 0) return true;
    const int side = volume(a - x, b - x, c - x);  // + below the face, where it looks up
    if (side == ab) sum += ab;
    return side == 0;
  });
  if (unclear) return std::nullopt;
  return sum > 0;
}

/// Of a place that is so far from the surface, by one nearby on the same side, or by what is known where that is clear.
std::optional<bool> inside_of(const Sheet& sheet, const Vector& x, double away, std::optional<bool> known = {}) {
  const double limit = static_cast<double>(exact::kRayLimit);
  if (!(space::size_of(x) < limit)) return false;
  if (!(away >
        margin::kPlaceNoise * (space::size_of(x) + space::size_of(exact::approx(sheet.body.high - sheet.body.low)))))
    return std::nullopt;
  if (known) return known;
  const Vector ways[] = {{0, 0, 0}, {0.31, 0.17, 0.09}, {-0.23, 0.29, -0.07}, {0.11, -0.37, 0.13}, {-0.19, -0.13, 0.3}};
  for (const Vector& way : ways) {
    if (const auto found = seen_inside(sheet, space::plus(x, space::scaled(away, way)))) return found;
  }
  return std::nullopt;
}

}  // namespace

FaceBoxes::FaceBoxes(const space::BoxTree& tree) {
  const auto rounded = [](const space::GridBox& box) { return Box{exact::approx(box.low), exact::approx(box.high)}; };
  int faces = 0;
  for (const space::BoxTree::Node& node : tree.nodes()) {
    nodes_.push_back({rounded(node.box), node.first, node.count});
    faces += node.count;
  }
  for (int k = 0; k < faces; ++k) {
    boxes_.push_back(rounded(tree.box(k)));
    faces_.push_back(tree.face(k));
  }
}

template <class Visit>
void FaceBoxes::near(const Vector& x, double& most, Visit visit) const {
  struct Task {
    int node;
    double gap;
  };
  std::array<Task, 128> stack;
  std::size_t depth = 0;
  stack[depth++] = {0, squared_gap(nodes_[0].box, x)};
  while (depth > 0) {
    const Task top = stack[--depth];
    if (!(top.gap <= most * most)) continue;
    const Node& node = nodes_[static_cast<std::size_t>(top.node)];
    if (node.count == 0) {
      const auto child = static_cast<std::size_t>(node.first);
      Task one{node.first, squared_gap(nodes_[child].box, x)},
          two{node.first + 1, squared_gap(nodes_[child + 1].box, x)};
      if (one.gap < two.gap) std::swap(one, two);
      if (one.gap <= most * most) stack[depth++] = one;
      stack[depth++] = two;
      continue;
    }
    for (int k = node.first; k < node.first + node.count; ++k) {
      const auto face = static_cast<std::size_t>(k);
      if (squared_gap(boxes_[face], x) <= most * most && !visit(faces_[face])) return;
    }
  }
}

SurfaceField::SurfaceField(const space::SurfaceSet& set, const Vector& by) : set_(set), by_(by), first_{0} {
  for (const auto& sheet : set.sheets()) {
    boxes_.emplace_back(sheet->tree);
    const space::RayBody& body = sheet->body;
    const double size = space::size_of(exact::approx(body.low)) + space::size_of(exact::approx(body.high));
    blur_ = std::max(blur_,
                     2 * margin::kFaceProjection * sheet->longest + margin::kPlaceNoise * (size + space::size_of(by)));
    for (int f = 0; f < static_cast<int>(body.faces.size()); ++f) {
      std::array<Vector, 3>& corners = corners_.emplace_back();
      for (int k = 0; k < 3; ++k) corners[std::size_t(k)] = space::plus(exact::approx(body.corner(f, k)), by);
    }
    first_.push_back(static_cast<int>(corners_.size()));
  }
}

space::Extent SurfaceField::box() const {
  space::Extent out{{exact::kInfinity, exact::kInfinity, exact::kInfinity},
                    {-exact::kInfinity, -exact::kInfinity, -exact::kInfinity}};
  for (const auto& triangle : corners_) {
    for (const Vector& v : triangle) out.add({v, v});
  }
  for (const auto& ball : set_.balls()) {
    const Vector center = space::plus(exact::approx(ball.center), by_);
    out.add(grown({center, center}, ball.radius.to_double()));
  }
  return out;
}

SurfaceField::Signed SurfaceField::at(const Vector& place, const Known& known) const {
  const Vector x = place - by_;
  // Which one of several holds the place is not known.
  std::optional<bool> known_inside;
  if (known.side > 0 || (known.side < 0 && set_.one_sheet())) known_inside = known.side < 0;
  Signed out{exact::kInfinity, exact::kInfinity, true};
  const auto offer = [&](const Signed& next) {
    if (next.value < out.value) out = next;
  };
  for (std::size_t k = 0; k < set_.sheets().size(); ++k) {
    const auto& sheet = set_.sheets()[k];
    double least = exact::kInfinity;
    int nearest = -1;
    const auto look = [&](int face) {
      const double d = nearer(first_[k] + face, place, least);
      if (d < least || nearest < 0) {
        least = d;
        nearest = face;
      }
      return true;
    };
    if (first_[k] <= known.part && known.part < first_[k + 1]) look(known.part - first_[k]);
    boxes_[k].near(x, least, look);
    const auto side = inside_of(*sheet, x, least, known_inside);
    const Vector projection = space::plus(space::nearest_place(*sheet, nearest, x), by_);
    offer({side.value_or(false) ? -least : least, least, side.has_value(), projection, first_[k] + nearest});
  }
  int part = first_.back();
  for (const auto& ball : set_.balls()) {
    const double d = space::length(x - exact::approx(ball.center)) - ball.radius.to_double();
    const Vector way = x - exact::approx(ball.center);
    const Vector projection = space::plus(place, space::scaled(-d / space::length(way), way));
    offer({d, std::fabs(d), true, projection, part++});
  }
  return out;
}

SurfaceField::Nearest SurfaceField::nearest(const Vector& place, double enough, std::span<const int> likely) const {
  Nearest best;
  const auto offer = [&](int part, double d) {
    if (d < best.distance) best = {d, part};
  };
  for (const int part : likely) offer(part, distance_to_place(part, place));
  const Vector x = place - by_;
  for (std::size_t k = 0; k < set_.sheets().size() && best.distance > enough; ++k) {
    boxes_[k].near(x, best.distance, [&](int face) {
      const int part = first_[k] + face;
      offer(part, nearer(part, place, best.distance));
      return best.distance > enough;
    });
  }
  for (std::size_t k = 0; k < set_.balls().size() && best.distance > enough; ++k) {
    const int part = first_.back() + static_cast<int>(k);
    offer(part, distance(part, place));
  }
  return best;
}

std::optional<bool> SurfaceField::inside(const Vector& place, double away) const {
  if (away < 0) return true;  // in a ball
  const Vector x = place - by_;
  bool certain = true;
  for (const auto& sheet : set_.sheets()) {
    const auto in = inside_of(*sheet, x, away);
    if (in.value_or(false)) return true;
    certain = certain && in;
  }
  return certain ? std::optional(false) : std::nullopt;
}

double SurfaceField::distance_to_ball(int part, const Vector& x) const {
  const auto& ball = set_.balls()[static_cast<std::size_t>(part - first_.back())];
  return space::length(x - space::plus(exact::approx(ball.center), by_)) - ball.radius.to_double();
}

double SurfaceField::distance(int part, const Vector& x) const {
  if (part >= first_.back()) return distance_to_ball(part, x);
  const auto& [a, b, c] = corners_[static_cast<std::size_t>(part)];
  using space::near::triple;
  return std::sqrt(space::near::squared_of_triangle(triple(a - x), triple(b - x), triple(c - x)));
}

double SurfaceField::nearer(int part, const Vector& x, double than) const {
  return distance_to_place(part, x) > than + blur_ ? exact::kInfinity : distance(part, x);
}

double SurfaceField::distance_to_place(int part, const Vector& x) const {
  if (part >= first_.back()) return distance_to_ball(part, x);
  const auto& [a, b, c] = corners_[static_cast<std::size_t>(part)];
  using space::near::triple;
  const auto way = space::near::nearest_of_triangle(triple(a - x), triple(b - x), triple(c - x));
  return std::sqrt(space::near::dot(way, way));
}

std::optional<Vector> SurfaceField::normal(int part) const {
  if (part >= first_.back()) return std::nullopt;
  const auto& [a, b, c] = corners_[static_cast<std::size_t>(part)];
  const Vector n = space::cross(b - a, c - a);
  return space::scaled(1 / space::length(n), n);
}

std::optional<InnerBall> SurfaceField::inner_ball(int part) const {
  if (part >= first_.back()) {
    const auto& ball = set_.balls()[static_cast<std::size_t>(part - first_.back())];
    return InnerBall{space::plus(exact::approx(ball.center), by_), ball.radius.to_double() * (1 - margin::kBallShrunk)};
  }
  const auto sheet =
      static_cast<std::size_t>(std::upper_bound(first_.begin(), first_.end(), part) - first_.begin() - 1);
  const space::RayBody& body = set_.sheets()[sheet]->body;
  const auto& [a, b, c] = corners_[static_cast<std::size_t>(part)];
  const Vector from = space::scaled(1.0 / 3, space::plus(a, space::plus(b, c)));
  const Vector normal = body.normal_approx[static_cast<std::size_t>(part - first_[sheet])];
  const Vector inward = space::scaled(-1 / space::length(normal), normal);
  const Vector wide = exact::approx(body.high - body.low);
  double radius = std::min({wide.x, wide.y, wide.z}) / 2;  // none is larger
  for (int k = 0; k < kShrinks; ++k) {
    const Vector center = space::plus(from, space::scaled(radius, inward));
    const double enough = radius * (1 - margin::kBallTouches);
    double least = enough;
    int within = -1;  // a face that the ball is to be shrunk by
    boxes_[sheet].near(center - by_, least, [&](int face) {
      if (distance(first_[sheet] + face, center) < enough) within = face;
      return within < 0;
    });
    if (within < 0) break;
    const Vector way = place(first_[sheet] + within, center) - from;
    const double along = 2 * space::dot(way, inward);
    if (!(along > 0)) break;
    radius = std::min(radius, space::dot(way, way) / along);
  }
  const Vector center = space::plus(from, space::scaled(radius, inward));
  const Signed there = at(center);
  if (!there.certain || !(there.value < 0)) return std::nullopt;
  return InnerBall{center, there.distance * (1 - margin::kBallShrunk)};
}

Vector SurfaceField::place(int part, const Vector& x) const {
  if (part >= first_.back()) {
    const auto& ball = set_.balls()[static_cast<std::size_t>(part - first_.back())];
    const Vector center = space::plus(exact::approx(ball.center), by_), way = x - center;
    return space::plus(center, space::scaled(ball.radius.to_double() / space::length(way), way));
  }
  const auto& [a, b, c] = corners_[static_cast<std::size_t>(part)];
  using space::near::triple;
  const auto way = space::near::nearest_of_triangle(triple(a - x), triple(b - x), triple(c - x));
  return space::plus(x, {way[0], way[1], way[2]});
}

std::optional<std::vector<int>> SurfaceField::near(const Vector& place, double within, std::size_t most) const {
  const Vector x = place - by_;
  std::vector<int> out;
  for (std::size_t k = 0; k < set_.sheets().size(); ++k) {
    double reach = within;
    boxes_[k].near(x, reach, [&](int face) {
      if (distance(first_[k] + face, place) <= within) out.push_back(first_[k] + face);
      return out.size() <= most;
    });
    if (out.size() > most) return std::nullopt;
  }
  for (std::size_t k = 0; k < set_.balls().size(); ++k) {
    const int part = first_.back() + static_cast<int>(k);
    if (distance(part, place) <= within) out.push_back(part);
  }
  if (out.empty() || out.size() > most) return std::nullopt;
  return out;
}

std::optional<space::PlaneTree::Plane> SurfaceField::bounding_plane(const Vector& x, double reach) const {
  // Else a surface may lie within another solid, or be a wall within this one.
  if (!set_.one_frontier()) return std::nullopt;
  const auto parts = near(x, reach * (1 + margin::kRayNoise), kFewBounding);
  if (!parts) return std::nullopt;
  std::optional<space::PlaneTree::Plane> best;
  for (const int part : *parts) {
    const Vector unit = *normal(part), &first = corners_[static_cast<std::size_t>(part)][0];
    const double off = margin::kPlaceNoise * (space::size_of(first) + space::size_of(x) + reach);
    const space::PlaneTree::Plane plane{unit, -space::dot(unit, first) - off};
    const bool all_below = std::all_of(parts->begin(), parts->end(), [&](int other) {
      const auto& corners = corners_[static_cast<std::size_t>(other)];
      return std::all_of(corners.begin(), corners.end(), [&](const Vector& v) { return plane.beyond(v) <= 0; });
    });
    if (all_below && (!best || plane.beyond(x) > best->beyond(x))) best = plane;
  }
  return best;
}

}  // namespace findspace::distance
