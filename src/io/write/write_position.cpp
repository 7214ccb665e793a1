// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "io/write/write_position.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "formula/language/text.h"
#include "io/write/json_text.h"
#include "io/write/write_witness.h"

namespace findspace::io {
namespace {

using exact::Real;
using formula::DistanceAt;

using Ends = distance::OutwardEnds;

/// Nothing where the value is exact, or there is none.
std::optional<Ends> ends(const DistanceAt& d) {
  if (!d.answer || d.answer->proven) return std::nullopt;
  return distance::outward(d.answer->bounds());
}

std::string closed_form(const DistanceAt& d) { return d.answer ? closed_form_text(*d.answer) : ""; }

std::string lacks_text(const formula::AtomAt& a) {
  return a.lacks ? fmt::format(R"( "lacks": {},)", json_number(*a.lacks)) : "";
}

/// Which way decided an atom, and how long it took.
std::string explanation(const formula::AtomAt& a) {
  return fmt::format(R"("way": {}, "milliseconds": {:.3f}, )", json_string(distance::name(a.way)), a.milliseconds);
}

/// The members after a value: "exact", "lower" and "upper" of one that is not exact, else "closed_form".
std::string ends_text(const DistanceAt& d) {
  const auto between = ends(d);
  const std::string closed = closed_form(d);
  if (!closed.empty()) return fmt::format(R"( "closed_form": {},)", closed);
  if (!between) return "";
  return fmt::format(R"( "exact": false, "lower": {}, "upper": {},)", json_number(between->lower),
                     json_number(between->upper));
}

/// The keys "atoms" and "distances": an atom with the names of its writer, the distances with the papers' names
/// too.
void put_atoms(std::string& out, const std::vector<formula::AtomAt>& atoms, const distance::Coordinates& at,
               bool explain) {
  std::map<std::string, std::optional<double>> distances;
  out += "  \"atoms\": ";
  out += list(
      atoms,
      [&](const formula::AtomAt& a) {
        const formula::Distance& of = a.atom.distance;
        const DistanceAt said = formula::negated(of) ? formula::minus(a.distance) : a.distance;
        distances[a.distance.text] = a.distance.value();
        // Of a sum that text is the written one, and no distance is said alone.
        distances[a.atom.more.empty() ? formula::written(of) : a.distance.text] = said.value();
        return fmt::format(R"({{"text": {}, "value": {},{} "true": {},{} {}"witness": {{{}}}}})",
                           json_string(formula::written(a.atom)), number(said.value()), ends_text(said), truth(a.holds),
                           lacks_text(a), explain ? explanation(a) : "", witness_members(a.distance, at));
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

/// A key whose value is an object with a line for each distance that says something, by the papers' names and by the
/// plain ones beside them. `say`: of the distance as that name means it; empty for nothing.
template <class Say>
std::string by_name(const char* key, const std::vector<DistanceAt>& distances, const Say& say) {
  std::string out;
  const auto add = [&](const std::string& name, const DistanceAt& d) {
    const std::string said = say(d);
    if (!said.empty()) put(out, "{}\n    {}: {}", out.empty() ? "" : ",", json_string(name), said);
  };
  for (const DistanceAt& d : distances) {
    const formula::PlainText plain = formula::plain(d.text);
    add(d.text, d);
    if (plain.text != d.text) add(plain.text, plain.negated ? formula::minus(d) : d);
  }
  return fmt::format("  \"{}\": {{{}\n  }}", key, out);
}

std::string witness_text(const DistanceAt& d, const distance::Coordinates& at) {
  const std::string members = witness_members(d, at);
  return members.empty() ? "" : "{" + members + "}";
}

/// The keys "distances" and "witnesses"; "closed_form", "not_computed", "lower" and "upper" where some value has them.
void put_distances(std::string& out, const std::vector<DistanceAt>& distances, const distance::Coordinates& at) {
  out += by_name("distances", distances, [](const DistanceAt& d) { return number(d.value()); });
  out += ",\n" + by_name("witnesses", distances, [&](const DistanceAt& d) { return witness_text(d, at); });
  const auto any = [&](const auto& has) { return std::any_of(distances.begin(), distances.end(), has); };
  if (any([](const DistanceAt& d) { return !closed_form(d).empty(); }))
    out += ",\n" + by_name("closed_form", distances, closed_form);
  const auto reason = [](const DistanceAt& d) { return d.refused.empty() ? "" : json_string(d.refused); };
  if (any([&](const DistanceAt& d) { return !d.refused.empty(); }))
    out += ",\n" + by_name("not_computed", distances, reason);
  if (!any([](const DistanceAt& d) { return ends(d).has_value(); })) return;
  const auto end = [](double Ends::*which) {
    return [which](const DistanceAt& d) {
      const auto between = ends(d);
      return between ? json_number((*between).*which) : "";
    };
  };
  out += ",\n" + by_name("lower", distances, end(&Ends::lower));
  out += ",\n" + by_name("upper", distances, end(&Ends::upper));
}

/// The key "bounds": how far values that lie between two numbers may be from the true ones.
std::string bounds_text(const std::vector<DistanceAt>& distances) {
  std::map<std::string, double> bounds;
  for (const DistanceAt& d : distances) {
    if (d.answer && d.answer->enclosed) bounds[d.text] = d.answer->error;
  }
  std::string out;
  for (const auto& [text, bound] : bounds)
    put(out, "{}{}: {}", out.empty() ? ",\n  \"bounds\": {" : ", ", json_string(text), json_number(bound));
  return out.empty() ? out : out + "}";
}

/// The key "not_computed" of a check: why a value, or the nearest feasible position, is not there though there may be
/// one.
std::string not_computed_text(const std::vector<formula::AtomAt>& atoms, const formula::AskedNearest& nearest) {
  std::map<std::string, std::string> reasons;
  for (const formula::AtomAt& a : atoms) {
    const std::string& why = a.distance.refused;
    if (why.empty()) continue;
    reasons[a.distance.text] = why;
    if (a.atom.more.empty()) reasons[formula::written(a.atom.distance)] = why;
  }
  if (nearest && !*nearest) reasons["nearest_feasible"] = nearest->refusal().error.message();
  std::string out;
  for (const auto& [what, why] : reasons)
    put(out, "{}\n    {}: {}", out.empty() ? "" : ",", json_string(what), json_string(why));
  return out.empty() ? out : fmt::format(",\n  \"not_computed\": {{{}\n  }}", out);
}

/// The keys "unit", "at" and "angle".
std::string place_text(const distance::Coordinates& at, std::string_view unit, std::optional<double> angle) {
  return fmt::format("{{{}\"at\": {},{}", unit_key(unit), json_point(at),
                     angle ? fmt::format(" \"angle\": {},", json_number(*angle)) : "");
}

}  // namespace

std::string nearest_member(const std::optional<formula::NearestFeasible>& nearest) {
  if (!nearest) return R"("nearest_feasible": null)";
  return fmt::format(R"("nearest_feasible": {{"at": {}, "distance": {}, "attained": {}}})", json_point(nearest->at),
                     json_number(nearest->distance.to_double()), truth(nearest->attained));
}

std::string check_json(const formula::Check& check, const distance::Coordinates& at, std::string_view unit,
                       std::optional<double> angle, const formula::AskedNearest& nearest, bool explain) {
  std::string out = place_text(at, unit, angle) + fmt::format(" \"true\": {},\n", truth(check.holds));
  put_atoms(out, check.atoms, at, explain);
  if (nearest && *nearest) out += ",\n  " + nearest_member(**nearest);
  std::vector<DistanceAt> all;
  for (const formula::AtomAt& a : check.atoms) all.push_back(a.distance);
  return out + bounds_text(all) + not_computed_text(check.atoms, nearest) + "\n}\n";
}

std::string measure_json(const std::vector<DistanceAt>& distances, const distance::Coordinates& at,
                         std::string_view unit, std::optional<double> angle) {
  std::string out = place_text(at, unit, angle) + "\n";
  put_distances(out, distances, at);
  return out + bounds_text(distances) + "\n}\n";
}

}  // namespace findspace::io
