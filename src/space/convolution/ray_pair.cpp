// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/convolution/ray_pair.h"

#include <findspace/error.h>

#include <mutex>

#include "plane/base/stage_observer.h"
#include "space/convolution/ray_row.h"

namespace findspace::space {
namespace {

Triangles prepared(const Triangles& t, const RayGrid& grid) {
  for (const Point& p : t.points) {
    if (!in_ray_range(p, grid.parts))
      throw Error(ErrorCode::kOutOfRange, "a coordinate times the parts of the ray grid exceeds 2^38");
  }
  return with_axis(scaled(t, grid.parts), grid.axis);
}

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
      a_(complement_ ? inside_out(prepared(a, grid)) : prepared(a, grid)),
      b_(prepared(b, grid)),
      base_winding_(complement_ ? b_->euler() : 0),
      overlap_(std::in_place, a_, *b_, complement_) {
  const RayBody mirrored(scaled(prepared(b, grid), -1));
  std::vector<RayFacet> facets = convolution(a_, mirrored);
  observe_facets(facets);
  sheets_ = std::make_unique<Sheets>(std::move(facets), grid);
  spare_ = std::make_unique<Spare>();
}

PairRays::PairRays(const Triangles& a, const RayGrid& grid)
    : complement_(false), a_(prepared(a, grid)), base_winding_(0) {
  std::vector<RayFacet> facets(a_.faces.size());
  for (std::size_t f = 0; f < facets.size(); ++f) {
    for (int k = 0; k < 3; ++k) facets[f].corner[static_cast<std::size_t>(k)] = a_.corner(static_cast<int>(f), k);
  }
  sheets_ = std::make_unique<Sheets>(std::move(facets), grid);
  spare_ = std::make_unique<Spare>();
}

PairRays::~PairRays() = default;

exact::Tried<RayRow> PairRays::try_row(int j) const {
  std::unique_ptr<RowWork> work = spare_->take(*this);
  RayRow row = work->run(j);
  spare_->give(std::move(work));
  return row;
}

}  // namespace findspace::space
