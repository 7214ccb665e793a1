// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/mesh/mesh_orientation.h"

#include <findspace/error.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <utility>

#include "plane/base/allowed_work.h"
#include "space/mesh/mesh.h"
#include "space/mesh/mesh_edges.h"
#include "space/polytope/extent_tree.h"

namespace findspace::space {
namespace {

struct Shell {
  std::vector<int> faces;
  bool agreed = true;  // as stated
  bool closed = true;
  Point low, high;           // its box
  int about = 0;             // so many shells in which it lies
  bool about_agreed = true;  // all of them as stated
  bool placed = true;        // `about` is certain: some vertex is on no other shell
};

void widen(Point& low, Point& high, const Point& p) {
  low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
  high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
}

class Orientation {
 public:
  explicit Orientation(Mesh& mesh)
      : mesh_(mesh), edges_(mesh), shell_of_face_(mesh.faces.size(), -1), turned_(mesh.faces.size(), 0) {}

  /// How many faces are the other way round than before.
  std::ptrdiff_t turned() const { return std::count(turned_.begin(), turned_.end(), 1); }

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
      if (!outer.placed || outer.about > 0 || volume_sign(outer) > 0) continue;
      turn(outer);
      if (outer.agreed) turn_all_within(outer);
    }
    for (const Shell& s : shells_) {
      const int sense = s.about % 2 == 0 ? 1 : -1;
      if (!s.placed || s.about == 0 || volume_sign(s) == sense) continue;
      if (s.agreed && s.about_agreed) refuse(s, step);
      turn(s);
    }
  }

 private:
  void find_shells() {
    for (int seed = 0; seed < static_cast<int>(shell_of_face_.size()); ++seed) {
      if (shell_of_face_[seed] < 0) shells_.push_back(shell_of(seed));
    }
    // At each edge, the faces of a shell that run along it upwards, less those that run along it downwards.
    std::vector<int> surplus(shells_.size(), 0);
    edges_.each([&](const MeshEdge&, std::span<const MeshEdges::Use> uses) {
      for (const MeshEdges::Use& use : uses)
        surplus[shell_of_face_[use.face]] += use.rising == (turned_[use.face] == 0) ? 1 : -1;
      for (const MeshEdges::Use& use : uses)
        if (std::exchange(surplus[shell_of_face_[use.face]], 0) != 0) shells_[shell_of_face_[use.face]].closed = false;
    });
  }

  void turn(int face) {
    std::reverse(mesh_.faces[face].begin(), mesh_.faces[face].end());
    turned_[face] ^= 1;
  }

  /// The faces reached over edges of two faces, turned so that neighbours agree with the seed.
  Shell shell_of(int seed) {
    const auto number = static_cast<int>(shells_.size());
    Shell s;
    s.faces = {seed};
    shell_of_face_[seed] = number;
    for (std::size_t i = 0; i < s.faces.size(); ++i) {
      const int f = s.faces[i];
      each_edge(mesh_.faces[f], [&](int a, int b) {
        const auto two = edges_.at(a, b);
        const int g = two[0].face == f ? two.back().face : two[0].face;
        if (two.size() != 2 || shell_of_face_[g] >= 0) return;
        bool same = false;
        each_edge(mesh_.faces[g], [&](int c, int d) { same = same || (a == c && b == d); });
        if (same) turn(g);
        s.agreed = s.agreed && !same;
        shell_of_face_[g] = number;
        s.faces.push_back(g);
      });
    }
    set_box(s);
    return s;
  }

  void set_box(Shell& s) const {
    s.low = s.high = mesh_.vertices[mesh_.faces[s.faces[0]][0]];
    for (const int f : s.faces) {
      for (const int v : mesh_.faces[f]) widen(s.low, s.high, mesh_.vertices[v]);
    }
  }

  void find_nesting() {
    std::vector<Extent> boxes;
    for (const Shell& s : shells_) boxes.push_back({vector_of(s.low), vector_of(s.high)});
    tree_ = ExtentTree(std::move(boxes));
    for (std::size_t i = 0; i < shells_.size(); ++i) {
      Shell& s = shells_[i];
      const Extent& box = tree_.extent(i);
      const auto about = [&](const Extent& e) { return e.holds(box.low, 0) && e.holds(box.high, 0); };
      tree_.each(about, [&](std::size_t k) {
        if (k == i) return;
        const std::optional<bool> inside = lies_in(s, shells_[k]);
        s.placed = s.placed && inside;
        if (!inside.value_or(false)) return;
        ++s.about;
        s.about_agreed = s.about_agreed && shells_[k].agreed;
      });
    }
  }

  /// Exact, as coordinates of meshes are below 2^40.
  static Vector vector_of(const Point& p) { return {double(p.x), double(p.y), double(p.z)}; }

  /// By the first vertex that is not on the other's surface; nothing where all are. Shells that cross are refused
  /// elsewhere.
  std::optional<bool> lies_in(const Shell& s, const Shell& outer) {
    for (const int f : s.faces) {
      for (const int v : mesh_.faces[f]) {
        work_.charge(1 + outer.faces.size() / kFacesAUnit, "a mesh with so many shells in each other");
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
      Point low = mesh_.vertices[face[0]], high = low;
      for (const int v : face) widen(low, high, mesh_.vertices[v]);
      if (p.x < low.x || high.x < p.x || p.y < low.y || high.y < p.y || high.z < p.z) continue;
      const Wide3 n = area_vector(mesh_, face);
      const int height = side(n, p - mesh_.vertices[face[0]], face.size());
      if (height == 0 && low.z <= p.z) return std::nullopt;
      if (n.z != 0 && (height > 0) != (n.z > 0) && covers(face, p)) odd = !odd;
    }
    return odd;
  }

  /// The sign of the height over a face of so many corners, times n.z, of a place as seen from one of them.
  static int side(const Wide3& n, const Point& v, std::size_t corners) {
    if (corners == 3) return exact::sign(exact::dot(n, v));  // below 2^126
    const exact::Real height =
        exact::Real(n.x) * exact::Real(v.x) + exact::Real(n.y) * exact::Real(v.y) + exact::Real(n.z) * exact::Real(v.z);
    return height.sign();
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
    for (const int f : s.faces) turn(f);
  }

  void turn_all_within(const Shell& outer) {
    const Extent box{vector_of(outer.low), vector_of(outer.high)};
    tree_.each([&](const Extent& e) { return e.meets(box); },
               [&](std::size_t k) {
                 const Shell& s = shells_[k];
                 if (&s != &outer && holds(outer, s.low) && holds(outer, s.high) && lies_in(s, outer).value_or(false))
                   turn(s);
               });
  }
  static bool holds(const Shell& s, const Point& p) {
    return s.low.x <= p.x && p.x <= s.high.x && s.low.y <= p.y && p.y <= s.high.y && s.low.z <= p.z && p.z <= s.high.z;
  }

  [[noreturn]] void refuse(const Shell& s, double step) const {
    const Point& p = mesh_.vertices[mesh_.faces[s.faces[0]][0]];
    const std::string_view why =
        volume_sign(s) == 0
            ? "lies in another and encloses no volume: it bounds neither a cavity nor a solid"
            : "lies in another of the same sense: reversed it would be a cavity, and as it is it adds nothing";
    throw Error(ErrorCode::kGeometry,
                fmt::format("a shell of the mesh, at {}, {}", places_text(std::array{p}, step), why));
  }

  Mesh& mesh_;
  MeshEdges edges_;  // as they are before faces are turned, which changes the senses only
  static constexpr std::size_t kFacesAUnit = 16;
  plane::WorkBudget work_ = plane::allowed_work();
  std::vector<Shell> shells_;
  ExtentTree tree_;  // of their boxes
  std::vector<int> shell_of_face_;
  std::vector<char> turned_;
};

}  // namespace

void orient(Mesh& mesh, double step, std::vector<std::string>& notes) {
  Orientation orientation(mesh);
  orientation.run(step);
  const std::ptrdiff_t reversed = orientation.turned();
  if (reversed == 0) return;
  notes.push_back(fmt::format("{} face{} reversed to point outward", reversed, reversed == 1 ? " was" : "s were"));
}

}  // namespace findspace::space
