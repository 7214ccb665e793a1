// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What the tests of mistakes in formulas share: a scene, and the message that a sentence gets in it.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "formula/language/parse.h"

namespace findspace::formula {

inline Context scene() {
  return {.shapes = {"board", "chip", "key", "screws", "my part"},
          .moving = {"chip"},
          .extra = {},
          .independent = false,
          .motion = false,
          .unit = Unit::kMillimetre,
          .dimension = 2};
}

inline std::string message(std::string_view sentence, const Context& context) {
  try {
    parse_formula(sentence, context);
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

/// The whole message of a sentence in scene().
inline void expect(std::string_view sentence, std::string_view expected) {
  EXPECT_EQ(message(sentence, scene()), expected) << sentence;
}

}  // namespace findspace::formula
