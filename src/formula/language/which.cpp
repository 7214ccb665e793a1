// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "formula/language/which.h"

#include "findspace/error.h"
#include "formula/language/text.h"
#include "plane/build/swept.h"

namespace findspace::formula {

using distance::Which;

Which which(Kind kind, bool second_moves) {
  switch (kind) {
    case Kind::kGamma1:
      return Which::kGamma1;
    case Kind::kGamma2:
      return Which::kGamma2;
    case Kind::kEta1:
      return Which::kEta1;
    case Kind::kEta2:
      return Which::kEta2;
    case Kind::kDelta1:
      return Which::kDelta1;
    case Kind::kDelta2:
      return Which::kDelta2;
    case Kind::kMu:
      return second_moves ? Which::kMuBack : Which::kMu;
    case Kind::kHausdorff:
      return Which::kHausdorff;
    case Kind::kD1:
      return Which::kD1;
    case Kind::kD2:
      return Which::kGamma2;
    case Kind::kH:
      return second_moves ? Which::kHBack : Which::kH;
    case Kind::kDstar:
      return second_moves ? Which::kDstarBack : Which::kDstar;
    case Kind::kDiameter:
      return Which::kDiameter;
    case Kind::kPenetration:
      return Which::kPenetration;
  }
  return Which::kGamma1;
}

Kind nearest_kind(Kind kind) {
  return kind == Kind::kGamma2   ? Kind::kGamma1
         : kind == Kind::kEta2   ? Kind::kEta1
         : kind == Kind::kDelta2 ? Kind::kDelta1
                                 : kind;
}

bool is_farthest(Kind kind) { return kind == Kind::kGamma2 || kind == Kind::kEta2 || kind == Kind::kDelta2; }

bool has_rate(Kind kind) {
  return kind != Kind::kEta1 && kind != Kind::kEta2 && kind != Kind::kDelta1 && kind != Kind::kDelta2;
}

bool is_plain_level(const SignMap& wanted) {
  return wanted.distance.mode == Mode::kRotation && wanted.level.sign() == 0 && !is_farthest(wanted.distance.kind);
}

SignMap plain_level(SignMap wanted) {
  if (is_plain_level(wanted) && !wanted.minimum) {
    wanted.distance.mode = Mode::kPlain;
    wanted.distance.vector.clear();
  }
  return wanted;
}

exact::Refusal refused(const Distance& distance, const std::string& what) {
  return exact::Refusal(written(distance) + ": " + what);
}

void refuse(const Distance& distance, const std::string& what) { throw refused(distance, what).error; }

bool is_directional(const Distance& d) { return d.mode == Mode::kAlong || d.mode == Mode::kToward; }

distance::TranslationDirection direction(const Distance& d) {
  const auto direction = plane::primitive_direction({d.vector.at(0), d.vector.at(1)});
  if (!direction) {
    throw Error(ErrorCode::kUnsupported,
                written(d) + ": the direction is not a ratio of integers below 2^53; use fewer digits");
  }
  return {direction->x, direction->y, d.mode == Mode::kAlong};
}

bool second_is_moving(const Distance& d, const std::vector<std::string>& moving) {
  if (d.first.empty() || d.second.empty())
    throw Error(ErrorCode::kBadValue, "a distance is between two shapes; one of its arguments names none");
  return std::find(moving.begin(), moving.end(), d.first[0]) == moving.end();
}

}  // namespace findspace::formula
