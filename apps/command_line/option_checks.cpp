// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "command_line/option_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "common/options.h"
#include "findspace/error.h"
#include "findspace/number.h"
#include "findspace/surface.h"
#include "findspace/vocabulary.h"

namespace findspace::app {
namespace {

std::optional<Number> number(const std::string& text) try {
  const Number result = text;
  result.value();  // refuses what is none
  return result;
} catch (const Error&) {
  return std::nullopt;
}

}  // namespace

std::string seconds(const std::string& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc{} && end == text.data() + text.size() && value >= 0 && value <= 1e9) return "";
  return fmt::format("a number of seconds from 0 to 1e9 is meant, not '{}'", text);
}

std::string thread_count(const std::string& text) {
  int value = -1;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc{} && end == text.data() + text.size() && value >= 0 && value <= 4096) return "";
  return fmt::format("a whole number from 0 to 4096 is meant, not '{}'", text);
}

std::optional<std::uint64_t> size_of(const std::string& text) {
  static constexpr std::string_view kLetters = "KMGT";
  std::uint64_t value = 0;
  const char* const stop = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), stop, value);
  if (error != std::errc{} || value == 0) return std::nullopt;
  unsigned shift = 0;
  if (end != stop) {
    const std::size_t letter = kLetters.find(*end);
    if (letter == std::string_view::npos || end + 1 != stop) return std::nullopt;
    shift = 10 * (static_cast<unsigned>(letter) + 1);
  }
  if (value > (UINT64_MAX >> 1 >> shift)) return std::nullopt;
  return value << shift;
}

std::string size_text(const std::string& text) {
  if (size_of(text)) return "";
  return fmt::format("a whole number above 0 is meant, such as 500M or 2G, not '{}'", text);
}

/// "; did you mean 'map'?", or "" where no name is near.
std::string meant(const std::string& word, const std::vector<std::string>& names) {
  const std::string near = nearest_word(word, names);
  return near.empty() ? "" : fmt::format("; did you mean '{}'?", near);
}

std::string length_text(const std::string& text) {
  const auto length = number(text);
  if (length && *length >= 0) return "";
  return fmt::format("a number from 0 on is meant, without a unit, such as 2.5; not '{}'", text);
}

std::string sheet_text(const std::string& text) {
  const std::vector<std::string> sizes = at_commas(text);
  const auto is_size = [](const std::string& size) {
    const auto length = number(size);
    return length && *length > 0;
  };
  if (sizes.size() == 2 && std::all_of(sizes.begin(), sizes.end(), is_size)) return "";
  return fmt::format("a width and a height above 0 are meant, without a unit, such as 600,400; not '{}'", text);
}

std::string angles_text(const std::string& text) {
  for (const std::string& angle : at_commas(text))
    if (!number(angle)) return fmt::format("angles in degrees are meant, such as 0,90,180; not '{}'", text);
  return "";
}

std::string seed_text(const std::string& text) {
  const bool whole = !text.empty() && text.size() < 20 && text.find_first_not_of("0123456789") == std::string::npos;
  return whole ? "" : fmt::format("a whole number from 0 on is meant, of at most 19 digits; not '{}'", text);
}

std::string tilt_text(const std::string& text) {
  const auto tilt = number(text);
  return tilt && *tilt >= 0 && *tilt <= 180 ? "" : fmt::format("a tilt is from 0 to 180 degrees; not '{}'", text);
}

std::string unit_text(const std::string& text) {
  const std::vector<std::string> units = unit_words();
  if (std::find(units.begin(), units.end(), text) != units.end()) return "";
  return fmt::format("unknown unit '{}'; the units are {}", text, fmt::join(units, ", "));
}

std::vector<std::string> endings_of(std::string_view verb) {
  if (verb == "batch") return {".jsonl"};
  if (verb == "check" || verb == "measure") return {".svg", ".json"};
  if (verb == "pack") return {".json", ".svg", ".dxf", ".obj", ".off", ".stl", ".ply", ".glb", ".3mf", ".step"};
  std::vector<std::string> all{".json"};
  if (verb == "phi") all.emplace_back(".txt");
  if (verb == "map") all.emplace_back(".html");
  if (verb == "place") all.emplace_back(".kicad_pcb");
  if (verb == "map" || verb == "describe" || verb == "convert") all.emplace_back(".wkt");
  if (verb == "map" || verb == "convert" || verb == "place") all.emplace_back(".dxf");
  if (verb == "convert") all.emplace_back(".geojson");
  for (std::string& ending : Surface::endings()) all.push_back(std::move(ending));  // .svg is among them
  return all;
}

}  // namespace findspace::app
