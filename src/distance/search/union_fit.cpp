// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/search/union_fit.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>
#include <memory>

#include "distance/search/boundary_columns.h"
#include "distance/search/solid_protrusion.h"
#include "exact/margins/space_distance.h"
#include "plane/base/search_work.h"

namespace findspace::distance {

using space::plus;
using space::scaled;
using space::Vector;

namespace {

/// How far a body B, drawn at a position x, protrudes from the union of the parts of A, each a convex core grown by a
/// radius: the greatest, over B's points, of the least signed distance to a part; B + x lies in A where it is at most
/// 0. And why nothing of a cell of positions, or only a half of it, can be such: a point of B that moves linearly with
/// the position, along a crease of A where it protrudes from two parts at once, so that the tangents of the distances
/// there are off by the square of the cell's size only.
class UnionProtrusion {
 public:
  UnionProtrusion(const space::Body& b, const space::Body& a);

  /// A point of B, drawn at 0, that protrudes at a position.
  struct Witness {
    space::Vector point, at;
    std::size_t piece = 0;  // of B, that holds it
  };
  struct Farthest {
    double value = 0, bound = 0;  // nothing protrudes farther than the bound
    Witness witness;
  };
  /// That protrudes farthest, but for so much, or as far as so many cells tell.
  Farthest farthest(const space::Vector& x, double precision, int most) const;
  /// Whether all of B is deeper than that, as far as so many cells tell; if not, perhaps a point that is not.
  bool deeper(const space::Vector& x, double than, int most, std::optional<Witness>& out) const;

  /// How far a point is out of A.
  double beyond(const space::Vector& y) const;
  /// To another position, and the point to where it protrudes farther there, nearby.
  void follow(Witness& witness, const space::Vector& to, double reach) const;
  /// For each part of A that can hold the point at some position of the cell: at most its signed distance there, linear
  /// between the cell's corners. No part: B lies in A nowhere in the cell. The point may go so far from corner to
  /// corner, to protrude farther.
  std::vector<Column> holders(const Witness& witness, const Tetrahedron& cell, double reach = 0) const;

  /// Of the coordinates of both.
  double size() const { return size_; }

 private:
  SolidMaxMin max_min(const space::Vector& x, double slack, double share, int most) const;
  Tetrahedron around(const Witness& witness, double reach) const;
  space::Vector farthest_out(const Tetrahedron& among, const space::Vector& x, std::span<const Touching> touching,
                             const space::Vector& at) const;
  std::vector<Touching> touching(const space::Vector& y) const;
  std::size_t piece_of(const space::Vector& point) const;

  std::vector<TouchingConstraint> parts_;  // of A
  Solids b_;                               // the round ones are numbered after the cells
  double size_ = 1;
};

/// To the nearest place that protrudes farthest; a place before is as good.
constexpr int kMostFarSteps = 12;

/// The signed distance to a core grown by a radius, with what touches it from below.
TouchingConstraint signed_touching(const space::BodyPart& part) {
  const double radius = part.radius.to_double();
  if (part.vertices().size() > 2) return touching_boundary(part, {}, radius);
  return [core = round_solid(part, {})](const Vector& x) {
    const Vector off = x - core.projection(x);
    const double d = space::length(off);
    return Touching{d - core.radius, d > 0 ? scaled(1 / d, off) : Vector{}};
  };
}

UnionProtrusion::UnionProtrusion(const space::Body& b, const space::Body& a) : b_(solids_of(b, {})) {
  for (const space::BodyPart& part : a.parts) parts_.push_back(signed_touching(part));
  for (const space::Body* body : {&b, &a}) {
    const space::Bounds3 box = bounds(*body);
    size_ += std::max(space::length(space::rounded(box.low)), space::length(space::rounded(box.high)));
  }
}

std::size_t UnionProtrusion::piece_of(const Vector& point) const {
  std::size_t best = 0;
  double least = exact::kInfinity;
  for (std::size_t k = 0; k < b_.cells.size() + b_.round.size(); ++k) {
    const double d =
        k < b_.cells.size() ? beyond_faces(b_.cells[k], point) : b_.round[k - b_.cells.size()].beyond(point);
    if (d < least) {
      least = d;
      best = k;
    }
  }
  return best;
}

/// The distances to the parts of A of a point of B at x, up to so much.
SolidMaxMin UnionProtrusion::max_min(const Vector& x, double slack, double share, int most) const {
  std::vector<ConvexDistance> sets;
  for (const TouchingConstraint& part : parts_)
    sets.emplace_back([&part, &x](const Vector& y) { return part(plus(x, y)).value; });
  return solid_max_min(b_, sets, slack, share, most);
}

UnionProtrusion::Farthest UnionProtrusion::farthest(const Vector& x, double precision, int most) const {
  // Nothing is deeper than that: so all of it counts.
  const double depth = 2 * (size_ + space::length(x));
  const SolidMaxMin found = max_min(x, -depth, precision / (2 * depth), most);
  return {found.value,
          found.complete ? std::max(found.bound, found.value + precision) : found.bound,
          {found.place, x, piece_of(found.place)}};
}

bool UnionProtrusion::deeper(const Vector& x, double than, int most, std::optional<Witness>& out) const {
  const SolidMaxMin found = max_min(x, -than, 1, most);
  if (!(found.value > -than)) return found.complete;
  out = Witness{found.place, x, piece_of(found.place)};
  return false;
}

double UnionProtrusion::beyond(const Vector& y) const {
  double least = exact::kInfinity;
  for (const TouchingConstraint& part : parts_) least = std::min(least, part(y).value);
  return least;
}

/// A tetrahedron within the piece; of a round one near the point, and nearly touching its boundary.
Tetrahedron UnionProtrusion::around(const Witness& witness, double reach) const {
  if (witness.piece < b_.cells.size()) return b_.cells[witness.piece];
  const RoundSolid& solid = b_.round[witness.piece - b_.cells.size()];
  Vector out = witness.point - solid.projection(witness.point);
  const double far = space::length(out);
  // Deep inside any way will do.
  out = far > solid.radius / 2 && far > 0 ? scaled(1 / far, out) : Vector{0, 0, 1};
  const Vector u = distance::across(out), w = space::cross(out, u);
  const auto at = [&](double a, double b, double c) {
    return solid.pulled_in(plus(witness.point, scaled(reach, plus(scaled(a, u), plus(scaled(b, w), scaled(c, out))))));
  };
  const double rise = far < solid.radius * (1 - margin::kInsideBall) ? 0.5 : 0;  // no sign: which tetrahedron
  return {at(1, 0, rise), at(-0.5, 0.8, rise), at(-0.5, -0.8, rise), at(0, 0, -1)};
}

std::vector<Touching> UnionProtrusion::touching(const Vector& y) const {
  std::vector<Touching> out;
  for (const TouchingConstraint& part : parts_) out.push_back(part(y));
  return out;
}

/// The point of a tetrahedron of B that protrudes farthest at x, by what touches the distances at `at`.
Vector UnionProtrusion::farthest_out(const Tetrahedron& among, const Vector& x, std::span<const Touching> touching,
                                     const Vector& at) const {
  std::vector<Column> columns;
  for (const Touching& t : touching) columns.push_back(tangent(t, at - x, among));
  return highest_place(std::move(columns), among).place;
}

void UnionProtrusion::follow(Witness& witness, const Vector& to, double reach) const {
  witness.at = to;
  Vector at = plus(witness.point, witness.at);
  double out = beyond(at);
  for (int k = 0; k < kMostFarSteps; ++k) {
    Witness next = witness;
    next.point = farthest_out(around(witness, reach), witness.at, touching(at), at);
    const Vector there = plus(next.point, next.at);
    const double farther = beyond(there);
    if (farther > out) {
      witness = next;
      at = there;
      out = farther;
    } else if (witness.piece < b_.cells.size()) {
      return;
    } else {
      reach /= 3;
    }
  }
}

std::vector<Column> UnionProtrusion::holders(const Witness& witness, const Tetrahedron& cell, double reach) const {
  Vector at = plus(witness.point, witness.at);
  const Tetrahedron near = around(witness, 1.5 * reach);
  const std::vector<Touching> there = touching(at);
  Tetrahedron moved;  // the point at each corner of the cell
  for (std::size_t v = 0; v < 4; ++v)
    moved[v] = plus(cell[v], reach > 0 ? farthest_out(near, cell[v], there, at) : witness.point);
  at = centre(moved);
  std::vector<Column> out;
  for (const TouchingConstraint& part : parts_) {
    const Column c = tangent(part(at), at, moved);
    if (least(c) <= margin::kDistanceNoise * size_) out.push_back(c);
  }
  return out;
}

using Witness = UnionProtrusion::Witness;

constexpr long kMostFitCells = 6000;
/// Cells of the search for what protrudes, at a corner and at a place that may be in E.
constexpr int kRough = 1500, kFine = 20000;
constexpr std::size_t kMostWitnesses = 6, kRecentWitnesses = 8;

/// The functions of one search: of points of B that protrude near a cell.
class FitConstraints : public LazyConstraints {
 public:
  explicit FitConstraints(std::shared_ptr<const UnionProtrusion> protrusion)
      : protrusion_(std::move(protrusion)), size_(protrusion_->size()) {}

  Constraints constraints() override { return {{}, {}, this}; }
  bool spent() const override { return cells_ > plane::allowed(kMostFitCells); }
  double nearer() const override { return margin::kNearerFit; }
  double last_cell() const override { return margin::kSmallestFitCell; }

  double beyond(int number, const Vector& x) const override {
    return number == kNone ? -exact::kInfinity : -protrusion_->beyond(plus(made(number).witness.point, x));
  }
  /// Of the cell that it was made for.
  Column column(int number, const Tetrahedron& cell) const override {
    return number == kNone ? LazyConstraints::column(number, cell) : made(number).column;
  }

  std::vector<int> near(const Tetrahedron& cell, double edge, std::span<const int> known) override {
    ++cells_;
    std::vector<int> out;
    std::vector<Witness> all, kept;
    for (const Vector& v : cell) {
      const UnionProtrusion::Farthest& there = at_corner(v, edge);
      if (there.value > edge + margin::kDistanceNoise * size_) return {kNone};
      all.push_back(there.witness);
      // As it is, too: where B has zero clearance, many points protrude, each on its own side.
      if (!add(there.witness, cell, 0, out)) return {kNone};
    }
    for (const int k : known) {
      if (made(k).followed) all.push_back(made(k).witness);
    }
    for (Witness& w : all) {
      if (kept.size() == kMostWitnesses) break;
      protrusion_->follow(w, centre(cell), edge);
      const bool same = std::any_of(kept.begin(), kept.end(), [&](const Witness& other) {
        return w.piece == other.piece && space::length(w.point - other.point) <= edge / 4;
      });
      if (same) continue;
      if (!add(w, cell, edge, out)) return {kNone};
      kept.push_back(w);
    }
    return out;
  }

  std::vector<Vector> places(const Tetrahedron& cell) const override {
    std::vector<Vector> out;
    for (const Vector& v : cell) {
      const auto at = corners_.find({v.x, v.y, v.z});
      if (at != corners_.end() && at->second.bound <= -margin::kFits * size_) out.push_back(v);
    }
    return out;
  }

  /// Whether B fits at a place, by more than rounding. A point that protruded before often says no.
  bool allows(const Vector& x, std::span<const int> /*known*/) const override {
    const double by = margin::kFits * size_;
    for (const Witness& w : recent_) {
      if (protrusion_->beyond(plus(w.point, x)) > -by) return false;
    }
    std::optional<Witness> out;
    const bool fits = protrusion_->deeper(x, by, kFine, out);
    if (out) recent_.push_front(*out);
    if (recent_.size() > kRecentWitnesses) recent_.pop_back();
    return fits;
  }

 private:
  static constexpr int kNone = -1;  // B fits nowhere in the cell

  struct Made {
    Witness witness;
    Column column;
    bool followed;  // to the middle of the cell
  };
  const Made& made(int number) const { return made_[static_cast<std::size_t>(number)]; }

  const UnionProtrusion::Farthest& at_corner(const Vector& v, double edge) {
    const auto [at, fresh] = corners_.try_emplace({v.x, v.y, v.z});
    if (fresh) {
      const double square = std::max(0.25 * edge * edge / size_, margin::kDistanceNoise * size_);
      at->second = protrusion_->farthest(v, std::min(square, margin::kRoughCorner * size_), kRough);
    }
    return at->second;
  }

  /// False where no part of A can hold the point anywhere in the cell.
  bool add(const Witness& witness, const Tetrahedron& cell, double reach, std::vector<int>& out) {
    const std::vector<Column> holders = protrusion_->holders(witness, cell, reach);
    if (holders.empty()) return false;
    Column deepest = less(0, holders[0]);
    for (const Column& c : holders) {
      for (std::size_t v = 0; v < 4; ++v) deepest[v] = std::max(deepest[v], -c[v]);
    }
    out.push_back(static_cast<int>(made_.size()));
    made_.push_back({witness, deepest, reach > 0});
    return true;
  }

  std::shared_ptr<const UnionProtrusion> protrusion_;
  double size_;
  long cells_ = 0;
  std::deque<Made> made_;
  std::map<std::array<double, 3>, UnionProtrusion::Farthest> corners_;
  mutable std::deque<Witness> recent_;
};

}  // namespace

PositionSet fits_in_union(const space::Body& b, const space::Body& a, const PositionSet::Box& box) {
  auto protrusion = std::make_shared<const UnionProtrusion>(b, a);
  const double size = protrusion->size();
  return PositionSet::lazily([protrusion] { return std::make_unique<FitConstraints>(protrusion); },
                             grown(box, margin::kAroundBox * size), size, margin::kUnionFitError);
}

}  // namespace findspace::distance
