// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "io/scene/scene_formulas.h"

#include <fmt/format.h>

#include <charconv>

#include "findspace/error.h"

namespace findspace::io {

formula::Context context_of(const Scene& scene) {
  formula::Context context;
  for (const plane::ShapePtr& s : scene.shapes) context.shapes.push_back(s->name);
  context.moving = scene.moving;
  context.motion = scene.motion.given();
  context.unit = scene.unit;
  context.dimension = scene.dimension;
  context.empty = scene.empty_lists;
  context.groups = scene.groups;
  context.all = scene.all_shapes;
  context.work_limit = scene.work_limit;
  return context;
}

Error placed(const Error& e, const FormulaText& formula) {
  int line = 1, column = 1;
  const char* end = e.place().data() + e.place().size();
  const char* colon = std::from_chars(e.place().data(), end, line).ptr;
  if (colon != end) std::from_chars(colon + 1, end, column);
  if (line != 1)
    return Error(e.code(), e.message(), fmt::format("{}:{}: formula {}", formula.file, formula.line, e.place()));
  return Error(e.code(), e.message(), fmt::format("{}:{}:{}", formula.file, formula.line, formula.column + column - 1));
}

formula::Formula read_formula(const FormulaText& text, const formula::Context& context) {
  if (text.empty()) return {};
  try {
    return formula::parse_formula(text.text, context);
  } catch (const Error& e) {
    throw placed(e, text);
  }
}

formula::Goal read_goal(const FormulaText& text, const formula::Context& context) {
  try {
    return formula::parse_goal(text.text, context);
  } catch (const Error& e) {
    throw placed(e, text);
  }
}

}  // namespace findspace::io
