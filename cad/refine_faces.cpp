// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "refine_faces.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "face_promise.h"
#include "problem.h"

namespace findspace::cad {
namespace {

using io::CadFault;

/// Counter-clockwise in the plane of parameters, and not at a pole, which has no one place there.
bool runs_left(const FaceMesh& f, const Triangle& t) {
  for (const int v : t)
    if (f.pole[std::size_t(v)] >= 0) return false;
  const auto &a = f.at[std::size_t(t[0])], &b = f.at[std::size_t(t[1])], &c = f.at[std::size_t(t[2])];
  return (b[0] - a[0]) * (c[1] - a[1]) > (b[1] - a[1]) * (c[0] - a[0]);
}

/// The triangle cut at the middles of its sides, where it has them.
void cut(const FaceMesh& f, const Triangle& t, const std::array<int, 3>& m, std::vector<Triangle>& out) {
  const auto count = std::count_if(m.begin(), m.end(), [](int v) { return v >= 0; });
  if (count == 0) {
    out.push_back(t);
    return;
  }
  if (count == 3) {
    for (std::size_t i = 0; i < 3; ++i) out.push_back({t[i], m[i], m[(i + 2) % 3]});
    out.push_back(m);
    return;
  }
  std::size_t i = 0;  // the side that has one, and with two the one before has one as well
  while (m[i] < 0 || (count == 2 && m[(i + 2) % 3] < 0)) ++i;
  const int a = t[i], b = t[(i + 1) % 3], c = t[(i + 2) % 3], ab = m[i], ca = m[(i + 2) % 3];
  if (count == 1) {
    out.push_back({a, ab, c});
    out.push_back({ab, b, c});
    return;
  }
  out.push_back({a, ab, ca});
  const auto apart = [&](int v, int w) {
    return std::hypot(f.at[std::size_t(v)][0] - f.at[std::size_t(w)][0],
                      f.at[std::size_t(v)][1] - f.at[std::size_t(w)][1]);
  };
  if (apart(ab, c) <= apart(b, ca)) {
    out.push_back({ab, b, c});
    out.push_back({ab, c, ca});
  } else {
    out.push_back({ab, b, ca});
    out.push_back({b, c, ca});
  }
}

class Refinement {
 public:
  Refinement(std::vector<FaceMesh>& faces, SolidCorners& corners) : faces_(faces), corners_(corners) {}

  /// Halves sides until no bound is above the tolerance.
  void run(double tolerance, std::size_t most) {
    for (int pass = 0; pass < kMostPasses; ++pass) {
      std::size_t count = 0;
      Marks marks;
      for (std::size_t f = 0; f < faces_.size(); ++f) {
        count += faces_[f].triangles.size();
        for (int k = 0; k < kSweeps && flip(faces_[f], tolerance); ++k) {
        }
        mark(f, tolerance, marks);
      }
      if (count > most)
        fail(CadFault::kUnsupported, "more than " + std::to_string(most) +
                                         " triangles are needed for this tolerance; raise it with --tolerance");
      if (marks.inner.empty() && marks.parts.empty()) return;
      for (std::size_t f = 0; f < faces_.size(); ++f) split(f, marks);
    }
    fail(CadFault::kUnsupported,
         "no bound within the tolerance could be proved for it; give the part as a mesh (STL, 3MF)");
  }

 private:
  struct Marks {
    std::set<std::pair<std::size_t, Segment>> inner;            // of a face, the lesser node first
    std::set<std::pair<int, std::pair<double, double>>> parts;  // of edges
  };

  /// Changes the diagonal of two triangles where that lowers a bound that is too high. True if any was changed.
  bool flip(FaceMesh& f, double tolerance) const {
    if (!f.bounds) return false;
    std::map<Segment, std::size_t> left;  // the triangle to the left of each side
    for (std::size_t k = 0; k < f.triangles.size(); ++k)
      for (std::size_t i = 0; i < 3; ++i) left[{f.triangles[k][i], f.triangles[k][(i + 1) % 3]}] = k;
    std::vector<bool> changed(f.triangles.size());
    bool any = false;
    for (std::size_t k = 0; k < f.triangles.size(); ++k) {
      const Promise p = promise_of(f, f.triangles[k], corners_.places());
      if (changed[k] || p.bound <= tolerance) continue;
      const auto i = std::size_t(p.longest);
      const int a = f.triangles[k][i], b = f.triangles[k][(i + 1) % 3], c = f.triangles[k][(i + 2) % 3];
      const auto across = left.find({b, a});
      if (across == left.end() || f.boundary.count({a, b}) > 0 || changed[across->second]) continue;
      const Triangle& other = f.triangles[across->second];
      const int d = other[0] + other[1] + other[2] - a - b;
      const Triangle one{a, d, c}, two{d, b, c};
      if (d == c || left.count({c, d}) > 0 || left.count({d, c}) > 0 || !runs_left(f, one) || !runs_left(f, two))
        continue;
      const double before = std::max(p.bound, promise_of(f, other, corners_.places()).bound);
      if (std::max(promise_of(f, one, corners_.places()).bound, promise_of(f, two, corners_.places()).bound) >=
          before * kGain)
        continue;
      changed[k] = changed[across->second] = any = true;
      f.triangles[across->second] = two;
      f.triangles[k] = one;
    }
    return any;
  }

  void mark(std::size_t index, double tolerance, Marks& marks) const {
    const FaceMesh& f = faces_[index];
    for (const auto& t : f.triangles) {
      const Promise p = promise_of(f, t, corners_.places());
      if (f.bounds) mark_ears(index, t, marks);
      if (p.bound <= tolerance) continue;
      if (off_surface(f, t, corners_.places()) > tolerance / 2)
        fail(CadFault::kGeometry, f.name() + " has edges that are farther from it than the tolerance allows");
      if (!f.bounds) continue;
      bool any = false;
      for (std::size_t i = 0; i < 3 && p.slack > p.bound / 2; ++i) {
        const auto found = f.boundary.find({t[i], t[(i + 1) % 3]});
        if (found == f.boundary.end() || found->second.slack.u + found->second.slack.v <= 0) continue;
        mark_part(f, found->second, marks);
        any = true;
      }
      if (any) continue;
      const int a = t[std::size_t(p.longest)], b = t[(std::size_t(p.longest) + 1) % 3];
      if (const auto found = f.boundary.find({a, b}); found != f.boundary.end())
        mark_part(f, found->second, marks);
      else
        marks.inner.insert({index, std::minmax(a, b)});
    }
  }

  /// An inner side between two nodes of one edge is halved: the triangle beyond could lie in the plane of that edge,
  /// and fold back on the face across it.
  void mark_ears(std::size_t index, const Triangle& t, Marks& marks) const {
    const FaceMesh& f = faces_[index];
    for (std::size_t i = 0; i < 3; ++i) {
      const auto one = f.boundary.find({t[i], t[(i + 1) % 3]}), two = f.boundary.find({t[(i + 1) % 3], t[(i + 2) % 3]});
      const Segment across{t[(i + 2) % 3], t[i]};
      if (one == f.boundary.end() || two == f.boundary.end() || f.boundary.count(across) > 0) continue;
      if (one->second.edge == two->second.edge) marks.inner.insert({index, std::minmax(across.first, across.second)});
    }
  }

  static std::pair<int, std::pair<double, double>> key_of(const FaceMesh& f, const EdgePart& part) {
    return {f.curves.at(part.edge).second, std::minmax(part.place0, part.place1)};
  }
  static void mark_part(const FaceMesh& f, const EdgePart& part, Marks& marks) { marks.parts.insert(key_of(f, part)); }

  /// The node in the middle of each marked side, made where it is first met.
  void split(std::size_t index, const Marks& marks) {
    FaceMesh& f = faces_[index];
    std::map<Segment, int> middle;
    std::vector<Triangle> out;
    for (const auto& t : f.triangles) {
      std::array<int, 3> m{};
      for (std::size_t i = 0; i < 3; ++i) m[i] = middle_of(index, t[i], t[(i + 1) % 3], marks, middle);
      cut(f, t, m, out);
    }
    f.triangles = std::move(out);
  }

  int middle_of(std::size_t index, int a, int b, const Marks& marks, std::map<Segment, int>& middle) {
    FaceMesh& f = faces_[index];
    if (const auto known = middle.find({a, b}); known != middle.end()) return known->second;
    if (const auto part = f.boundary.find({a, b}); part != f.boundary.end()) {
      if (marks.parts.count(key_of(f, part->second)) == 0) return -1;
      return middle[{a, b}] = halve(f, a, b, part->second);
    }
    if (marks.inner.count({index, std::minmax(a, b)}) == 0) return -1;
    std::array<double, 2> uv{};
    for (std::size_t k = 0; k < 2; ++k) {
      const double x = f.at[std::size_t(a)][k], y = f.at[std::size_t(b)][k];
      uv[k] = f.pole[std::size_t(a)] == int(k) ? y : f.pole[std::size_t(b)] == int(k) ? x : (x + y) / 2;
    }
    const int node = add_node(f, uv, corners_.add(f.surface->Value(uv[0], uv[1])));
    return middle[{a, b}] = middle[{b, a}] = node;
  }

  /// Replaces the part of an edge by its halves.
  int halve(FaceMesh& f, int a, int b, const EdgePart whole) {
    const double place = (whole.place0 + whole.place1) / 2, t = (whole.t0 + whole.t1) / 2;
    const gp_Pnt2d p = f.curves.at(whole.edge).first->Value(t);
    const std::array<double, 2> uv{p.X(), p.Y()};
    const int node = add_node(f, uv, corners_.at_edge(f, f.curves.at(whole.edge).second, place, t, uv));
    f.boundary.erase({a, b});
    EdgePart first = whole, second = whole;
    first.place1 = second.place0 = place;
    first.t1 = second.t0 = t;
    first.slack = slack_of(f, first, a, node);
    second.slack = slack_of(f, second, node, b);
    f.boundary.emplace(Segment{a, node}, first);
    f.boundary.emplace(Segment{node, b}, second);
    return node;
  }

  static constexpr int kMostPasses = 60, kSweeps = 8;
  static constexpr double kGain = 0.9;  // of the bound before

  std::vector<FaceMesh>& faces_;
  SolidCorners& corners_;
};

}  // namespace

void refine_faces(std::vector<FaceMesh>& faces, SolidCorners& corners, double tolerance, std::size_t most) {
  Refinement(faces, corners).run(tolerance, most);
}

}  // namespace findspace::cad
