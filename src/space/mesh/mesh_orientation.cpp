// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/mesh/mesh_orientation.h"

#include <findspace/error.h>
#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "space/mesh/mesh.h"
#include "space/mesh/mesh_edges.h"

namespace findspace::space {
namespace {

struct Shell {
  std::vector<int> faces;
  bool agreed = true;  // as stated
  bool closed = false;
  Point low, high;           // its box
  std::vector<int> about{};  // the shells in which it lies
  bool placed = true;        // `about` is certain: some vertex is on no other shell
};

void widen(Point& low, Point& high, const Point& p) {
  low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
  high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
}

class Orientation {
 public:
  explicit Orientation(Mesh& mesh) : mesh_(mesh), edges_(mesh) {}

  void run(double step) {
    find_shells();
    const bool parted = std::all_of(shells_.begin(), shells_.end(), [](const Shell& s) { return s.closed; });
    if (shells_.size() == 1 || !parted) {  // where shells meet in edges nothing tells them apart
      if (six_volumes(mesh_).sign() < 0)
        std::for_each(shells_.begin(), shells_.end(), [&](const Shell& s) { turn(s); });
      return;
    }
    find_nesting();
    for (const Shell& outer : shells_) {
      if (!outer.placed || !outer.about.empty() || volume_sign(outer) > 0) continue;
      turn(outer);
      if (outer.agreed) turn_all_within(outer);
    }
    for (const Shell& s : shells_) {
      const int sense = s.about.size() % 2 == 0 ? 1 : -1;
      if (!s.placed || s.about.empty() || volume_sign(s) == sense) continue;
      const auto agreed = [&](int k) { return shells_[static_cast<std::size_t>(k)].agreed; };
      if (s.agreed && std::all_of(s.about.begin(), s.about.end(), agreed)) refuse(s, step);
      turn(s);
    }
  }

 private:
  void find_shells() {
    std::vector<char> done(mesh_.faces.size(), 0);
    for (int seed = 0; seed < static_cast<int>(done.size()); ++seed) {
      if (!done[seed]) shells_.push_back(shell_of(seed, done));
    }
  }

  /// The faces reached over edges of two faces, turned so that neighbours agree with the seed.
  Shell shell_of(int seed, std::vector<char>& done) {
    Shell s;
    s.faces = {seed};
    done[seed] = 1;
    for (std::size_t i = 0; i < s.faces.size(); ++i) {
      const int f = s.faces[i];
      each_edge(std::vector<int>(mesh_.faces[f]), [&](int a, int b) {
        const auto two = edges_.at(a, b);
        const int g = two[0].face == f ? two.back().face : two[0].face;
        if (two.size() != 2 || done[g]) return;
        bool same = false;
        each_edge(mesh_.faces[g], [&](int c, int d) { same = same || (a == c && b == d); });
        if (same) std::reverse(mesh_.faces[g].begin(), mesh_.faces[g].end());
        s.agreed = s.agreed && !same;
        done[g] = 1;
        s.faces.push_back(g);
      });
    }
    s.closed = is_closed(s);
    set_box(s);
    return s;
  }

  bool is_closed(const Shell& s) const {
    std::vector<std::pair<MeshEdge, int>> senses;
    for (const int f : s.faces)
      each_edge(mesh_.faces[f], [&](int a, int b) { senses.emplace_back(std::minmax(a, b), a < b ? 1 : -1); });
    std::sort(senses.begin(), senses.end());
    for (std::size_t i = 0; i < senses.size();) {
      int sum = 0;
      const MeshEdge edge = senses[i].first;
      for (; i < senses.size() && senses[i].first == edge; ++i) sum += senses[i].second;
      if (sum != 0) return false;
    }
    return true;
  }

  void set_box(Shell& s) const {
    s.low = s.high = mesh_.vertices[mesh_.faces[s.faces[0]][0]];
    for (const int f : s.faces) {
      for (const int v : mesh_.faces[f]) widen(s.low, s.high, mesh_.vertices[v]);
    }
  }

  void find_nesting() {
    for (Shell& s : shells_) {
      for (int k = 0; k < static_cast<int>(shells_.size()); ++k) {
        const Shell& outer = shells_[k];
        if (&outer == &s || !box_within(s, outer)) continue;
        const std::optional<bool> inside = lies_in(s, outer);
        s.placed = s.placed && inside;
        if (inside.value_or(false)) s.about.push_back(k);
      }
    }
  }

  static bool box_within(const Shell& s, const Shell& outer) {
    return outer.low.x <= s.low.x && outer.low.y <= s.low.y && outer.low.z <= s.low.z && s.high.x <= outer.high.x &&
           s.high.y <= outer.high.y && s.high.z <= outer.high.z;
  }

  /// By the first vertex that is not on the other's surface; nothing where all are. Shells that cross are refused
  /// elsewhere.
  std::optional<bool> lies_in(const Shell& s, const Shell& outer) const {
    for (const int f : s.faces) {
      for (const int v : mesh_.faces[f]) {
        if (const auto inside = encloses(outer, mesh_.vertices[v])) return inside;
      }
    }
    return std::nullopt;
  }

  /// Whether an odd number of faces lies above p; nothing where p is in the plane and the box of a face.
  std::optional<bool> encloses(const Shell& s, const Point& p) const {
    bool odd = false;
    for (const int f : s.faces) {
      const auto& face = mesh_.faces[f];
      const Wide3 n = area_vector(mesh_, face);
      const Point& q = mesh_.vertices[face[0]];
      const exact::Real height = exact::Real(n.x) * exact::Real(p.x - q.x) +  // of p over the plane, times n.z
                                 exact::Real(n.y) * exact::Real(p.y - q.y) + exact::Real(n.z) * exact::Real(p.z - q.z);
      if (height.sign() == 0 && in_box(face, p)) return std::nullopt;
      if (n.z != 0 && (height.sign() > 0) != (n.z > 0) && covers(face, p)) odd = !odd;
    }
    return odd;
  }

  bool in_box(const std::vector<int>& face, const Point& p) const {
    Point low = mesh_.vertices[face[0]], high = low;
    for (const int v : face) widen(low, high, mesh_.vertices[v]);
    return low.x <= p.x && low.y <= p.y && low.z <= p.z && p.x <= high.x && p.y <= high.y && p.z <= high.z;
  }

  /// Whether the face, seen from above, covers p moved by (e, e * e) for every small e > 0.
  bool covers(const std::vector<int>& face, const Point& p) const {
    bool odd = false;
    each_edge(face, [&](int i, int j) {
      const Point &a = mesh_.vertices[i], &b = mesh_.vertices[j];
      if ((a.x > p.x) == (b.x > p.x)) return;
      const int128 sense = b.x > a.x ? 1 : -1;
      const int128 side = (int128(b.x - a.x) * (p.y - a.y) - int128(b.y - a.y) * (p.x - a.x)) * sense;
      const bool edge_above = side != 0 ? side < 0 : (b.y - a.y) * sense > 0;
      if (edge_above) odd = !odd;
    });
    return odd;
  }

  int volume_sign(const Shell& s) const {
    Mesh part;
    for (const int f : s.faces) {
      std::vector<int> face;
      for (const int v : mesh_.faces[f]) {
        face.push_back(static_cast<int>(part.vertices.size()));
        part.vertices.push_back(mesh_.vertices[v]);
      }
      part.faces.push_back(std::move(face));
    }
    return six_volumes(part).sign();
  }

  void turn(const Shell& s) {
    for (const int f : s.faces) std::reverse(mesh_.faces[f].begin(), mesh_.faces[f].end());
  }

  void turn_all_within(const Shell& outer) {
    const int k = static_cast<int>(&outer - shells_.data());
    for (const Shell& s : shells_) {
      if (std::find(s.about.begin(), s.about.end(), k) != s.about.end()) turn(s);
    }
  }

  [[noreturn]] void refuse(const Shell& s, double step) const {
    const Point& p = mesh_.vertices[mesh_.faces[s.faces[0]][0]];
    const auto at = [&](std::int64_t c) { return static_cast<double>(c) * step; };
    throw Error(
        ErrorCode::kGeometry,
        fmt::format("a shell of the mesh, at ({:g}, {:g}, {:g}), lies in another of the same sense: reversed it "
                    "would be a cavity, and as it is it adds nothing",
                    at(p.x), at(p.y), at(p.z)));
  }

  Mesh& mesh_;
  MeshEdges edges_;  // as they are before faces are turned, which changes the senses only
  std::vector<Shell> shells_;
};

}  // namespace

void orient(Mesh& mesh, double step, std::vector<std::string>& notes) {
  const std::vector<std::vector<int>> stated = mesh.faces;
  Orientation(mesh).run(step);
  int reversed = 0;
  for (std::size_t f = 0; f < stated.size(); ++f) reversed += mesh.faces[f] != stated[f];
  if (reversed == 0) return;
  notes.push_back(fmt::format("{} face{} reversed to point outward", reversed, reversed == 1 ? " was" : "s were"));
}

}  // namespace findspace::space
