// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "packing/proof/verify.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "packing/nfp/depth_field.h"
#include "packing/problem/pair_formula.h"
#include "packing/proof/standing.h"
#include "plane/base/parallel.h"

namespace findspace::packing {
namespace {

/// A sheet in the common steps.
struct Container {
  LatticeBox box;
  std::vector<Standing> obstacles;
  std::vector<std::vector<Standing>> zones;  // the walls of each
};

bool is_on_many_sheets(const Layout& layout) {
  return std::any_of(layout.items.begin(), layout.items.end(),
                     [&](const Placed& item) { return item.sheet != layout.items[0].sheet; });
}

class Check {
 public:
  Check(const Problem& problem, const Layout& layout)
      : problem_(problem),
        layout_(layout),
        parts_(problem, layout),
        common_(parts_.common()),
        ties_(problem.conditions, problem.parts.size()),
        greatest_level_(is_on_many_sheets(layout) ? greatest_level(problem.conditions) : 0) {}

  Verdict verdict() {
    count_copies();
    find_fixed();
    count_sheets();
    int128 used = 0;
    for (std::size_t i = 0; i < items().size(); ++i) {
      check_inside(i);
      if (sheet_of(i) + 1 >= layout_.sheets.size()) used = std::max(used, items()[i].box.high.x);
    }
    check_pairs();
    result_.used = Fraction(used, common_);
    result_.density = density();
    std::stable_sort(result_.faults.begin(), result_.faults.end(),
                     [](const Fault& f, const Fault& g) { return f.depth > g.depth; });
    return std::move(result_);
  }

 private:
  const std::vector<Standing>& items() const { return parts_.items(); }
  std::size_t sheet_of(std::size_t i) const { return layout_.items[i].sheet; }

  /// Of a last sheet as much counts as is used, whatever the layout says.
  double density() const {
    Layout used;
    used.length = problem_.on_sheets() ? std::max(layout_.length, result_.used + problem_.edge) : layout_.length;
    used.sheets = layout_.sheets;
    used.height = layout_.height;
    const double all = packing::container_area(problem_, used);
    return all > 0 ? area(problem_, layout_) / all : 0;
  }

  /// No more sheets of a kind than there are, and every item on one of them.
  void count_sheets() {
    std::vector<int> left;
    for (const Sheet& sheet : problem_.sheets) left.push_back(sheet.count);
    for (const std::size_t kind : layout_.sheets) --left[kind];
    for (std::size_t kind = 0; kind < left.size(); ++kind)
      if (left[kind] < 0)
        result_.faults.push_back({.kind = Fault::Kind::kSheets, .first = kind, .depth = -double(left[kind])});
    for (const std::size_t kind : layout_.sheets) {
      Container& container = containers_.emplace_back();
      const Sheet& sheet = problem_.sheets[kind];
      container.box = parts_.scaled(box_of(sheet));
      for (const Part& part : obstacles_of(problem_, sheet)) container.obstacles.push_back(parts_.obstacle(part));
      for (const Zone& zone : sheet.zones) {
        std::vector<Standing>& walls = container.zones.emplace_back();
        for (const Part& wall : walls_of(problem_, sheet, zone)) walls.push_back(parts_.obstacle(wall));
      }
    }
  }

  void count_copies() {
    std::vector<int> left(problem_.parts.size());
    for (std::size_t p = 0; p < left.size(); ++p) left[p] = problem_.parts[p].demand;
    for (const LeftOut& out : layout_.left_out) left[out.part] -= out.copies;
    for (std::size_t i = 0; i < layout_.items.size(); ++i) {
      const Placed& item = layout_.items[i];
      --left[item.part];
      if (!is_fixed(item) && !problem_.parts[item.part].allows(item.angle, item.mirrored))
        result_.faults.push_back({.kind = Fault::Kind::kAngle, .first = i});
    }
    for (std::size_t p = 0; p < left.size(); ++p)
      if (left[p] != 0) result_.faults.push_back({.kind = Fault::Kind::kCount, .first = p, .depth = -double(left[p])});
  }

  bool is_fixed(const Placed& item) const {
    return std::any_of(problem_.fixed.begin(), problem_.fixed.end(),
                       [&](const FixedPart& f) { return is_fixed_part(layout_, item, f); });
  }

  void find_fixed() {
    for (const FixedPart& f : problem_.fixed) {
      const auto here = [&](const Placed& item) { return is_fixed_part(layout_, item, f); };
      if (std::any_of(layout_.items.begin(), layout_.items.end(), here)) continue;
      result_.faults.push_back({.kind = Fault::Kind::kFixed,
                                .first = f.placed.part,
                                .x = f.placed.x.to_double(),
                                .y = f.placed.y.to_double()});
    }
  }

  void check_inside(std::size_t i) {
    const bool on_sheets = problem_.on_sheets();
    if (sheet_of(i) >= (on_sheets ? containers_.size() : 1)) return outside(i, 0);
    const LatticeBox& box = items()[i].box;
    const int128 right = on_sheets ? containers_[sheet_of(i)].box.high.x : layout_.length.over(common_);
    const int128 top = on_sheets ? containers_[sheet_of(i)].box.high.y : height_of(problem_, layout_).over(common_);
    const int128 out =
        problem_.edge.over(common_) + std::max({-box.low.x, -box.low.y, box.high.x - right, box.high.y - top});
    if (out > 0 && !lies_within(items()[i], right, top)) return outside(i, double(out) / double(common_));
    if (on_sheets) check_sheet(i, containers_[sheet_of(i)]);
  }

  /// Of a round part, whose box may end off the grid, by the exact one.
  bool lies_within(const Standing& item, int128 right, int128 top) const {
    if (item.round == nullptr) return false;
    const exact::Real scale(common_ / problem_.steps()), edge(problem_.edge.over(common_));
    const exact::Real x(item.x.over(common_)), y(item.y.over(common_));
    return x + scale * item.round->low.x >= edge && y + scale * item.round->low.y >= edge &&
           x + scale * item.round->high.x + edge <= exact::Real(right) &&
           y + scale * item.round->high.y + edge <= exact::Real(top);
  }

  void outside(std::size_t i, double depth) {
    result_.faults.push_back({.kind = Fault::Kind::kOutside,
                              .first = i,
                              .depth = depth,
                              .x = layout_.items[i].x.to_double(),
                              .y = layout_.items[i].y.to_double()});
  }

  void check_sheet(std::size_t i, const Container& container) {
    for (const Standing& obstacle : container.obstacles)
      if (parts_.contact(items()[i], obstacle, problem_.edge) != Contact::kNone) return outside(i, 0);
    const auto& zones = problem_.sheets[layout_.sheets[sheet_of(i)]].zones;
    for (std::size_t z = 0; z < zones.size(); ++z) {
      const auto& kept_out = zones[z].parts;
      if (std::count(kept_out.begin(), kept_out.end(), layout_.items[i].part) == 0) continue;
      const auto enters = [&](const Standing& wall) { return parts_.contact(items()[i], wall, 0) != Contact::kNone; };
      if (std::none_of(container.zones[z].begin(), container.zones[z].end(), enters)) continue;
      result_.faults.push_back({.kind = Fault::Kind::kZone,
                                .first = i,
                                .x = layout_.items[i].x.to_double(),
                                .y = layout_.items[i].y.to_double()});
    }
  }

  void check_pairs() {
    std::vector<std::vector<Fault>> found(items().size());
    plane::parallel_for(items().size(), [&](std::size_t i) {
      for (std::size_t j = i + 1; j < items().size(); ++j)
        if (const auto fault = pair_fault(i, j)) found[i].push_back(*fault);
    });
    for (const auto& faults : found) result_.faults.insert(result_.faults.end(), faults.begin(), faults.end());
  }

  std::optional<Fault> pair_fault(std::size_t i, std::size_t j) const {
    if (sheet_of(i) == sheet_of(j)) {
      const Contact found = parts_.contact(items()[i], items()[j], problem_.gap_of(part_of(i), part_of(j)));
      if (found == Contact::kOverlap) return overlap(i, j);
      if (found == Contact::kGap) return fault_at(Fault::Kind::kGap, i, j);
    }
    if (ties_.between(part_of(i), part_of(j)) && !conditions_hold(i, j)) return fault_at(Fault::Kind::kCondition, i, j);
    return std::nullopt;
  }

  std::size_t part_of(std::size_t i) const { return layout_.items[i].part; }

  /// On different sheets: those of two parts that are farther apart than any condition asks.
  bool conditions_hold(std::size_t i, std::size_t j) const {
    const Placed &a = layout_.items[i], &b = layout_.items[j];
    const auto shape_of = [&](const Placed& item) {
      return region_of(problem_.parts[item.part], item.angle, item.mirrored);
    };
    const exact::Real step = exact::Real(1) / exact::Real(problem_.steps());
    const PairFormula pair(problem_, a.part, shape_of(a), b.part, shape_of(b), step);
    if (a.sheet == b.sheet) return pair.holds(b.x - a.x, b.y - a.y);
    const Fraction far = size_of(a) + size_of(b) + Fraction(int128(std::ceil(greatest_level_))) + 1;
    return pair.holds(far, 0);
  }

  /// How far a part reaches from its origin, at most.
  Fraction size_of(const Placed& item) const {
    const LatticeBox box = box_of(problem_.parts[item.part], item.angle, item.mirrored);
    int128 most = 0;
    for (const int128 c : {box.low.x, box.low.y, box.high.x, box.high.y}) most = std::max(most, c < 0 ? -c : c);
    return Fraction(most, problem_.steps());
  }

  Fault fault_at(Fault::Kind kind, std::size_t i, std::size_t j) const {
    Fault fault{.kind = kind, .first = i, .second = j};
    locate(fault);
    return fault;
  }

  /// The middle of what the boxes have in common, or of what is between them.
  void locate(Fault& fault) const {
    const LatticeBox &a = items()[fault.first].box, &b = items()[fault.second].box;
    fault.x = (double(std::max(a.low.x, b.low.x)) + double(std::min(a.high.x, b.high.x))) / 2 / double(common_);
    fault.y = (double(std::max(a.low.y, b.low.y)) + double(std::min(a.high.y, b.high.y))) / 2 / double(common_);
  }

  Fault overlap(std::size_t i, std::size_t j) const {
    const Placed &a = layout_.items[i], &b = layout_.items[j];
    const auto searched = [&](const Placed& item) {
      return search_shape(problem_, problem_.parts[item.part], item.angle, item.mirrored);
    };
    const DepthField field(no_fit_polygon(searched(a), searched(b), 0));
    const Vec off{(b.x - a.x).to_double(), (b.y - a.y).to_double()};
    Fault fault = fault_at(Fault::Kind::kOverlap, i, j);
    fault.depth = field.depth(off);
    return fault;
  }

  const Problem& problem_;
  const Layout& layout_;
  StandingParts parts_;
  int128 common_;
  Ties ties_;
  double greatest_level_;  // of parts on different sheets
  std::vector<Container> containers_;
  Verdict result_;
};

}  // namespace

Verdict verify(const Problem& problem, const Layout& layout) { return Check(problem, layout).verdict(); }

}  // namespace findspace::packing
