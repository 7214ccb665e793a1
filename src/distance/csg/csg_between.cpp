// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/csg/csg_between.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "distance/csg/csg_part.h"
#include "distance/solid/solid_pair.h"
#include "plane/base/lazy.h"
#include "space/shape/box_shape.h"

namespace findspace::distance {

using exact::Real;
using space::Body;
using space::BodyPart;
using space::CsgPart;
using space::CsgSolid;
using space::Point;
using space::RealVector;

namespace {

/// Of cells along each axis.
constexpr int kCellsAcross = 8;

enum class CellSide { kIn, kOut, kUnsure };

/// The cells of a lattice over the box about a solid: which lie in it, which beside it.
class SolidCells {
 public:
  explicit SolidCells(const CsgSolid& solid) {
    const space::Bounds3 box = bounds(solid);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto low = static_cast<std::int64_t>(floor(box.low[k]));
      const auto length = static_cast<std::int64_t>(-floor(-box.high[k])) - low;
      const std::int64_t step = std::max<std::int64_t>((length + kCellsAcross - 1) / kCellsAcross, 1);
      for (std::size_t i = 0; i <= kCellsAcross; ++i) at_[k][i] = low + static_cast<std::int64_t>(i) * step;
    }
    std::vector<const CsgPart*> parts;
    for (const CsgPart& part : solid.parts) parts.push_back(&part);
    divide({}, kCellsAcross, parts);
  }

  /// No body where there are none.
  std::optional<Body> inside() const { return body(inside_); }
  std::optional<Body> about() const { return body(about_); }
  /// How much of what holds it lies in it.
  double filled() const { return volume(inside_) / volume(about_); }

 private:
  using Index = std::array<std::size_t, 3>;

  void divide(const Index& first, std::size_t across, const std::vector<const CsgPart*>& parts) {
    const Point low = corner(first, 0), high = corner(first, across);
    std::vector<const CsgPart*> left;
    for (const CsgPart* part : parts) {
      const CellSide side = side_of(*part, low, high);
      if (side == CellSide::kIn) {
        take(inside_, low, high);
        take(about_, low, high);
        return;
      }
      if (side == CellSide::kUnsure) left.push_back(part);
    }
    if (left.empty()) return;
    if (across == 1) {
      take(about_, low, high);
      return;
    }
    for (std::size_t i = 0; i < 8; ++i) {
      Index next = first;
      for (std::size_t k = 0; k < 3; ++k) next[k] += (i >> k & 1) * across / 2;
      divide(next, across / 2, left);
    }
  }

  Point corner(const Index& first, std::size_t across) const {
    return {at_[0][first[0] + across], at_[1][first[1] + across], at_[2][first[2] + across]};
  }

  static std::array<Point, 8> corners_of(const Point& low, const Point& high) {
    std::array<Point, 8> out;
    for (std::size_t i = 0; i < 8; ++i)
      out[i] = {(i & 1) != 0 ? high.x : low.x, (i & 2) != 0 ? high.y : low.y, (i & 4) != 0 ? high.z : low.z};
    return out;
  }

  static CellSide side_of(const CsgPart& part, const Point& low, const Point& high) {
    const std::array<Point, 8> corners = corners_of(low, high);
    const auto cell = std::make_shared<const Body>(space::body_of_part(space::part_of(corners, Real())));
    // The set is convex.
    const auto holds_all = [&](const BodyPart& set) {
      return std::all_of(corners.begin(), corners.end(),
                         [&](const Point& x) { return side(set, space::real(x)) <= 0; });
    };
    const auto beside = [&](const BodyPart& set) {
      const TriedAnswer gap =
          solid_pair(cell, std::make_shared<const Body>(space::body_of_part(set))).try_value(Which::kGamma1, {});
      return gap && *gap && *(*gap)->bounds().lower >= Real();
    };
    bool in = true;
    for (const BodyPart& set : part.within) {
      if (holds_all(set)) continue;
      if (beside(set)) return CellSide::kOut;
      in = false;
    }
    for (const BodyPart& set : part.without) {
      if (holds_all(set)) return CellSide::kOut;
      in = in && beside(set);
    }
    return in ? CellSide::kIn : CellSide::kUnsure;
  }

  static void take(std::vector<space::IntervalBox>& cells, const Point& low, const Point& high) {
    const RealVector from = space::real(low), to = space::real(high);
    space::IntervalBox box;
    for (std::size_t k = 0; k < 3; ++k) box[k] = {from[k], to[k], true, true};
    cells.push_back(box);
  }

  static double volume(const std::vector<space::IntervalBox>& cells) {
    double sum = 0;
    for (const space::IntervalBox& box : cells) {
      double one = 1;
      for (const space::Interval& side : box) one *= (*side.to - *side.from).to_double();
      sum += one;
    }
    return sum;
  }

  static std::optional<Body> body(const std::vector<space::IntervalBox>& cells) {
    if (cells.empty()) return std::nullopt;
    return space::body_of(space::BoxComplex::of_boxes(cells).simplified());
  }

  std::array<std::array<std::int64_t, kCellsAcross + 1>, 3> at_{};
  std::vector<space::IntervalBox> inside_, about_;
};

/// Of a solid in which no cell lies; nothing where no place of the grid is found in it.
std::optional<Body> place_inside(const CsgSolid& solid) {
  const double size = cut_size({}, solid);
  for (const CsgPart& part : solid.parts) {
    const space::Vector at = csg_part_search(part, size).places.deepest({}).place;
    const Point near{std::llround(at.x), std::llround(at.y), std::llround(at.z)};
    if (holds(part, space::real(near))) return space::body_of_part({{}, near, Real()});
  }
  return std::nullopt;
}

/// Of a body in the place of the solid.
struct BodyPair {
  PairDistances pair;
  bool convex = true;  // else of cells
};

/// Those of what lies in the solid and those of what holds it.
struct BodyPairs {
  std::vector<BodyPair> inside, about;
  bool moves = true;  // the solid
};

BodyPairs made_body_pairs(const ReplacedSolid& replaced, const SolidCells& cells) {
  BodyPairs out;
  out.moves = replaced.moves;
  const CsgSolid& solid = *replaced.solid;
  const auto add = [&](std::vector<BodyPair>& pairs, Body body) {
    body.scale = solid.scale;
    const bool convex = body.parts.size() == 1;
    pairs.push_back({replaced.pair(std::make_shared<const Body>(std::move(body))), convex});
  };
  auto inside = cells.inside();
  if (!inside) inside = place_inside(solid);
  if (inside) add(out.inside, *std::move(inside));
  if (auto about = cells.about()) add(out.about, *std::move(about));
  if (solid.parts.size() > 1) return out;
  for (const BodyPart& set : solid.parts[0].within) add(out.about, space::body_of_part(set));
  return out;
}

/// What an end of a value is known to be.
struct KnownEnd {
  std::optional<Real> at;
  bool undefined = false, lowest = false;  // of one of the bodies: it is, or is -infinity
};

/// One of the ends is there.
Answer answer_between(Enclosure ends) {
  if (ends.lower && ends.upper && *ends.lower == *ends.upper) return exact_answer<RealVector>(*ends.lower, Way::kCut);
  Answer out;
  out.set_unproven();
  out.error = exact::kInfinity;
  out.value = ends.lower ? *ends.lower : *ends.upper;
  if (ends.lower && ends.upper) {
    out.value = (*ends.lower + *ends.upper) / Real(2);
    out.error = ends.width();
  }
  out.enclosed = std::move(ends);
  return out;
}

/// "B in A" of the two, or with `back` "A in B".
class SideBetween : public PairSide {
 public:
  struct Source {
    std::vector<ReplacedSolid> solids;  // two at most
    plane::Lazy<std::vector<SolidCells>> cells{};
    std::array<plane::Lazy<BodyPairs>, 2> pairs{};
  };
  SideBetween(std::shared_ptr<const Source> source, bool back) : source_(std::move(source)), back_(back) {}

  TriedAnswer gap(const RealVector& p, Depth depth) const override {
    return asked(depth == Depth::kSign ? Which::kD1 : Which::kGamma1, p, false, false);
  }
  TriedAnswer reach(const RealVector& p) const override { return asked(Which::kGamma2, p, true, true); }
  TriedAnswer diameter(const RealVector& p) const override { return asked(Which::kDiameter, p, true, true); }
  TriedAnswer fit(const RealVector& p) const override { return asked(Which::kEta1, p, true, false); }
  TriedAnswer farthest_fit(const RealVector& p) const override { return asked(Which::kEta2, p, false, true); }
  TriedAnswer protrusion(const RealVector& p, Depth depth) const override {
    return asked(depth == Depth::kSign ? Which::kH : Which::kMu, p, true, false);
  }
  TriedAnswer clearance(const RealVector& p) const override { return asked(Which::kDstarBack, p, false, true); }

 private:
  /// Of a fit it is, where it can be, the solid that shall lie in the other: how a solid fits into some hundred cells
  /// would take many seconds.
  const BodyPairs& pairs(bool of_a_fit) const;

  /// Whether it grows with the solid that is replaced, else it falls: where that shall lie in the other, and where the
  /// other shall lie in it.
  TriedAnswer asked(Which which, const RealVector& p, bool grows_within, bool grows_about) const;
  exact::Tried<KnownEnd> end(const std::vector<BodyPair>& of, Which which, const RealVector& p, bool within,
                             bool upper) const;

  std::shared_ptr<const Source> source_;
  bool back_;
};

bool is_fit(Which which) { return which == Which::kEta1 || which == Which::kEta2; }

const BodyPairs& SideBetween::pairs(bool of_a_fit) const {
  const std::vector<ReplacedSolid>& solids = source_->solids;
  const std::vector<SolidCells>& cells = source_->cells.of([&] {
    std::vector<SolidCells> made;
    for (const ReplacedSolid& one : solids) made.emplace_back(*one.solid);
    return made;
  });
  std::size_t k = 0;
  if (solids.size() > 1) {
    const bool second = of_a_fit ? solids[1].moves != back_ : cells[0].filled() < cells[1].filled();
    k = second ? 1 : 0;
  }
  return source_->pairs[k].of([&] { return made_body_pairs(solids[k], cells[k]); });
}

/// The best of what the pairs tell.
exact::Tried<KnownEnd> SideBetween::end(const std::vector<BodyPair>& of, Which which, const RealVector& p, bool within,
                                        bool upper) const {
  KnownEnd out;
  std::optional<exact::Refusal> refused;
  bool told = false;
  for (const auto& [pair, convex] : of) {
    if (!within && !convex && is_fit(which)) continue;
    const TriedAnswer v = within ? pair.try_value(which, p) : pair.try_value(exchanged(which), space::negated(p));
    if (!v) {
      refused = v.refusal();
      continue;
    }
    told = true;
    if (!*v) {
      out.undefined = true;
      continue;
    }
    if ((*v)->minus_infinity) {
      out.lowest = true;
      continue;
    }
    const Enclosure ends = (*v)->bounds();
    const std::optional<Real>& one = upper ? ends.upper : ends.lower;
    if (one && (!out.at || (upper ? *one < *out.at : *out.at < *one))) out.at = one;
  }
  if (refused && !told) return *refused;
  return out;
}

TriedAnswer SideBetween::asked(Which which, const RealVector& p, bool grows_within, bool grows_about) const {
  const BodyPairs& bodies = pairs(is_fit(which));
  const bool within = bodies.moves != back_;
  const bool grows = within ? grows_within : grows_about;
  const exact::Tried<KnownEnd> least = end(grows ? bodies.inside : bodies.about, which, p, within, false);
  const exact::Tried<KnownEnd> most = end(grows ? bodies.about : bodies.inside, which, p, within, true);
  if (!least && !most) return least.refusal();
  if (most && most->lowest) return std::optional(lowest_answer<RealVector>(Way::kCut));
  Enclosure ends;
  if (least) ends.lower = least->at;
  if (most) ends.upper = most->at;
  if (which == Which::kEta2) {
    // A larger one that fits nowhere says nothing of it.
    if (most && most->undefined) return std::nullopt;
    if (!ends.lower) ends = {Real(), std::nullopt};
  } else if (least && least->undefined) {
    return std::nullopt;
  }
  if (!ends.lower && !ends.upper) return not_found_in_part();
  return std::optional(answer_between(std::move(ends)));
}

}  // namespace

PairDistances pair_between(std::vector<ReplacedSolid> solids) {
  const auto source = std::make_shared<SideBetween::Source>();
  source->solids = std::move(solids);
  return {std::make_shared<const SideBetween>(source, false), std::make_shared<const SideBetween>(source, true)};
}

}  // namespace findspace::distance
