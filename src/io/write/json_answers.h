// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What the answers of `check` and `measure` share in the plane and in space (docs/results.md): atoms, distances with
// their witnesses, the nearest feasible position, the extreme value of a map. Templates over formula::AtomAt,
// DistanceAt and NearestFeasible and their like in space; `witness` gives the members of a "witness" object.
#pragma once

#include <fmt/format.h>

#include <limits>
#include <map>
#include <optional>
#include <string>

#include "formula/language/text.h"
#include "io/write/json_text.h"

namespace findspace::io {

/// Minus a value; undefined where that is +infinity.
inline std::optional<double> negated(const std::optional<double>& value) {
  if (!value || *value == -std::numeric_limits<double>::infinity()) return std::nullopt;
  return -*value;
}

/// The keys "atoms" and "distances": an atom with the names of its writer, the distances with the papers' names too.
template <class Atoms, class Witness>
void put_atoms(std::string& out, const Atoms& atoms, Witness witness) {
  std::map<std::string, std::optional<double>> distances;
  out += "  \"atoms\": ";
  out += list(
      atoms,
      [&](const auto& a) {
        const formula::Distance& of = a.atom.distance;
        const auto value = formula::negated(of) ? negated(a.distance.value) : a.distance.value;
        distances[a.distance.text] = a.distance.value;
        distances[formula::written(of)] = value;
        const std::string lacks = a.lacks ? fmt::format(R"( "lacks": {},)", json_number(*a.lacks)) : "";
        return fmt::format(R"({{"text": {}, "value": {}, "true": {},{} "witness": {{{}}}}})",
                           json_string(formula::written(a.atom)), number(value), truth(a.holds), lacks,
                           witness(a.distance));
      },
      true);
  out += ",\n  \"distances\": {";
  const char* separator = "";
  for (const auto& [text, value] : distances) {
    put(out, "{}{}: {}", separator, json_string(text), number(value));
    separator = ", ";
  }
  out += "}";
}

/// The keys "distances" and "witnesses": by the papers' names and by the plain ones beside them.
template <class Distances, class Witness>
void put_distances(std::string& out, const Distances& distances, Witness witness) {
  std::string witnesses;
  const char* separator = "\n    ";
  const char* between = "\n    ";
  out += "  \"distances\": {";
  const auto add = [&](const std::string& key, const std::optional<double>& value, const std::string& members) {
    put(out, "{}{}: {}", separator, json_string(key), number(value));
    separator = ",\n    ";
    if (members.empty()) return;
    put(witnesses, "{}{}: {{{}}}", between, json_string(key), members);
    between = ",\n    ";
  };
  for (const auto& d : distances) {
    const std::string members = witness(d);
    const formula::PlainText plain = formula::plain(d.text);
    add(d.text, d.value, members);
    if (plain.text != d.text) {
      add(plain.text, plain.negated ? negated(d.value) : d.value, members);
    }
  }
  out += "\n  },\n  \"witnesses\": {" + witnesses + "\n  }";
}

/// The key "nearest_feasible", `at` as text.
template <class Nearest>
void put_nearest(std::string& out, const Nearest& nearest, const std::string& at) {
  put(out, ",\n  \"nearest_feasible\": {{\"at\": {}, \"distance\": {}, \"attained\": {}}}", at,
      json_number(nearest.distance.to_double()), truth(nearest.attained));
}

/// The keys of an extreme value: "minimum" or "maximum", "attained"; where it is not proven "proven", "bound",
/// "within".
inline void put_extreme(std::string& out, const ExtremeValue& e) {
  const std::string value = e.unbounded && !e.maximum ? "\"-inf\"" : number(e.value);
  put(out, "  \"{}\": {}, \"attained\": {},", e.maximum ? "maximum" : "minimum", value, truth(e.attained));
  if (!e.proven) put(out, " \"proven\": false,");
  if (e.bound) put(out, " \"bound\": {},", json_number(*e.bound));
  if (e.within) put(out, " \"within\": {},", json_number(*e.within));
  put(out, "\n");
}

}  // namespace findspace::io
