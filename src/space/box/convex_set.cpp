// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/box/convex_set.h"

#include <algorithm>
#include <map>
#include <utility>

namespace findspace::space {

using exact::Real;

namespace {

class ConvexSummarizer {
 public:
  ConvexSummarizer(const ConvexSet& set, const Real& step)
      : set_(set),
        step_(step),
        radius_((set.radius * step).to_double()),
        core_(set.region.dimension()),
        dimension_(core_ >= 0 && set.radius.sign() > 0 ? 3 : core_) {
    for (const ConvexRegion::Vertex& v : set.region.vertices()) {
      corners_.push_back({(v.at[0] * step).to_double(), (v.at[1] * step).to_double(), (v.at[2] * step).to_double()});
    }
  }

  SpaceSummary run() {
    const bool solid = dimension_ == 3, inside = solid && set_.inside, frontier = dimension_ >= 0 && set_.frontier;
    // Without an interior nothing lies inside, without vertices nothing on the frontier.
    const bool lacks_inside = solid && !set_.inside, lacks_frontier = dimension_ >= 0 && !set_.frontier;
    out_.empty = !inside && !frontier && !set_.outside;
    out_.whole = set_.outside && !lacks_inside && !lacks_frontier;
    out_.bounded = !set_.outside;
    const bool trivial = out_.empty || out_.whole;
    out_.open = trivial || !frontier;
    out_.closed = trivial || frontier;
    out_.regular = trivial || (frontier && (solid ? inside != set_.outside : set_.outside));
    if (out_.bounded) out_.volume = inside ? volume() : 0;
    if (!out_.bounded && !trivial) {
      out_.holes = lacks_inside || lacks_frontier;
      if (!lacks_inside && lacks_frontier) crack();
    }
    if (out_.bounded && frontier && !inside) dangle();
    if (!out_.empty && out_.bounded) out_.bbox = box();
    add_components(inside, frontier, solid);
    return out_;
  }

 private:
  void add_components(bool inside, bool frontier, bool solid) {
    if (out_.empty) return;
    if (inside || (frontier && !set_.outside)) {
      SpaceComponent c;
      c.dimension = inside ? 3 : solid ? 2 : dimension_;
      if (!set_.outside || !frontier) {
        c.volume = inside ? volume() : 0;
        c.dangling_area = inside ? 0 : area();
        c.dangling_length = inside ? 0 : length_of_segment();
        c.bbox = box();
        c.holes = solid && !inside;
        c.sample = inside || !solid ? middle(all()) : on_frontier();
        if (dimension_ == 0) out_.isolated.push_back(c.sample);
        out_.components.push_back(c);
        if (!set_.outside) {
          out_.holes = c.holes;
          return;
        }
      }
    }
    SpaceComponent c;
    c.dimension = 3;
    c.holes = out_.whole || (inside && frontier) ? 0 : dimension_ >= 0;
    if (!corners_.empty()) {
      c.sample = corners_[0];
      for (const Place3& p : corners_) c.sample[0] = std::max(c.sample[0], p[0]);
      c.sample[0] += 1 + radius_;
    }
    out_.components.insert(out_.components.begin(), c);
  }

  std::vector<int> all() const {
    std::vector<int> ids(corners_.size());
    for (std::size_t i = 0; i < ids.size(); ++i) ids[i] = static_cast<int>(i);
    return ids;
  }
  Place3 middle(const std::vector<int>& of) const {
    Place3 p{};
    for (const int v : of) {
      for (std::size_t k = 0; k < 3; ++k) p[k] += corners_[std::size_t(v)][k] / double(of.size());
    }
    return p;
  }
  /// The highest corner raised by the radius, or a middle of a facet.
  Place3 on_frontier() const {
    if (set_.radius.sign() == 0) return middle(set_.region.circuit(set_.region.facets()[0]));
    Place3 p = *std::max_element(corners_.begin(), corners_.end(), [](auto& a, auto& b) { return a[2] < b[2]; });
    p[2] += radius_;
    return p;
  }
  /// Steiner: V + S r + M r^2 + 4/3 pi r^3.
  double volume() const {
    const double core = (set_.region.six_volumes() / Real(6) * step_ * step_ * step_).to_double(), r = radius_;
    if (r == 0) return core;
    return core + core_area() * r + mean_width() * r * r + 4 * M_PI / 3 * r * r * r;
  }
  /// Of the frontier of a body, or of a flat set.
  double area() const {
    return radius_ > 0 ? core_area() + 2 * mean_width() * radius_ + 4 * M_PI * radius_ * radius_ : flat_area();
  }
  /// A flat set has two sides.
  double core_area() const { return core_ == 2 ? 2 * flat_area() : flat_area(); }
  /// Half the sum of the edges' lengths times the angles between the normals about them.
  double mean_width() const {
    if (core_ == 1) return M_PI * length(between(0, 1));
    double sum = 0;
    if (core_ < 2) return sum;
    if (core_ == 2) {
      for (const auto& [v, w] : set_.region.edges()) sum += length(between(std::size_t(v), std::size_t(w))) * M_PI / 2;
      return sum;
    }
    std::map<std::pair<int, int>, std::vector<Vector>> normals;  // of an edge's two facets
    const std::vector<int> faces = set_.region.facets();
    const std::vector<std::vector<int>> rings = set_.region.circuits();
    for (std::size_t f = 0; f < faces.size(); ++f)
      for (std::size_t i = 0; i < rings[f].size(); ++i)
        normals[std::minmax(rings[f][i], rings[f][(i + 1) % rings[f].size()])].push_back(
            set_.region.planes()[std::size_t(faces[f])].unit);
    for (const auto& [edge, of] : normals)
      sum += length(between(std::size_t(edge.first), std::size_t(edge.second))) *
             std::atan2(length(cross(of[0], of[1])), dot(of[0], of[1])) / 2;
    return sum;
  }
  Vector between(std::size_t v, std::size_t w) const {
    const Place3 &a = corners_[v], &b = corners_[w];
    return {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
  }

  double flat_area() const {
    if (core_ < 2) return 0;
    double sum = 0;
    for (const std::vector<int>& ring : flat_rings()) {
      for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
        const auto at = [&](std::size_t k) { return between(std::size_t(ring[0]), std::size_t(ring[k])); };
        sum += length(cross(at(i), at(i + 1))) / 2;
      }
    }
    return sum;
  }
  /// A flat set is its one facet; which of the planes it lies in does not matter.
  std::vector<std::vector<int>> flat_rings() const {
    std::vector<std::vector<int>> rings = set_.region.circuits();
    if (core_ == 3) return rings;
    for (std::vector<int>& ring : rings)
      if (ring.size() == corners_.size()) return {std::move(ring)};
    return {};
  }
  double length_of_segment() const {
    if (dimension_ != 1) return 0;
    return length(between(0, 1));
  }
  void dangle() {
    out_.dangling_area = area();
    out_.dangling_length = length_of_segment();
  }
  void crack() {
    out_.crack_area = area();
    out_.crack_length = length_of_segment();
  }
  PlaceBox box() const {
    PlaceBox b{corners_[0], corners_[0]};
    for (const Place3& p : corners_) {
      for (std::size_t k = 0; k < 3; ++k) {
        b.low[k] = std::min(b.low[k], p[k]);
        b.high[k] = std::max(b.high[k], p[k]);
      }
    }
    for (std::size_t k = 0; k < 3; ++k) {
      b.low[k] -= radius_;
      b.high[k] += radius_;
    }
    return b;
  }

  const ConvexSet& set_;
  const Real& step_;
  double radius_;
  int core_, dimension_;  // of the region, of the set
  std::vector<Place3> corners_;
  SpaceSummary out_;
};

}  // namespace

namespace {

bool solid(const ConvexSet& set) { return set.radius.sign() > 0 ? !set.region.empty() : set.region.dimension() == 3; }

}  // namespace

ConvexSet closure(ConvexSet set) {
  set.frontier = set.frontier || set.outside || (set.inside && solid(set));
  return set;
}

ConvexSet interior(ConvexSet set) {
  set.frontier = set.frontier && set.outside && (set.inside || !solid(set));
  return set;
}

ConvexSet complement(ConvexSet set) {
  set.inside = !set.inside;
  set.frontier = !set.frontier;
  set.outside = !set.outside;
  return set;
}

ConvexSet boundary(const ConvexSet& set) {
  const ConvexSet closed = closure(set), open = interior(set);
  ConvexSet out = set;
  out.inside = out.outside = false;
  out.frontier = closed.frontier && !open.frontier;
  return out;
}

SpaceSummary summarize(const ConvexSet& set, const Real& step) { return ConvexSummarizer(set, step).run(); }

}  // namespace findspace::space
