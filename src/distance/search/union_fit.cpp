// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/search/union_fit.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>

#include "distance/search/boundary_columns.h"
#include "exact/margins/space_distance.h"

namespace findspace::distance {

using space::plus;
using space::Vector;
using Witness = UnionProtrusion::Witness;

namespace {

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
  bool spent() const override { return cells_ > kMostFitCells; }
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

PositionSet fits_in_union(std::shared_ptr<const UnionProtrusion> protrusion, const PositionSet::Box& box) {
  const double size = protrusion->size(), tolerance = margin::kAroundBox * size;
  const Vector by{tolerance, tolerance, tolerance};
  return PositionSet::lazily(
      [protrusion = std::move(protrusion)] { return std::make_unique<FitConstraints>(protrusion); },
      {box.low - by, plus(box.high, by)}, size, {});
}

}  // namespace findspace::distance
