// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/rays/longest_run.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "exact/margins/rounding.h"
#include "plane/base/subdivide.h"
#include "space/rays/swept_pieces.h"

namespace findspace::space {
namespace {

using exact::Real;

/// A piece seen along the direction, and where it lies along it; a hair wider.
struct RunShadow {
  std::array<double, 3> low, high;  // the last one along the direction
  bool over(const RunShadow& start) const {
    return low[0] <= start.high[0] && start.low[0] <= high[0] && low[1] <= start.high[1] && start.low[1] <= high[1] &&
           start.low[2] <= high[2];
  }
  bool holds(const std::array<double, 3>& p) const {
    return low[0] <= p[0] && p[0] <= high[0] && low[1] <= p[1] && p[1] <= high[1];
  }
};

/// What a piece hides of the column over a start, made when first looked at; no planes where that is nothing.
struct HiddenColumn {
  std::size_t piece;
  bool made = false;
  std::vector<HalfSpace> planes;
};

/// A part of the column; `top` of its vertices is farthest from the start.
struct ColumnPart {
  ConvexRegion region;
  std::size_t top = 0;
  double key = 0;
  bool operator<(const ColumnPart& other) const { return key < other.key; }
};

class RunSearch {
 public:
  RunSearch(std::span<const ConvexRegion> pieces, const RealVector& u, const RealVector& low, const RealVector& high)
      : pieces_(pieces), u_(u), low_(low), high_(high) {
    const auto [across, upward] = axes_across(u);
    Real from, to;
    for (std::size_t k = 0; k < 3; ++k) {
      const Real a = u[k] * low[k], b = u[k] * high[k];
      from += std::min(a, b);
      to += std::max(a, b);
    }
    height_ = exact::floor((to - from) / dot(u, u)) + 1;
    axes_ = {unit(across), unit(upward), unit(u)};
    for (const ConvexRegion& piece : pieces) shadows_.push_back(shadow(piece));
  }

  void look_from(const RunStart& start) {
    start_ = &start;
    slope_ = dot(start.plane.normal, u_);
    hidden_.clear();
    ConvexRegion column(low_, high_);
    for (const HalfSpace& h : swept_piece(start.facet, {u_, Real(), height_}).planes) column.cut(h);
    if (column.dimension() < 3) return;
    const RunShadow over = shadow(start.facet);
    for (std::size_t k = 0; k < pieces_.size(); ++k) {
      if (shadows_[k].over(over)) hidden_.push_back({k, false, {}});
    }
    std::sort(hidden_.begin(), hidden_.end(), [&](const HiddenColumn& a, const HiddenColumn& b) {
      return shadows_[a.piece].low[2] < shadows_[b.piece].low[2];
    });
    column_ = column;
    plane::Subdivision<ColumnPart> queue;
    push(std::move(column), queue);
    queue.run([](const ColumnPart&) { return false; }, [&](ColumnPart part) { look(std::move(part), queue); });
  }

  std::optional<LongestRun> found() const { return found_; }

 private:
  static Vector unit(const RealVector& v) {
    const Vector out = space::rounded(v);
    return scaled(1 / length(out), out);
  }

  std::array<double, 3> seen(const Vector& p) const { return {dot(axes_[0], p), dot(axes_[1], p), dot(axes_[2], p)}; }

  RunShadow shadow(const ConvexRegion& set) const {
    RunShadow out;
    out.low.fill(exact::kInfinity);
    out.high.fill(-exact::kInfinity);
    for (const ConvexRegion::Vertex& v : set.vertices()) {
      const std::array<double, 3> p = seen(v.near);
      const double tolerance = margin::kWiderBox * size_of(v.near);
      for (std::size_t k = 0; k < 3; ++k) {
        out.low[k] = std::min(out.low[k], p[k] - tolerance);
        out.high[k] = std::max(out.high[k], p[k] + tolerance);
      }
    }
    return out;
  }

  /// What of the piece is beyond the start's plane; what lies in that plane hides nothing.
  std::vector<HalfSpace> hidden_by(ConvexRegion piece) const {
    if (!piece.sides(start_->plane).outside) return {};
    piece.cut(start_->plane.opposite());
    std::vector<HalfSpace> planes = swept_piece(piece, {u_, Real(), height_}).planes;
    ConvexRegion part = *column_;
    for (const HalfSpace& h : planes) {
      part.cut(h);
      if (part.empty()) return {};
    }
    if (part.dimension() < 3) return {};
    return planes;
  }

  double away(const ConvexRegion::Vertex& v) const { return start_->plane.approx_value(v.near); }

  void push(ConvexRegion region, plane::Subdivision<ColumnPart>& queue) const {
    if (region.dimension() < 3) return;
    ColumnPart part{std::move(region), 0, 0};
    const auto vertices = part.region.vertices();
    for (std::size_t k = 1; k < vertices.size(); ++k) {
      const double tolerance = start_->plane.error(vertices[k].near) + start_->plane.error(vertices[part.top].near);
      const double more = away(vertices[k]) - away(vertices[part.top]);
      if (more > tolerance ||
          (more >= -tolerance && start_->plane.value(vertices[part.top].at) < start_->plane.value(vertices[k].at)))
        part.top = k;
    }
    part.key = away(vertices[part.top]);
    queue.push(std::move(part));
  }

  void look(ColumnPart part, plane::Subdivision<ColumnPart>& queue) {
    const ConvexRegion::Vertex top = part.region.vertices()[part.top];
    const Real length = start_->plane.value(top.at) / slope_;
    if (found_) {
      const int order = compare(length, found_->length);
      if (order < 0 || (order == 0 && found_->middle)) return;
    }
    const std::array<double, 3> at = seen(top.near);
    for (HiddenColumn& hidden : hidden_) {
      if (!shadows_[hidden.piece].holds(at)) continue;
      if (!hidden.made) hidden.planes = hidden_by(pieces_[hidden.piece]);
      hidden.made = true;
      if (hidden.planes.empty() || !hides(hidden, part.region, top)) continue;
      for (const HalfSpace& h : hidden.planes) {
        const ConvexRegion::Sides sides = part.region.sides(h);
        if (!sides.outside) continue;
        ConvexRegion beyond = part.region;
        beyond.cut(h.opposite());
        push(std::move(beyond), queue);
        part.region.cut(h);
      }
      return;
    }
    if (length.sign() <= 0) return;
    LongestRun run{length, std::nullopt};
    if (const auto end = taken(part.region, top, length)) run.middle = along(*end, -length / Real(2), u_);
    found_ = std::move(run);
  }

  /// Whether something of the part's interior next to the vertex is hidden.
  static bool hides(const HiddenColumn& hidden, const ConvexRegion& part, const ConvexRegion::Vertex& vertex) {
    for (const HalfSpace& h : hidden.planes) {
      if (h.sign(vertex.at, vertex.near) > 0) return false;
    }
    ConvexRegion common = part;
    for (const HalfSpace& h : hidden.planes) common.cut(h);
    return common.dimension() == 3;
  }

  /// The end of a stretch of that length, looked for among the places of the part that are as far as the vertex.
  std::optional<RealVector> taken(const ConvexRegion& part, const ConvexRegion::Vertex& top, const Real& length) const {
    std::vector<RealVector> ends;
    for (const ConvexRegion::Vertex& v : part.vertices()) {
      if (start_->plane.value(v.at) / slope_ == length) ends.push_back(v.at);
    }
    if (ends.size() == 2) return taken_between(ends[0], ends[1], length);
    if (free(top.at, length)) return top.at;
    if (ends.size() < 3) return std::nullopt;
    // Near the vertex only pieces that hold the direction are in the way, in lines of the face.
    RealVector even, uneven;
    Real weights;
    for (std::size_t k = 0; k < ends.size(); ++k) {
      const Real weight(static_cast<int>(k) + 1);
      even = plus(even, scaled(Real::ratio(1, static_cast<int>(ends.size())), ends[k]));
      uneven = plus(uneven, scaled(weight, ends[k]));
      weights += weight;
    }
    uneven = scaled(Real(1) / weights, uneven);
    Real share(1);
    for (int k = 0; k < kNearer; ++k, share = share / Real(2)) {
      for (const RealVector& to : {even, uneven}) {
        const RealVector end = along(top.at, share, minus(to, top.at));
        if (free(end, length)) return end;
      }
    }
    return std::nullopt;
  }

  /// What is in the way of stretches between two begins and ends at places that are all tried, and between them.
  std::optional<RealVector> taken_between(const RealVector& p, const RealVector& q, const Real& length) const {
    const RealVector way = minus(q, p), across = cross(way, u_), forward = cross(u_, across);
    ConvexRegion strip(low_, high_);
    const auto cut = [&](const RealVector& n, const RealVector& x) { strip.cut(HalfSpace(n, -dot(n, x))); };
    cut(across, p);
    cut(negated(across), p);
    const int sense = dot(forward, way).sign();
    cut(scaled(Real(-sense), forward), p);
    cut(scaled(Real(sense), forward), q);
    cut(start_->plane.normal, p);
    strip.cut(start_->plane.opposite());
    std::vector<Real> shares{Real(), Real(1)};
    for (const ConvexRegion& piece : pieces_) {
      ConvexRegion met = strip;
      for (const HalfSpace& h : piece.planes()) met.cut(h);
      for (const ConvexRegion::Vertex& v : met.vertices())
        shares.push_back(dot(forward, minus(v.at, p)) / dot(forward, way));
    }
    std::sort(shares.begin(), shares.end());
    shares.erase(std::unique(shares.begin(), shares.end()), shares.end());
    for (std::size_t k = 1; k < shares.size(); ++k) {
      const RealVector end = along(p, (shares[k - 1] + shares[k]) / Real(2), way);
      if (free(end, length)) return end;
    }
    for (const Real& share : shares) {
      const RealVector end = along(p, share, way);
      if (free(end, length)) return end;
    }
    return std::nullopt;
  }

  /// Whether no piece meets the open stretch of that length that ends there.
  bool free(const RealVector& end, const Real& length) const {
    const std::array<double, 3> at = seen(space::rounded(end));
    for (std::size_t k = 0; k < pieces_.size(); ++k) {
      if (shadows_[k].holds(at) && met(pieces_[k], end, length)) return false;
    }
    return true;
  }

  bool met(const ConvexRegion& piece, const RealVector& end, const Real& length) const {
    std::optional<Real> from, to;  // back from the end
    for (const HalfSpace& h : piece.planes()) {
      const Real slope = -dot(h.normal, u_), value = h.value(end);
      const int way = slope.sign();
      if (way == 0 && value.sign() > 0) return false;
      if (way == 0) continue;
      const Real at = -value / slope;
      if (way > 0 && (!to || at < *to)) to = at;
      if (way < 0 && (!from || *from < at)) from = at;
    }
    return *from <= *to && *from < length && to->sign() > 0;
  }

  static constexpr int kNearer = 40;

  std::span<const ConvexRegion> pieces_;
  RealVector u_, low_, high_;
  Real height_;
  std::array<Vector, 3> axes_;
  std::vector<RunShadow> shadows_;
  const RunStart* start_ = nullptr;
  Real slope_;                          // of the start's plane
  std::optional<ConvexRegion> column_;  // over the start
  std::vector<HiddenColumn> hidden_;
  std::optional<LongestRun> found_;
};

/// By their least corners, so that of equal runs the one that is found does not depend on the order of shapes.
std::vector<const RunStart*> in_order(std::span<const RunStart> starts) {
  using Corner = std::array<double, 3>;
  std::vector<std::pair<Corner, const RunStart*>> placed;
  for (const RunStart& start : starts) {
    Corner least{exact::kInfinity, exact::kInfinity, exact::kInfinity};
    for (const ConvexRegion::Vertex& v : start.facet.vertices())
      least = std::min(least, {v.near.x, v.near.y, v.near.z});
    placed.emplace_back(least, &start);
  }
  std::stable_sort(placed.begin(), placed.end(), [](const auto& p, const auto& q) { return p.first < q.first; });
  std::vector<const RunStart*> out;
  for (const auto& [corner, start] : placed) out.push_back(start);
  return out;
}

}  // namespace

std::optional<LongestRun> longest_run(std::span<const ConvexRegion> pieces, std::span<const RunStart> starts,
                                      const RealVector& direction, const RealVector& low, const RealVector& high) {
  RunSearch search(pieces, direction, low, high);
  for (const RunStart* start : in_order(starts)) search.look_from(*start);
  return search.found();
}

}  // namespace findspace::space
