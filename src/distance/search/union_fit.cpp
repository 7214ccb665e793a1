// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/search/union_fit.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "distance/search/boundary_columns.h"
#include "distance/search/grown_set.h"
#include "exact/margins/space_distance.h"
#include "plane/base/subdivide.h"

namespace findspace::distance {

using space::plus;
using space::scaled;
using space::Vector;
using Witness = UnionProtrusion::Witness;

namespace {

constexpr int kMostCells = 6000;
/// Cells of the search for what protrudes, at a corner and at a place that may be in E.
constexpr int kRough = 1500, kFine = 20000;
constexpr std::size_t kMostWitnesses = 6;
/// Choices of parts that are tried for a cell; with more it is divided.
constexpr int kMostChoices = 200;

struct FitCorner {
  Vector at;
  UnionProtrusion::Farthest protrusion;
};
using CornerPointer = std::shared_ptr<const FitCorner>;

struct FitCell {
  std::array<CornerPointer, 4> corner;
  std::vector<Witness> witnesses;
  CornerPointer inside;  // a corner of it or of one that it is a part of, at which B fits
  double key = 0;
  int depth = 0;
  Tetrahedron corners() const { return {corner[0]->at, corner[1]->at, corner[2]->at, corner[3]->at}; }
  bool operator<(const FitCell& other) const { return key > other.key || (key == other.key && depth < other.depth); }
  void draw(plane::ObservedCells& seen) const { TetrahedralCell{corners()}.draw(seen); }
};

/// A place where the columns, of which one of each witness is chosen, are all at most 0, and the objective allows it.
class Choice {
 public:
  Choice(const Tetrahedron& cell, std::vector<std::vector<Column>> witnesses, std::vector<Column> wanted, double noise)
      : cell_(cell), witnesses_(std::move(witnesses)), columns_(std::move(wanted)), noise_(noise) {
    std::sort(witnesses_.begin(), witnesses_.end(), [](const auto& x, const auto& y) { return x.size() < y.size(); });
  }
  std::optional<Vector> place() {
    if (columns_.empty() && witnesses_.empty()) return centre(cell_);
    if (!columns_.empty() && !better()) return std::nullopt;
    return from(0) ? place_ : std::nullopt;
  }

 private:
  bool from(std::size_t k) {
    if (k == witnesses_.size()) return true;
    for (const Column& c : witnesses_[k]) {
      columns_.push_back(less(0, c));
      if (++tried_ > kMostChoices) return true;
      if (better() && from(k + 1)) return true;
      columns_.pop_back();
    }
    return false;
  }

  /// Takes the place where the least of the columns is greatest, if that is not below 0.
  bool better() {
    const HighestPlace found = highest_place(columns_, cell_);
    if (found.value < -noise_ - margin::kLpNoise * found.spread) return false;
    place_ = found.place;
    return true;
  }

  const Tetrahedron& cell_;
  std::vector<std::vector<Column>> witnesses_;
  std::vector<Column> columns_;
  double noise_;
  std::optional<Vector> place_;
  int tried_ = 0;
};

class FitSearch {
 public:
  FitSearch(const UnionProtrusion& protrusion, const FitQuery& query, double size)
      : protrusion_(protrusion), query_(query), size_(size) {
    best_.value = query.known;
    best_.known = std::isfinite(query.known);
  }

  BoundaryPlace run(std::span<const Tetrahedron> domain) {
    for (const Tetrahedron& t : domain) {
      FitCell cell;
      for (std::size_t v = 0; v < 4; ++v) cell.corner[v] = corner(t[v], margin::kRoughCorner * size_);
      cell.key = query_.floor;
      add(std::move(cell));
    }
    double left = exact::kInfinity;
    bool stopped = false;
    const auto stop = [&](const FitCell& cell, bool complete) {
      best_.complete = complete;
      left = cell.key;
      best_.unresolved = centre(cell.corners());
      stopped = true;
    };
    const auto end = queue_.run(
        kMostCells, [&](const FitCell& top) { return stopped || !(top.key < wanted()); },
        [&](const FitCell& top) {
          std::size_t a = 0, b = 1;
          const double edge = longest_edge(top.corners(), a, b);
          if (edge <= margin::kSmallestFitCell * size_)
            stop(top, true);
          else
            split(top, a, b, edge);
        });
    if (end == plane::SubdivisionEnd::kSpent) stop(queue_.best(), false);
    best_.bound = std::min(best_.value, left);
    return best_;
  }

 private:
  CornerPointer corner(const Vector& at, double precision) const {
    return std::make_shared<const FitCorner>(FitCorner{at, protrusion_.farthest(at, precision, kRough)});
  }

  double objective(const Vector& x) const {
    const double d = space::length(x - query_.from);
    return query_.farthest ? -d : d;
  }
  double wanted() const { return std::isfinite(best_.value) ? best_.value - margin::kNearerFit * size_ : best_.value; }

  /// At the corners, what is nowhere more than the objective.
  Column objective_below(const Tetrahedron& t) const {
    if (!query_.farthest) return tangent(distance_to_point(query_.from)(centre(t)), centre(t), t);
    Column out;
    for (std::size_t v = 0; v < 4; ++v) out[v] = objective(t[v]);
    return out;
  }

  void take(const Vector& x) {
    const double value = objective(x);
    if (value < best_.value) {
      best_.value = value;
      best_.place = x;
      best_.found = true;
      best_.known = false;
    }
  }

  /// Whether B fits at a place, by more than rounding; if not, about how far it protrudes. One of the witnesses often
  /// says so.
  bool fits(const Vector& x, const FitCell& cell, double edge, double& out) const {
    const double tolerance = margin::kFits * size_;
    out = -exact::kInfinity;
    for (const Witness& w : cell.witnesses) out = std::max(out, protrusion_.beyond(plus(w.point, x)));
    if (out > -tolerance) return false;
    const UnionProtrusion::Farthest protrusion =
        protrusion_.farthest(x, std::max(0.25 * edge * edge / size_, margin::kDistanceNoise * size_), kFine);
    out = protrusion.bound;
    return protrusion.bound <= -tolerance;
  }

  /// A place that may be in E, or else where E begins on the way to one that is.
  void offer(const Vector& x, const FitCell& cell, double edge) {
    double out = 0;
    if (!(objective(x) < wanted())) return;
    if (fits(x, cell, edge, out)) return take(x);
    if (!cell.inside) return;
    const double deep = 2 * margin::kFits * size_ - cell.inside->protrusion.bound;
    double step = (out + 2 * margin::kFits * size_) / (out + deep);
    for (int k = 0; k < 6 && step < 1; ++k, step *= 1.5) {
      const Vector y = plus(x, scaled(step, cell.inside->at - x));
      if (!(objective(y) < wanted())) return;
      if (fits(y, cell, edge, out)) return take(y);
    }
  }

  /// The columns of the witnesses that say something; false where one says that B fits nowhere in the cell.
  bool decided(FitCell& cell, const Tetrahedron& t, double edge, std::vector<std::vector<Column>>& out) const {
    std::vector<Witness> kept, all;
    for (const CornerPointer& c : cell.corner) {
      all.push_back({c->protrusion.point, c->at, c->protrusion.piece});
      // As it is, too: where B has zero clearance, many points protrude, each on its own side.
      if (!add_columns(protrusion_.holders(all.back(), t), out)) return false;
    }
    all.insert(all.end(), cell.witnesses.begin(), cell.witnesses.end());
    for (Witness& w : all) {
      if (kept.size() == kMostWitnesses) break;
      protrusion_.follow(w, centre(t), edge);
      const bool same = std::any_of(kept.begin(), kept.end(), [&](const Witness& other) {
        return w.piece == other.piece && space::length(w.point - other.point) <= edge / 4;
      });
      if (same) continue;
      if (!add_columns(protrusion_.holders(w, t, edge), out)) return false;
      kept.push_back(w);
    }
    cell.witnesses = std::move(kept);
    return true;
  }

  static bool add_columns(std::vector<Column> holders, std::vector<std::vector<Column>>& out) {
    if (holders.empty()) return false;
    double certain = exact::kInfinity;
    for (const Column& c : holders) certain = std::min(certain, most(c));
    if (certain > 0) out.push_back(std::move(holders));
    return true;
  }

  void add(FitCell cell) {
    const Tetrahedron t = cell.corners();
    const Column objective = objective_below(t);
    cell.key = std::max(cell.key, least(objective));
    if (!(cell.key < wanted())) return;
    std::size_t a = 0, b = 1;
    const double edge = longest_edge(t, a, b);
    for (const CornerPointer& c : cell.corner) {
      if (c->protrusion.value > edge + margin::kDistanceNoise * size_) return;
      if (c->protrusion.bound > -margin::kFits * size_) continue;
      cell.inside = c;
      take(c->at);
    }
    std::vector<std::vector<Column>> witnesses;
    if (!decided(cell, t, edge, witnesses)) return;
    std::vector<Column> better;
    if (std::isfinite(wanted())) better.push_back(less(wanted(), objective));
    const auto place = Choice(t, std::move(witnesses), std::move(better), margin::kDistanceNoise * size_).place();
    if (!place) return;
    offer(*place, cell, edge);
    if (cell.key < wanted()) queue_.push(std::move(cell));
  }

  void split(const FitCell& cell, std::size_t a, std::size_t b, double edge) {
    const Vector half = scaled(0.5, plus(cell.corner[a]->at, cell.corner[b]->at));
    const CornerPointer fresh = corner(half, std::max(0.25 * edge * edge / size_, margin::kDistanceNoise * size_));
    for (const std::size_t moved : {a, b}) {
      FitCell part = cell;
      part.corner[moved] = fresh;
      part.depth = cell.depth + 1;
      add(std::move(part));
    }
  }

  const UnionProtrusion& protrusion_;
  const FitQuery& query_;
  double size_;
  BoundaryPlace best_;
  plane::Subdivision<FitCell> queue_{"tetrahedra of the best fit into a union"};
};

}  // namespace

BoundaryPlace best_fit(const UnionProtrusion& protrusion, const Vector& low, const Vector& high,
                       const FitQuery& query) {
  const double size = protrusion.size(), tolerance = margin::kAroundBox * size;
  const auto [from, to] =
      askew(low - Vector{tolerance, tolerance, tolerance}, plus(high, {tolerance, tolerance, tolerance}));
  return FitSearch(protrusion, query, size).run(tetrahedra_of_box(from, to));
}

}  // namespace findspace::distance
