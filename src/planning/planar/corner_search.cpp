// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "planning/planar/corner_search.h"

#include <algorithm>
#include <tuple>

#include "plane/complex/overlay.h"

namespace findspace::planning {

using exact::RealPoint;
using plane::Region;

namespace {

class CornerSearch {
 public:
  CornerSearch(const Relations& relations, const Limit& limit)
      : relations_(relations), problem_(relations.problem()), limit_(limit), poses_(problem_.bodies.size()) {
    for (const Condition& c : problem_.conditions) bodies_.push_back(bodies_of(*c.formula, c.roles));
  }

  std::optional<Poses> run() {
    if (!extend(0)) return std::nullopt;
    return poses_;
  }

 private:
  bool extend(std::size_t body) {
    if (body == poses_.size()) return true;
    for (std::size_t angle = 0; angle < problem_.bodies[body].angles.size(); ++angle) {
      for (const RealPoint& at : corners(allowed(body, angle))) {
        if (limit_.over() || --tries_ < 0) break;
        poses_[body] = Pose{angle, at};
        if (extend(body + 1)) return true;
      }
    }
    poses_[body].reset();
    return false;
  }

  /// Where the body may stand as far as the ones before it go.
  Region allowed(std::size_t body, std::size_t angle) const {
    Poses poses = poses_;
    poses[body] = Pose{angle, {}};
    std::vector<Region> sets;
    for (std::size_t c = 0; c < bodies_.size(); ++c) {
      const bool counts =
          bodies_[c].empty() || std::find(bodies_[c].begin(), bodies_[c].end(), body) != bodies_[c].end();
      const bool known = std::all_of(bodies_[c].begin(), bodies_[c].end(), [&](std::size_t b) { return b <= body; });
      if (counts && known) sets.push_back(relations_.allowed(problem_.conditions[c], body, poses));
    }
    std::vector<const Region*> all;
    for (const Region& r : sets) all.push_back(&r);
    return keeping_conditions(problem_, plane::intersect(all));
  }

  /// The vertices of the set by rows and columns, those with short numbers first, and a position of it besides.
  static std::vector<RealPoint> corners(const Region& region) {
    constexpr std::size_t kMost = 16;
    struct Corner {
      bool lengthy;
      double y, x;
      RealPoint at;
    };
    std::vector<Corner> all;
    for (const plane::Vertex& v : region.vertices) {
      if (v.mark <= 0) continue;
      const RealPoint at = region.geometry.exact(v.point);
      all.push_back({!at.x.is_closed() || !at.y.is_closed(), at.y.to_double(), at.x.to_double(), at});
    }
    std::sort(all.begin(), all.end(), [](const Corner& p, const Corner& q) {
      return std::tie(p.lengthy, p.y, p.x) < std::tie(q.lengthy, q.y, q.x);
    });
    if (all.size() > kMost) all.resize(kMost);
    std::vector<RealPoint> out;
    for (Corner& c : all) out.push_back(std::move(c.at));
    if (auto other = representative(region)) out.push_back(std::move(*other));
    return out;
  }

  const Relations& relations_;
  const Problem& problem_;
  const Limit& limit_;
  std::vector<std::vector<std::size_t>> bodies_;  // by condition
  Poses poses_;
  int tries_ = 3000;
};

}  // namespace

std::optional<Poses> search_corners(const Relations& relations, const Limit& limit) {
  return CornerSearch(relations, limit).run();
}

}  // namespace findspace::planning
