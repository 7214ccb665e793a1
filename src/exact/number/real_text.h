// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Exact numbers as text, and back. A number in closed form is written out, "12", "-5/3" or "(1+2*sqrt(5))/3"; any other
// is "#k", and definition k says how it is made of others, "#3*sqrt(2)". So what numbers share is written once.
// Guarantee: what is read is exactly the number that was written. Cost: linear in the operations behind the numbers.
// Grammar: + - * / and brackets over integers, sqrt(..) and #k with k defined before. Keywords: serialisation.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "exact/number/real.h"

namespace findspace::exact {

class RealWriter {
 public:
  std::string text(const Real& x);
  /// Of #0, #1, ...; more come with every number that is written.
  const std::vector<std::string>& definitions() const { return definitions_; }

 private:
  std::vector<std::string> definitions_;
  std::vector<Real> kept_;  // so that no address is used twice
  std::unordered_map<const void*, std::size_t> known_;
};

class RealReader {
 public:
  /// The next #k.
  void define(std::string_view text) { defined_.push_back(read(text)); }
  /// Throws Error(kSyntax) with the place in the text; Error(kBadValue) for a division by zero or a root of a negative
  /// number.
  Real read(std::string_view text) const;

 private:
  std::vector<Real> defined_;
};

}  // namespace findspace::exact
