// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/mesh/mesh.h"

#include <findspace/error.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <set>
#include <span>
#include <unordered_map>
#include <utility>

#include "space/mesh/mesh_edges.h"
#include "space/mesh/mesh_orientation.h"
#include "space/mesh/mesh_repair.h"
#include "space/mesh/vertex_tree.h"
#include "space/polytope/triangulate.h"

namespace findspace::space {
namespace {

MeshEdge undirected(int a, int b) { return std::minmax(a, b); }

void weld(Mesh& mesh, std::vector<std::string>& notes) {
  const auto hash = [](const Point& p) {
    constexpr std::size_t kOdd = 0x9e3779b97f4a7c15;
    return ((std::size_t(p.x) * kOdd + std::size_t(p.y)) * kOdd + std::size_t(p.z)) * kOdd >> 8;
  };
  std::unordered_map<Point, int, decltype(hash)> seen(mesh.vertices.size() / 4, hash);
  std::vector<int> to(mesh.vertices.size(), -1);
  std::vector<Point> kept;
  for (auto& face : mesh.faces) {
    for (int& v : face) {
      if (to[v] < 0) {
        const auto [at, fresh] = seen.emplace(mesh.vertices[v], static_cast<int>(kept.size()));
        if (fresh) kept.push_back(mesh.vertices[v]);
        to[v] = at->second;
      }
      v = to[v];
    }
  }
  const auto unused = std::count(to.begin(), to.end(), -1);
  if (unused > 0)
    notes.push_back(unused == 1 ? "1 vertex belongs to no face and was dropped"
                                : fmt::format("{} vertices belong to no face and were dropped", unused));
  mesh.vertices = std::move(kept);
}

/// Takes out corners that repeat the one before, and spurs that run out and back (a b a).
void take_out_spurs(std::vector<int>& ring) {
  std::vector<int> kept;
  for (const int v : ring) {
    if (!kept.empty() && kept.back() == v) continue;
    if (kept.size() > 1 && kept[kept.size() - 2] == v)
      kept.pop_back();
    else
      kept.push_back(v);
  }
  std::size_t begin = 0, end = kept.size();  // the same where the end meets the beginning
  while (end - begin > 2) {
    if (kept[end - 1] == kept[begin] || kept[end - 2] == kept[begin])
      --end;
    else if (kept[end - 1] == kept[begin + 1])
      ++begin;
    else
      break;
  }
  ring.assign(kept.begin() + static_cast<std::ptrdiff_t>(begin), kept.begin() + static_cast<std::ptrdiff_t>(end));
}

/// Drops repeated corners, spurs, and faces without area.
void drop_empty_faces(Mesh& mesh, std::vector<std::string>& notes) {
  for (std::vector<int>& face : mesh.faces) {
    const bool is_triangle = face.size() == 3 && face[0] != face[1] && face[1] != face[2] && face[2] != face[0];
    if (!is_triangle) take_out_spurs(face);
  }
  const auto is_empty = [&](const std::vector<int>& face) {
    return face.size() < 3 || exact::is_zero(area_vector(mesh, face));
  };
  const std::size_t empty = std::erase_if(mesh.faces, is_empty);
  if (empty == 0) return;
  notes.push_back(empty == 1 ? "1 face without area was dropped"
                             : fmt::format("{} faces without area were dropped", empty));
}

bool is_flat(const Mesh& mesh, const std::vector<int>& face) {
  if (face.size() == 3) return true;
  const Wide3 n = exact::primitive(area_vector(mesh, face));
  return std::all_of(face.begin(), face.end(),
                     [&](int v) { return exact::dot(n, mesh.vertices[v] - mesh.vertices[face[0]]) == 0; });
}

/// The triangles of a face that is not flat, as it looks along its normal.
std::vector<std::array<int, 3>> triangles_of(const Mesh& mesh, const std::vector<int>& face, double step) {
  try {
    return triangulate(projected(mesh, face, exact::primitive(area_vector(mesh, face))), StraightCorner::kKeep);
  } catch (const Error& e) {
    const std::array begin{mesh.vertices[face[0]], mesh.vertices[face[1]], mesh.vertices[face[2]]};
    throw Error(e.code(), fmt::format("a face of {} corners is not flat and crosses itself: it begins {}", face.size(),
                                      places_text(begin, step)));
  }
}

/// Faces that are not flat are cut into triangles.
void flatten(Mesh& mesh, double step, std::vector<std::string>& notes) {
  if (std::all_of(mesh.faces.begin(), mesh.faces.end(), [&](const auto& face) { return is_flat(mesh, face); })) return;
  std::vector<std::vector<int>> flat;
  int bent = 0;
  for (auto& face : mesh.faces) {
    if (is_flat(mesh, face)) {
      flat.push_back(std::move(face));
      continue;
    }
    ++bent;
    for (const auto& [a, b, c] : triangles_of(mesh, face, step)) flat.push_back({face[a], face[b], face[c]});
  }
  notes.push_back(bent == 1 ? "1 face is not flat and was cut into triangles"
                            : fmt::format("{} faces are not flat and were cut into triangles", bent));
  mesh.faces = std::move(flat);
}

bool strictly_between(const Point& a, const Point& b, const Point& p) {
  if (!((a < p && p < b) || (b < p && p < a))) return false;
  const auto within = [](std::int64_t u, std::int64_t v, std::int64_t w) { return (u <= w) == (w <= v) || w == v; };
  if (!within(a.y, b.y, p.y) || !within(a.z, b.z, p.z)) return false;
  return exact::is_zero(exact::cross(b - a, p - a));
}

/// Puts the ends of odd edges into the odd edges on which they lie. True if anything changed.
bool split_edges(Mesh& mesh, std::vector<std::string>& notes) {
  std::vector<int> ends;
  std::map<MeshEdge, bool> odd;
  MeshEdges(mesh).each([&](const MeshEdge& edge, std::span<const MeshEdges::Use> uses) {
    if (uses.size() % 2 == 0) return;
    odd[edge] = true;
    ends.push_back(edge.first);
    ends.push_back(edge.second);
  });
  std::sort(ends.begin(), ends.end());
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  if (ends.empty()) return false;
  const VertexTree near(mesh, ends);
  int split = 0;
  for (auto& face : mesh.faces) {
    std::vector<int> ring;
    each_edge(face, [&](int a, int b) {
      ring.push_back(a);
      if (!odd.contains(undirected(a, b))) return;
      std::vector<int> on;
      near.each_near(a, b, 0, [&](int v) {
        if (strictly_between(mesh.vertices[a], mesh.vertices[b], mesh.vertices[v])) on.push_back(v);
      });
      const bool rising = mesh.vertices[a] < mesh.vertices[b];
      std::sort(on.begin(), on.end(), [&](int v, int w) { return (mesh.vertices[v] < mesh.vertices[w]) == rising; });
      ring.insert(ring.end(), on.begin(), on.end());
      split += static_cast<int>(on.size());
    });
    face = std::move(ring);
  }
  if (split > 0) notes.push_back(fmt::format("{} edges were split where a vertex lies on them", split));
  return split > 0;
}

/// Faces that another one repeats, corner by corner.
std::size_t repeated_faces(const Mesh& mesh) {
  std::set<std::vector<int>> seen;
  std::size_t repeated = 0;
  for (const std::vector<int>& face : mesh.faces)
    if (!seen.insert(from_least_corner(face)).second) ++repeated;
  return repeated;
}

/// Of the faces at an edge: how many there are in all, and more of one sense than of the other.
std::string faces_at_edge(int all, int surplus) {
  if (all == 1) return "1 face";
  if (all == surplus) return fmt::format("{} faces of one sense", all);
  return fmt::format("{} faces, {} of one sense and {} of the other", all, (all + surplus) / 2, (all - surplus) / 2);
}

void check_closed(const Mesh& mesh, double step) {
  constexpr int kListed = 6;
  std::string list;
  int open = 0;
  bool crowded = false;
  MeshEdges(mesh).each([&](const MeshEdge& edge, std::span<const MeshEdges::Use> uses) {
    const int surplus = balance(uses);
    crowded = crowded || uses.size() > 2;
    if (surplus == 0) return;
    const Point &a = mesh.vertices[edge.first], &b = mesh.vertices[edge.second];
    const auto at = [&](std::int64_t c) { return static_cast<double>(c) * step; };
    if (open++ < kListed) {
      list +=
          fmt::format("{}({:g}, {:g}, {:g})-({:g}, {:g}, {:g}) in {}", open == 1 ? "" : "; ", at(a.x), at(a.y), at(a.z),
                      at(b.x), at(b.y), at(b.z), faces_at_edge(static_cast<int>(uses.size()), std::abs(surplus)));
    }
  });
  if (open == 0 && !crowded) return;
  std::string twice;
  if (const std::size_t n = repeated_faces(mesh); n > 0)
    twice = fmt::format("{} face{} twice", n, n == 1 ? " stands" : "s stand");
  if (open == 0 && twice.empty()) return;
  if (open == 0) throw Error(ErrorCode::kGeometry, "in the mesh " + twice + "; --repair takes them once");
  if (open > kListed) list += fmt::format("; and {} more", open - kListed);
  if (!twice.empty()) twice += "; ";
  throw Error(
      ErrorCode::kGeometry,
      fmt::format(
          "the mesh is not closed: {}{} open edges: {}; --repair joins what is near, --close-holes closes holes", twice,
          open, list));
}

}  // namespace

std::vector<int> from_least_corner(std::vector<int> face) {
  std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
  return face;
}

Wide3 area_vector(const Mesh& mesh, const std::vector<int>& face) {
  Wide3 sum;
  for (std::size_t i = 1; i + 1 < face.size(); ++i) {
    const Wide3 n = exact::cross(mesh.vertices[face[i]] - mesh.vertices[face[0]],
                                 mesh.vertices[face[i + 1]] - mesh.vertices[face[0]]);
    sum = {sum.x + n.x, sum.y + n.y, sum.z + n.z};
  }
  return sum;
}

std::vector<Point2> projected(const Mesh& mesh, const std::vector<int>& face, const Wide3& n) {
  const auto size = [](int128 v) { return v < 0 ? -v : v; };
  const int axis = size(n.x) >= size(n.y) && size(n.x) >= size(n.z) ? 0 : size(n.y) >= size(n.z) ? 1 : 2;
  const bool flip = (axis == 0 ? n.x : axis == 1 ? n.y : n.z) < 0;
  std::vector<Point2> ring;
  for (const int v : face) {
    const Point& p = mesh.vertices[v];
    const std::int64_t x = axis == 0 ? p.y : axis == 1 ? p.z : p.x, y = axis == 0 ? p.z : axis == 1 ? p.x : p.y;
    ring.push_back({x, flip ? -y : y});
  }
  return ring;
}

std::string places_text(std::span<const Point> points, double step) {
  const auto at = [unit = step > 0 ? step : 1](std::int64_t c) { return static_cast<double>(c) * unit; };
  std::string out;
  for (const Point& p : points)
    out += fmt::format("{}({:g}, {:g}, {:g})", out.empty() ? "" : " ", at(p.x), at(p.y), at(p.z));
  return step > 0 ? out : out + ", in grid steps";
}

exact::Real six_volumes(const Mesh& mesh) {
  exact::Real sum;
  for (const auto& face : mesh.faces) {
    for (std::size_t i = 1; i + 1 < face.size(); ++i) {
      const Point base = mesh.vertices[0], a = mesh.vertices[face[0]];
      const Wide3 n = exact::cross(mesh.vertices[face[i]] - a, mesh.vertices[face[i + 1]] - a);
      sum += exact::Real(exact::dot(n, a - base));
    }
  }
  return sum;
}

std::vector<std::string> clean(Mesh& mesh, double step, const MeshRepair& how) {
  std::vector<std::string> notes;
  weld(mesh, notes);
  if (mesh.faces.empty()) throw Error(ErrorCode::kGeometry, "the mesh has no faces");
  drop_empty_faces(mesh, notes);
  flatten(mesh, step, notes);
  split_edges(mesh, notes);
  if (how.asked()) {
    repair(mesh, how, step, notes);
    drop_empty_faces(mesh, notes);
    flatten(mesh, step, notes);
    split_edges(mesh, notes);
  }
  orient(mesh, step, notes);
  check_closed(mesh, step);
  if (six_volumes(mesh).sign() <= 0)
    throw Error(ErrorCode::kGeometry, how.asked()
                                          ? "the mesh encloses no volume after its repair; a smaller width may help"
                                          : "the mesh encloses no volume");
  return notes;
}

namespace {

/// Where a corner stands in a face, looked for backwards from a place: so do neighbours run along the edges of a face.
std::size_t place_of(int corner, const std::vector<int>& face, std::size_t from) {
  std::size_t at = from < face.size() ? from : 0;
  while (face[at] != corner) at = (at == 0 ? face.size() : at) - 1;
  return at;
}

/// Whether no edge has the surface above it, as far as the next corner of its neighbour tells.
bool bends_outward(const Mesh& mesh) {
  const MeshEdges edges(mesh);
  std::size_t place = 0;  // found last
  const auto bends = [&](int f, const Wide3& normal, int a, int b) {
    const auto uses = edges.at(a, b);
    if (uses.size() != 2) return false;
    const std::vector<int>& beside = mesh.faces[uses[0].face == f ? uses[1].face : uses[0].face];  // from b to a
    if (beside.size() > mesh.faces[f].size()) return true;                                         // seen from there
    place = place_of(a, beside, place);
    const int next = beside[(place + 1) % beside.size()];
    return exact::dot(normal, mesh.vertices[next] - mesh.vertices[a]) <= 0;
  };
  for (int f = 0; f < static_cast<int>(mesh.faces.size()); ++f) {
    const std::vector<int>& face = mesh.faces[f];
    const Wide3 normal = exact::primitive(area_vector(mesh, face));
    for (std::size_t i = 0; i < face.size(); ++i)
      if (!bends(f, normal, face[i], face[(i + 1) % face.size()])) return false;
  }
  return true;
}

/// Whether the surface lies on that of the hull of its vertices, and covers it once: such a surface covers each place
/// of it equally often, so the volumes tell.
bool covers_once(const Mesh& mesh, const Polytope& hull) {
  const auto of = [](const Wide3& normal, const int128& offset) {
    return std::array{normal.x, normal.y, normal.z, offset};
  };
  std::set<std::array<int128, 4>> planes;
  for (const Plane& p : hull.planes()) planes.insert(of(p.normal, p.offset));
  const auto lies_on_it = [&](const std::vector<int>& face) {
    const Wide3 normal = exact::primitive(area_vector(mesh, face));
    return planes.contains(of(normal, -exact::dot(normal, mesh.vertices[face[0]])));
  };
  if (!std::all_of(mesh.faces.begin(), mesh.faces.end(), lies_on_it)) return false;
  Mesh whole{{hull.vertices().begin(), hull.vertices().end()}, {}};
  for (int f = 0; f < hull.facet_count(); ++f) whole.faces.push_back(hull.circuit(f));
  return (six_volumes(mesh) - six_volumes(whole)).sign() == 0;
}

}  // namespace

std::optional<Polytope> convex_solid(const Mesh& mesh) {
  if (!bends_outward(mesh)) return std::nullopt;
  Polytope hull = Polytope::hull(mesh.vertices);
  if (!covers_once(mesh, hull)) return std::nullopt;
  return hull;
}

bool is_convex(const Mesh& mesh) { return convex_solid(mesh).has_value(); }

}  // namespace findspace::space
