// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "io/text/read_transform.h"

#include <cmath>
#include <numbers>

#include "findspace/error.h"

namespace findspace::io {

using exact::Real;

Direction direction(const Real& degrees) {
  auto quarters = (degrees / Real(90)).integer();
  if (!quarters) {
    double angle = degrees.to_double() * (std::numbers::pi / 180);
    return {Real::from_double(std::cos(angle)), Real::from_double(std::sin(angle))};
  }
  switch (static_cast<int>((*quarters % 4 + 4) % 4)) {
    case 0:
      return {1, 0};
    case 1:
      return {0, 1};
    case 2:
      return {-1, 0};
    default:
      return {0, -1};
  }
}

Affine Affine::translation(const Real& x, const Real& y) {
  Affine map;
  map.e = x;
  map.f = y;
  return map;
}

Affine Affine::scaling(const Real& x, const Real& y) {
  Affine map;
  map.a = x;
  map.d = y;
  map.mirrors = x.sign() * y.sign() < 0;
  map.scale = compare(abs(x), abs(y)) == 0 ? std::optional(abs(x)) : std::nullopt;
  return map;
}

Affine Affine::rotation(const Real& degrees) {
  Direction to = direction(degrees);
  Affine map;
  map.a = map.d = to.cosine;
  map.b = to.sine;
  map.c = -to.sine;
  return map;
}

Affine Affine::matrix(Real a, Real b, Real c, Real d, Real e, Real f) {
  Affine map{std::move(a), std::move(b), std::move(c), std::move(d), std::move(e), std::move(f), std::nullopt, false};
  map.mirrors = (map.a * map.d - map.b * map.c).sign() < 0;
  Real p = map.a * map.a + map.b * map.b, q = map.c * map.c + map.d * map.d;
  if (compare(p, q) == 0 && (map.a * map.c + map.b * map.d).sign() == 0) map.scale = sqrt(p);
  return map;
}

const Real& Affine::similarity() const {
  if (!scale) throw Error(ErrorCode::kUnsupported, "an arc under a transform that makes it elliptical");
  return *scale;
}

Affine operator*(const Affine& o, const Affine& i) {
  Affine map{o.a * i.a + o.c * i.b,       o.b * i.a + o.d * i.b,       o.a * i.c + o.c * i.d, o.b * i.c + o.d * i.d,
             o.a * i.e + o.c * i.f + o.e, o.b * i.e + o.d * i.f + o.f, std::nullopt,          o.mirrors != i.mirrors};
  if (o.scale && i.scale) map.scale = *o.scale * *i.scale;
  return map;
}

}  // namespace findspace::io
