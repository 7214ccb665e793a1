// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "io/draw/space_names.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "io/draw/draw_canvas.h"
#include "io/draw/draw_layout.h"
#include "io/text/put.h"

namespace findspace::io {
namespace {

using plane::Bounds;
using plane::Place;

constexpr double kNameFont = 12.5, kBeside = 7;  // pixels
constexpr double kTowardsMiddle = 0.22;          // of the way from a corner
// What speaks against a place: the name of a solid in front would be read there, or of one in it; it is off its own.
constexpr double kCovered = 8, kOnOther = 3, kSticksOut = 1, kOff = 5, kOnLine = 0.5;

double on_left(const Place& a, const Place& b, const Place& p) {
  return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
}

bool holds(const std::vector<Place>& ring, const Place& p) {
  if (ring.size() < 3) return false;
  bool left = false, right = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const double side = on_left(ring[i], ring[(i + 1) % ring.size()], p);
    left = left || side > 0;
    right = right || side < 0;
  }
  return !(left && right);
}

Bounds box_of_ring(const std::vector<Place>& ring) {
  Bounds box{ring[0], ring[0]};
  for (const Place& p : ring)
    for (std::size_t k = 0; k < 2; ++k) {
      box.low[k] = std::min(box.low[k], p[k]);
      box.high[k] = std::max(box.high[k], p[k]);
    }
  return box;
}

Place middle_of(const Bounds& b) { return {(b.low[0] + b.high[0]) / 2, (b.low[1] + b.high[1]) / 2}; }

std::array<Place, 5> probes(const Bounds& b) {
  return {{middle_of(b), b.low, b.high, {b.low[0], b.high[1]}, {b.high[0], b.low[1]}}};
}

}  // namespace

/// With what is asked often.
struct SpaceNames::Sized {
  NamedSolid solid;
  Bounds box;
  double area;
};

namespace {

/// A place for a name.
struct NamePlace {
  Place middle;
  double against;
};
/// Places on the solid, then beside it.
std::vector<Place> name_places(const NamedSolid& solid, const Bounds& box, double width) {
  const Place m = middle_of(box);
  std::vector<Place> out;
  if (!solid.wire) out = solid.faces;
  for (const Place& p : solid.faces) {
    for (const double far : {1.0, 2.5}) {
      if (!solid.wire) break;
      const double x = width / 2 + kBeside * far, y = kNameFont / 2 + kBeside * far;
      out.insert(out.end(), {{p[0], p[1] - y}, {p[0], p[1] + y}, {p[0] + x, p[1]}, {p[0] - x, p[1]}});
    }
  }
  if (!solid.wire && (!solid.glass || solid.faces.empty())) out.insert(out.begin(), m);
  for (const Place& p : solid.around) {
    if (solid.wire || solid.around.size() > 12) break;  // round: its corners are no places
    out.push_back({p[0] + (m[0] - p[0]) * kTowardsMiddle, p[1] + (m[1] - p[1]) * kTowardsMiddle});
  }
  const double w = width / 2 + kBeside, h = kNameFont / 2 + kBeside;
  const double left = box.low[0] - w, right = box.high[0] + w, above = box.low[1] - h, below = box.high[1] + h;
  for (const double far : {0.0, 1.5, 3.0}) {
    const double more = far * kNameFont;
    out.insert(out.end(), {{m[0], above - more},
                           {m[0], below + more},
                           {right + more, m[1]},
                           {left - more, m[1]},
                           {right, above - more},
                           {left, above - more},
                           {right, below + more},
                           {left, below + more}});
  }
  return out;
}

}  // namespace

double area_on_page(const std::vector<Place>& ring) {
  double sum = 0;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) sum += on_left(ring[0], ring[i], ring[i + 1]);
  return std::abs(sum) / 2;
}

std::vector<Place> hull_on_page(std::vector<Place> points) {
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  std::vector<Place> chain;
  for (int pass = 0; pass < 2; ++pass) {
    const std::size_t start = chain.size();
    for (const Place& p : points) {
      while (chain.size() >= start + 2 && on_left(chain[chain.size() - 2], chain.back(), p) <= 0) chain.pop_back();
      chain.push_back(p);
    }
    chain.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return chain;
}

void SpaceNames::shun(const Place& from, const Place& to) {
  constexpr double kStridePixels = 8;
  constexpr std::size_t kMostShunned = 4000;
  const double length = std::hypot(to[0] - from[0], to[1] - from[1]);
  const int n = static_cast<int>(length / kStridePixels) + 1;
  for (int i = 0; i <= n && shunned_.size() < kMostShunned; ++i)
    shunned_.push_back({from[0] + (to[0] - from[0]) * i / n, from[1] + (to[1] - from[1]) * i / n});
}

bool SpaceNames::is_free(const Bounds& box) const {
  return picture_.low[0] <= box.low[0] && box.high[0] <= picture_.high[0] && picture_.low[1] <= box.low[1] &&
         box.high[1] <= picture_.high[1] &&
         std::none_of(taken_.begin(), taken_.end(), [&](const Bounds& b) { return boxes_meet(b, box); });
}

void SpaceNames::put(std::string_view text, const Place& middle, const char* colour) {
  taken_.push_back(text_box(middle, text, kNameFont));
  io::put(out_,
          "<text x=\"{:.2f}\" y=\"{:.2f}\" font-size=\"{}\" text-anchor=\"middle\" fill=\"{}\" stroke=\"#fff\" "
          "stroke-width=\"3.5\" stroke-opacity=\".85\" paint-order=\"stroke\">{}</text>\n",
          middle[0], middle[1] + kNameFont * 0.36, kNameFont, colour, xml_escaped(text));
}

void SpaceNames::put_text(std::string_view text, const std::vector<Place>& places, const char* colour) {
  for (const Place& p : places)
    if (is_free(text_box(p, text, kNameFont))) return put(text, p, colour);
}

/// Against a box for the name of solid k, all others being as they are seen.
double SpaceNames::against(const std::vector<Sized>& solids, std::size_t k, const Bounds& box) const {
  const Sized& own = solids[k];
  double sum = own.solid.wire || holds(own.solid.around, middle_of(box)) ? 0 : kOff;
  const auto probed = probes(box);
  for (const Place& p : shunned_)
    if (box.low[0] < p[0] && p[0] < box.high[0] && box.low[1] < p[1] && p[1] < box.high[1]) sum += kOnLine;
  for (const Place& p : probed)
    if (!holds(own.solid.around, p)) sum += kSticksOut / double(probed.size());
  for (std::size_t j = 0; j < solids.size(); ++j) {
    const NamedSolid& other = solids[j].solid;
    if (j == k || !boxes_meet(solids[j].box, box)) continue;
    if (std::none_of(probed.begin(), probed.end(), [&](const Place& p) { return holds(other.around, p); })) continue;
    if (!other.glass && other.depth > own.solid.depth)
      sum += kCovered;
    else if (solids[j].area < own.area)
      sum += kOnOther;
  }
  return sum;
}

bool SpaceNames::is_seen(const std::vector<Sized>& solids, std::size_t k, const Place& p) {
  return std::none_of(solids.begin(), solids.end(), [&](const Sized& other) {
    return &other != &solids[k] && !other.solid.glass && other.solid.depth > solids[k].solid.depth &&
           holds(other.solid.around, p);
  });
}

void SpaceNames::put_leader(const std::vector<Sized>& solids, std::size_t k, const Place& middle) {
  const NamedSolid& own = solids[k].solid;
  std::vector<Place> ends{middle_of(solids[k].box)};
  if (own.wire) ends.clear();
  ends.insert(ends.end(), own.faces.begin(), own.faces.end());
  const Place m = middle_of(solids[k].box);
  for (const Place& p : own.around) {  // a little within the rim
    if (own.wire) break;
    constexpr double kWithin = 0.1;
    ends.push_back({p[0] + (m[0] - p[0]) * kWithin, p[1] + (m[1] - p[1]) * kWithin});
  }
  const auto far = [&](const Place& p) { return std::hypot(p[0] - middle[0], p[1] - middle[1]); };
  std::stable_sort(ends.begin(), ends.end(), [&](const Place& a, const Place& b) { return far(a) < far(b); });
  const auto seen =
      std::find_if(ends.begin(), ends.end(), [&](const Place& p) { return own.wire || is_seen(solids, k, p); });
  if (ends.empty()) return;
  const Place& to = seen == ends.end() ? ends.front() : *seen;
  const Bounds box = text_box(middle, own.name, kNameFont);
  const Place from{std::clamp(to[0], box.low[0], box.high[0]), std::clamp(to[1], box.low[1], box.high[1])};
  io::put(out_,
          "<path stroke=\"{0}\" stroke-width=\".8\" fill=\"none\" d=\"M{1:.2f} {2:.2f}L{3:.2f} {4:.2f}\"/>"
          "<circle cx=\"{3:.2f}\" cy=\"{4:.2f}\" r=\"1.6\" fill=\"{0}\"/>\n",
          own.colour, from[0], from[1], to[0], to[1]);
}

void SpaceNames::name_one(const std::vector<Sized>& solids, std::size_t k) {
  const NamedSolid& own = solids[k].solid;
  std::optional<NamePlace> best;
  for (const Place& p : name_places(own, solids[k].box, text_width(own.name, kNameFont))) {
    const Bounds box = text_box(p, own.name, kNameFont);
    if (!is_free(box)) continue;
    const double sum = against(solids, k, box);
    if (!best || sum < best->against) best = NamePlace{p, sum};
  }
  if (!best) return;
  if (own.wire || !holds(own.around, best->middle)) put_leader(solids, k, best->middle);
  put(own.name, best->middle, own.colour);
}

void SpaceNames::name(std::vector<NamedSolid> solids) {
  std::vector<Sized> sized;
  for (NamedSolid& solid : solids) {
    if (solid.around.empty()) continue;
    const Bounds box = box_of_ring(solid.around);
    const double area = area_on_page(solid.around);
    sized.push_back({std::move(solid), box, area});
  }
  std::stable_sort(sized.begin(), sized.end(), [](const Sized& a, const Sized& b) { return a.area < b.area; });
  for (std::size_t k = 0; k < sized.size(); ++k)
    if (!sized[k].solid.name.empty()) name_one(sized, k);
}

}  // namespace findspace::io
