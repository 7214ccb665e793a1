// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "formula/solid/ray_minima.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include "distance/rays/ray_directional_least.h"
#include "formula/language/evaluate.h"
#include "formula/language/text.h"

namespace findspace::formula {

bool has_minima(const Formula& formula) {
  return std::any_of(formula.sign_maps().begin(), formula.sign_maps().end(),
                     [](const SignMap& m) { return m.minimum; });
}

MinimaAsLevels minima_as_levels(const SpaceSolver& solver, const Formula& formula) {
  MinimaAsLevels out;
  std::vector<Atom> atoms = formula.atoms();
  each_atom(formula.root(), false, [&](std::size_t k, bool negated) {
    if (!atoms[k].minimum) return;
    const auto least = solver.nearly_least(atoms[k].distance);
    out.minima.push_back({written(atoms[k]), least});
    if (least && !least->proven) out.side = both(out.side, negated ? Side::kInner : Side::kOuter);
    atoms[k] = compare(atoms[k].distance, Relation::kLessEqual, least ? least->value : exact::Real());
  });
  out.formula = Formula(formula.root(), std::move(atoms));
  return out;
}

RegionOnLines QuestionOnLines::on(const RayWorld& world, const Formula& asked, const space::RayGrid& grid) const {
  if (one_position) return {space::constant_rays(grid, 1), Side::kInner};
  return ray_region(world, asked, grid);
}

QuestionOnLines question_on_lines(const RayWorld& world, const std::function<const SpaceSolver&()>& solver,
                                  const Formula& formula, const std::vector<int>& axes) {
  QuestionOnLines out{{formula, {}, Side::kExact}, {}};
  if (has_minima(formula)) out.levels = minima_as_levels(solver(), formula);
  const Formula& asked = out.levels.formula;
  out.window = window(world, asked);
  out.unbounded = holds_far_away(world, asked);
  const bool alone = asked.atoms().size() == 1 && !out.levels.minima.empty();
  out.somewhere = alone && out.levels.minima[0].least && is_taken(*out.levels.minima[0].least);
  const auto has_map = [&](int axis) {
    const space::Point& low = out.window.low;
    const std::array<std::int64_t, 3> at{low.x, low.y, low.z};
    const auto k = std::size_t(axis);
    return bool(try_ray_region(world, asked, {axis, 1, at[(k + 1) % 3], at[(k + 2) % 3], 1, 1, 1, 1}));
  };
  if (alone && !std::all_of(axes.begin(), axes.end(), has_map)) {
    out.one_position = true;
    out.levels.side = Side::kInner;
  }
  return out;
}

}  // namespace findspace::formula
