// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "packing/compaction/finish.h"

#include <algorithm>
#include <cmath>

#include "exact/number/search_margins.h"
#include "packing/proof/verify.h"

namespace findspace::packing {
namespace {

constexpr int kSearchGridDigits = 7;  // to these the search's shapes are those of the problem

class Finisher {
 public:
  Finisher(const Problem& problem, const FieldTable& table) : problem_(problem), table_(table) {
    while (double(power_of_ten(digits_)) * problem.height.to_double() * margin::kLayoutGrid < 1) ++digits_;
  }

  double step() const { return 1 / double(power_of_ten(digits_)); }
  bool on_grid() const { return problem_.digits <= std::min(digits_, kSearchGridDigits); }

  Layout rounded(const std::vector<Pose>& poses) const {
    Layout layout;
    std::vector<int> copies(problem_.parts.size());
    for (const Pose& pose : poses) {
      const Variant& v = table_.variants()[pose.variant];
      layout.items.push_back({v.part, ++copies[v.part], v.angle, false, 0, 0});
      put(layout, pose);
    }
    return layout;
  }

 private:
  int128 nearest(double value) const { return int128(std::llround(value * double(power_of_ten(digits_)))); }
  /// The least step that is not below a number of grid steps of the problem, and the greatest not above one.
  int128 above(const Fraction& value) const { return -below(0 - value); }
  int128 below(const Fraction& value) const {
    const int128 scaled = bounded_product(value.numerator(), power_of_ten(digits_)), d = value.denominator();
    return scaled >= 0 ? scaled / d : -((-scaled + d - 1) / d);
  }

  /// The last item's position: on the grid, above the strip's lower side and behind its end.
  void put(Layout& layout, const Pose& pose) const {
    Placed& item = layout.items.back();
    const Ring ring = turned(problem_.parts[item.part].shape, item.angle, false).rings[0];
    LatticePoint low = ring[0], high = ring[0];
    for (const LatticePoint& p : ring) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    const int128 steps = problem_.steps(), grid = power_of_ten(digits_);
    const int128 bottom = above(Fraction(-low.y, steps)), top = below(problem_.height - Fraction(high.y, steps));
    item.x = Fraction(std::max(nearest(pose.at.x), above(Fraction(-low.x, steps))), grid);
    item.y = Fraction(std::max(bottom, std::min(top, nearest(pose.at.y))), grid);
    layout.length = std::max(layout.length, item.x + Fraction(high.x, steps));
  }

  const Problem& problem_;
  const FieldTable& table_;
  int digits_ = 0;
};

}  // namespace

std::optional<Layout> finished(const Problem& problem, const FieldTable& table, const std::vector<Pose>& poses,
                               double length) {
  const Finisher finisher(problem, table);
  for (const double steps : {0, 4, 32, 256, 2048}) {
    std::vector<Pose> moved = poses;
    if (steps > 0) LinearMoves(table).loosen(moved, length, steps * finisher.step(), finisher.on_grid());
    Layout layout = finisher.rounded(moved);
    if (verify(problem, layout).feasible()) return layout;
  }
  return std::nullopt;
}

std::vector<Pose> poses_of(const Problem& problem, const FieldTable& table, const Layout& layout) {
  std::vector<Pose> poses;
  for (const Placed& item : layout.items) {
    const Polygon shape = turned(problem.parts[item.part].shape, item.angle, false);
    // An angle may look like another one of the part up to a translation; then the pose is that one's.
    const SearchShape mine = search_shape(shape, problem.digits);
    Pose pose{table.variants_of(item.part)[0], {item.x.to_double(), item.y.to_double()}};
    for (const std::size_t v : table.variants_of(item.part)) {
      const auto off = table.offset_to(v, mine);
      if (!off) continue;
      pose = {v, {item.x.to_double() + off->x, item.y.to_double() + off->y}};
      break;
    }
    poses.push_back(pose);
  }
  return poses;
}

}  // namespace findspace::packing
