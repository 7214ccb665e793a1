// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The one exception type for bad input and wrong usage. It says what is wrong (`code`, `message`) and where
// (`place`: "scene.json:12:5", or a shape and a vertex), and carries the geometry that shows it where there is one.
// Internal invariants are asserts, never this. Thrown in every build; nothing is written half when it is thrown.
#pragma once

#include <array>
#include <stdexcept>
#include <string>
#include <vector>

namespace findspace {

enum class ErrorCode {
  kUsage,        // wrong command line: exit status 2
  kSyntax,       // a file or a formula cannot be parsed
  kUnknownName,  // an unknown key, shape, distance or unit
  kBadValue,     // a number or a combination that means nothing (NaN, negative radius, wrong unit)
  kGeometry,     // a shape that is not what it claims to be (self-intersection, zero area, hole outside)
  kOutOfRange,   // a coordinate too large for the grid
  kFile,         // a file that is missing, truncated or of an unknown kind
  kUnsupported,  // a valid request outside what the program computes
  kLimit         // more input or work than is allowed: exit status 4
};

class Error : public std::runtime_error {
 public:
  Error(ErrorCode code, std::string message, std::string place = {})
      : std::runtime_error(place.empty() ? message : place + ": " + message),
        code_(code),
        message_(std::move(message)),
        place_(std::move(place)) {}

  ErrorCode code() const { return code_; }
  const std::string& message() const { return message_; }
  const std::string& place() const { return place_; }
  /// Points (in the scene's unit) that show the fault, e.g. where a ring crosses itself; may be empty.
  const std::vector<std::array<double, 2>>& geometry() const { return geometry_; }
  Error& at(double x, double y) {
    geometry_.push_back({x, y});
    return *this;
  }
  /// The same error with `prefix` put before its place (a shape's name, a file's path).
  Error within(const std::string& prefix) const {
    Error e(code_, message_, place_.empty() ? prefix : prefix + ": " + place_);
    e.geometry_ = geometry_;
    return e;
  }

 private:
  ErrorCode code_;
  std::string message_, place_;
  std::vector<std::array<double, 2>> geometry_;
};

}  // namespace findspace
