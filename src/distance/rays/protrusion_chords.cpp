// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// At which places on a line B holds a point (protrusion_rays.h): by a convex part, or by where its surface is crossed.
#include <algorithm>
#include <cmath>

#include "distance/rays/protrusion_rays.h"
#include "exact/margins/space_distance.h"

namespace findspace::distance {

namespace {

using space::Vector;

/// The line {x - s * unit} meets the half spaces for s in between; for none where it runs along a face farther outside
/// than `noise`.
void clip(const std::vector<NearPlane>& planes, const Vector& x, const Vector& unit, double noise, double& from,
          double& to) {
  for (const NearPlane& h : planes) {
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

/// Of one surface, ascending; nothing where they are not clear. Where the line meets an edge or a corner, faces that it
/// enters by and faces that it leaves by meet: it may only touch there. The sides of the crossings before and after
/// tell.
std::optional<std::vector<ProtrusionRays::SolidChord>> ProtrusionRays::chords_of_surface(
    const Line& line, const Vector& off, std::span<const std::size_t> parts) const {
  struct Crossing {
    double at;
    int sense;  // +: comes to hold it, 0: or leaves it, or touches it
    const Part* part;
  };
  std::vector<Crossing> all;
  for (const std::size_t k : parts) {
    const auto [from, to] = held(parts_[k], line, off);
    if (!(from <= to)) continue;
    const double along = space::dot(parts_[k].normals[0], line.unit);
    if (std::fabs(along) < margin::kAlongFace) return std::nullopt;
    all.push_back({(from + to) / 2, along > 0 ? 1 : -1, &parts_[k]});  // no sign: tested by their order
  }
  std::sort(all.begin(), all.end(), [](const Crossing& a, const Crossing& b) { return a.at < b.at; });
  std::vector<SolidChord> out;
  const Crossing* unclear = nullptr;  // since the last one that is clear
  Crossing touched{};
  bool within = false;
  const auto cross = [&](const Crossing& c) {
    if (!within) out.push_back({{c.at, c.at}, c.part, c.part});
    out.back().held.to = c.at;
    out.back().last = c.part;
    within = !within;
  };
  for (std::size_t k = 0; k < all.size();) {
    Crossing one = all[k];
    for (++k; k < all.size() && all[k].at - one.at <= size_ * margin::kRayNoise; ++k) {
      if (all[k].sense != one.sense) one.sense = 0;
    }
    if (one.sense == 0) {
      if (unclear) return std::nullopt;
      touched = one;
      unclear = &touched;
      continue;
    }
    if (within != (one.sense < 0)) {
      if (!unclear) return std::nullopt;
      cross(*unclear);
    }
    unclear = nullptr;
    cross(one);
  }
  if (within && unclear) cross(*unclear);
  return within ? std::nullopt : std::optional(std::move(out));
}

/// By the surfaces, ascending; nothing where they are not clear.
std::optional<std::vector<ProtrusionRays::SolidChord>> ProtrusionRays::solid_chords(
    const Line& line, const Vector& off, const std::vector<std::size_t>& parts) const {
  std::vector<SolidChord> all, out;
  for (auto first = parts.begin(); first != parts.end();) {
    const auto last =
        std::find_if(first, parts.end(), [&](std::size_t k) { return parts_[k].surface != parts_[*first].surface; });
    const auto some = chords_of_surface(line, off, {first, last});
    if (!some) return std::nullopt;
    all.insert(all.end(), some->begin(), some->end());
    first = last;
  }
  std::sort(all.begin(), all.end(), [](const SolidChord& a, const SolidChord& b) { return a.held.from < b.held.from; });
  for (const SolidChord& c : all) {
    if (out.empty() || c.held.from > out.back().held.to) {
      out.push_back(c);
    } else if (c.held.to > out.back().held.to) {
      out.back().held.to = c.held.to;
      out.back().last = c.last;
    }
  }
  return out;
}

/// That which has most in common with the stretch; nothing where that is not clear.
std::optional<ProtrusionRays::Chord> ProtrusionRays::solid_chord(const Line& line, const Vector& off,
                                                                 const std::vector<std::size_t>& parts,
                                                                 const Stretch& within) const {
  const std::optional<std::vector<SolidChord>> chords = solid_chords(line, off, parts);
  if (!chords) return std::nullopt;
  std::optional<Chord> best;
  double longest = -exact::kInfinity;
  for (const SolidChord& c : *chords) {
    const double common = std::min(c.held.to, within.to) - std::max(c.held.from, within.from);
    if (!(common > longest)) continue;
    longest = common;
    best = Chord{c.held, c.held.from >= within.from ? c.first : c.last, true};
  }
  // A place at the rim of B may be seen to be beside it.
  return longest >= 0 ? best : std::nullopt;
}

std::vector<std::size_t> ProtrusionRays::parts_along(const Line& line, const Vector& off, const Stretch& within) const {
  const double noise = size_ * margin::kRayNoise;
  std::vector<std::size_t> some;
  boxes_.each(
      [&](const space::Extent& box) {
        double from = within.from - noise, to = within.to + noise;
        const auto cut = [&](double low, double high, double at, double way) {
          low -= noise;
          high += noise;
          if (way == 0) {  // no sign: a coordinate of the line's direction
            if (at < low || at > high) to = -exact::kInfinity;
            return;
          }
          from = std::max(from, std::min((at - low) / way, (at - high) / way));
          to = std::min(to, std::max((at - low) / way, (at - high) / way));
        };
        cut(box.low.x, box.high.x, off.x, line.unit.x);
        cut(box.low.y, box.high.y, off.y, line.unit.y);
        cut(box.low.z, box.high.z, off.z, line.unit.z);
        return from <= to;
      },
      [&](std::size_t k) { some.push_back(k); });
  std::sort(some.begin(), some.end());
  return some;
}

/// The places at which a part of B holds x. Where none on the line does, a single place.
ProtrusionRays::Chord ProtrusionRays::chord(const Line& line, const Vector& x, const Stretch& within) const {
  const Vector off = x - line.start;
  // A surface has to be known on all of the line.
  const std::vector<std::size_t> some = parts_along(line, off, flat_ ? kAllOfIt : within);
  Chord best{{within.from, within.from}, nullptr};
  if (flat_) {
    if (const std::optional<Chord> solid = solid_chord(line, off, some, within)) return *solid;
  }
  double longest = -exact::kInfinity;
  for (const std::size_t k : some) {
    const auto [from, to] = held(parts_[k], line, off);
    const double common = std::min(to, within.to) - std::max(from, within.from);
    if (!(common > longest)) continue;
    longest = common;
    best.part = &parts_[k];
    best.exact = from <= to;
    // Rounding may leave nothing of a chord that is a point.
    best.held = from <= to ? Stretch{from, to} : Stretch{(from + to) / 2, (from + to) / 2};
  }
  return best;
}

}  // namespace findspace::distance
