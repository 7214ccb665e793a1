// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/touch_frontier.h"

#include <findspace/error.h>

#include <algorithm>
#include <optional>

#include "plane/parallel.h"
#include "space/surface_side.h"
#include "space/touch_facets.h"

namespace findspace::space {
namespace {

using exact::Real;

/// The units of parallel work: fixed, so that the order of pieces does not depend on the number of threads.
constexpr std::size_t kBlock = 16;
/// Points of a part that are tried until the line up from one meets no edge.
constexpr int kTried = 64;

/// How a set lies about a facet.
enum class Lies { kApart, kCuts, kCovers };

struct Cutter {
  double depth;  // of the middle of the facet, the deeper the less
  std::size_t set;
};

class Frontier {
 public:
  Frontier(const Triangles& a, std::span<const Polytope> b, TouchSide side)
      : body_(a),
        tree_(body_),
        facets_(body_, side == TouchSide::kOutside),
        b_(b),
        side_(side),
        sets_(std::make_shared<std::vector<TouchSet>>()) {
    std::vector<std::optional<TouchSet>> made(body_.faces.size() * b.size());
    plane::parallel_for(body_.faces.size(), [&](std::size_t t) {
      for (std::size_t k = 0; k < b.size(); ++k) made[t * b.size() + k].emplace(touch_set(body_, t, b[k]));
    });
    sets_->reserve(made.size());
    for (auto& set : made) sets_->push_back(std::move(*set));
    for (const Polytope& part : b) boxes_.push_back(box_of(part.vertices()));
  }

  TouchFrontier run(const BoxWish& wanted) {
    const std::size_t blocks = (body_.faces.size() + kBlock - 1) / kBlock;
    std::vector<std::vector<FlatPiece>> found(blocks);
    plane::parallel_for(blocks, [&](std::size_t block) {
      const std::size_t end = std::min(body_.faces.size(), (block + 1) * kBlock);
      for (std::size_t t = block * kBlock; t < end; ++t) {
        for (std::size_t k = 0; k < b_.size(); ++k) add_facets(t, t * b_.size() + k, wanted, found[block]);
      }
    });
    TouchFrontier out;
    for (auto& part : found) std::move(part.begin(), part.end(), std::back_inserter(out.pieces));
    out.sets = sets_;
    return out;
  }

 private:
  static GridBox box_of(std::span<const Point> points) {
    GridBox box{points[0], points[0]};
    for (const Point& p : points) {
      box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y), std::min(box.low.z, p.z)};
      box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y), std::max(box.high.z, p.z)};
    }
    return box;
  }

  void add_facets(std::size_t t, std::size_t own, const BoxWish& wanted, std::vector<FlatPiece>& out) const {
    const TouchSet& set = (*sets_)[own];
    std::vector<Point> ring;
    for (int f = 0; f < set.closed.facet_count(); ++f) {
      const Wide3& normal = set.closed.planes()[static_cast<std::size_t>(f)].normal;
      if (!facets_.may_touch(t, normal, set.closed.normal_shadow(f))) continue;
      ring.clear();
      for (const int v : set.closed.circuit(f)) ring.push_back(set.closed.vertices()[static_cast<std::size_t>(v)]);
      const GridBox box = box_of(ring);
      if (!wanted(exact::shadow(box.low), exact::shadow(box.high))) continue;
      std::vector<Cutter> cutters;
      if (find_cutters(own, ring, box, cutters)) add_rest(own, f, cutters, out);
    }
  }

  /// The sets that cut the facet; false if one covers all of it.
  bool find_cutters(std::size_t own, const std::vector<Point>& ring, const GridBox& box,
                    std::vector<Cutter>& cutters) const {
    for (std::size_t k = 0; k < b_.size(); ++k) {
      // t - S meets the box where t meets the box plus S.
      const bool covered = tree_.any_meeting({box.low + boxes_[k].low, box.high + boxes_[k].high}, [&](int face) {
        const std::size_t other = static_cast<std::size_t>(face) * b_.size() + k;
        if (other == own) return false;
        double depth = 0;
        const Lies lies = lie(ring, (*sets_)[other], depth);
        if (lies == Lies::kCuts) cutters.push_back({depth, other});
        return lies == Lies::kCovers;
      });
      if (covered) return false;
    }
    std::sort(cutters.begin(), cutters.end(),
              [](const Cutter& p, const Cutter& q) { return std::pair(p.depth, p.set) < std::pair(q.depth, q.set); });
    return true;
  }

  static Lies lie(const std::vector<Point>& ring, const TouchSet& set, double& depth) {
    bool all = true;
    depth = -exact::kInfinity;
    for (std::size_t h = 0; h < set.planes.size(); ++h) {
      const HalfSpace& plane = set.planes[h];
      bool inside = false;
      double sum = 0;
      for (const Point& p : ring) {
        const Vector near = exact::shadow(p);
        const double v = plane.shadow_value(near), e = plane.error(near);
        const Plane& whole = set.closed.planes()[h];
        const int sign = v > e ? 1 : v < -e ? -1 : exact::sign(exact::dot(whole.normal, p) + whole.offset);
        inside = inside || sign < 0;
        all = all && sign < 0;
        sum += v;
      }
      if (!inside) return Lies::kApart;
      depth = std::max(depth, sum / static_cast<double>(ring.size()));
    }
    return all ? Lies::kCovers : Lies::kCuts;
  }

  void add_rest(std::size_t own, int facet, const std::vector<Cutter>& cutters, std::vector<FlatPiece>& out) const {
    const TouchSet& set = (*sets_)[own];
    FlatPiece whole{&set.planes[static_cast<std::size_t>(facet)], {}};
    for (int h = set.closed.first_half_edge(facet); h < set.closed.first_half_edge(facet + 1); ++h) {
      const HalfEdge& edge = set.closed.half_edges()[static_cast<std::size_t>(h)];
      const Point& p = set.closed.vertices()[static_cast<std::size_t>(edge.origin)];
      whole.corners.push_back({real(p), exact::shadow(p), &set.planes[static_cast<std::size_t>(edge.right)]});
    }
    std::vector<FlatPiece> left{std::move(whole)}, next;
    for (const Cutter& cutter : cutters) {
      next.clear();
      for (FlatPiece& piece : left) subtract(std::move(piece), (*sets_)[cutter.set].planes, next);
      left.swap(next);
      if (left.empty()) return;
    }
    for (FlatPiece& piece : left) {
      if (on_side(piece.corners[0])) out.push_back(std::move(piece));
    }
  }

  /// Whether all parts of B lie on the side of A that is asked for; none of them meets the surface.
  bool on_side(const FlatPiece::Corner& at) const {
    return std::all_of(b_.begin(), b_.end(), [&](const Polytope& part) {
      for (int tried = 0; tried < kTried; ++tried) {
        const RealVector point = plus(at.at, inner_point(part, tried));
        if (const auto inside = encloses(body_, tree_, point, rounded(point)))
          return *inside == (side_ == TouchSide::kInside);
      }
      throw Error(ErrorCode::kUnsupported, "on which side of a surface a touching position lies was not found");
    });
  }

  /// Weighted means of all vertices: points of the interior.
  static RealVector inner_point(const Polytope& part, int tried) {
    RealVector sum;
    std::int64_t weights = 0;
    for (int v = 0; v < part.vertex_count(); ++v) {
      const std::int64_t weight = 1 + (std::int64_t{v} * 7 + tried * std::int64_t{v} * v) % 11;
      sum = plus(sum, scaled(Real(weight), real(part.vertices()[static_cast<std::size_t>(v)])));
      weights += weight;
    }
    return scaled(Real::ratio(1, weights), sum);
  }

  RayBody body_;
  BoxTree tree_;
  TouchFacets facets_;
  std::span<const Polytope> b_;
  std::vector<GridBox> boxes_;
  TouchSide side_;
  std::shared_ptr<std::vector<TouchSet>> sets_;
};

}  // namespace

TouchFrontier touch_frontier(const Triangles& a, std::span<const Polytope> b, TouchSide side, const BoxWish& wanted) {
  return Frontier(a, b, side).run(wanted);
}

}  // namespace findspace::space
