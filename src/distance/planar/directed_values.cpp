// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/planar/directed_values.h"

#include <algorithm>
#include <cmath>

#include "distance/planar/farthest_corner.h"
#include "distance/planar/farthest_place.h"
#include "exact/margins/planar_distance.h"
#include "plane/base/real_vector.h"
#include "plane/query/topology.h"

namespace findspace::distance {

using exact::Real;
using exact::RealPoint;
using plane::operator+;
using plane::operator-;

const FarthestFromSet& DirectedValues::farthest_search(bool back) const {
  std::call_once(searches_made_[back], [&] {
    const plane::Region &b = boundaries_.moving().region(), &a = boundaries_.fixed().region();
    searches_[back] = std::make_unique<const FarthestFromSet>(back ? a : b, back ? b : a);
  });
  return *searches_[back];
}

std::optional<FarthestPlace> DirectedValues::place(bool back, const RealPoint& by, double least) const {
  const FeatureTree &b = boundaries_.moving(), &a = boundaries_.fixed();
  if (b.has_arcs() || a.has_arcs()) return farthest_search(back).greatest(by, least);
  return farthest_place(back ? a : b, back ? b : a, back ? boundaries_.moving_boxes() : boundaries_.fixed_boxes(), by,
                        least);
}

std::optional<PlanarAnswer> DirectedValues::directed(bool back, const RealPoint& p, double floor) const {
  const FeatureTree &from = back ? boundaries_.fixed() : boundaries_.moving(),
                    &to = back ? boundaries_.moving() : boundaries_.fixed();
  if (!plane::is_bounded(from.region())) return std::nullopt;
  const PlanarAnswer none = boundary_answer(Real(), {});
  const RealPoint by = back ? -p : p;
  const double scale = boundaries_.scale(p);
  auto farthest = place(back, by, std::max(scale * margin::kClearlyOut, floor));
  if (!farthest && floor > scale * margin::kClearlyOut) return none;
  if (!farthest) {
    Standing s = boundaries_.standing(p);
    if (s.kind == (back ? Standing::Kind::kAround : Standing::Kind::kInside))
      return boundary_answer(-s.pair->distance, features(*s.pair));
    // One touches the other from inside, or all but: containment decides.
    auto margin = contacts_.signed_value(back ? Which::kDelta1 : Which::kEta1, s, p);
    if (margin && (margin->minus_infinity || margin->value.sign() <= 0)) return margin;
    farthest = place(back, by, scale * margin::kHardlyOut);
    if (!farthest) farthest = farthest_corner(from.region(), to.region(), by, scale * margin::kHardlyOut);
  }
  const FeaturePair near = farthest->nearest ? *farthest->nearest : nearest_point(to, farthest->at);
  Feature out{!back, farthest->cell, farthest->at}, in{back, near.first_cell, near.first};
  if (back) {
    out.at = out.at + p;
    in.at = in.at + p;
    std::swap(out, in);
  }
  PlanarAnswer answer = farthest->answer();
  answer.witness = {out, in};
  return answer;
}

double DirectedValues::protrudes(bool back, double px, double py) const {
  const FeatureTree &b = boundaries_.moving(), &a = boundaries_.fixed();
  const FeatureBox &s = a.nodes()[0].box, &t = b.nodes()[0].box;
  const double sign = back ? -1 : 1, dx = t.x0 + t.x1 + 2 * px - s.x0 - s.x1, dy = t.y0 + t.y1 + 2 * py - s.y0 - s.y1,
               size = plain_length(dx, dy), ux = size > 0 ? sign * dx / size : 1, uy = size > 0 ? sign * dy / size : 0;
  const double ahead = b.extreme(ux, uy).height + ux * px + uy * py - a.extreme(ux, uy).height;
  return back ? -ahead : ahead;
}

std::optional<PlanarAnswer> DirectedValues::hausdorff(const RealPoint& p) const {
  const FeatureTree &b = boundaries_.moving(), &a = boundaries_.fixed();
  const double px = near_value(p.x), py = near_value(p.y), scale = boundaries_.scale(p);
  const bool plain = !b.has_arcs() && !a.has_arcs() && !b.empty() && !a.empty() && boundaries_.bounded();
  const double out = plain ? protrudes(false, px, py) : 0, back_out = plain ? protrudes(true, px, py) : 0;
  const bool back = back_out > out;
  auto f = directed(back, p);
  if (!f) return std::nullopt;
  auto g = directed(!back, p, near_value(f->value) - scale * margin::kHardlyOut);
  if (!g) return std::nullopt;
  return back ? greater(*std::move(g), *std::move(f)) : greater(*std::move(f), *std::move(g));
}

}  // namespace findspace::distance
