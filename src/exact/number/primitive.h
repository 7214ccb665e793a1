// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Many integer vectors made primitive at once: as the normals of the edges of a ring. Guarantee: exact; Euclid's
// algorithm with least remainders on floats, whose numbers are integers below 2^24, or on doubles, below 2^53. Cost:
// some eighty instructions a short vector, twice that a long one, as up to twenty-four advance together and no branch
// depends on one of them. Source: Knuth, The Art of Computer Programming 2, 4.5.2. Keywords: greatest common divisor.
#pragma once

#include <cstdint>
#include <span>

namespace findspace::exact {

/// Not (0, 0); |a|, |b| <= 2^50.
struct Normal {
  std::int64_t a, b;
};

/// Each as by make_primitive of geometry.h.
void make_primitive(std::span<Normal> normals);

}  // namespace findspace::exact
