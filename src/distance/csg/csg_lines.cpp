// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/csg/csg_lines.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "distance/rays/line_signs.h"
#include "exact/margins/space_distance.h"

namespace findspace::distance {

using exact::Real;
using space::RealVector;

namespace {

/// Of a part of a line that is not decided, in widths of the ends there: it is left so.
constexpr double kShareOfEnds = 0.25;

class RaysByEnds : public space::RaySource {
 public:
  RaysByEnds(ValueBetween value, const Real& level, const space::Extent& box, std::int64_t scale,
             const space::RayGrid& grid)
      : value_(std::move(value)),
        level_(level),
        size_(space::length(box.high - box.low) + std::fabs(level.to_double()) + 1),
        grown_(std::max(level.to_double(), 0.0) + size_ * margin::kPlaceNoise),
        box_(box),
        unit_(static_cast<double>(scale) / static_cast<double>(grid.parts)),
        grid_(grid) {}

  const space::RayGrid& grid() const override { return grid_; }
  bool searched() const override { return true; }
  exact::Tried<space::RayRow> try_row(int j) const override;

 private:
  /// The distance less the level is between.
  struct Ends {
    double low = -exact::kInfinity, high = exact::kInfinity;
    /// How far about a place the sign is the same.
    double reach() const { return std::max(low, -high); }
  };
  exact::Tried<Ends> ends(const RealVector& p, Cells cells) const;
  /// The stretch beyond which the line is too far away; none where it all is.
  std::vector<SignStretch> near(const PositionLine& line) const;
  exact::Tried<std::vector<SignStretch>> known(const PositionLine& line) const;

  ValueBetween value_;
  Real level_;
  double size_, grown_;
  space::Extent box_;
  double unit_;
  space::RayGrid grid_;
};

exact::Tried<RaysByEnds::Ends> RaysByEnds::ends(const RealVector& p, Cells cells) const {
  const TriedAnswer v = value_(p, cells);
  if (!v) return v.refusal();
  if (!*v) return Ends{4 * size_, exact::kInfinity};
  const Enclosure known = (*v)->bounds();
  Ends out;
  if (known.lower) out.low = (*known.lower - level_).to_double();
  if (known.upper) out.high = (*known.upper - level_).to_double();
  return out;
}

std::vector<SignStretch> RaysByEnds::near(const PositionLine& line) const {
  const space::Vector start = space::rounded(line.start), unit = space::rounded(line.unit);
  const double more = grown_ + margin::kPlaceNoise * space::length(start);
  double from = -exact::kInfinity, to = exact::kInfinity;
  const auto between = [&](double at, double by, double low, double high) {
    if (by == 0) {
      if (at < low - more || high + more < at) to = -exact::kInfinity;
      return;
    }
    const double one = (low - more - at) / by, other = (high + more - at) / by;
    from = std::max(from, std::min(one, other));
    to = std::min(to, std::max(one, other));
  };
  between(start.x, unit.x, box_.low.x, box_.high.x);
  between(start.y, unit.y, box_.low.y, box_.high.y);
  between(start.z, unit.z, box_.low.z, box_.high.z);
  if (!(from < to)) return {};
  return {{from, to, 0}};
}

/// The widest pieces come first.
exact::Tried<std::vector<SignStretch>> RaysByEnds::known(const PositionLine& line) const {
  const double noise = size_ * margin::kPlaceNoise;
  std::vector<SignStretch> open = near(line), known;
  std::optional<exact::Refusal> refused;
  bool told = false;
  for (std::size_t k = 0; k < open.size(); ++k) {
    const double from = open[k].from, to = open[k].to, middle = (from + to) / 2;
    const bool spent = static_cast<long>(k) >= plane::allowed(kMostPlacesOfLine) || plane::cells_left() <= 0;
    if (spent || !(from < middle && middle < to)) {
      known.push_back(open[k]);
      continue;
    }
    const RealVector p = space::along(line.start, Real::from_double(middle), line.unit);
    exact::Tried<Ends> v = ends(p, Cells::kCoarse);
    if (!v || v->reach() <= noise) {
      exact::Tried<Ends> finer = ends(p, Cells::kFine);
      if (finer) v = std::move(finer);
    }
    if (!v) refused = v.refusal();
    told = told || v;
    const Ends here = v ? *v : Ends();
    const double reach = here.reach() - noise;
    const double least = std::max(size_ * margin::kRayCertain, std::min(here.high - here.low, size_) * kShareOfEnds);
    if (reach <= 0 && to - from <= least) {
      known.push_back(open[k]);
      continue;
    }
    const double first = reach > 0 ? std::max(from, middle - reach) : middle,
                 last = reach > 0 ? std::min(to, middle + reach) : middle;
    if (from < first) open.push_back({from, first, 0});
    if (first < last) known.push_back({first, last, here.low > 0 ? 1 : -1});
    if (last < to) open.push_back({last, to, 0});
  }
  if (refused && !told) return *refused;
  std::sort(known.begin(), known.end(), [](const SignStretch& a, const SignStretch& b) { return a.from < b.from; });
  return known;
}

exact::Tried<space::RayRow> RaysByEnds::try_row(int j) const {
  space::RayRow out;
  for (int i = 0; i < grid_.nu; ++i) {
    const auto stretches = in_share(share_of_line(grid_), [&] { return known(position_line(grid_, unit_, i, j)); });
    if (!stretches) return stretches.refusal();
    put_line(*stretches, unit_, out);
  }
  return out;
}

}  // namespace

std::unique_ptr<space::RaySource> rays_by_ends(ValueBetween value, const Real& level, const space::Extent& box,
                                               std::int64_t scale, const space::RayGrid& grid) {
  return std::make_unique<RaysByEnds>(std::move(value), level, box, scale, grid);
}

}  // namespace findspace::distance
