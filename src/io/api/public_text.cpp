// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include <findspace/text.h>
#include <findspace/vocabulary.h>
#include <fmt/format.h>

#include <cmath>

#include "formula/language/lexer.h"
#include "io/report/position_report.h"
#include "io/text/file_kind.h"
#include "io/text/put.h"

namespace findspace {

std::string json_number(double value) {
  if (std::isinf(value) && value < 0) return "\"-inf\"";
  if (!std::isfinite(value)) return "null";
  return value == 0 ? "0" : fmt::format("{}", value);
}

std::string json_string(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    if (static_cast<unsigned char>(c) < 0x20)
      io::put(out, "\\u{:04x}", int(c));
    else
      out += c;
  }
  return out + "\"";
}

std::vector<std::string> drawing_endings(int dimension) {
  std::vector<std::string> out;
  for (const std::string_view ending : io::file_endings(dimension == 3))
    if (ending != ".json") out.emplace_back(ending);
  return out;
}

std::string printable(std::string_view text) { return formula::printable(text); }

std::vector<std::string> usual_distance_words() { return {io::kUsualDistances.begin(), io::kUsualDistances.end()}; }

}  // namespace findspace
