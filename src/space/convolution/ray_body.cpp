// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/convolution/ray_body.h"

#include <findspace/error.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <string>

#include "space/mesh/mesh.h"

namespace findspace::space {
namespace {

/// A side of a triangle, number 3 f + k, in the group of its two ends.
struct Side {
  int low = 0, high = 0, id = 0;
  bool rising = false;
};

struct Sides {
  const RayBody& body;

  int from(int side) const { return body.faces[side / 3][side % 3]; }
  int to(int side) const { return body.faces[side / 3][(side % 3 + 1) % 3]; }
  const Point& apex(int side) const { return body.points[body.faces[side / 3][(side % 3 + 2) % 3]]; }
};

using Fault = std::optional<exact::Refusal>;

Fault fault(const std::string& what) { return exact::Refusal(Error(ErrorCode::kGeometry, what)); }

/// Whether, turning clockwise about the line a b from the half-plane of p, that of q is met before that of r; the
/// half-plane of p itself is met last, after a whole turn.
bool before_clockwise(const Point& a, const Point& b, const Point& p, const Point& q, const Point& r) {
  const auto look = [&](const Point& x) { return exact::lexicographic_sign(exact::cross(b - a, x - a)); };
  // Turning positively about b - a leads from x to y by less than half a turn iff the volume a, b, x, y is positive.
  const auto turns = [&](const Point& x) {  // less than half, half, more than half, a whole one
    const int s = exact::sign_volume(a, b, p, x);
    return s < 0 ? 0 : s > 0 ? 2 : look(x) == look(p) ? 3 : 1;
  };
  const int of_q = turns(q), of_r = turns(r);
  return of_q != of_r ? of_q < of_r : exact::sign_volume(a, b, q, r) < 0;
}

/// "... (0, 0, 0) (1, 0, 0)": of an edge.
Fault fault_at(const std::string& what, const Point& from, const Point& to, double step) {
  const std::array<Point, 2> ends{from, to};
  return fault(what + " " + places_text(ends, step));
}

/// Pairs the sides of one edge; `group` are its sides. Each rising one gets the first falling one clockwise: solid
/// between.
Fault pair_group(const RayBody& body, const std::vector<Side>& group, double step, std::vector<int>& twin) {
  if (group.size() == 2 && group[0].rising != group[1].rising) {
    twin[group[0].id] = group[1].id;
    twin[group[1].id] = group[0].id;
    return std::nullopt;
  }
  const Sides sides{body};
  std::vector<int> rising, falling;
  for (const Side& s : group) (s.rising ? rising : falling).push_back(s.id);
  if (rising.size() != falling.size())
    return fault_at("the surface is not closed: there are " + std::to_string(group.size()) + " faces at the edge",
                    body.points[sides.from(group[0].id)], body.points[sides.to(group[0].id)], step);
  for (const int r : rising) {
    const Point &a = body.points[sides.from(r)], &b = body.points[sides.to(r)];
    int best = -1;
    for (const int f : falling) {
      if (best < 0 || before_clockwise(a, b, sides.apex(r), sides.apex(f), sides.apex(best))) best = f;
    }
    if (best < 0 || twin[best] >= 0) return fault_at("faces cross or repeat at the edge", a, b, step);
    twin[r] = best;
    twin[best] = r;
  }
  return std::nullopt;
}

/// By their lower vertex, then the higher one, then by number.
std::vector<Side> sorted_sides(const RayBody& body) {
  const Sides at{body};
  const int count = static_cast<int>(body.faces.size() * 3);
  std::vector<std::size_t> first(body.points.size() + 1, 0);
  for (int id = 0; id < count; ++id) ++first[static_cast<std::size_t>(std::min(at.from(id), at.to(id))) + 1];
  for (std::size_t v = 0; v < body.points.size(); ++v) first[v + 1] += first[v];
  std::vector<Side> sides(static_cast<std::size_t>(count));
  std::vector<std::size_t> next(first.begin(), first.end() - 1);
  for (int id = 0; id < count; ++id) {
    const int low = std::min(at.from(id), at.to(id)), high = std::max(at.from(id), at.to(id));
    sides[next[static_cast<std::size_t>(low)]++] = {low, high, id, at.from(id) < at.to(id)};
  }
  for (std::size_t v = 0; v < body.points.size(); ++v) {
    const auto begin = sides.begin();
    std::sort(begin + static_cast<std::ptrdiff_t>(first[v]), begin + static_cast<std::ptrdiff_t>(first[v + 1]),
              [](const Side& s, const Side& t) { return s.high != t.high ? s.high < t.high : s.id < t.id; });
  }
  return sides;
}

exact::Tried<std::vector<int>> twins(const RayBody& body, double step) {
  const std::vector<Side> sides = sorted_sides(body);
  std::vector<int> twin(sides.size(), -1);
  std::vector<Side> group;
  for (std::size_t i = 0; i < sides.size(); i += group.size()) {
    group.clear();
    for (std::size_t j = i; j < sides.size() && sides[j].low == sides[i].low && sides[j].high == sides[i].high; ++j) {
      group.push_back(sides[j]);
    }
    if (const Fault found = pair_group(body, group, step, twin)) return *found;
  }
  return twin;
}

Fault make_edges(RayBody& body, const std::vector<int>& twin, double step) {
  const Sides at{body};
  body.face_edges.resize(body.faces.size());
  for (int id = 0; id < static_cast<int>(twin.size()); ++id) {
    if (twin[id] < id) continue;
    const int left = id / 3, right = twin[id] / 3;
    const int bend =
        -exact::sign_dot(body.normals[left], body.normal_approx[left], at.apex(twin[id]) - body.points[at.from(id)]);
    const auto& n = body.normal_approx[left];
    const auto& m = body.normal_approx[right];
    if (bend == 0 && n.x * m.x + n.y * m.y + n.z * m.z < 0)
      return fault_at("the surface folds back on itself at the edge", body.points[at.from(id)], body.points[at.to(id)],
                      step);
    body.face_edges[left][id % 3] = body.face_edges[right][twin[id] % 3] = static_cast<int>(body.edges.size());
    body.edges.push_back({at.from(id), at.to(id), left, right, bend});
  }
  return std::nullopt;
}

void make_vertices(RayBody& body, const std::vector<int>& twin) {
  std::vector<char> done(twin.size(), 0);
  body.corners.reserve(twin.size());
  for (int start = 0; start < static_cast<int>(twin.size()); ++start) {
    if (done[start]) continue;
    RayVertex vertex{body.faces[start / 3][start % 3], static_cast<int>(body.corners.size()), 0};
    for (int side = start; !done[side];) {
      done[side] = 1;
      body.corners.push_back({body.faces[side / 3][(side % 3 + 1) % 3], side / 3});
      ++vertex.count;
      side = twin[side - side % 3 + (side % 3 + 2) % 3];  // over the side that ends in the vertex
    }
    body.vertices.push_back(vertex);
  }
}

void number_pieces(RayBody& body) {
  std::vector<int> stack;
  body.piece.assign(body.faces.size(), -1);
  for (std::size_t f = 0; f < body.faces.size(); ++f) {
    if (body.piece[f] >= 0) continue;
    body.piece[f] = body.pieces;
    body.first_face.push_back(static_cast<int>(f));
    stack.push_back(static_cast<int>(f));
    while (!stack.empty()) {
      const int g = stack.back();
      stack.pop_back();
      for (const int e : body.face_edges[g]) {
        const int h = body.edges[e].left == g ? body.edges[e].right : body.edges[e].left;
        if (body.piece[h] >= 0) continue;
        body.piece[h] = body.pieces;
        stack.push_back(h);
      }
    }
    ++body.pieces;
  }
}

}  // namespace

bool in_ray_range(const Point& p, std::int64_t factor) {
  const std::int64_t most = exact::kRayLimit / factor;
  const auto in = [&](std::int64_t c) { return -most <= c && c <= most; };
  return in(p.x) && in(p.y) && in(p.z);
}

exact::Refusal beyond_ray_range() {
  return exact::Refusal("a coordinate exceeds 2^38 grid steps, the limit of ray maps");
}

std::optional<exact::Refusal> RayBody::measure_faces() {
  if (faces.empty()) return fault("a body without faces");
  for (const auto& [a, b, c] : faces) {
    normals.push_back(exact::cross(points[b] - points[a], points[c] - points[a]));
    if (exact::is_zero(normals.back())) return fault("a face without area");
    normal_approx.push_back(exact::approx(normals.back()));
  }
  low = high = points[faces[0][0]];
  for (const auto& face : faces) {
    for (const int v : face) {
      const Point& p = points[v];
      low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
  }
  if (!in_ray_range(low) || !in_ray_range(high)) return beyond_ray_range();
  return std::nullopt;
}

exact::Tried<RayBody> RayBody::of(Triangles surface) {
  RayBody out;
  out.points = std::move(surface.points);
  out.faces = std::move(surface.faces);
  if (const Fault found = out.measure_faces()) return *found;
  const exact::Tried<std::vector<int>> twin = twins(out, surface.step);
  if (!twin) return twin.refusal();
  if (const Fault found = make_edges(out, *twin, surface.step)) return *found;
  make_vertices(out, *twin);
  number_pieces(out);
  return out;
}

int RayBody::euler() const {
  return (static_cast<int>(vertices.size()) - static_cast<int>(edges.size()) + static_cast<int>(faces.size())) / 2;
}

}  // namespace findspace::space
