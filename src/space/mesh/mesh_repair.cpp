// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/mesh/mesh_repair.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <span>
#include <utility>

#include "space/mesh/mesh.h"
#include "space/mesh/mesh_edges.h"
#include "space/mesh/vertex_tree.h"
#include "space/polytope/triangulate.h"

namespace findspace::space {
namespace {

using exact::int128;

int128 inner_product(const exact::Grid3& a, const exact::Grid3& b) {
  return int128(a.x) * b.x + int128(a.y) * b.y + int128(a.z) * b.z;
}
int128 squared_distance(const Point& p, const Point& q) { return inner_product(p - q, p - q); }
int128 squared(std::int64_t length) { return int128(length) * length; }

/// Edges with an odd number of faces.
std::set<MeshEdge> odd_edges(const Mesh& mesh) {
  std::set<MeshEdge> odd;
  MeshEdges(mesh).each([&](const MeshEdge& edge, std::span<const MeshEdges::Use> uses) {
    if (uses.size() % 2 == 1) odd.insert(edge);
  });
  return odd;
}

std::vector<int> ends_of(const std::set<MeshEdge>& edges) {
  std::set<int> ends;
  for (const auto& [from, to] : edges) ends.insert({from, to});
  return {ends.begin(), ends.end()};
}

void drop_repeated_faces(Mesh& mesh, std::vector<std::string>& notes) {
  std::set<std::vector<int>> seen;
  const auto repeats = [&](const std::vector<int>& face) { return !seen.insert(from_least_corner(face)).second; };
  if (const std::size_t n = std::erase_if(mesh.faces, repeats); n > 0)
    notes.push_back(fmt::format("{} that stood twice {} dropped", n == 1 ? "1 face" : fmt::format("{} faces", n),
                                n == 1 ? "was" : "were"));
}

/// Cubes of the width, and in each the vertices that others are joined with.
class Kept {
 public:
  Kept(const Mesh& mesh, std::int64_t width) : mesh_(mesh), width_(width) {}

  /// The nearest of those within the width, of equally near ones the first; v itself where there is none.
  int join(int v) {
    const Point& p = mesh_.vertices[std::size_t(v)];
    const Cube at = cube(p);
    std::pair<int128, int> best{squared(width_) + 1, v};
    for (std::int64_t x = -1; x <= 1; ++x)
      for (std::int64_t y = -1; y <= 1; ++y)
        for (std::int64_t z = -1; z <= 1; ++z)
          if (const auto found = cubes_.find({at[0] + x, at[1] + y, at[2] + z}); found != cubes_.end())
            for (const int w : found->second)
              best = std::min(best, std::pair{squared_distance(p, mesh_.vertices[std::size_t(w)]), w});
    if (best.second == v) cubes_[at].push_back(v);
    return best.second;
  }

 private:
  using Cube = std::array<std::int64_t, 3>;
  Cube cube(const Point& p) const { return {floor(p.x), floor(p.y), floor(p.z)}; }
  std::int64_t floor(std::int64_t c) const { return c / width_ - (c % width_ < 0 ? 1 : 0); }

  const Mesh& mesh_;
  std::int64_t width_;
  std::map<Cube, std::vector<int>> cubes_;
};

/// Joins ends of odd edges. Faces may lose corners by it.
void join_vertices(Mesh& mesh, std::int64_t width, double step, std::vector<std::string>& notes) {
  std::vector<int> to(mesh.vertices.size());
  for (std::size_t v = 0; v < to.size(); ++v) to[v] = int(v);
  Kept kept(mesh, width);
  std::size_t joined = 0;
  int128 farthest = 0;
  for (const int v : ends_of(odd_edges(mesh))) {
    const int w = to[std::size_t(v)] = kept.join(v);
    if (w == v) continue;
    ++joined;
    farthest = std::max(farthest, squared_distance(mesh.vertices[std::size_t(v)], mesh.vertices[std::size_t(w)]));
  }
  if (joined == 0) return;
  for (auto& face : mesh.faces) {
    for (int& v : face) v = to[std::size_t(v)];
    face.erase(std::unique(face.begin(), face.end()), face.end());
    while (face.size() > 1 && face.front() == face.back()) face.pop_back();
  }
  std::erase_if(mesh.faces, [](const std::vector<int>& face) { return face.size() < 3; });
  notes.push_back(fmt::format("{} joined with others, moved by {:.3g} at most",
                              joined == 1 ? "1 vertex was" : fmt::format("{} vertices were", joined),
                              std::sqrt(double(farthest)) * step));
}

/// Whether the vertex is no farther than the width from the line through an edge, and beside it.
bool is_beside(const Mesh& mesh, int from, int to, int vertex, std::int64_t width) {
  const Point &a = mesh.vertices[std::size_t(from)], &b = mesh.vertices[std::size_t(to)],
              &p = mesh.vertices[std::size_t(vertex)];
  if (inner_product(p - a, b - a) <= 0 || inner_product(p - b, a - b) <= 0) return false;
  const Wide3 area = exact::cross(b - a, p - a);
  const auto square = [](int128 v) { return exact::Real(v) * exact::Real(v); };
  return square(area.x) + square(area.y) + square(area.z) <=
         exact::Real(squared_distance(a, b)) * exact::Real(squared(width));
}

/// Leads odd edges over vertices: their faces become fans about a corner that is not on the edge.
class LeadOver {
 public:
  LeadOver(const Mesh& mesh, std::int64_t width)
      : mesh_(mesh), width_(width), odd_(odd_edges(mesh)), near_(mesh, ends_of(odd_)) {}

  /// A face, all sides of which may be led.
  void take(const std::vector<int>& face) { take(face, std::vector<char>(face.size(), 1)); }

  std::size_t vertices() const { return vertices_; }
  std::vector<std::vector<int>> faces() { return std::move(faces_); }

 private:
  /// Vertices on the side from corner a to corner b, in their order from a.
  std::vector<int> between(const std::vector<int>& face, int a, int b) const {
    std::vector<int> on;
    if (!odd_.contains(std::minmax(a, b))) return on;
    near_.each_near(a, b, width_, [&](int v) {
      if (std::find(face.begin(), face.end(), v) == face.end() && is_beside(mesh_, a, b, v, width_)) on.push_back(v);
    });
    const Point &from = mesh_.vertices[std::size_t(a)], &to = mesh_.vertices[std::size_t(b)];
    const auto place = [&](int v) {
      return std::pair{inner_product(mesh_.vertices[std::size_t(v)] - from, to - from), v};
    };
    std::sort(on.begin(), on.end(), [&](int v, int w) { return place(v) < place(w); });
    return on;
  }

  /// `open`: the sides that are still to be looked at; sides that a cut makes are not led.
  void take(const std::vector<int>& face, const std::vector<char>& open) {
    for (std::size_t i = 0; i < face.size(); ++i) {
      if (open[i] == 0) continue;
      const std::vector<int> on = between(face, face[i], face[(i + 1) % face.size()]);
      if (on.empty()) continue;
      if (face.size() > 3) return in_triangles(face, open);
      vertices_ += on.size();
      return as_fan(face, i, on, open);
    }
    faces_.push_back(face);
  }

  void in_triangles(const std::vector<int>& face, const std::vector<char>& open) {
    const auto ring = projected(mesh_, face, area_vector(mesh_, face));
    for (const auto& t : triangulate(ring, StraightCorner::kKeep)) {
      std::vector<int> triangle;
      std::vector<char> sides;
      for (std::size_t k = 0; k < 3; ++k) {
        const auto from = std::size_t(t[k]), to = std::size_t(t[(k + 1) % 3]);
        triangle.push_back(face[from]);
        sides.push_back((from + 1) % face.size() == to ? open[from] : 0);
      }
      take(triangle, sides);
    }
  }

  /// The triangle cut from the corner across side i to the vertices that this side is led over.
  void as_fan(const std::vector<int>& face, std::size_t i, const std::vector<int>& on, const std::vector<char>& open) {
    int from = face[i];
    const int last = face[(i + 1) % 3], apex = face[(i + 2) % 3];
    take({from, on.front(), apex}, {0, 0, open[(i + 2) % 3]});
    from = on.front();
    for (const int v : std::span(on).subspan(1)) faces_.push_back({std::exchange(from, v), v, apex});
    take({from, last, apex}, {0, open[(i + 1) % 3], 0});
  }

  const Mesh& mesh_;
  std::int64_t width_;
  std::set<MeshEdge> odd_;
  VertexTree near_;
  std::vector<std::vector<int>> faces_;
  std::size_t vertices_ = 0;
};

void lead_over(Mesh& mesh, std::int64_t width, std::vector<std::string>& notes) {
  LeadOver led(mesh, width);
  for (const auto& face : mesh.faces) led.take(face);
  mesh.faces = led.faces();
  if (led.vertices() > 0)
    notes.push_back(fmt::format("slits were closed: edges of faces were led over {}",
                                led.vertices() == 1 ? "1 vertex" : fmt::format("{} vertices", led.vertices())));
}

/// Circuits of edges with one face each, at whose vertices no other such edge ends.
std::vector<std::vector<int>> holes_of(const Mesh& mesh) {
  std::map<int, std::vector<int>> next;  // against the sense of the faces, then with it
  std::map<MeshEdge, bool> rising;
  MeshEdges(mesh).each([&](const MeshEdge& edge, std::span<const MeshEdges::Use> uses) {
    if (uses.size() != 1) return;
    rising[edge] = uses[0].rising;
    next[edge.first].push_back(edge.second);
    next[edge.second].push_back(edge.first);
  });
  std::vector<std::vector<int>> holes;
  std::set<int> seen;
  for (const auto& [start, ways] : next) {
    if (ways.size() != 2 || seen.contains(start)) continue;
    std::vector<int> circuit{start};
    int at = rising[std::minmax(start, ways[0])] == (start < ways[0]) ? ways[1] : ways[0];
    while (at != start && next[at].size() == 2 && seen.insert(at).second) {
      const int before = circuit.back();
      circuit.push_back(at);
      at = next[at][0] == before ? next[at][1] : next[at][0];
    }
    if (at == start && circuit.size() > 2) holes.push_back(std::move(circuit));
  }
  return holes;
}

std::int64_t rounded_up_root(int128 square) {
  auto root = std::int64_t(std::sqrt(double(square)));
  while (squared(root) < square) ++root;
  return root;
}

/// The greatest distance of two of its vertices.
std::int64_t width_of(const Mesh& mesh, const std::vector<int>& hole) {
  int128 most = 0;
  for (std::size_t i = 0; i < hole.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      most = std::max(most, squared_distance(mesh.vertices[std::size_t(hole[i])], mesh.vertices[std::size_t(hole[j])]));
  return rounded_up_root(most);
}

/// The triangles of the least area in all that a circuit bounds. Areas are doubles: they choose, and prove nothing.
class LeastArea {
 public:
  LeastArea(const Mesh& mesh, const std::vector<int>& hole)
      : mesh_(mesh), hole_(hole), n_(hole.size()), area_(n_ * n_, 0), apex_(n_ * n_, 0) {
    for (std::size_t wide = 2; wide < n_; ++wide)
      for (std::size_t i = 0; i + wide < n_; ++i) choose(i, i + wide);
  }

  void add_to(Mesh& mesh) const { add(mesh, 0, n_ - 1); }

 private:
  void choose(std::size_t i, std::size_t k) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t j = i + 1; j < k; ++j) {
      const double area = area_[i * n_ + j] + area_[j * n_ + k] + triangle(i, j, k);
      if (area >= least) continue;
      least = area;
      apex_[i * n_ + k] = j;
    }
    area_[i * n_ + k] = least;
  }
  double triangle(std::size_t i, std::size_t j, std::size_t k) const {
    const Point &a = at(i), &b = at(j), &c = at(k);
    const Wide3 n = exact::cross(b - a, c - a);
    return std::hypot(double(n.x), double(n.y), double(n.z));
  }
  const Point& at(std::size_t i) const { return mesh_.vertices[std::size_t(hole_[i])]; }
  void add(Mesh& mesh, std::size_t i, std::size_t k) const {
    if (k < i + 2) return;
    const std::size_t j = apex_[i * n_ + k];
    mesh.faces.push_back({hole_[i], hole_[j], hole_[k]});
    add(mesh, i, j);
    add(mesh, j, k);
  }

  const Mesh& mesh_;
  const std::vector<int>& hole_;
  std::size_t n_;
  std::vector<double> area_;
  std::vector<std::size_t> apex_;
};

void close_holes(Mesh& mesh, std::int64_t most, double step, std::vector<std::string>& notes) {
  constexpr std::size_t kMostEdges = 300;  // n^3 steps
  std::size_t closed = 0;
  std::int64_t widest = 0;
  Point place;
  for (const std::vector<int>& hole : holes_of(mesh)) {
    if (hole.size() > kMostEdges) continue;
    const std::int64_t width = width_of(mesh, hole);
    if (width > most) continue;
    ++closed;
    if (width > widest) place = mesh.vertices[std::size_t(hole[0])];
    widest = std::max(widest, width);
    LeastArea(mesh, hole).add_to(mesh);
  }
  if (closed == 0) return;
  const auto at = [&](std::int64_t c) { return double(c) * step; };
  notes.push_back(fmt::format("{} closed, {}{:.3g} wide at ({:g}, {:g}, {:g})",
                              closed == 1 ? "1 hole was" : fmt::format("{} holes were", closed),
                              closed == 1 ? "" : "the widest ", at(widest), at(place.x), at(place.y), at(place.z)));
}

}  // namespace

void repair(Mesh& mesh, const MeshRepair& how, double step, std::vector<std::string>& notes) {
  drop_repeated_faces(mesh, notes);
  if (how.width > 0) {
    join_vertices(mesh, how.width, step, notes);
    lead_over(mesh, how.width, notes);
  }
  if (how.hole > 0) close_holes(mesh, how.hole, step, notes);
}

}  // namespace findspace::space
