// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/rays/protrusion_rays.h"

#include <findspace/error.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "distance/rays/line_signs.h"
#include "distance/search/grown_set.h"
#include "exact/margins/space_distance.h"
#include "plane/base/search_work.h"
#include "space/rays/oblique_line.h"

namespace findspace::distance {

namespace {

using space::Vector;

/// To the end of a run; a shorter one is as good.
constexpr int kMostRootSteps = 60;

/// How far a line runs until a convex function, positive at 0, is no longer so: a secant through places before lies
/// below it beyond, so its zero comes no later.
double convex_run(const std::function<double(double)>& f, double size) {
  const double farthest = 4 * size;
  double before = -size * margin::kSecantStart, at = 0;
  double value_before = f(before), value = f(at);
  for (int count = 0; count < kMostRootSteps && value > size * margin::kDistanceNoise; ++count) {
    // With a margin for rounding, so that steps are rather too short.
    const double slope = (value - value_before - size * margin::kDistanceNoise) / (at - before);
    if (slope >= 0 || value > -slope * (farthest - at)) return farthest;
    const double next = at - value / slope;
    if (!(next > at)) break;
    before = at;
    value_before = value;
    at = next;
    value = f(at);
  }
  return at;
}

class PartsField : public ProtrusionField {
 public:
  PartsField(const space::Body& body, std::span<const space::WallBridge> further) {
    // Less than 0 inside: at small levels what is deep in A counts.
    for (const space::BodyPart& part : body.parts) nearest_.push_back(grown_distance(grown_set(part)));
    for (const space::WallBridge& set : further) nearest_.push_back(grown_distance({set.planes, {}, {}}));
    const space::Bounds3 box = bounds(body);
    size_ = space::length(space::rounded(space::minus(box.high, box.low)));
  }
  double size() const override { return size_; }
  SolidMaxMin max_min(const Solids& solids, double slack, double share) const override {
    return solid_max_min(solids, nearest_, slack, share);
  }
  double run(const Vector& x, const Vector& way, double cut, double size) const override {
    double least = exact::kInfinity;
    for (const ConvexDistance& d : nearest_)
      least =
          std::min(least, convex_run([&](double s) { return d(space::plus(x, space::scaled(s, way))) - cut; }, size));
    return least;
  }

 private:
  std::vector<ConvexDistance> nearest_;
  double size_;
};

using exact::Real;
using space::Body;
using space::BodyPart;
using space::RayEvent;
using space::RayGrid;
using space::RayPosition;
using space::RayRow;
using space::Vector;

/// What the point found may lack of how far B protrudes. The nearer it is, the fewer cuts until an end; but the last
/// eighths of a search among many triangles cost more than a cut.
constexpr double kProvenShare = 0.875;
/// Stretches that a line is cut into, at most; kCertain is reached long before.
constexpr int kMostCuts = 4000;

/// Places that are remembered, and what share of a stretch one is to cut away.
constexpr std::size_t kMostSeen = 16;
constexpr double kMuch = 0.25;

double size_of(const Body& body) {
  const space::Bounds3 box = bounds(body);
  return space::length(space::rounded(space::minus(box.high, box.low)));
}

/// The line {x - s * unit} meets the half spaces for s in between; for none where it runs along a face farther outside
/// than `noise`.
template <class Planes>
void clip(const Planes& planes, const Vector& x, const Vector& unit, double noise, double& from, double& to) {
  for (const space::HalfSpace& h : planes) {
    const double value = h.approx_value(x), slope = space::dot(h.unit, unit);  // value - s * slope <= 0
    if (std::fabs(slope) < margin::kAlongFace) {
      if (value <= noise) continue;
      from = exact::kInfinity;
      to = -exact::kInfinity;
      return;
    }
    if (slope > 0)
      from = std::max(from, value / slope);
    else
      to = std::min(to, value / slope);
  }
}

}  // namespace

std::unique_ptr<ProtrusionField> field_of_parts(const space::Body& body, std::span<const space::WallBridge> further) {
  return std::make_unique<PartsField>(body, further);
}

ProtrusionRays::ProtrusionRays(const Body& b, std::unique_ptr<ProtrusionField> a, const Real& level,
                               const Vertices& vertices, const RayGrid& grid)
    : grid_(grid), field_(std::move(a)), unit_(static_cast<double>(b.scale) / static_cast<double>(grid.parts)) {
  for (const BodyPart& part : b.parts) {
    if (part.point() && part.radius.sign() == 0) continue;  // a point is its vertex
    Part& made = parts_.emplace_back();
    if (part.point()) {
      made.center = exact::approx(part.center);
      made.radius = part.radius.to_double();
      continue;
    }
    made.solid = tetrahedra(*part.core);
    for (int f = 0; f < part.core->facet_count(); ++f) {
      const auto corner = [&](int v) { return exact::approx(part.core->vertices()[static_cast<std::size_t>(v)]); };
      const std::vector<int> ring = part.core->circuit(f);
      made.planes.emplace_back(part.core->planes()[static_cast<std::size_t>(f)]);
      for (std::size_t k = 1; k + 1 < ring.size(); ++k) {
        made.faces.push_back({corner(ring[0]), corner(ring[k]), corner(ring[k + 1])});
        made.normals.push_back(made.planes.back().unit);
      }
    }
  }
  const double reach = level.to_double();
  size_ = field_->size() + size_of(b) + std::fabs(reach);
  const Real shift = Real::from_double(size_ * kCertain);
  sides_[0] = {vertices(level), reach + size_ * margin::kPlaceNoise, reach + size_ * kCertain};
  sides_[1] = {vertices(level - shift), reach - size_ * kCertain, reach - size_ * kCertain / 2};
}

ProtrusionRays::Line ProtrusionRays::line(int i, int j) const {
  if (grid_.oblique)
    return {space::scaled(unit_, space::rounded(grid_.oblique->origin)), space::rounded(grid_.oblique->frame[2])};
  std::array<double, 3> start{}, unit{};
  const auto axis = static_cast<std::size_t>(grid_.axis);
  start[(axis + 1) % 3] = static_cast<double>(grid_.u_at(i)) * unit_;
  start[(axis + 2) % 3] = static_cast<double>(grid_.v_at(j)) * unit_;
  unit[axis] = 1;
  return {{start[0], start[1], start[2]}, {unit[0], unit[1], unit[2]}};
}

/// What B covers on the stretch of its way: it at the start, and what its faces that look ahead sweep; balls at once.
Solids ProtrusionRays::swept(const Line& line, const Stretch& stretch) const {
  const auto at = [&](const Vector& v, double s) {
    return space::plus(v, space::plus(line.start, space::scaled(s, line.unit)));
  };
  Solids out;
  for (const Part& part : parts_) {
    if (part.radius > 0) out.round.push_back({at(part.center, stretch.from), at(part.center, stretch.to), part.radius});
    for (Tetrahedron t : part.solid) {
      for (Vector& v : t) v = at(v, stretch.from);
      out.cells.push_back(t);
    }
    if (stretch.to <= stretch.from) continue;
    for (std::size_t k = 0; k < part.faces.size(); ++k) {
      if (space::dot(part.normals[k], line.unit) < -margin::kAlongFace)
        continue;  // no sign: those beside cost, but add nothing
      std::array<Vector, 6> c;
      for (std::size_t v = 0; v < 3; ++v) {
        c[v] = at(part.faces[k][v], stretch.from);
        c[v + 3] = at(part.faces[k][v], stretch.to);
      }
      out.cells.push_back({c[0], c[1], c[2], c[3]});
      out.cells.push_back({c[1], c[2], c[3], c[4]});
      out.cells.push_back({c[2], c[3], c[4], c[5]});
    }
  }
  return out;
}

ProtrusionRays::Stretch ProtrusionRays::held(const Part& part, const Line& line, const Vector& off) const {
  if (part.radius > 0) {
    const Vector way = off - part.center;
    const double middle = space::dot(way, line.unit);
    const double half = std::sqrt(std::max(0.0, part.radius * part.radius - space::dot(way, way) + middle * middle));
    return {middle - half, middle + half};
  }
  double from = -exact::kInfinity, to = exact::kInfinity;
  clip(part.planes, off, line.unit, size_ * margin::kPlaceNoise, from, to);
  return {from, to};
}

/// The places at which a part of B holds x. Where none on the line does, a single place.
ProtrusionRays::Stretch ProtrusionRays::chord(const Line& line, const Vector& x, const Stretch& within) const {
  const Vector off = x - line.start;
  Stretch best{within.from, within.from};
  double longest = -exact::kInfinity;
  for (const Part& part : parts_) {
    const auto [from, to] = held(part, line, off);
    const double common = std::min(to, within.to) - std::max(from, within.from);
    if (!(common > longest)) continue;
    longest = common;
    // Rounding may leave nothing of a chord that is a point.
    best = from <= to ? Stretch{from, to} : Stretch{(from + to) / 2, (from + to) / 2};
  }
  return best;
}

/// The places at which x, or what lies before or behind it on its line, is outside V while B holds it.
ProtrusionRays::Stretch ProtrusionRays::outside(const Side& side, const Line& line, const Vector& x,
                                                const Stretch& within) const {
  const auto far = [&](double way) {
    return std::max(0.0, field_->run(x, space::scaled(way, line.unit), side.cut, size_) - size_ * margin::kPlaceNoise);
  };
  const Stretch held = chord(line, x, within);
  return {held.from - far(-1), held.to + far(1)};
}

std::optional<ProtrusionRays::Stretch> ProtrusionRays::cut_again(const Side& side, const Line& line,
                                                                 const Stretch& stretch, Places& seen) const {
  const auto common = [&](const Stretch& s) { return std::min(s.to, stretch.to) - std::max(s.from, stretch.from); };
  for (std::size_t k = 0; k < seen.size(); ++k) {
    const Stretch held = chord(line, seen[k], stretch);
    if (!(common(held) > 0)) continue;
    const Stretch cut = outside(side, line, seen[k], stretch);
    if (!(cut.from < held.from && held.to < cut.to)) continue;  // it is too near to A
    if (!(common(cut) > kMuch * (stretch.to - stretch.from))) continue;
    std::rotate(seen.begin(), seen.begin() + static_cast<std::ptrdiff_t>(k),
                seen.begin() + static_cast<std::ptrdiff_t>(k) + 1);
    return cut;
  }
  return std::nullopt;
}

/// Disjoint open stretches of `whole`, ascending; or all of it, where it is a single place. None in `known`.
exact::Tried<std::vector<ProtrusionRays::Stretch>> ProtrusionRays::cuts(const Side& side, const Line& line,
                                                                        const Stretch& whole,
                                                                        std::span<const Stretch> known,
                                                                        Places& seen) const {
  std::vector<Stretch> left, out;
  double from = whole.from;
  for (const Stretch& k : known) {
    if (k.to < whole.from || k.from > whole.to) continue;
    if (from < k.from) left.push_back({from, k.from});
    from = std::max(from, k.to);
  }
  if (from < whole.to || (from == whole.from && left.empty())) left.push_back({from, whole.to});
  int count = 0;
  while (!left.empty()) {
    const Stretch s = left.back();
    left.pop_back();
    std::optional<Stretch> again = cut_again(side, line, s, seen);
    if (!again) {
      const SolidMaxMin max_min = field_->max_min(swept(line, s), side.enough, kProvenShare);
      if (!max_min.complete || ++count > plane::allowed(kMostCuts))
        return plane::search_spent("the protrusion of the shape was not found");
      if (max_min.value <= side.enough) continue;
      again = outside(side, line, max_min.place, s);
      seen.insert(seen.begin(), max_min.place);
      if (seen.size() > kMostSeen) seen.pop_back();
    }
    const Stretch cut{std::max(again->from, s.from), std::min(again->to, s.to)};
    if (s.from == s.to) return std::vector{s};  // the whole is a single place
    if (!(cut.from < cut.to)) continue;
    out.push_back(cut);
    if (s.from < cut.from) left.push_back({s.from, cut.from});
    if (cut.to < s.to) left.push_back({cut.to, s.to});
  }
  std::sort(out.begin(), out.end(), [](const Stretch& a, const Stretch& b) { return a.from < b.from; });
  // Where two meet the second began before the first's end: it was clipped.
  std::vector<Stretch> joined;
  for (const Stretch& s : out) {
    if (!joined.empty() && s.from <= joined.back().to)
      joined.back().to = s.to;
    else
      joined.push_back(s);
  }
  return joined;
}

ProtrusionRays::Stretch ProtrusionRays::whole(const RayEvent& first, const RayEvent& last) const {
  return {first.at.value * unit_, last.at.value * unit_};
}

/// The closed stretch from event `first` to event `last` of a line, less the cuts.
void ProtrusionRays::keep(std::span<const Stretch> gone, const RayEvent& first, const RayEvent& last,
                          std::vector<RayEvent>& out) const {
  const Stretch whole = this->whole(first, last);
  RayPosition from = first.at;
  bool open = false;  // `from` itself is cut away
  const auto put = [&](const RayPosition& to) {
    const int length = compare_positions(to, from);
    if (length == 0) out.push_back({from, -1, 1});
    if (length > 0) {
      out.push_back({from, -1, -1});
      out.push_back({to, -1, 1});
    }
  };
  for (const Stretch& cut : gone) {
    if (cut.from > whole.from && !open) put(ray_place(cut.from / unit_));
    open = cut.to >= whole.to;
    from = ray_place(cut.to / unit_);
  }
  if (!open) put(last.at);
}

/// The stretches of line i, which are all that there are.
std::vector<ProtrusionRays::Stretch> ProtrusionRays::stretches(const RayRow& row, int i) const {
  std::vector<Stretch> out;
  bool open = false;
  for (int e = row.first[static_cast<std::size_t>(i)]; e < row.first[static_cast<std::size_t>(i) + 1]; ++e) {
    const RayEvent& event = row.events[static_cast<std::size_t>(e)];
    const double at = event.at.value * unit_;
    if (!open) out.push_back({at, at});
    open = event.after < 0;
    out.back().to = at;
  }
  return out;
}

/// `inner`: what is certainly kept.
exact::Tried<RayRow> ProtrusionRays::kept(const Side& side, int j, const RayRow* inner,
                                          std::vector<Places>& seen) const {
  const exact::Tried<RayRow> found = side.vertices->try_row(j);
  if (!found) return found;
  const RayRow& all = *found;
  RayRow out;
  seen.resize(static_cast<std::size_t>(grid_.nu));
  for (int i = 0; i < grid_.nu; ++i) {
    const auto column = static_cast<std::size_t>(i);
    const std::vector<Stretch> known = inner ? stretches(*inner, i) : std::vector<Stretch>{};
    out.before.push_back(1);
    if (!inner && i > 0) seen[column] = seen[column - 1];
    for (int e = all.first[column]; e < all.first[column + 1]; ++e) {
      const RayEvent& first = all.events[static_cast<std::size_t>(e)];
      if (first.here > 0) continue;
      // Places where a vertex touches from inside are not ends.
      while (all.events[static_cast<std::size_t>(e)].after <= 0) ++e;
      const RayEvent& last = all.events[static_cast<std::size_t>(e)];
      const exact::Tried<std::vector<Stretch>> gone = cuts(side, line(i, j), whole(first, last), known, seen[column]);
      if (!gone) return gone.refusal();
      keep(*gone, first, last, out.events);
    }
    out.first.push_back(static_cast<int>(out.events.size()));
  }
  return out;
}

exact::Tried<RayRow> ProtrusionRays::try_row(int j) const {
  std::vector<Places> seen;
  const exact::Tried<RayRow> inner = kept(sides_[1], j, nullptr, seen);
  if (!inner) return inner;
  const exact::Tried<RayRow> outer = kept(sides_[0], j, &*inner, seen);
  if (!outer) return outer;
  const std::array<RayRow, 2> rows{*outer, *inner};
  return space::combined(rows, [](std::span<const std::int8_t> s) {
    return static_cast<std::int8_t>(s[1] < 0 ? -1 : s[0] < 0 ? 0 : 1);
  });
}

}  // namespace findspace::distance
