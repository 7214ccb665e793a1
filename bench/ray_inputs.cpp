// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "ray_inputs.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <queue>
#include <set>
#include <sstream>
#include <tuple>

namespace ray_bench {
namespace {

Point grid(double x, double y, double z) {
  return {std::llround(x * kUnit), std::llround(y * kUnit), std::llround(z * kUnit)};
}

double squared(const Point& p, const Point& q) {
  const double x = static_cast<double>(p.x - q.x), y = static_cast<double>(p.y - q.y),
               z = static_cast<double>(p.z - q.z);
  return x * x + y * y + z * z;
}

using Face = std::array<int, 3>;

/// Edge collapses on faces listed by vertex, none of which makes the surface meet itself anew.
class Collapse {
 public:
  explicit Collapse(const Triangles& mesh) : t_(mesh), at_(mesh.points.size()), dead_(mesh.faces.size(), false) {
    for (std::size_t f = 0; f < t_.faces.size(); ++f) {
      for (int k = 0; k < 3; ++k) {
        at_[t_.faces[f][k]].insert(static_cast<int>(f));
        push(t_.faces[f][k], t_.faces[f][(k + 1) % 3]);
      }
    }
  }

  Triangles run(int wanted) {
    auto left = static_cast<int>(t_.faces.size());
    while (left > wanted && !queue_.empty()) {
      const auto [length, a, b] = queue_.top();
      queue_.pop();
      if (can_collapse(a, b)) left -= collapse(a, b);
    }
    Triangles out;
    std::vector<int> index(t_.points.size(), -1);
    for (std::size_t f = 0; f < t_.faces.size(); ++f) {
      if (dead_[f]) continue;
      auto face = t_.faces[f];
      for (int& v : face) {
        if (index[v] < 0) {
          index[v] = static_cast<int>(out.points.size());
          out.points.push_back(t_.points[v]);
        }
        v = index[v];
      }
      out.faces.push_back(face);
    }
    return out;
  }

 private:
  void push(int a, int b) { queue_.emplace(squared(t_.points[a], t_.points[b]), std::min(a, b), std::max(a, b)); }

  std::set<int> around(int v) const {
    std::set<int> result;
    for (const int f : at_[v]) {
      for (const int w : t_.faces[f]) {
        if (w != v) result.insert(w);
      }
    }
    return result;
  }

  bool can_collapse(int a, int b) const {
    const std::set<int> p = around(a), q = around(b);
    if (!p.contains(b)) return false;
    std::vector<int> both;
    std::set_intersection(p.begin(), p.end(), q.begin(), q.end(), std::back_inserter(both));
    if (both.size() != 2) return false;
    for (const int f : at_[a]) {  // a goes to b: no face may turn over or become flat
      auto face = t_.faces[f];
      if (std::find(face.begin(), face.end(), b) != face.end()) continue;
      const auto before = normal(face);
      for (int& v : face) v = v == a ? b : v;
      const auto after = normal(face);
      const double dot = before.x * after.x + before.y * after.y + before.z * after.z;
      const double size = std::sqrt((before.x * before.x + before.y * before.y + before.z * before.z) *
                                    (after.x * after.x + after.y * after.y + after.z * after.z));
      if (!(dot > 0.3 * size) || crosses(face, a)) return false;
    }
    return true;
  }

  /// Whether a face that has got another corner in place of a would meet one that keeps its place.
  bool crosses(const Face& face, int a) const {
    const auto at = [&](int v) { return std::find(face.begin(), face.end(), v) != face.end(); };
    for (std::size_t g = 0; g < t_.faces.size(); ++g) {
      const Face& other = t_.faces[g];
      const int shared = at(other[0]) + at(other[1]) + at(other[2]);
      const bool moves = std::find(other.begin(), other.end(), a) != other.end();
      if (!dead_[g] && !moves && shared < 2 && boxes_meet(face, other) && (pass(face, other) || pass(other, face)))
        return true;
    }
    return false;
  }

  bool boxes_meet(const Face& f, const Face& g) const {
    for (const auto axis : {&Point::x, &Point::y, &Point::z}) {
      const auto ends = [&](const Face& h) {
        return std::minmax({t_.points[h[0]].*axis, t_.points[h[1]].*axis, t_.points[h[2]].*axis});
      };
      const auto p = ends(f), q = ends(g);
      if (p.second < q.first || q.second < p.first) return false;
    }
    return true;
  }

  /// Whether an edge of f that has no corner of g meets g.
  bool pass(const Face& f, const Face& g) const {
    const auto corner = [&](int v) { return std::find(g.begin(), g.end(), v) != g.end(); };
    const auto sign = [&](int p, int q, int r, int s) {
      return findspace::exact::sign_volume(t_.points[p], t_.points[q], t_.points[r], t_.points[s]);
    };
    for (int k = 0; k < 3; ++k) {
      const int p = f[k], q = f[(k + 1) % 3];
      if (corner(p) || corner(q) || sign(g[0], g[1], g[2], p) * sign(g[0], g[1], g[2], q) > 0) continue;
      const int u = sign(p, q, g[0], g[1]), v = sign(p, q, g[1], g[2]), w = sign(p, q, g[2], g[0]);
      if ((u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0)) return true;
    }
    return false;
  }

  findspace::exact::Approx3 normal(const Face& f) const {
    return findspace::exact::approx(
        findspace::exact::cross(t_.points[f[1]] - t_.points[f[0]], t_.points[f[2]] - t_.points[f[0]]));
  }

  int collapse(int a, int b) {
    int gone = 0;
    const std::set<int> faces = at_[a];
    for (const int f : faces) {
      auto& face = t_.faces[f];
      if (std::find(face.begin(), face.end(), b) != face.end()) {
        dead_[f] = true;
        ++gone;
        for (const int v : face) at_[v].erase(f);
        continue;
      }
      for (int& v : face) v = v == a ? b : v;
      at_[b].insert(f);
    }
    at_[a].clear();
    for (const int v : around(b)) push(v, b);
    return gone;
  }

  Triangles t_;
  std::vector<std::set<int>> at_;
  std::vector<bool> dead_;
  std::priority_queue<std::tuple<double, int, int>, std::vector<std::tuple<double, int, int>>, std::greater<>> queue_;
};

}  // namespace

Triangles octahedron(double r) {
  Triangles t;
  t.points = {grid(r, 0, 0), grid(-r, 0, 0), grid(0, r, 0), grid(0, -r, 0), grid(0, 0, r), grid(0, 0, -r)};
  t.faces = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  return t;
}

Triangles bumpy_sphere(double radius, double bump, int waves, int around, int across) {
  Triangles t;
  const auto at = [&](double u, double v) {
    const double r = radius * (1 + bump * std::sin(waves * u) * std::sin(waves * v) * std::sin(v));
    return grid(r * std::cos(u) * std::sin(v), r * std::sin(u) * std::sin(v), r * std::cos(v));
  };
  for (int i = 0; i < around; ++i) {
    for (int k = 1; k < across; ++k) t.points.push_back(at(2 * M_PI * i / around, M_PI * k / across));
  }
  const int rows = across - 1, north = around * rows, south = north + 1;
  t.points.push_back(at(0, 0));
  t.points.push_back(at(0, M_PI));
  for (int i = 0; i < around; ++i) {
    const int next = (i + 1) % around;
    t.faces.push_back({north, i * rows, next * rows});
    t.faces.push_back({south, next * rows + rows - 1, i * rows + rows - 1});
    for (int k = 0; k + 1 < rows; ++k) {
      t.faces.push_back({i * rows + k, i * rows + k + 1, next * rows + k + 1});
      t.faces.push_back({i * rows + k, next * rows + k + 1, next * rows + k});
    }
  }
  return t;
}

Triangles read_obj(const std::string& path) {
  Triangles t;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (word == "v") {
      double x = 0, y = 0, z = 0;
      words >> x >> y >> z;
      t.points.push_back(grid(x, y, z));
    } else if (word == "f") {
      std::vector<int> ring;
      while (words >> word) ring.push_back(std::stoi(word) - 1);
      for (std::size_t k = 1; k + 1 < ring.size(); ++k) t.faces.push_back({ring[0], ring[k], ring[k + 1]});
    }
  }
  return t;
}

Triangles coarser(const Triangles& mesh, int faces) { return Collapse(mesh).run(faces); }

}  // namespace ray_bench
