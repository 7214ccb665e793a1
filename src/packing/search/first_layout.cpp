// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "packing/search/first_layout.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "exact/margins/packing.h"
#include "plane/base/parallel.h"

namespace findspace::packing {
namespace {

constexpr std::size_t kMostCorners = 40, kAllCorners = 100000;  // of a no-fit polygon
constexpr std::size_t kMostVariants = 64;  // beyond that a part stands at its first angle: fewer no-fit polygons

class Builder {
 public:
  Builder(const Problem& problem, const FieldTable& table, const Row& row)
      : problem_(problem), table_(table), row_(row), shallow_(table.height() * margin::kNoOverlap) {}

  /// The largest first, or those of the highest value for their area.
  FirstLayout build(const std::vector<double>& values) {
    result_.layout.length = row_.fixed_end();
    std::vector<std::size_t> order;
    for (std::size_t p = 0; p < problem_.parts.size(); ++p) order.push_back(p);
    const auto first = [&](std::size_t p, std::size_t q) { return values[p] > values[q]; };
    std::stable_sort(order.begin(), order.end(), first);
    make_fields();
    for (const std::size_t part : order)
      for (int copy = 0; copy < problem_.free_copies(part); ++copy)
        if (!place(part)) result_.left.push_back(part);
    return std::move(result_);
  }

 private:
  bool has_many() const { return table_.variants().size() > kMostVariants; }

  /// Those of the first angles, by all threads, where only these are needed.
  void make_fields() const {
    if (!has_many()) return;
    std::vector<std::size_t> standing;
    for (std::size_t part = 0; part < problem_.parts.size(); ++part)
      if (!table_.variants_of(part).empty()) standing.push_back(table_.variants_of(part)[0]);
    plane::parallel_for(standing.size(), [&](std::size_t i) {
      for (std::size_t j = i; j < standing.size(); ++j) table_.link(standing[i], standing[j]);
    });
  }

  bool place(std::size_t part) {
    const bool many = has_many();
    std::optional<Pose> best;
    double right = std::numeric_limits<double>::infinity();
    for (const std::size_t v : table_.variants_of(part)) {
      const std::optional<Vec> at = leftmost(v);
      if (at && at->x + table_.variants()[v].high.x < right) {
        right = at->x + table_.variants()[v].high.x;
        best = Pose{v, *at};
      }
      if (many && best) break;
    }
    if (!best && (problem_.on_sheets() || table_.variants_of(part).empty())) return false;
    if (!best) {
      const std::size_t v = table_.variants_of(part)[0];
      const Variant& shape = table_.variants()[v];
      best = Pose{v, {result_.layout.length + 1.01 * table_.gap() - shape.low.x, -shape.low.y}};
      right = best->at.x + shape.high.x;
      result_.overlaps = true;
    }
    result_.layout.poses.push_back(*best);
    result_.layout.length = std::max(result_.layout.length, right);
    return true;
  }

  /// Of a part without clearance the far side may come out before the near one, by a rounding. Where it does by more,
  /// the part fits other sheets alone.
  bool is_in_room(const Variant& shape, Vec at) const {
    const Room<Vec>& room = row_.rooms()[row_.room_of(shape, at)];
    const auto between = [&](double c, double low, double high) {
      return c >= low && c <= (low - high <= shallow_ ? std::max(low, high) : high);
    };
    return between(at.x, room.low.x - shape.low.x, room.high.x - shape.high.x) &&
           between(at.y, -shape.low.y, room.high.y - shape.high.y);
  }

  std::optional<Vec> leftmost(std::size_t v) const {
    const Variant& shape = table_.variants()[v];
    std::vector<Vec> corners;
    for (const Room<Vec>& room : row_.rooms().all()) {
      corners.push_back({room.low.x - shape.low.x, -shape.low.y});
      corners.push_back({room.low.x - shape.low.x, room.high.y - shape.high.y});
    }
    for (const Pose& other : result_.layout.poses)
      add_corners(v, other, table_.are_tied(v, other.variant) ? kAllCorners : kMostCorners, corners);
    for (const Pose& obstacle : row_.obstacles()) add_corners(v, obstacle, kAllCorners, corners);
    if (problem_.on_sheets())
      std::erase_if(corners, [&](Vec at) { return !is_in_room(shape, at); });
    else
      corners.push_back({result_.layout.length + 1.01 * table_.gap() - shape.low.x, -shape.low.y});
    std::sort(corners.begin(), corners.end(), [](Vec p, Vec q) { return p.x != q.x ? p.x < q.x : p.y < q.y; });
    for (const Vec at : corners)
      if (is_free({v, at})) return at;
    return std::nullopt;
  }

  void add_corners(std::size_t v, const Pose& other, std::size_t most, std::vector<Vec>& corners) const {
    const Variant& shape = table_.variants()[v];
    const FieldTable::Link& link = table_.link(other.variant, v);
    const NoFitPolygon& polygon = link.field().polygon();
    const Vec shift = link.in_field({});
    const std::size_t stride = (polygon.edges.size() + most - 1) / most;
    const auto add = [&](Vec corner) {
      const Vec at = other.at + link.rotated(corner - shift);
      if (is_in_room(shape, at)) corners.push_back(at);
    };
    for (std::size_t e = 0; e < polygon.edges.size(); e += std::max<std::size_t>(stride, 1)) {
      add(polygon.edges[e].from);
      if (polygon.edges[e].slit) add(polygon.edges[e].to);  // no edge goes on from its end
    }
    // The right end of the polygon at the lower side: a place beside the other part.
    const double beside = std::max(link.rotated(polygon.high - shift).x, link.rotated(polygon.low - shift).x);
    corners.push_back({other.at.x + beside, -shape.low.y});
  }

  bool is_free(const Pose& pose) const {
    const auto apart = [&](const Pose& other) { return table_.depth(pose, other) <= shallow_; };
    const auto& poses = result_.layout.poses;
    return std::all_of(poses.rbegin(), poses.rend(), apart) &&
           std::all_of(row_.obstacles().begin(), row_.obstacles().end(), apart);
  }

  const Problem& problem_;
  const FieldTable& table_;
  const Row& row_;
  double shallow_;
  FirstLayout result_;
};

}  // namespace

std::vector<double> values_of(const Problem& problem) {
  std::vector<double> values;
  const double steps = double(problem.steps());
  for (const Part& part : problem.parts)
    values.push_back(part.value ? part.value->to_double() : twice_area(part) / 2 / steps / steps);
  return values;
}

FirstLayout first_layout(const Problem& problem, const FieldTable& table, const Row& row) {
  std::vector<double> areas, values = values_of(problem), of_area;
  for (const Part& part : problem.parts) areas.push_back(twice_area(part));
  FirstLayout layout = Builder(problem, table, row).build(areas);
  if (layout.left.empty()) return layout;
  for (std::size_t part = 0; part < areas.size(); ++part) of_area.push_back(values[part] / areas[part]);
  FirstLayout dear = Builder(problem, table, row).build(of_area);
  const auto lost = [&](const FirstLayout& from) {
    double sum = 0;
    for (const std::size_t part : from.left) sum += values[part];
    return sum;
  };
  return lost(dear) < lost(layout) ? dear : layout;
}

}  // namespace findspace::packing
