// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/touch_search.h"

#include <algorithm>
#include <queue>

#include "space/extent.h"

namespace findspace::space {
namespace {

using exact::Real;

Vector normal_to(const Vector& a, const Vector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

double from_segment(const Vector& a, const Vector& b, const Vector& p) {
  const Vector e = b - a, w = p - a;
  const double square = dot(e, e), t = square > 0 ? std::clamp(dot(e, w) / square, 0.0, 1.0) : 0;
  return length(w - scaled(t, e));
}

/// From the polygon with the corners, counter-clockwise from where its normal points to; a rounding or so off.
template <class Corners, class Near>
double from_polygon(const Corners& corners, const Vector& unit, const Vector& p, Near near) {
  const std::size_t n = corners.size();
  bool inside = n > 2;
  double least = exact::kInfinity;
  for (std::size_t k = 0; k < n; ++k) {
    const Vector a = near(corners[k]), b = near(corners[(k + 1) % n]);
    inside = inside && dot(normal_to(unit, b - a), p - a) >= 0;
    least = std::min(least, from_segment(a, b, p));
  }
  return inside ? std::fabs(dot(unit, p - near(corners[0]))) : least;
}

template <class Corners, class Near>
double to_farthest(const Corners& corners, const Vector& p, Near near) {
  double most = 0;
  for (const auto& c : corners) most = std::max(most, length(near(c) - p));
  return most;
}

RealVector nearest_on_segment(const RealVector& a, const RealVector& b, const RealVector& p) {
  const RealVector e = minus(b, a);
  const Real t = dot(minus(p, a), e), square = dot(e, e);
  if (t.sign() <= 0) return a;
  return t < square ? along(a, t / square, e) : b;
}

/// On a polygon, a segment or a point.
RealVector nearest_on(const FlatPiece& piece, const RealVector& p) {
  const auto& corners = piece.corners;
  const std::size_t n = corners.size();
  if (n > 2) {
    const RealVector& normal = piece.plane->normal;
    const RealVector foot = along(p, -(piece.plane->value(p) / dot(normal, normal)), normal);
    bool inside = true;
    for (std::size_t k = 0; inside && k < n; ++k) {
      const RealVector edge = minus(corners[(k + 1) % n].at, corners[k].at);
      inside = dot(cross(normal, edge), minus(foot, corners[k].at)).sign() > 0;
    }
    if (inside) return foot;
  }
  RealVector best = corners[0].at;
  Real least = dot(minus(best, p), minus(best, p));
  for (std::size_t k = 0; n > 1 && k < n; ++k) {
    RealVector q = nearest_on_segment(corners[k].at, corners[(k + 1) % n].at, p);
    const Real square = dot(minus(q, p), minus(q, p));
    if (square < least) least = square, best = std::move(q);
  }
  return best;
}

class Search {
 public:
  Search(const TouchSets& sets, const RealVector& p, bool farthest)
      : sets_(sets), p_(p), near_(rounded(p)), sign_(farthest ? -1 : 1) {
    const RayBody& body = sets.sheet().body;
    double size = 0;
    for (std::size_t k = 0; k < sets.parts().size(); ++k)
      size = std::max(size, size_of(exact::shadow(sets.box(k).low)) + size_of(exact::shadow(sets.box(k).high)));
    size += size_of(near_) + size_of(exact::shadow(body.low)) + size_of(exact::shadow(body.high));
    slack_ = 0x1p-40 * size;
  }

  std::optional<RealVector> run() {
    for (std::size_t k = 0; k < sets_.parts().size(); ++k) add_node(0, k);
    while (!queue_.empty() && !(queue_.top().key > best_key_ + slack_)) {
      const Task top = queue_.top();
      queue_.pop();
      if (top.kind == Task::kNode)
        divide(top);
      else if (top.kind == Task::kPair)
        add_facets({static_cast<std::size_t>(top.index), top.part});
      else
        cut(static_cast<std::size_t>(top.index));
    }
    return best_;
  }

 private:
  struct Task {
    double key;  // the least distance, or minus the greatest
    enum Kind { kNode, kPair, kFacet } kind;
    int index;  // of the node, triangle or facet
    std::size_t part = 0;
    bool operator<(const Task& o) const {
      return key != o.key     ? key > o.key
             : kind != o.kind ? kind > o.kind
                              : std::pair(index, part) > std::pair(o.index, o.part);
    }
  };

  /// Of what the box holds less the part.
  double key(const GridBox& box, std::size_t part) const {
    const GridBox& by = sets_.box(part);
    const Extent e{exact::shadow(box.low - by.high), exact::shadow(box.high - by.low)};
    if (sign_ > 0) return e.distance(near_);
    const auto far = [](double c, double lo, double hi) { return std::max(std::fabs(lo - c), std::fabs(hi - c)); };
    return -length({far(near_.x, e.low.x, e.high.x), far(near_.y, e.low.y, e.high.y), far(near_.z, e.low.z, e.high.z)});
  }
  template <class Corners, class Near>
  double key(const Corners& corners, const Vector& unit, Near near) const {
    return sign_ > 0 ? from_polygon(corners, unit, near_, near) : -to_farthest(corners, near_, near);
  }

  void add_node(int node, std::size_t part) {
    queue_.push({key(sets_.sheet().tree.nodes()[static_cast<std::size_t>(node)].box, part), Task::kNode, node, part});
  }

  void divide(const Task& task) {
    const BoxTree& tree = sets_.sheet().tree;
    const BoxTree::Node& node = tree.nodes()[static_cast<std::size_t>(task.index)];
    if (node.count == 0) {
      add_node(node.first, task.part), add_node(node.first + 1, task.part);
      return;
    }
    for (int k = node.first; k < node.first + node.count; ++k)
      queue_.push({key(tree.box(k), task.part), Task::kPair, tree.face(k), task.part});
  }

  void add_facets(const TouchSets::Pair& of) {
    const TouchSet& set = sets_.set(of);
    for (TouchSets::Facet& facet : sets_.facets(of)) {
      const double at = key(facet.ring, set.planes[static_cast<std::size_t>(facet.facet)].unit,
                            [](const Point& q) { return exact::shadow(q); });
      if (at > best_key_ + slack_) continue;
      queue_.push({at, Task::kFacet, static_cast<int>(facets_.size()), of.part});
      facets_.push_back(std::move(facet));
    }
  }

  void cut(std::size_t facet) {
    std::vector<FlatPiece> pieces;
    sets_.add_pieces(facets_[facet], pieces);
    facets_[facet].ring.clear();
    for (const FlatPiece& piece : pieces) {
      const double at = key(piece.corners, piece.plane->unit, [](const FlatPiece::Corner& c) { return c.near; });
      if (at > best_key_ + slack_) continue;
      if (sign_ > 0) {
        offer(nearest_on(piece, p_), at);
        continue;
      }
      for (const FlatPiece::Corner& c : piece.corners) {
        if (!(-length(c.near - near_) > best_key_ + slack_)) offer(c.at, -length(c.near - near_));
      }
    }
  }

  void offer(const RealVector& q, double key) {
    const RealVector way = minus(q, p_);
    const Real square = dot(way, way);
    if (best_ && !(sign_ > 0 ? square < square_ : square_ < square)) return;
    best_ = q, square_ = square, best_key_ = key;
  }

  const TouchSets& sets_;
  RealVector p_;
  Vector near_;
  int sign_;
  double slack_ = 0;
  std::priority_queue<Task> queue_;
  std::vector<TouchSets::Facet> facets_;
  std::optional<RealVector> best_;
  Real square_;
  double best_key_ = exact::kInfinity;
};

}  // namespace

std::optional<RealVector> nearest_touch(const TouchSets& sets, const RealVector& p) {
  return Search(sets, p, false).run();
}

std::optional<RealVector> farthest_touch(const TouchSets& sets, const RealVector& p) {
  return Search(sets, p, true).run();
}

}  // namespace findspace::space
