// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "formula/language/position_answers.h"

#include <cmath>

#include "formula/language/evaluate.h"

namespace findspace::formula {

std::optional<double> DistanceAt::value() const {
  if (!answer) return std::nullopt;
  return answer->minus_infinity ? -exact::kInfinity : answer->value.to_double();
}

std::optional<std::string> DistanceAt::closed_form() const {
  return answer ? distance::closed_form(*answer) : std::nullopt;
}

DistanceAt distance_at(std::string text, std::optional<distance::SceneAnswer> answer) {
  DistanceAt out;
  out.text = std::move(text);
  if (answer) out.way = answer->way;
  out.answer = std::move(answer);
  return out;
}

DistanceAt minus(DistanceAt d) {
  if (!d.refused.empty()) return d;
  if (!d.answer)
    d.answer = distance::lowest_answer<distance::Coordinates>(d.way);
  else if (d.answer->minus_infinity)
    d.answer.reset();
  else
    d.answer = distance::minus(*std::move(d.answer));
  return d;
}

AtomAt atom_at(const Atom& atom, DistanceAt distance, int sign) {
  AtomAt out{atom, std::move(distance), holds(atom, static_cast<std::int8_t>(sign)), std::nullopt};
  const auto& answer = out.distance.answer;
  if (!out.holds && answer && !answer->minus_infinity && !atom.minimum)
    out.lacks = std::abs(answer->value.to_double() - atom.level.to_double());
  return out;
}

}  // namespace findspace::formula
