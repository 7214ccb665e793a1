// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Any bytes are a formula or an Error; a formula survives being written and read, and evaluates whatever the signs.
// The first byte chooses the context (unit, dimension, motion, placement), so that seeds of plain text work as well.
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string_view>
#include <vector>

#include "formula/language/evaluate.h"
#include "formula/language/parse.h"
#include "formula/language/text.h"

namespace {

using namespace findspace::formula;

Context context_of(unsigned char choice) {
  Context context;
  context.shapes = {"A", "A0", "A1", "A2", "B", "R", "S", "board", "chip", "key", "my part"};
  context.moving = {"B", "chip", "self"};
  context.extra = {"other"};
  context.independent = (choice & 1) != 0;
  context.motion = (choice & 2) == 0;
  context.dimension = (choice & 4) != 0 ? 3 : 2;
  if ((choice & 24) != 24) context.unit = static_cast<Unit>(choice % kUnitNames.size());
  return context;
}

void require(bool law) {
  if (!law) std::abort();
}

template <class Read>
auto attempt(Read read) -> std::optional<decltype(read())> {
  try {
    return read();
  } catch (const findspace::Error& error) {
    require(!error.place().empty() && !error.message().empty());
    return std::nullopt;
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view input(reinterpret_cast<const char*>(data), size);
  const Context context = context_of(size == 0 ? 0 : data[0]);
  // Only the first reading may fail: what was written by us has to be readable.
  if (const auto formula = attempt([&] { return parse_formula(input, context); })) {
    require(parse_formula(text(*formula), context) == *formula);
    require(parse_formula(text(*formula, Script::kSymbols), context) == *formula);
    std::vector<std::int8_t> signs(formula->sign_maps().size());
    for (std::size_t i = 0; i < signs.size(); ++i) signs[i] = static_cast<std::int8_t>(data[i % size] % 3 - 1);
    require(evaluate(*formula, signs) != evaluate(negation(*formula), signs));
  }
  if (const auto objective = attempt([&] { return parse_objective(input, context); })) {
    require(parse_objective(text(*objective), context) == *objective);
  }
  return 0;
}
