// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Shapes of a scene that are made of curves, and the rules by which curves and drawings are read.
#pragma once

#include "io/scene/scene_shapes.h"

namespace findspace::io {

std::span<const ShapeKind> curve_kinds();
std::span<const ShapeKind> simplify_kinds();

/// `curves`, `tolerance`, `join`, `open_lines` and the like of an object, where they are there.
DrawingRules read_drawing_rules(const SceneReader& json, const JsonValue& object, const Label& label);

/// Keeps the rules beside a shape in force while it lives.
class RulesBeside {
 public:
  RulesBeside(ShapeReader& reader, const JsonValue& object, const Label& label);
  ~RulesBeside() { context_.drawing = before_; }
  RulesBeside(const RulesBeside&) = delete;
  RulesBeside& operator=(const RulesBeside&) = delete;

 private:
  ReadContext& context_;
  DrawingUse before_;
};

}  // namespace findspace::io
