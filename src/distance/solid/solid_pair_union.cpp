// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// How far a body is from fitting into a union of round parts, and the farthest place where it does (solid_pair.h). The
// places at which it lies in a single part are those of a convex A, exactly; one is told where the search through all
// others (union_fit.h) finds none that is better. Guarantee: else found by search, to 2^-36 of the sizes; where a fit
// that has no room to spare, and is none in a single part, may be nearer, Error(kUnsupported) says so. Keywords:
// erosion, containment.

#include <findspace/error.h>

#include <cmath>

#include "distance/search/solid_value.h"
#include "distance/search/union_fit.h"
#include "distance/solid/solid_pair.h"

namespace findspace::distance {

using exact::Real;
using space::RealVector;

/// What is kept from position to position.
struct UnionRooms {
  UnionStickOut stick_out;
  std::vector<std::unique_ptr<SolidPair>> alone;  // with each part of A
  space::Vector low, high;                        // of the box that E lies in
};

namespace {

/// What a value found by search may be off, of the sizes.
constexpr double kError = 0x1p-36;

/// The nearest (farthest) place in a single part, where that is known.
std::optional<SolidValue> in_one_part(const UnionRooms& rooms, const RealVector& p, bool farthest) {
  std::optional<SolidValue> best;
  for (const auto& pair : rooms.alone) {
    try {
      auto v = pair->value(farthest ? Which::kEta2 : Which::kEta1, p);
      if (!v) continue;
      if (!best || (farthest ? best->value < v->value : v->value < best->value)) best = std::move(v);
    } catch (const Error& e) {
      if (e.code() != ErrorCode::kUnsupported) throw;  // the search will tell
    }
  }
  return best;
}

std::optional<SolidValue> settled(const FrontPlace& found, const std::optional<SolidValue>& known, double size,
                                  int sense) {
  const double slack = kError * size;
  if (found.known && found.value - found.bound <= slack) return known;
  if (found.found && found.value - found.bound <= slack) {
    SolidValue out;
    out.value = Real::from_double(sense * found.value);
    out.nearest = RealVector{Real::from_double(found.place.x), Real::from_double(found.place.y),
                             Real::from_double(found.place.z)};
    out.proven = false, out.error = slack;
    return out;
  }
  if (!found.whole)
    throw Error(
        ErrorCode::kUnsupported,
        "how far a shape is from fitting into a union of round parts was not found within the limit of the search");
  if (!found.unsure) return std::nullopt;
  throw Error(ErrorCode::kUnsupported,
              "whether a shape fits into a union of round parts where it has no room to spare "
              "is not decided");
}

}  // namespace

std::shared_ptr<const UnionRooms> SolidPair::union_rooms(const space::Body& b, const space::Body& a,
                                                         const space::Bounds3& box) {
  auto out = std::make_shared<UnionRooms>(
      UnionRooms{UnionStickOut(b, a), {}, space::rounded(box.low), space::rounded(box.high)});
  const auto moving = std::make_shared<const space::Body>(b);
  for (const space::BodyPart& part : a.parts) {
    auto one = std::make_shared<space::Body>();
    one->scale = a.scale;
    one->parts.push_back(part);
    out->alone.push_back(std::make_unique<SolidPair>(moving, std::move(one)));
  }
  return out;
}

std::optional<SolidValue> SolidPair::into_union(const Side& side, const Fit& fit, const RealVector& p,
                                                const SolidValue& stuck) const {
  // Moved by as much, the way that B sticks out by, it often fits, and no shorter way leads to where it does.
  if (stuck.points && stuck.proven) {
    const RealVector q = space::minus(p, space::minus((*stuck.points)[0], (*stuck.points)[1]));
    if (sticking_out(side, q, false).value.sign() <= 0) return signed_value(p, q, 1);
  }
  const UnionRooms& rooms = *fit.in_union;
  const auto known = in_one_part(rooms, p, false);
  FitWish wish{space::rounded(p)};
  wish.floor = stuck.value.to_double() - stuck.error;
  if (known) wish.known = known->value.to_double();
  return settled(best_fit(rooms.stick_out, rooms.low, rooms.high, wish), known, rooms.stick_out.size(), 1);
}

std::optional<SolidValue> SolidPair::farthest_in_union(const Fit& fit, const RealVector& p) {
  const UnionRooms& rooms = *fit.in_union;
  const auto known = in_one_part(rooms, p, true);
  FitWish wish{space::rounded(p), true};
  if (known) wish.known = -known->value.to_double();
  auto out = settled(best_fit(rooms.stick_out, rooms.low, rooms.high, wish), known, rooms.stick_out.size(), -1);
  if (out) out->nearest.reset();
  return out;
}

}  // namespace findspace::distance
