// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Formulas and goals of a scene in their context. Guarantee: a mistake is an Error at its place in the file. Cost: that
// of reading them.
#pragma once

#include "formula/language/parse.h"
#include "formula/language/parse_goal.h"
#include "io/scene/scene.h"

namespace findspace::io {

/// What formulas of the scene may speak of.
formula::Context context_of(const Scene& scene);
/// The error of a formula, its place "LINE:COLUMN" within it, as one at a place in the file.
Error placed(const Error& error, const FormulaText& text);
/// True where there is no text.
formula::Formula read_formula(const FormulaText& text, const formula::Context& context);
formula::Goal read_goal(const FormulaText& text, const formula::Context& context);

}  // namespace findspace::io
