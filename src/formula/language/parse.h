// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Reads formulas and objectives. The grammar (docs/formula.md explains it to users):
//
//     formula  := conj ("or" conj)*
//     conj       := neg ("and" neg)*
//     neg        := "not" neg | "(" formula ")" | atom
//     atom       := distance REL number | number REL distance [REL number] | distance "->" "min"
//                 | "argmin" "(" distance ")" | predicate | "true" | "false"
//     distance   := ["inf" | "sup"] WORD "(" shapes "," shapes ["," mode "=" vector] ")"
//     mode       := "along" | "toward" | "rotating" | "turning"
//     predicate  := WORD "(" shapes "," shapes ["," number] ")"
//     shapes     := shape ("+" shape)*         shape := NAME | "quoted name"
//     vector     := "(" number "," number ["," number] ")"
//     number     := ["-" | "+"] DECIMAL [UNIT]  UNIT := um | mm | cm | m | in | mil | deg
//     objective  := distance | "x" | "y" | "z" | "distance" "to" "[" number "," number ["," number] "]"
//
// Guarantee: either the formula that was written, with exact numbers, or an Error whose place is "line:column" and
// whose message shows the line with a caret and asks for the nearest known name. No other exception for any bytes
// whatever, but for want of memory; nesting deeper than kDeepest is an error, so the stack is safe. Cost: linear, in
// the length times the number of known names.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "findspace/error.h"
#include "formula/language/formula.h"
#include "formula/language/units.h"
#include "plane/base/work_budget.h"

namespace findspace::formula {

/// What a formula may speak of.
struct Context {
  std::vector<std::string> shapes;    // the scene's shapes
  std::vector<std::string> moving;    // those that move, all together unless `independent`
  std::vector<std::string> extra;     // further names that stand still: `other` in a placement's `pairs`
  std::vector<std::string> placed{};  // those that are placed themselves: not to be named in `each` and `pairs`
  std::vector<std::string> empty{};   // lists without a shape in them: the empty set
  std::map<std::string, std::vector<std::string>> groups{};  // lists of shapes, also of those that move
  std::optional<std::vector<std::string>> all{};  // what `all` and `others` mean, if not all shapes: a board's parts
  std::map<std::string, std::size_t> body_of{};   // of a placement: which body a moving shape belongs to
  bool independent = false;  // each moving shape has its own position (a placement's `constraints`)
  bool motion = false;       // the scene has a motion: `inf` and `sup` mean something
  std::optional<Unit> unit;  // the scene's unit; without one, numbers may not carry units
  int dimension = 2;
  std::uint64_t work_limit = plane::kUsualWorkBudget;  // of a formula (plane/base/work_budget.h)
};

inline constexpr int kDeepest = 200;

/// The formula `text`. Throws Error: kSyntax, kUnknownName, kBadValue (a unit, a direction, or a pair of shapes that
/// means nothing), kOutOfRange (a number of more than 100 digits). In every distance one argument has to move and the
/// other to stand still (or, if `independent`, to be another shape); either order is allowed and kept.
Formula parse_formula(std::string_view text, const Context& context);

/// The value of a scene key `minimize` or `maximize`; errors as above.
Objective parse_objective(std::string_view text, const Context& context);

}  // namespace findspace::formula
