// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "packing/search/last_sheet.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "packing/problem/pair_formula.h"
#include "packing/problem/round_part.h"
#include "packing/proof/remnant.h"
#include "packing/proof/verify.h"
#include "packing/search/tilting.h"
#include "plane/build/transform.h"

namespace findspace::packing {
namespace {

const Fraction kQuarter = 90;
constexpr double kWorth = 1.05;  // times the area of the rectangle: then longer use along x is worth it

double area_of(const std::optional<Remnant>& remnant) {
  return remnant ? remnant->width.to_double() * remnant->height.to_double() : 0;
}

/// A sheet on its side: a point (x, y) goes to (y, width - x).
class OnItsSide {
 public:
  OnItsSide(const Problem& problem, const Layout& layout)
      : problem_(problem),
        layout_(layout),
        sheet_(problem.sheets[layout.sheets.back()]),
        box_(box_of(sheet_)),
        width_(box_.high.x, problem.steps()) {}

  /// The parts of the last sheet, with that sheet alone.
  Problem problem() const {
    Problem result = with_angles_of(problem_, layout_);  // of tilted parts
    result.sheets = {turned(sheet_)};
    result.fixed.clear();
    for (PairCondition& condition : result.conditions) condition.where = turned_back(condition.where);
    for (Part& part : result.parts) {
      part.demand = 0;
      for (Fraction& angle : part.angles) angle = angle - kQuarter;
    }
    for (const Placed& item : layout_.items) {
      if (!is_on_it(item)) continue;
      ++result.parts[item.part].demand;
      const auto is_it = [&](const FixedPart& fixed) { return is_fixed_part(layout_, item, fixed); };
      if (std::none_of(problem_.fixed.begin(), problem_.fixed.end(), is_it)) continue;
      Placed placed = item;
      placed.angle = item.angle - kQuarter;
      placed.x = item.y;
      placed.y = width_ - item.x;
      placed.sheet = 0;
      result.fixed.push_back({placed, 0});
    }
    return result;
  }

  /// The layout with these places on its last sheet instead.
  Layout with(const Layout& turned) const {
    Layout result = layout_;
    result.length = 0;
    std::vector<const Placed*> done;
    for (const Placed& from : turned.items) {
      const auto same = [&](const Placed& item) {
        return is_on_it(item) && item.part == from.part && std::find(done.begin(), done.end(), &item) == done.end();
      };
      Placed& item = *std::find_if(result.items.begin(), result.items.end(), same);
      item.angle = from.angle + kQuarter;
      item.mirrored = from.mirrored;
      item.x = width_ - from.y;
      item.y = from.x;
      done.push_back(&item);
      const LatticeBox box = box_of(problem_.parts[item.part], item.angle, item.mirrored);
      result.length = std::max(result.length, item.x + Fraction(box.high.x, problem_.steps()) + problem_.edge);
    }
    return result;
  }

 private:
  bool is_on_it(const Placed& item) const { return item.sheet + 1 == layout_.sheets.size(); }

  Polygon turned(Polygon shape) const {
    for (Ring& ring : shape.rings)
      for (LatticePoint& p : ring) p = {p.y, box_.high.x - p.x};
    return shape;
  }
  std::shared_ptr<const RoundPart> turned(const std::shared_ptr<const RoundPart>& round) const {
    if (round == nullptr) return nullptr;
    const auto up = std::int64_t(box_.high.x);
    return std::make_shared<const RoundPart>(
        plane::translated(*round->at(Fraction() - kQuarter, false).region, {0, up}), round->step());
  }
  Zone turned(const Zone& zone) const {
    return {turned(zone.shape), zone.parts, zone.holds, turned(zone.round), turned(zone.about)};
  }
  Sheet turned(const Sheet& sheet) const {
    Sheet result{sheet.name, 1, {}, turned(sheet.shape), {}, turned(sheet.round), turned(sheet.about)};
    for (const Zone& zone : sheet.zones) result.zones.push_back(turned(zone));
    return result;
  }

  const Problem& problem_;
  const Layout& layout_;
  const Sheet& sheet_;
  const LatticeBox box_;
  const Fraction width_;
};

}  // namespace

std::optional<Layout> with_larger_remnant(const Problem& problem, const Layout& layout, const SearchOptions& options,
                                          const StopWish& stop) {
  const OnItsSide on_its_side(problem, layout);
  const Problem last = on_its_side.problem();
  SearchOptions own = options;
  own.start = nullptr;
  const std::optional<Layout> found = search_strip(last, own, {}, stop);
  if (!found || !found->left_out.empty()) return std::nullopt;
  Layout result = on_its_side.with(*found);
  if (area_of(largest_remnant(problem, result)) <= kWorth * area_of(largest_remnant(problem, layout)))
    return std::nullopt;
  if (!verify(problem, result).feasible()) return std::nullopt;
  return result;
}

}  // namespace findspace::packing
