// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// From the formula's names of distances to those of a pair of shapes, in which the first moves.
#pragma once

#include "distance/planar/directional.h"
#include "distance/planar/shape_pair.h"
#include "exact/number/tried.h"
#include "formula/language/formula.h"

namespace findspace::formula {

/// For a distance whose first shape moves, unless `second_moves`.
distance::Which which(Kind kind, bool second_moves);

/// gamma2, eta2 and delta2.
bool is_farthest(Kind kind);
/// Not eta and delta: they jump where places at which a shape fits come and go.
bool has_rate(Kind kind);
/// gamma1 of gamma2, eta1 of eta2, delta1 of delta2; else the kind itself.
Kind nearest_kind(Kind kind);
/// A distance in rotation at level 0, where it is on the same side as the plain one (and of those of the second kind
/// nothing is known so simply).
bool is_plain_level(const SignMap& wanted);
/// The plain one in its place, where it is.
SignMap plain_level(SignMap wanted);
/// The refusal of a distance, by its name; and the Error(kUnsupported) that it is.
exact::Refusal refused(const Distance& distance, const std::string& what);
[[noreturn]] void refuse(const Distance& distance, const std::string& what);

/// With along= or toward=.
bool is_directional(const Distance& d);
/// Their direction; throws Error(kUnsupported) where it is not a ratio of integers below 2^53.
distance::TranslationDirection direction(const Distance& d);

/// Whether the second argument of a distance of moving_first() is the one that moves. Throws Error(kBadValue) where an
/// argument names no shape.
bool second_is_moving(const Distance& d, const std::vector<std::string>& moving);

}  // namespace findspace::formula
