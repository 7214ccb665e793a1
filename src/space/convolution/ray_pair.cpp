// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/convolution/ray_pair.h"

#include <findspace/error.h>

#include <algorithm>
#include <utility>

#include "plane/base/stage_observer.h"
#include "space/convolution/ray_row.h"
#include "space/rays/ray_sources.h"
#include "space/rays/row_merge.h"

namespace findspace::space {
namespace {

Triangles prepared(const Triangles& t, const RayGrid& grid) {
  for (const Point& p : t.points) {
    if (!in_ray_range(p, grid.parts))
      throw Error(ErrorCode::kOutOfRange, "a coordinate times the parts of the ray grid exceeds 2^38");
  }
  return with_axis(scaled(t, grid.parts), grid.axis);
}

PairRays::BodyPointer shared(Triangles surface) { return std::make_shared<const RayBody>(std::move(surface)); }

}  // namespace

struct PairRays::Spare {
  std::mutex guard;
  std::vector<std::unique_ptr<RowWork>> works;

  std::unique_ptr<RowWork> take(const PairRays& pair) {
    const std::lock_guard lock(guard);
    if (works.empty()) return std::make_unique<RowWork>(pair);
    auto work = std::move(works.back());
    works.pop_back();
    return work;
  }
  void give(std::unique_ptr<RowWork> work) {
    const std::lock_guard lock(guard);
    works.push_back(std::move(work));
  }
};

namespace {

void observe_facets(const std::vector<RayFacet>& facets) {
  plane::StageObserver* observer = plane::stage_observer();
  if (observer == nullptr) return;
  plane::StageDrawing drawing;
  for (const RayFacet& facet : facets) {
    std::vector<plane::StageDrawing::Corner> corners;
    for (std::size_t k = 0; k < std::size_t(facet.corners); ++k) {
      const Approx3 at = exact::approx(facet.corner[k]);
      corners.push_back({at.x, at.y, at.z});
    }
    drawing.add_face(corners);
  }
  observer->drawing("convolution", "signed convolution of two surfaces; the lines run along the third coordinate",
                    drawing);
}

}  // namespace

PairRays::PairRays(const Triangles& a, const Triangles& b, const RayGrid& grid, Side side_of_a)
    : complement_(side_of_a == Side::kComplement),
      a_(shared(complement_ ? inside_out(prepared(a, grid)) : prepared(a, grid))),
      b_(shared(prepared(b, grid))),
      base_winding_(complement_ ? b_->euler() : 0),
      overlap_(std::in_place, *a_, *b_, complement_) {
  set_facets(convolution(*a_, RayBody(scaled(prepared(b, grid), -1))), grid);
}

PairRays::PairRays(BodyPointer a, BodyPointer b, const RayBody& mirrored, const RayGrid& grid)
    : complement_(false),
      a_(std::move(a)),
      b_(std::move(b)),
      base_winding_(0),
      overlap_(std::in_place, *a_, *b_, false) {
  set_facets(convolution(*a_, mirrored), grid);
}

PairRays::PairRays(const Triangles& a, const RayGrid& grid)
    : complement_(false), a_(shared(prepared(a, grid))), base_winding_(0) {
  std::vector<RayFacet> facets(a_->faces.size());
  for (std::size_t f = 0; f < facets.size(); ++f) {
    for (int k = 0; k < 3; ++k) facets[f].corner[static_cast<std::size_t>(k)] = a_->corner(static_cast<int>(f), k);
  }
  sheets_ = std::make_unique<Sheets>(std::move(facets), grid);
  spare_ = std::make_unique<Spare>();
}

PairRays::~PairRays() = default;

void PairRays::set_facets(std::vector<RayFacet> facets, const RayGrid& grid) {
  observe_facets(facets);
  sheets_ = std::make_unique<Sheets>(std::move(facets), grid);
  spare_ = std::make_unique<Spare>();
}

exact::Tried<RayRow> PairRays::try_row(int j) const {
  std::unique_ptr<RowWork> work = spare_->take(*this);
  RayRow row = work->run(j);
  spare_->give(std::move(work));
  return row;
}

UnitedPairs::UnitedPairs(std::span<const Triangles> a, std::span<const Triangles> b, const RayGrid& grid)
    : grid_(grid), first_(static_cast<std::size_t>(grid.nv) + 1, 0) {
  for (const Triangles& t : a) a_.push_back(shared(prepared(t, grid)));
  for (const Triangles& t : b) {
    b_.push_back(shared(prepared(t, grid)));
    mirrored_.push_back(shared(scaled(prepared(t, grid), -1)));
  }
  std::vector<int> first_row;
  for (std::size_t s = 0; s < b_.size(); ++s) {
    for (std::size_t t = 0; t < a_.size(); ++t) {
      const auto [first, last] = rows_of(*a_[t], *b_[s]);
      if (last < first) continue;
      pairs_.push_back({static_cast<int>(t), static_cast<int>(s), last - first + 1});
      first_row.push_back(first);
      for (int j = first; j <= last; ++j) ++first_[static_cast<std::size_t>(j) + 1];
    }
  }
  for (std::size_t j = 1; j < first_.size(); ++j) first_[j] += first_[j - 1];
  of_row_.resize(first_.back());
  std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
  for (std::size_t k = 0; k < pairs_.size(); ++k) {
    for (int j = 0; j < pairs_[k].rows; ++j) of_row_[next[static_cast<std::size_t>(first_row[k] + j)]++] = k;
  }
  made_.resize(pairs_.size());
}

std::array<int, 2> UnitedPairs::rows_of(const RayBody& a, const RayBody& b) const {
  const std::int64_t low = a.low.y - b.high.y - grid_.v, high = a.high.y - b.low.y - grid_.v, step = grid_.dv;
  if (high < 0) return {0, -1};
  const std::int64_t first = low <= 0 ? 0 : (low + step - 1) / step, last = high / step;
  return {static_cast<int>(std::min<std::int64_t>(first, grid_.nv)),
          static_cast<int>(std::min<std::int64_t>(last, grid_.nv - 1))};
}

std::shared_ptr<const PairRays> UnitedPairs::made(std::size_t pair) const {
  const Pair& p = pairs_[pair];
  {
    const std::lock_guard lock(guard_);
    if (std::shared_ptr<const PairRays> rays = made_[pair].rays) {
      if (++made_[pair].asked == p.rows) made_[pair] = {};
      return rays;
    }
  }
  const auto a = static_cast<std::size_t>(p.a), b = static_cast<std::size_t>(p.b);
  auto rays = std::make_shared<const PairRays>(a_[a], b_[b], *mirrored_[b], grid_);
  const std::lock_guard lock(guard_);
  if (p.rows > ++made_[pair].asked)
    made_[pair].rays = rays;
  else
    made_[pair] = {};
  return rays;
}

exact::Tried<RayRow> UnitedPairs::try_row(int j) const {
  std::vector<RayRow> rows;
  for (const std::size_t pair : on_row(j)) {
    exact::Tried<RayRow> row = made(pair)->try_row(j);
    if (!row) return row;
    rows.push_back(*std::move(row));
  }
  return rows.empty() ? constant_row(grid_, 1) : extreme(rows, true);
}

}  // namespace findspace::space
