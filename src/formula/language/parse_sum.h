// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Sums of distances, as formulas compare them and objectives take them. Private to src/formula; users include parse.h.
//     sum := ["-" | "+"] summand (("+" | "-") summand)*      summand := [DECIMAL "*"] distance | number
// Guarantee: exact weights; an Error at the place otherwise. Cost: linear, and the number of summands squared.
// Keywords: linear combination, weighted sum, wire length, comparison of distances.
#pragma once

#include <optional>
#include <vector>

#include "formula/language/parse_call.h"
#include "formula/language/parse_number.h"

namespace findspace::formula {

/// What stands on one side of a relation.
struct Sum {
  std::vector<SumTerm> terms;   // no distance twice
  std::vector<Number> numbers;  // angles where a distance is in rotation, else lengths
  std::optional<Term> term;     // where it is one distance and nothing else
  Span span;
  bool angle = false;  // a distance is in rotation
  /// One number and nothing else.
  bool is_number() const { return terms.empty() && numbers.size() == 1; }
};

/// From the first summand to the last, or on from a summand that was read.
Sum read_sum(Cursor& cursor, const Context& context, CallReader& calls);
Sum read_sum(Cursor& cursor, const Context& context, CallReader& calls, Number first);

/// left - right, with equal distances made one; nothing is left of those that cancel.
Sum difference(const Sum& left, const Sum& right);

/// `sum relation 0` as an atom, or its truth where no distance is left or one is infinite. Fails where sums are not
/// computed: over a motion, along a direction, in rotation, in space, of shapes that move each on its own.
struct SumCondition {
  std::optional<Atom> atom;
  bool holds = false;  // without an atom
};
SumCondition condition(const Cursor& cursor, const Context& context, Sum sum, Relation relation);
/// Fails there.
void check_sum(const Cursor& cursor, const Context& context, const Sum& sum);

}  // namespace findspace::formula
