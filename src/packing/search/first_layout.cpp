// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "packing/search/first_layout.h"

#include <algorithm>
#include <limits>

#include "exact/margins/packing.h"

namespace findspace::packing {
namespace {

constexpr std::size_t kMostCorners = 40;   // of a no-fit polygon
constexpr std::size_t kMostVariants = 64;  // beyond that a part stands at its first angle: fewer no-fit polygons

class Builder {
 public:
  Builder(const Problem& problem, const FieldTable& table)
      : problem_(problem), table_(table), shallow_(table.height() * margin::kNoOverlap) {}

  DoubleLayout build() {
    std::vector<std::size_t> order;
    for (std::size_t p = 0; p < problem_.parts.size(); ++p) order.push_back(p);
    const auto larger = [&](std::size_t p, std::size_t q) {
      return twice_area(problem_.parts[p].shape) > twice_area(problem_.parts[q].shape);
    };
    std::stable_sort(order.begin(), order.end(), larger);
    for (const std::size_t part : order)
      for (int copy = 0; copy < problem_.parts[part].demand; ++copy) place(part);
    return std::move(layout_);
  }

 private:
  void place(std::size_t part) {
    const bool many = table_.variants().size() > kMostVariants;
    Pose best;
    double right = std::numeric_limits<double>::infinity();
    for (const std::size_t v : table_.variants_of(part)) {
      const Pose pose{v, leftmost(v)};
      if (const double end = pose.at.x + table_.variants()[v].high.x; end < right) {
        right = end;
        best = pose;
      }
      if (many) break;
    }
    layout_.poses.push_back(best);
    layout_.length = std::max(layout_.length, right);
  }

  Vec leftmost(std::size_t v) const {
    const Variant& shape = table_.variants()[v];
    std::vector<Vec> corners{{-shape.low.x, -shape.low.y}, {-shape.low.x, table_.height() - shape.high.y}};
    for (const Pose& other : layout_.poses) add_corners(v, other, corners);
    std::sort(corners.begin(), corners.end(), [](Vec p, Vec q) { return p.x != q.x ? p.x < q.x : p.y < q.y; });
    for (const Vec at : corners)
      if (is_free({v, at})) return at;
    return {layout_.length + 1.01 * table_.gap() - shape.low.x, -shape.low.y};
  }

  void add_corners(std::size_t v, const Pose& other, std::vector<Vec>& corners) const {
    const Variant& shape = table_.variants()[v];
    const FieldTable::Link& link = table_.link(other.variant, v);
    const NoFitPolygon& polygon = link.field().polygon();
    const Vec shift = link.in_field({});
    const std::size_t stride = (polygon.edges.size() + kMostCorners - 1) / kMostCorners;
    for (std::size_t e = 0; e < polygon.edges.size(); e += std::max<std::size_t>(stride, 1)) {
      const Vec at = other.at + link.turned(polygon.edges[e].from - shift);
      if (at.x >= -shape.low.x && at.y >= -shape.low.y && at.y <= table_.height() - shape.high.y) corners.push_back(at);
    }
    // The right end of the polygon at the lower side: a place beside the other part.
    const double beside = std::max(link.turned(polygon.high - shift).x, link.turned(polygon.low - shift).x);
    corners.push_back({other.at.x + beside, -shape.low.y});
  }

  bool is_free(const Pose& pose) const {
    const auto apart = [&](const Pose& other) { return table_.depth(pose, other) <= shallow_; };
    return std::all_of(layout_.poses.rbegin(), layout_.poses.rend(), apart);
  }

  const Problem& problem_;
  const FieldTable& table_;
  double shallow_;
  DoubleLayout layout_;
};

}  // namespace

DoubleLayout first_layout(const Problem& problem, const FieldTable& table) { return Builder(problem, table).build(); }

}  // namespace findspace::packing
