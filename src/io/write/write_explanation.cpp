// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "io/write/write_explanation.h"

#include <fmt/format.h>

#include "formula/language/text.h"
#include "io/draw/draw_layout.h"
#include "io/write/json_text.h"
#include "io/write/write_position.h"
#include "io/write/write_witness.h"

namespace findspace::io {
namespace {

using exact::Real;
using formula::LevelChange;
using Kind = LevelChange::Kind;

}  // namespace

SaidChange said(const ExplanationReport& r, const LevelChange& change) {
  const formula::Atom& atom = r.formula.atoms()[change.atom];
  const bool minus = formula::negated(atom.distance);
  SaidChange out{formula::written(atom), "", change.level, {}};
  if (change.kind != Kind::kTo) return out;
  if (minus) out.level.negate();
  out.by = abs(change.to() - atom.level);
  if (change.level.proven() || change.level.answer->side == distance::Side::kInner)
    out.becomes = formula::written_at(r.demands, change, r.step);
  return out;
}

namespace {

std::string place_members(const ExplanationReport& r, const formula::RemainingPlace& place) {
  std::string out;
  if (place.at) put(out, R"(, "at": {})", json_point(*place.at));
  if (place.degrees) put(out, R"(, "angle": {})", json_number(*place.degrees));
  if (place.time) put(out, R"(, "time": {})", json_number(*place.time));
  if (place.at && !r.degrees.empty()) put(out, R"(, "angle": {})", json_number(r.degrees[place.pose]));
  return out;
}

std::string change_json(const ExplanationReport& r, const LevelChange& change) {
  const SaidChange s = said(r, change);
  std::string out = fmt::format(R"({{"text": {}, )", json_string(s.text));
  if (change.kind == Kind::kUnknown)
    return out + fmt::format(R"("to": null, "refused": {}}})", json_string(change.refused));
  if (change.kind != Kind::kTo)
    return out + fmt::format(R"("to": null, "free": {}}})", truth(change.kind == Kind::kFree));
  put(out, R"("to": {},{} "by": {}, "reached": {})", json_number(s.level.value()->to_double()),
      how_known_members(s.level), json_number(s.by.to_double()), truth(change.reached));
  if (!s.becomes.empty()) put(out, R"(, "becomes": {})", json_string(s.becomes));
  return out + place_members(r, change.place) + "}";
}

std::string changes_json(const ExplanationReport& r, const std::vector<LevelChange>& changes) {
  return list(
      changes, [&](const LevelChange& c) { return change_json(r, c); }, true);
}

std::string atoms_json(const ExplanationReport& r, const std::vector<std::size_t>& atoms) {
  return list(atoms, [&](std::size_t k) { return json_string(formula::written(r.formula.atoms()[k])); });
}

std::string together_json(const ExplanationReport& r, const formula::CommonRelaxation& t) {
  if (!t.upper) return fmt::format(R"({{"lower": {}, "upper": null}})", json_number(t.lower.to_double()));
  return fmt::format(R"({{"lower": {}, "upper": {}{}}})", json_number(t.lower.to_double()),
                     json_number(t.upper->to_double()), place_members(r, t.place));
}

std::string with_unit(double value, std::string_view unit) {
  return unit.empty() ? shown(value) : fmt::format("{} {}", shown(value), unit);
}

/// An amount by which the level of an atom differs.
std::string amount(const ExplanationReport& r, std::size_t atom, double value) {
  const bool degrees = r.formula.atoms()[atom].distance.mode == formula::Mode::kRotation;
  return degrees ? fmt::format("{}°", shown(value)) : with_unit(value, r.unit);
}

/// What there is room for.
const char* noun(const ExplanationReport& r) {
  return r.sought == Sought::kAngle ? "angle" : r.sought == Sought::kInstant ? "instant" : "position";
}
std::string article(const ExplanationReport& r) {
  return fmt::format("{} {}", r.sought == Sought::kPosition ? "a" : "an", noun(r));
}

/// Of a level that is not exact.
std::string bounds_text(const distance::OptimalValue& level) {
  if (level.proven()) return "";
  const distance::OutwardEnds ends = distance::outward(level.answer->bounds());
  return fmt::format(" (between {} and {})", shown(ends.lower), shown(ends.upper));
}

/// Empty if there is none.
std::string place_text(const ExplanationReport& r, const formula::RemainingPlace& place) {
  if (place.degrees) return fmt::format("{}°", shown(*place.degrees));
  if (place.time) return shown(*place.time);
  if (!place.at) return "";
  const std::string at = shown_point(*place.at);
  return r.degrees.empty() ? at : fmt::format("{} at {}°", at, shown(r.degrees[place.pose]));
}

std::string change_text(const ExplanationReport& r, const LevelChange& change, bool slack) {
  const SaidChange s = said(r, change);
  if (change.kind == Kind::kNone) return fmt::format("  {}: no level of it alone leaves {}\n", s.text, article(r));
  if (change.kind == Kind::kFree) return fmt::format("  {}: can be as tight as you like\n", s.text);
  if (change.kind == Kind::kUnknown) return fmt::format("  {}: not decided: {}\n", s.text, change.refused);
  std::string out = fmt::format("  {}: ", s.text);
  if (s.by.sign() == 0 && slack)
    out += "no slack";
  else if (s.by.sign() == 0)
    out += "beyond its level, by as little as you like";
  else
    out += fmt::format("{} {}, to {}", slack ? "slack" : "change by", amount(r, change.atom, s.by.to_double()),
                       (change.reached ? ""
                        : slack        ? "just before "
                                       : "just beyond ") +
                           shown(s.level.value()->to_double())) +
           bounds_text(s.level);
  const std::string place = place_text(r, change.place), last = fmt::format("the last {} is", noun(r));
  if (!place.empty()) out += fmt::format("; {} {}", slack ? last : "then", place);
  return out + "\n";
}

std::string empty_text(const ExplanationReport& r) {
  std::string out = fmt::format("no {} is feasible{}\n", noun(r), r.degrees.empty() ? "" : " at any of these angles");
  if (r.explanation.conflict) {
    out += "these conditions contradict each other:\n";
    for (const std::size_t k : r.explanation.conflict->atoms)
      out += fmt::format("  {}\n", formula::written(r.formula.atoms()[k]));
  }
  if (!r.explanation.relax.empty()) put(out, "the least change of one level that leaves {}:\n", article(r));
  for (const LevelChange& c : r.explanation.relax) out += change_text(r, c, false);
  const auto& t = r.explanation.together;
  if (t && t->upper)
    out += fmt::format("all levels together: between {} and {}; then {}\n", shown(t->lower.to_double()),
                       amount(r, r.explanation.relax[0].atom, t->upper->to_double()), place_text(r, t->place));
  return out;
}

std::string here_text(const ExplanationReport& r) {
  const formula::PositionExplanation& here = *r.here;
  const std::string at = shown_point(r.at);
  if (here.check.holds) return fmt::format("{} is feasible\n", at);
  std::string out = fmt::format("{} is not feasible; in the way:\n", at);
  for (const std::size_t k : here.change) {
    const formula::AtomAt& a = here.check.atoms[k];
    out += fmt::format("  {}", formula::written(a.atom));
    if (a.lacks) out += ": " + lacks_words(a, r.unit);
    out += "\n";
  }
  return r.explanation.feasible ? out + nearest_words(here.nearest, r.unit) : out;
}

}  // namespace

std::string explanation_json(const ExplanationReport& r) {
  const formula::Explanation& e = r.explanation;
  std::string out = fmt::format("{{{}\"feasible\": {}", unit_key(r.unit), truth(e.feasible));
  if (e.conflict)
    put(out, ",\n  \"conflict\": {}, \"smallest\": {}", atoms_json(r, e.conflict->atoms), truth(e.conflict->smallest));
  if (!e.feasible) put(out, ",\n  \"relax\": {}", changes_json(r, e.relax));
  if (e.together) put(out, ",\n  \"relax_all\": {}", together_json(r, *e.together));
  if (e.feasible) put(out, ",\n  \"slack\": {}", changes_json(r, e.slack));
  if (r.here != nullptr) {
    std::string check = check_json(r.here->check, r.at, "", std::nullopt, r.here->nearest);
    check.pop_back();
    put(out, ",\n  \"change\": {},\n  \"check\": {}", atoms_json(r, r.here->change), check);
  }
  return out + "\n}\n";
}

std::string explanation_text(const ExplanationReport& r) {
  std::string out = r.here != nullptr ? here_text(r) : "";
  if (!r.explanation.feasible) return out + empty_text(r);
  if (r.here == nullptr) put(out, "some {}s are feasible\n", noun(r));
  if (!r.explanation.slack.empty()) out += "how far each level can be tightened:\n";
  for (const LevelChange& c : r.explanation.slack) out += change_text(r, c, true);
  return out;
}

}  // namespace findspace::io
