// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/csg/csg_between.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "distance/csg/csg_cells.h"
#include "distance/csg/csg_lines.h"
#include "distance/csg/csg_part.h"
#include "distance/csg/csg_work.h"
#include "distance/rays/ray_directional_least.h"
#include "distance/search/least_in_box.h"
#include "plane/base/lazy.h"

namespace findspace::distance {

using exact::Real;
using space::Body;
using space::BodyPart;
using space::CsgSolid;
using space::RealVector;

/// Of a body in the place of the solid.
struct BodyInPlace {
  BesideBody beside;
  bool convex = true;  // else of cells
};

/// Those of what lies in the solid and those of what holds it.
struct BodiesInPlace {
  std::vector<BodyInPlace> inside, about;
  bool moves = true;  // the solid
};

namespace {

BodiesInPlace made_bodies_in_place(const ReplacedSolid& replaced, const BodiesOfCells& cells) {
  BodiesInPlace out;
  out.moves = replaced.moves;
  const CsgSolid& solid = *replaced.solid;
  const auto add = [&](std::vector<BodyInPlace>& all, Body body) {
    body.scale = solid.scale;
    const bool convex = body.parts.size() == 1;
    all.push_back({replaced.beside(std::make_shared<const Body>(std::move(body))), convex});
  };
  if (cells.inside) add(out.inside, *cells.inside);
  if (cells.about) add(out.about, *cells.about);
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

bool is_fit(Which which) {
  return which == Which::kEta1 || which == Which::kEta2 || which == Which::kDelta1 || which == Which::kDelta2;
}

/// Whether the distance grows with the solid that moves, else it falls: all but that of what the other one shall lie
/// in.
bool grows_with_moving(Which which) {
  switch (which) {
    case Which::kGamma2:
    case Which::kDiameter:
    case Which::kPenetration:
    case Which::kEta1:
    case Which::kDelta2:
    case Which::kMu:
    case Which::kH:
    case Which::kDstar:
      return true;
    default:
      return false;
  }
}

/// Of the greatest distance to places of which there may be none, that to the nearest of them; nothing of others. All
/// shapes can meet; on one line they need not.
std::optional<Which> nearest_of_places(Which which, bool on_line) {
  if (which == Which::kEta2) return Which::kEta1;
  if (which == Which::kDelta2) return Which::kDelta1;
  if (which == Which::kGamma2 && on_line) return Which::kGamma1;
  return std::nullopt;
}

}  // namespace

struct DistancesBetween::Source {
  std::vector<ReplacedSolid> solids;  // two at most
  Real size;
  // Of coarse cells, and of fine ones.
  std::array<plane::Lazy<std::vector<BodiesOfCells>>, 2> cells{};
  std::array<plane::Lazy<BodiesInPlace>, 4> bodies{};

  /// Of a fit it is, where it can be, the solid that shall lie in the other: how a solid fits into some hundred cells
  /// would take many seconds.
  const BodiesInPlace& of(Which which, Cells size_of_cells = Cells::kFine) const {
    const plane::ScopedSearchWork of_no_question(nullptr);  // kept: not of the one that comes first
    const std::size_t fine = size_of_cells == Cells::kFine ? 1 : 0;
    const std::vector<BodiesOfCells>& made = cells[fine].of([&] {
      std::vector<BodiesOfCells> all;
      for (const ReplacedSolid& one : solids) all.push_back(bodies_of_cells(*one.solid, cells_across(size_of_cells)));
      return all;
    });
    std::size_t k = 0;
    if (solids.size() > 1) {
      const bool moving = which == Which::kEta1 || which == Which::kEta2;
      k = (is_fit(which) ? solids[1].moves == moving : made[0].filled < made[1].filled) ? 1 : 0;
    }
    return bodies[2 * fine + k].of([&] { return made_bodies_in_place(solids[k], made[k]); });
  }

  /// Of B in A: the bodies of which the distance is no more, and those of which it is no less; less those that would
  /// take too long.
  struct Bounding {
    std::vector<const BesideBody*> least, most;
    std::vector<const BesideBody*> convex_least;  // of `least`

    /// Those of which a least value is found soon: what is searched among hundreds of cells takes minutes.
    const std::vector<const BesideBody*>& quick_least(Which which) const {
      const bool soon =
          which == Which::kGamma2 || which == Which::kDiameter || which == Which::kEta2 || which == Which::kDelta2;
      return soon || convex_least.empty() ? least : convex_least;
    }
  };
  Bounding bounding(Which which, Cells size_of_cells = Cells::kFine) const {
    const BodiesInPlace& all = of(which, size_of_cells);
    const bool grows = grows_with_moving(all.moves ? which : exchanged(which));
    const bool moving = which == Which::kEta1 || which == Which::kEta2;
    const auto taken = [](const std::vector<BodyInPlace>& some, bool cells) {
      std::vector<const BesideBody*> out;
      for (const BodyInPlace& one : some) {
        if (one.convex || cells) out.push_back(&one.beside);
      }
      return out;
    };
    const bool cells = !is_fit(which) || all.moves == moving;
    const std::vector<BodyInPlace>&least = grows ? all.inside : all.about, &most = grows ? all.about : all.inside;
    return {taken(least, cells), taken(most, cells), taken(least, false)};
  }

  /// Of B moved by p in A.
  TriedAnswer value(Which which, const RealVector& p, Cells size_of_cells, long share = kMostCellsOfValue) const {
    return in_share(share, [&] { return value_in_share(which, p, size_of_cells, share / 4); });
  }
  PairDistances pair(Cells size_of_cells) const;
  /// Of two solids: where their boxes meet.
  space::Bounds3 meeting() const { return space::meeting(bounds(*solids[0].solid), bounds(*solids[1].solid)); }

 private:
  TriedAnswer value_in_share(Which which, const RealVector& p, Cells size_of_cells, long of_body) const;
  struct AskedEnd {
    Which which;
    const RealVector& p;
    bool moves, upper;
    long share;  // of each body
  };
  exact::Tried<KnownEnd> end(const std::vector<const BesideBody*>& bodies, const AskedEnd& asked) const;
};

/// The best of what the pairs tell.
exact::Tried<KnownEnd> DistancesBetween::Source::end(const std::vector<const BesideBody*>& bodies,
                                                     const AskedEnd& asked) const {
  KnownEnd out;
  std::optional<exact::Refusal> refused;
  bool told = false;
  for (const BesideBody* body : bodies) {
    const TriedAnswer v = in_share(asked.share, [&] {
      return asked.moves ? body->pair.try_value(asked.which, asked.p)
                         : body->pair.try_value(exchanged(asked.which), space::negated(asked.p));
    });
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
    const std::optional<Real>& one = asked.upper ? ends.upper : ends.lower;
    if (one && (!out.at || (asked.upper ? *one < *out.at : *out.at < *one))) out.at = one;
  }
  if (refused && !told) return *refused;
  return out;
}

TriedAnswer DistancesBetween::Source::value_in_share(Which which, const RealVector& p, Cells size_of_cells,
                                                     long of_body) const {
  const Bounding bodies = bounding(which, size_of_cells);
  const bool moves = of(which, size_of_cells).moves;
  const exact::Tried<KnownEnd> least = end(bodies.least, {which, p, moves, false, of_body});
  const exact::Tried<KnownEnd> most = end(bodies.most, {which, p, moves, true, of_body});
  if (!least && !most) return least.refusal();
  if (most && most->lowest) return std::optional(lowest_answer<RealVector>(Way::kCut));
  Enclosure ends;
  if (least) ends.lower = least->at;
  if (most) ends.upper = most->at;
  if (nearest_of_places(which, false)) {
    // A larger one that fits nowhere says nothing of it.
    if (most && most->undefined) return std::nullopt;
    if (!ends.lower) ends = {Real(), std::nullopt};
  } else if (least && least->undefined) {
    return std::nullopt;
  }
  if (!ends.lower && !ends.upper) return not_found_in_part();
  return std::optional(answer_between(std::move(ends)));
}

/// The sign that the maps of bodies tell, of which the distance is no more, or no less.
class DistancesBetween::Rays : public space::RaySource {
 public:
  Rays(std::shared_ptr<const Source> source, const space::RayGrid& grid) : source_(std::move(source)), grid_(grid) {}

  /// At the level, which may be refused.
  enum class Told { kLeast, kMost, kNearest, kThere };
  void add(Told told, const std::vector<const BesideBody*>& bodies, Which which, const Real& level,
           const std::optional<AlongWay>& way) {
    for (const BesideBody* body : bodies) {
      exact::Tried<space::RaySourcePointer> rays = body->map(which, level, way, grid_);
      if (rays) {
        maps_.push_back(*std::move(rays));
        of_.push_back({told, body});
      } else {
        refused_ = rays.refusal();
      }
    }
  }
  /// Tells rows that the maps do not.
  void else_by(space::RaySourcePointer other) { other_ = std::move(other); }
  /// Of places of which there may be none.
  void may_be_none() { there_ = false; }
  /// Why, if no body has a map.
  std::optional<exact::Refusal> refusal() const {
    return maps_.empty() && !other_ ? std::optional(refused_) : std::nullopt;
  }

  const space::RayGrid& grid() const override { return grid_; }
  bool searched() const override { return true; }
  exact::Tried<space::RayRow> try_row(int j) const override;

 private:
  std::int8_t sign(std::span<const std::int8_t> signs) const;

  std::shared_ptr<const Source> source_;  // that the maps belong to
  space::RayGrid grid_;
  std::vector<space::RaySourcePointer> maps_;
  struct Of {
    Told told;
    const BesideBody* body;
  };
  std::vector<Of> of_;
  space::RaySourcePointer other_;
  bool there_ = true;
  exact::Refusal refused_ = not_found_in_part();
};

std::int8_t DistancesBetween::Rays::sign(std::span<const std::int8_t> signs) const {
  const auto any = [&](Told told, int sign, const BesideBody* body = nullptr) {
    for (std::size_t k = 0; k < signs.size(); ++k) {
      if (of_[k].told == told && signs[k] == sign && (body == nullptr || of_[k].body == body)) return true;
    }
    return false;
  };
  if (any(Told::kNearest, 1)) return 1;
  if (!there_ && !any(Told::kThere, -1)) return 0;
  for (std::size_t k = 0; k < signs.size(); ++k) {
    // A body of which there is no place says nothing, whatever another one says.
    const bool told = of_[k].told == Told::kLeast && signs[k] == 1;
    if (told && (there_ || any(Told::kThere, -1, of_[k].body))) return 1;
  }
  return any(Told::kMost, -1) ? -1 : 0;
}

/// A map that does not tell a row says nothing of it.
exact::Tried<space::RayRow> DistancesBetween::Rays::try_row(int j) const {
  const auto lines = static_cast<std::size_t>(grid_.nu);
  std::vector<space::RayRow> rows;
  exact::Refusal refused = refused_;
  for (const space::RaySourcePointer& map : maps_) {
    const long share = share_of_line(grid_) * grid_.nu / static_cast<long>(maps_.size());
    exact::Tried<space::RayRow> row = in_share(share, [&] { return map->try_row(j); });
    if (!row) refused = row.refusal();
    rows.push_back(row ? *std::move(row)
                       : space::RayRow{std::vector<std::int8_t>(lines, 0), std::vector<int>(lines + 1, 0), {}});
  }
  const auto untold = [&](const space::RayRow& row) {
    // Far away the sign is known unless too little is.
    return std::any_of(row.before.begin(), row.before.end(), [](std::int8_t s) { return s == 0; });
  };
  space::RayRow out;
  if (!rows.empty()) out = space::combined(rows, [&](std::span<const std::int8_t> signs) { return sign(signs); });
  if (rows.empty() || untold(out)) return other_ ? other_->try_row(j) : exact::Tried<space::RayRow>(refused);
  return out;
}

namespace {

/// How one protrudes from the other, or fits into it.
bool takes_long(Which which) {
  return which == Which::kMu || which == Which::kMuBack || which == Which::kHausdorff || which == Which::kEta1 ||
         which == Which::kDelta1;
}

}  // namespace

DistancesBetween::DistancesBetween(std::vector<ReplacedSolid> solids, Real size) {
  auto source = std::make_shared<Source>();
  source->solids = std::move(solids);
  source->size = std::move(size);
  source_ = std::move(source);
}

PairDistances DistancesBetween::Source::pair(Cells size_of_cells) const {
  return pair_by_values(
      [this, size_of_cells](Which which, const RealVector& p) { return value(which, p, size_of_cells); });
}

PairDistances DistancesBetween::pair() const {
  return pair_by_values([source = source_](Which which, const RealVector& p) {
    return source->value(which, p, Cells::kFine, kMostCellsOfOneValue);
  });
}

exact::Tried<space::RaySourcePointer> DistancesBetween::map(Which which, const Real& level,
                                                            const std::optional<AlongWay>& way,
                                                            const space::RayGrid& grid) const {
  if (const auto cut = cut_off_of(which); cut && !way) {
    if (level.sign() < 0) return space::constant_rays(grid, 1);
    exact::Tried<space::RaySourcePointer> base = map(cut->base, cut->negated ? -level : level, way, grid);
    if (!base) return base;
    return space::cut_off_rays(*std::move(base), cut->negated, level);
  }
  space::RaySourcePointer by_ends;
  if (source_->solids.size() > 1 && !way) {
    const auto value = [source = source_, which](const RealVector& p, Cells cells) {
      return source->pair(cells).try_value(which, p);
    };
    by_ends = rays_by_ends(value, level, space::rounded(source_->meeting()), source_->solids[0].solid->scale, grid);
    if (takes_long(which)) return by_ends;
  }
  // It neither grows nor falls with a solid.
  if (which == Which::kHausdorff) return not_found_in_part();
  const Source::Bounding bodies = source_->bounding(which);
  const auto nearest = nearest_of_places(which, way.has_value());
  if (nearest && level.sign() < 0) return space::constant_rays(grid, 1);
  auto rays = std::make_unique<Rays>(source_, grid);
  rays->else_by(std::move(by_ends));
  if (nearest) {
    // The places of the larger set hold those of the smaller one.
    rays->may_be_none();
    rays->add(Rays::Told::kNearest, bodies.most, *nearest, level, way);
    rays->add(Rays::Told::kThere, bodies.least, *nearest, level + Real(2) * source_->size, way);
  }
  rays->add(Rays::Told::kLeast, bodies.least, which, level, way);
  rays->add(Rays::Told::kMost, bodies.most, which, level, way);
  if (auto refused = rays->refusal()) return *std::move(refused);
  return space::RaySourcePointer(std::move(rays));
}

namespace {

exact::Refusal may_not_fit() {
  return exact::Refusal("whether one of the shapes fits into the other is not known, so there may be no least value");
}

/// What the least values of the bodies tell.
struct LeastOfBodies {
  std::optional<Real> lower, upper;
  std::vector<Answer> found;  // that positions take, or nearly
  bool undefined = false;     // of one of the bodies
  std::optional<exact::Refusal> refused;
};

template <class Ask>
void add_least(LeastOfBodies& out, const std::vector<const BesideBody*>& bodies, bool upper, const Ask& ask) {
  for (const BesideBody* body : bodies) {
    const TriedAnswer v = in_share(kMostCellsOfBody, [&] { return ask(*body); });
    if (!v) {
      out.refused = v.refusal();
      continue;
    }
    if (!*v) {
      out.undefined = true;
      continue;
    }
    const Enclosure ends = (*v)->bounds();
    if (upper && ends.upper && (!out.upper || *ends.upper < *out.upper)) out.upper = ends.upper;
    if (!upper && ends.lower && (!out.lower || *out.lower < *ends.lower)) out.lower = ends.lower;
    out.found.push_back(**v);
  }
}

/// The place of those found at which the value is known to be least.
std::optional<Answer> best_of_places(const PairDistances& pair, Which which, const LeastOfBodies& least) {
  std::optional<Answer> best;
  for (const Answer& found : least.found) {
    const TriedAnswer v = pair.try_value(which, found.at);
    const std::optional<Real> upper = v && *v ? (*v)->bounds().upper : std::nullopt;
    if (!upper || (best && !(*upper < best->value))) continue;
    best = exact_answer<RealVector>(*upper, Way::kCut);
    best->at = found.at;
  }
  return best;
}

/// Of two solids, by values between ends.
TriedAnswer least_between(const PairDistances& pair, Which which, const space::Bounds3& box, const Real& size,
                          const std::optional<Real>& floor) {
  const auto value = [&](const RealVector& p) -> exact::Tried<Answer> {
    const TriedAnswer v = pair.try_value(which, p);
    if (!v) return v.refusal();
    Enclosure ends = *v ? (*v)->bounds() : Enclosure{size, std::nullopt};
    if (!ends.lower) ends.lower = -size;  // no way out of the boxes is longer
    Answer out;
    out.set_unproven();
    out.value = ends.upper ? *ends.upper : *ends.lower;
    out.error = ends.upper ? ends.width() : exact::kInfinity;
    out.enclosed = std::move(ends);
    return out;
  };
  const exact::Tried<Answer> least = least_in_box(value, space::rounded(box.low), space::rounded(box.high),
                                                  floor ? floor->to_double() : -exact::kInfinity, kMostPlacesOfLeast);
  if (!least) return least.refusal();
  if (!(least->error < exact::kInfinity) || !least->bounds().upper) return may_not_fit();
  return std::optional(*least);
}

}  // namespace

TriedAnswer DistancesBetween::least(Which which) const {
  plane::SearchWork work{plane::allowed(kMostCellsBetween)};  // kept: not of the question that comes first
  const plane::ScopedSearchWork here(&work);
  LeastOfBodies least;
  const std::vector<Which> of =
      which == Which::kHausdorff ? std::vector{Which::kMu, Which::kMuBack} : std::vector{which};
  const auto ask = [](Which one) { return [one](const BesideBody& body) { return body.least(one); }; };
  for (const Which one : of) add_least(least, source_->bounding(one).quick_least(one), false, ask(one));
  const bool farthest = nearest_of_places(which, false).has_value();
  if (!farthest && least.undefined) return std::nullopt;
  if (farthest && least.found.empty()) return may_not_fit();
  const PairDistances pair = source_->pair(Cells::kCoarse);
  std::optional<Answer> best = best_of_places(pair, which, least);
  if (best && (least.lower || farthest)) {
    const Real lower = least.lower.value_or(Real());
    return std::optional(least_answer(best->value, lower, lower == best->value, best->at, Way::kCut));
  }
  if (source_->solids.size() < 2) return least.refused.value_or(not_found_in_part());
  return least_between(pair, which, source_->meeting(), source_->size, least.lower);
}

TriedAnswer DistancesBetween::least_along(Which which, const AlongWay& way) const {
  const Source::Bounding bodies = source_->bounding(which);
  LeastOfBodies least, most;
  const auto ask = [&](const BesideBody& body) { return body.least_along(which, way); };
  add_least(least, bodies.least, false, ask);
  if (least.undefined) return std::nullopt;
  if (!least.lower) return least.refused.value_or(not_found_in_part());
  add_least(most, bodies.most, true, ask);
  const auto lowest = std::min_element(most.found.begin(), most.found.end(),
                                       [](const Answer& a, const Answer& b) { return a.value < b.value; });
  if (lowest == most.found.end()) return most.undefined ? may_not_fit() : most.refused.value_or(not_found_in_part());
  Answer out = least_answer(*most.upper, *least.lower, false, lowest->at);
  if (!is_taken(*lowest)) out.side = distance::Side::kNone;
  return std::optional(std::move(out));
}

}  // namespace findspace::distance
