// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "packing/compaction/finish.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "packing/compaction/decimal_steps.h"
#include "packing/proof/verify.h"

namespace findspace::packing {
namespace {

constexpr double kSnap = 8;  // fine steps
/// Gaps in steps of the fine grid, and whether contacts along an axis stay.
constexpr std::pair<double, bool> kLoosenings[] = {{0, true},  {4, true},   {4, false},
                                                   {32, true}, {32, false}, {512, true}};
constexpr int kSearchGridDigits = 7;  // to these the search's shapes are those of the problem

class Finisher {
 public:
  Finisher(const Problem& problem, const FieldTable& table, const Row& row)
      : problem_(problem), table_(table), row_(row), steps_(problem.digits, table.height()) {}

  double step() const { return steps_.step(); }
  bool on_grid() const { return problem_.digits <= std::min(steps_.digits(), kSearchGridDigits); }

  Layout rounded(const std::vector<Pose>& poses, double snap) const {
    Layout layout;
    std::vector<std::size_t> rooms;
    for (const Pose& pose : poses) rooms.push_back(row_.room_of(table_.variants()[pose.variant], pose.at));
    std::vector<std::size_t> all(rooms);
    all.insert(all.end(), row_.fixed_rooms().begin(), row_.fixed_rooms().end());
    const UsedRooms used(std::move(all));
    if (problem_.on_sheets())
      for (const std::size_t room : used.all()) layout.sheets.push_back(row_.rooms()[room].kind);
    std::vector<int> copies(problem_.parts.size());
    for (std::size_t k = 0; k < problem_.fixed.size(); ++k)
      put_fixed(layout, problem_.fixed[k].placed, used.number_of(row_.fixed_rooms()[k]), copies);
    for (std::size_t i = 0; i < poses.size(); ++i) {
      const Variant& v = table_.variants()[poses[i].variant];
      const std::size_t sheet = used.number_of(rooms[i]);
      layout.items.push_back({v.part, ++copies[v.part], v.angle, v.mirrored, 0, 0, sheet});
      put(layout, poses[i].at - Vec{row_.rooms()[rooms[i]].low.x, 0}, snap);
    }
    const auto fits = [&](std::size_t part) { return !table_.variants_of(part).empty(); };
    layout.left_out = left_out_of(problem_.parts, copies, fits, "it is larger than every sheet");
    return layout;
  }

 private:
  void put_fixed(Layout& layout, Placed item, std::size_t sheet, std::vector<int>& copies) const {
    item.copy = ++copies[item.part];
    item.sheet = sheet;
    const LatticeBox box = box_of(problem_.parts[item.part], item.angle, item.mirrored);
    layout.items.push_back(item);
    lengthen(layout, item, box.high.x);
  }
  /// The length takes in an item on the last sheet that ends so many steps behind its origin.
  void lengthen(Layout& layout, const Placed& item, int128 high) const {
    if (item.sheet + 1 < layout.sheets.size()) return;
    layout.length = std::max(layout.length, item.x + Fraction(high, problem_.steps()) + problem_.edge);
  }

  /// The last item's position: on the grid, above the lower side and behind the end, and on a sheet before its end.
  void put(Layout& layout, Vec at, double snap) const {
    Placed& item = layout.items.back();
    const auto [low, high] = box_of(problem_.parts[item.part], item.angle, item.mirrored);
    const int128 steps = problem_.steps(), grid = steps_.in_one();
    const Fraction& edge = problem_.edge;
    const int128 left = steps_.above(edge - Fraction(low.x, steps)),
                 bottom = steps_.above(edge - Fraction(low.y, steps));
    int128 x = steps_.nearest(at.x + table_.edge(), snap), y = steps_.nearest(at.y + table_.edge(), snap);
    Fraction height = problem_.height;
    if (problem_.on_sheets()) {
      const LatticeBox box = box_of(problem_.sheets[layout.sheets[item.sheet]]);
      height = Fraction(box.high.y, steps);
      x = std::min(x, steps_.below(Fraction(box.high.x - high.x, steps) - edge));
    }
    y = std::min(y, steps_.below(height - edge - Fraction(high.y, steps)));
    item.x = Fraction(std::max(x, left), grid);
    item.y = Fraction(std::max(y, bottom), grid);
    lengthen(layout, item, high.x);
  }

  const Problem& problem_;
  const FieldTable& table_;
  const Row& row_;
  DecimalSteps steps_;
};

}  // namespace

std::optional<Layout> finished(const Problem& problem, const FieldTable& table, const Row& row,
                               const std::vector<Pose>& poses, double length) {
  const Finisher finisher(problem, table, row);
  for (const auto& [steps, keep_contacts] : kLoosenings) {
    std::vector<Pose> moved = poses;
    if (steps > 0)
      LinearMoves(table, row).loosen(moved, length, steps * finisher.step(), keep_contacts && finisher.on_grid());
    Layout layout = finisher.rounded(moved, kSnap + 2 * steps);
    if (verify(problem, layout).feasible()) return layout;
  }
  return std::nullopt;
}

Layout layout_of_boxes(const Problem& problem, const FieldTable& table) {
  Layout layout;
  Fraction gap = problem.gap;
  for (const PairGap& pair : problem.pair_gaps) gap = std::max(gap, pair.gap);
  Fraction begin = problem.edge;
  std::vector<int> copies(problem.parts.size());
  for (const FixedPart& f : problem.fixed) {
    const LatticeBox box = box_of(problem.parts[f.placed.part], f.placed.angle, f.placed.mirrored);
    const Fraction end = f.placed.x + Fraction(box.high.x, problem.steps());
    layout.items.push_back(f.placed);
    layout.items.back().copy = ++copies[f.placed.part];
    layout.length = std::max(layout.length, end + problem.edge);
    begin = std::max(begin, end + gap);
  }
  Fraction column = begin, x = begin, y = problem.edge;
  for (std::size_t part = 0; part < problem.parts.size(); ++part) {
    if (problem.free_copies(part) == 0) continue;
    const Variant& v = table.variants()[table.variants_of(part)[0]];
    const LatticeBox box = box_of(problem.parts[part], v.angle, v.mirrored);
    const Fraction low_x(box.low.x, problem.steps()), low_y(box.low.y, problem.steps());
    const Fraction width = Fraction(box.high.x, problem.steps()) - low_x;
    const Fraction height = Fraction(box.high.y, problem.steps()) - low_y;
    for (int copy = copies[part] + 1; copy <= problem.parts[part].demand; ++copy) {
      if (y + height + problem.edge > problem.height) {
        x = column;
        y = problem.edge;
      }
      layout.items.push_back({part, copy, v.angle, v.mirrored, x - low_x, y - low_y});
      y = y + height + gap;
      column = std::max(column, x + width + gap);
      layout.length = std::max(layout.length, x + width + problem.edge);
    }
  }
  return layout;
}

std::vector<const Placed*> movable_items(const Problem& problem, const FieldTable& table, const Layout& layout) {
  std::vector<const Placed*> items;
  for (const Placed& item : layout.items) {
    const auto is_it = [&](const FixedPart& fixed) { return is_fixed_part(layout, item, fixed); };
    if (std::none_of(problem.fixed.begin(), problem.fixed.end(), is_it) && !table.variants_of(item.part).empty())
      items.push_back(&item);
  }
  return items;
}

std::vector<Pose> poses_of(const Problem& problem, const FieldTable& table, const Row& row, const Layout& layout) {
  std::vector<Pose> poses;
  for (const Placed* item : movable_items(problem, table, layout)) {
    const double low = row.rooms()[problem.on_sheets() ? item->sheet : 0].low.x;
    poses.push_back(table.pose_of(item->part, item->angle, item->mirrored,
                                  {(item->x - problem.edge).to_double() + low, (item->y - problem.edge).to_double()}));
  }
  return poses;
}

}  // namespace findspace::packing
