// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/rays/protrusion_rays.h"

#include <algorithm>
#include <cmath>

#include "distance/rays/line_signs.h"
#include "exact/margins/protrusion.h"
#include "exact/margins/space_distance.h"
#include "plane/base/search_work.h"
#include "space/rays/oblique_line.h"

namespace findspace::distance {

namespace {

using exact::Real;
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

exact::Refusal spent() { return plane::search_spent("the protrusion of the shape was not found"); }
exact::Refusal not_clear() {
  return exact::Refusal(
      "where the shape protrudes was not found: along a line it touches itself, or runs along a face");
}

/// Places in a cube of which the half side is 1.
constexpr Vector kInVoid[] = {{0, 0, 0},           {0.31, 0.17, 0.59},   {-0.23, 0.67, -0.37}, {0.71, -0.47, 0.13},
                              {0.53, 0.61, -0.19}, {-0.59, -0.29, 0.43}, {0.11, -0.73, -0.67}, {-0.41, 0.37, 0.79}};

/// Places that the outer side takes over from the inner one.
constexpr std::size_t kFewSeen = 2;

space::Extent box_of(const ProtrusionPart& part) {
  if (part.radius > 0) {
    const Vector r{part.radius, part.radius, part.radius};
    return {part.center - r, space::plus(part.center, r)};
  }
  std::vector<Vector> corners;
  for (const auto& face : part.faces) corners.insert(corners.end(), face.begin(), face.end());
  return space::extent_of(corners);
}

}  // namespace

ProtrusionRays::ProtrusionRays(ProtrusionParts b, std::shared_ptr<const ProtrusionField> a, const Real& level,
                               const Vertices& vertices, const RayGrid& grid, double step,
                               space::RaySourcePointer first)
    : grid_(grid),
      field_(std::move(a)),
      unit_(step / static_cast<double>(grid.parts)),
      parts_(std::move(b.parts)),
      flat_(b.flat),
      room_(b.room),
      voids_(std::move(b.voids)),
      first_(std::move(first)) {
  std::vector<space::Extent> boxes;
  for (const Part& part : parts_) boxes.push_back(box_of(part));
  boxes_ = space::ExtentTree(std::move(boxes));
  const double reach = level.to_double();
  size_ = field_->size() + b.size + std::fabs(reach);
  const double shift = size_ * kInner;
  sides_[0] = {vertices(level), reach + size_ * margin::kPlaceNoise + b.moved, reach + size_ * kCertain};
  sides_[1] = {vertices(level - Real::from_double(shift)), reach - shift, reach - shift / 2 - b.moved};
}

ProtrusionRays::Line ProtrusionRays::line(int i, int j) const {
  const PositionLine line = position_line(grid_, unit_, i, j);
  return {space::rounded(line.start), space::rounded(line.unit)};
}

/// What B covers on the stretch of its way, but for what is surely within.
Solids ProtrusionRays::swept(const Line& line, const Stretch& stretch, double enough) const {
  const Vector from = space::plus(line.start, space::scaled(stretch.from, line.unit)),
               to = space::plus(line.start, space::scaled(stretch.to, line.unit));
  std::vector<std::size_t> some;
  boxes_.each(
      [&](const space::Extent& box) {
        space::Extent all{space::plus(box.low, from), space::plus(box.high, from)};
        all.add({space::plus(box.low, to), space::plus(box.high, to)});
        return !field_->within(all, enough);
      },
      [&](std::size_t k) { some.push_back(k); });
  std::sort(some.begin(), some.end());
  Solids out;
  for (const std::size_t k : some) add_swept(parts_[k], line, stretch, out);
  return out;
}

/// The part at the start, and what its faces that look ahead sweep; balls at once.
void ProtrusionRays::add_swept(const Part& part, const Line& line, const Stretch& stretch, Solids& out) const {
  const auto at = [&](const Vector& v, double s) {
    return space::plus(v, space::plus(line.start, space::scaled(s, line.unit)));
  };
  if (part.radius > 0) out.round.push_back({at(part.center, stretch.from), at(part.center, stretch.to), part.radius});
  for (Tetrahedron t : part.solid) {
    for (Vector& v : t) v = at(v, stretch.from);
    out.cells.push_back(t);
  }
  const bool moves = stretch.from < stretch.to;
  for (std::size_t k = 0; k < part.faces.size(); ++k) {
    std::array<Vector, 6> c;
    for (std::size_t v = 0; v < 3; ++v) {
      c[v] = at(part.faces[k][v], stretch.from);
      c[v + 3] = at(part.faces[k][v], stretch.to);
    }
    // no sign: faces beside cost, but add nothing
    const bool ahead = moves && space::dot(part.normals[k], line.unit) >= -margin::kAlongFace;
    if (!ahead && flat_) out.cells.push_back({c[0], c[1], c[2], c[2]});
    if (!ahead) continue;
    out.cells.push_back({c[0], c[1], c[2], c[3]});
    out.cells.push_back({c[1], c[2], c[3], c[4]});
    out.cells.push_back({c[2], c[3], c[4], c[5]});
  }
}

/// The places at which x, or what lies before or behind it on its line, is outside V while B holds it.
ProtrusionRays::Stretch ProtrusionRays::outside(const Side& side, const Line& line, const Vector& x,
                                                const Stretch& held) const {
  const auto far = [&](double way) {
    const double run = field_->run(x, space::scaled(way, line.unit), side.cut, size_, 4 * size_);
    return std::max(0.0, run - size_ * margin::kPlaceNoise);
  };
  return {held.from - far(-1), held.to + far(1)};
}

std::optional<ProtrusionRays::Stretch> ProtrusionRays::cut_again(const Side& side, const Line& line,
                                                                 const Stretch& stretch, Places& seen) const {
  const auto common = [&](const Stretch& s) { return std::min(s.to, stretch.to) - std::max(s.from, stretch.from); };
  for (std::size_t k = 0; k < seen.size(); ++k) {
    const Stretch held = chord(line, seen[k], stretch).held;
    if (!(common(held) > 0)) continue;
    const Stretch cut = outside(side, line, seen[k], held);
    if (!(cut.from < held.from && held.to < cut.to)) continue;  // it is too near to A
    if (!(common(cut) > kMuch * (stretch.to - stretch.from))) continue;
    std::rotate(seen.begin(), seen.begin() + static_cast<std::ptrdiff_t>(k),
                seen.begin() + static_cast<std::ptrdiff_t>(k) + 1);
    return cut;
  }
  return std::nullopt;
}

std::optional<EndPlace> ProtrusionRays::outermost(const Side& side, const Line& line, const Part& part, const Vector& x,
                                                  double at, int way, double reach) const {
  if (part.planes.empty()) return std::nullopt;
  EndQuestion q{part.planes, line.start, line.unit};
  q.target = side.cut + (side.enough - side.cut) / 8;
  q.noise = size_ * margin::kPlaceNoise;
  q.room = flat_ ? room_ : 4 * q.noise;  // faces are thick
  q.way = way;
  q.reach = std::max(reach, size_ * margin::kEndReach);
  return outermost_place(*field_, q, x, at);
}

std::vector<ProtrusionRays::Stretch> ProtrusionRays::lengthened(const Side& side, const Line& line,
                                                                const Stretch& within, const Vector& x,
                                                                const Stretch& cut, Places& seen) const {
  std::vector<Stretch> out{cut};
  const Chord of = chord(line, x, within);
  if (!of.part) return out;
  for (const int way : {-1, 1}) {
    const double end = way < 0 ? cut.from : cut.to, away = end - (way < 0 ? of.held.from : of.held.to);
    if (!(within.from < end && end < within.to)) continue;
    const double reach =
        std::min(8 * std::fabs(away), std::max(side.cut, size_ * margin::kEndWindow));  // no sign: what is looked at
    const std::optional<EndPlace> y =
        outermost(side, line, *of.part, space::plus(x, space::scaled(away, line.unit)), end, way, reach);
    if (!y) continue;
    const std::optional<Stretch> more = tested(side, line, within, y->x);
    if (!more || (way < 0 ? more->from >= cut.from : more->to <= cut.to)) continue;
    out.push_back(*more);
    remember(y->x, seen);
    const double until = way < 0 ? of.held.from : of.held.to;
    if (const std::optional<Stretch> between = inward(side, line, *of.part, *y, until)) out.push_back(*between);
  }
  return out;
}

/// What is cut away beside the end, by places from y inward until that place or the part's frontier.
std::optional<ProtrusionRays::Stretch> ProtrusionRays::inward(const Side& side, const Line& line, const Part& part,
                                                              const EndPlace& y, double until) const {
  const double speed = space::length(y.inward);
  if (!(speed > 0) || !(y.inward_at * (until - y.at) > 0)) return std::nullopt;
  double most = (until - y.at) / y.inward_at;
  const Vector off = y.x - space::plus(line.start, space::scaled(y.at, line.unit));
  for (const NearPlane& p : part.planes) {
    const double room = -p.approx_value(off),
                 used = space::dot(p.unit, y.inward - space::scaled(y.inward_at, line.unit));
    if (used > 0) most = std::min(most, std::max(room, 0.0) / used);  // no sign: how far it is looked
  }
  const double run = field_->run(y.x, space::scaled(1 / speed, y.inward), side.cut, size_, most * speed);
  const double at = y.at + std::min(run / speed, most) * y.inward_at;
  return Stretch{std::min(y.at, at), std::max(y.at, at)};
}

/// What a place cuts away that may lie beside B, or in V.
std::optional<ProtrusionRays::Stretch> ProtrusionRays::tested(const Side& side, const Line& line, const Stretch& within,
                                                              const Vector& x) const {
  const Chord of = chord(line, x, within);
  if (!of.part || !of.exact || !field_->outside(x)) return std::nullopt;
  const Stretch cut = outside(side, line, x, of.held);
  if (!(cut.from < of.held.from && of.held.to < cut.to)) return std::nullopt;  // it is too near to A
  return cut;
}

void ProtrusionRays::remember(const Vector& x, Places& seen) {
  seen.insert(seen.begin(), x);
  if (seen.size() > kMostSeen) seen.pop_back();
}

/// No distance grows faster than a step.
bool ProtrusionRays::settled(const Side& side, const Stretch& stretch, std::span<const Stretch> known) const {
  const double room = side.enough - sides_[1].enough - size_ * margin::kRayNoise;
  return std::any_of(known.begin(), known.end(),
                     [&](const Stretch& k) { return std::max(k.from - stretch.from, stretch.to - k.to) <= room; });
}

exact::Tried<std::optional<ProtrusionRays::Stretch>> ProtrusionRays::cut_by_void(const Side& side, const Line& line,
                                                                                 const Stretch& stretch,
                                                                                 Places& seen) const {
  for (const VoidPlace& v : voids_) {
    Vector x{};
    std::optional<std::vector<SolidChord>> chords;
    for (const Vector& way : kInVoid) {  // a line that runs along a face, or meets an edge, does not tell
      x = space::plus(v.middle, space::scaled(v.room, way));
      chords = solid_chords(line, x - line.start, parts_along(line, x - line.start, kAllOfIt));
      if (chords) break;
    }
    if (!chords) return not_clear();
    for (const SolidChord& c : *chords) {
      const Stretch cut = outside(side, line, x, c.held);
      // It is open: at its end it cuts nothing away, and the stretch that it left begins there.
      if (!(cut.from < stretch.to && stretch.from < cut.to)) continue;
      remember(x, seen);
      return std::optional(cut);
    }
  }
  return std::optional<Stretch>();
}

/// Beside what is known to be kept the places that ended it are nearly the ones.
std::optional<ProtrusionRays::Stretch> ProtrusionRays::cut_beside(const Side& side, const Line& line,
                                                                  const Stretch& stretch,
                                                                  std::span<const Stretch> known, Places& seen) const {
  const Places before(seen.begin(), seen.begin() + static_cast<std::ptrdiff_t>(std::min(seen.size(), kFewSeen)));
  for (const Stretch& k : known) {
    const int way = k.to <= stretch.from ? -1 : 1;
    const double end = way < 0 ? stretch.from : stretch.to;
    if ((way < 0 ? k.to : k.from) != end) continue;
    // A short one may be left to what is cut away beyond, so that nothing is left between them.
    if (stretch.to - stretch.from <= 8 * (side.enough - sides_[1].enough)) continue;
    for (const Vector& x : before) {
      const Chord of = chord(line, x, stretch);
      if (!of.part) continue;
      const double at = way < 0 ? of.held.from : of.held.to;
      if (std::fabs(at - end) > size_ * margin::kEndReach) continue;
      const std::optional<EndPlace> y = outermost(side, line, *of.part, x, at, way, 0);
      const std::optional<Stretch> cut = y ? tested(side, line, stretch, y->x) : std::nullopt;
      // A short one would leave places between it and what is cut away beyond.
      if (!cut ||
          !(std::min(cut->to, stretch.to) - std::max(cut->from, stretch.from) > kMuch * (stretch.to - stretch.from)))
        continue;
      remember(y->x, seen);
      return cut;
    }
  }
  return std::nullopt;
}

exact::Tried<std::vector<ProtrusionRays::Stretch>> ProtrusionRays::cut(const Side& side, const Line& line,
                                                                       const Stretch& stretch,
                                                                       std::span<const Stretch> known,
                                                                       Places& seen) const {
  const exact::Tried<std::optional<Stretch>> by_void = cut_by_void(side, line, stretch, seen);
  if (!by_void) return by_void.refusal();
  std::optional<Stretch> out = *by_void;
  if (!out) out = cut_again(side, line, stretch, seen);
  if (!out) out = cut_beside(side, line, stretch, known, seen);
  if (!out) {
    const SolidMaxMin max_min = field_->max_min(swept(line, stretch, side.enough), side.enough, kProvenShare);
    if (!max_min.complete) return spent();
    if (max_min.value <= side.enough) return std::vector<Stretch>();
    const Chord of = chord(line, max_min.place, stretch);
    if (!of.part || (flat_ && !of.exact)) return not_clear();
    out = outside(side, line, max_min.place, of.held);
    remember(max_min.place, seen);
  }
  return lengthened(side, line, stretch, Vector(seen.front()), *out, seen);
}

/// Of open stretches, ascending.
std::vector<ProtrusionRays::Stretch> ProtrusionRays::joined(std::vector<Stretch> all) {
  std::sort(all.begin(), all.end(), [](const Stretch& a, const Stretch& b) { return a.from < b.from; });
  std::vector<Stretch> out;
  for (const Stretch& s : all) {
    // Where two meet the second began before the first's end: it was clipped.
    if (!out.empty() && s.from <= out.back().to)
      out.back().to = std::max(out.back().to, s.to);
    else
      out.push_back(s);
  }
  return out;
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
    if (settled(side, s, known)) continue;
    const exact::Tried<std::vector<Stretch>> found = this->cut(side, line, s, known, seen);
    if (!found) return found.refusal();
    if (found->empty()) continue;
    if (++count > plane::allowed(kMostCuts)) return spent();
    if (s.from == s.to) return std::vector{s};  // the whole is a single place
    bool any = false;
    double begun = s.from;
    for (const Stretch& cut : joined(*found)) {
      if (!(std::max(cut.from, s.from) < std::min(cut.to, s.to))) continue;
      any = true;
      out.push_back({std::max(cut.from, s.from), std::min(cut.to, s.to)});
      if (begun < cut.from) left.push_back({begun, cut.from});
      begun = cut.to;
    }
    // Where B holds the place was not seen, so it is not known what is cut away.
    if (!any) return not_clear();
    if (begun < s.to) left.push_back({begun, s.to});
  }
  return joined(std::move(out));
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

/// `inner`: what is certainly kept.
exact::Tried<RayRow> ProtrusionRays::kept(const Side& side, int j, const RayRow& allowed, const RayRow* inner,
                                          std::vector<Places>& seen) const {
  RayRow out;
  seen.resize(static_cast<std::size_t>(grid_.nu));
  for (int i = 0; i < grid_.nu; ++i) {
    const auto column = static_cast<std::size_t>(i);
    std::vector<Stretch> known;
    if (inner) {
      for (const auto& [first, last] : stretches_on(*inner, i)) known.push_back(whole(*first, *last));
    }
    out.before.push_back(1);
    if (!inner && i > 0) seen[column] = seen[column - 1];
    for (const auto& [first, last] : stretches_on(allowed, i)) {
      const exact::Tried<std::vector<Stretch>> gone = cuts(side, line(i, j), whole(*first, *last), known, seen[column]);
      if (!gone) return gone.refusal();
      keep(*gone, *first, *last, out.events);
    }
    out.first.push_back(static_cast<int>(out.events.size()));
  }
  return out;
}

exact::Tried<RayRow> ProtrusionRays::try_row(int j) const {
  std::optional<RayRow> before;
  if (first_) {
    exact::Tried<RayRow> row = first_->try_row(j);
    if (!row) return row;
    before = *std::move(row);
  }
  const exact::Tried<RayRow> allowed = sides_[0].vertices->try_row(j, before ? &*before : nullptr);
  if (!allowed) return allowed;
  const exact::Tried<RayRow> allowed_inner = sides_[1].vertices->try_row(j, &*allowed);
  if (!allowed_inner) return allowed_inner;
  std::vector<Places> seen;
  const exact::Tried<RayRow> inner = kept(sides_[1], j, *allowed_inner, nullptr, seen);
  if (!inner) return inner;
  const exact::Tried<RayRow> outer = kept(sides_[0], j, *allowed, &*inner, seen);
  if (!outer) return outer;
  std::vector<RayRow> rows{*outer, *inner};
  if (before) rows.push_back(*std::move(before));
  return space::combined(rows, [](std::span<const std::int8_t> s) {
    const int own = s[1] < 0 ? -1 : s[0] < 0 ? 0 : 1;
    return static_cast<std::int8_t>(s.size() > 2 ? std::max<int>(own, s[2]) : own);
  });
}

}  // namespace findspace::distance
