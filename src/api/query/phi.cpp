// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Public Phi-functions over those of the layer `space`.

#include "findspace/phi.h"

#include <numeric>
#include <optional>

#include "api/values/shape_data.h"
#include "exact/planar/geometry.h"
#include "findspace/error.h"
#include "plane/base/parallel.h"
#include "space/body/body.h"
#include "space/body/rounded_phi.h"
#include "space/phi/planar_phi_union.h"
#include "space/polytope/planar_parts.h"

namespace findspace {

using exact::Real;

struct Phi::Data {
  Shape first, second;
  Real step;  // one unit of the coordinates in the shapes' unit
  std::size_t a = 0, b = 0;
  std::optional<space::PlanarPhiUnion> planar{};  // one of these two
  std::optional<space::RoundedPhi> solid{};

  const space::PlanarPhiUnion& plane() const {
    if (!planar) throw Error(ErrorCode::kBadValue, "a position of these shapes has three coordinates");
    return *planar;
  }
  const space::RoundedPhi& space() const {
    if (!solid) throw Error(ErrorCode::kBadValue, "a position of these shapes has two coordinates");
    return *solid;
  }
};

namespace {

std::int64_t common_scale(std::int64_t a, std::int64_t b) {
  const exact::int128 scale = exact::int128(a / std::gcd(a, b)) * b;
  if (scale > plane::Grid::kLimit) throw Error(ErrorCode::kOutOfRange, "the corners of the two have no common grid");
  return std::int64_t(scale);
}

void make_planar(const plane::Shape& a, const plane::Shape& b, double step, Phi::Data& data) {
  const auto p = space::planar_parts(a, step), q = space::planar_parts(b, step);
  if (!p || !q)
    throw Error(ErrorCode::kUnsupported, "a Phi-function of shapes that are not unions of polygons and discs");
  const std::int64_t scale = common_scale(p->scale, q->scale);
  const auto ps = space::at_scale(*p, scale), qs = space::at_scale(*q, scale);
  if (!ps || !qs) throw Error(ErrorCode::kOutOfRange, "the corners of the two have no common grid");
  data.planar.emplace(*ps, *qs);
  data.a = ps->size();
  data.b = qs->size();
  data.step = data.step / Real(scale);
}

void make_solid(const plane::Shape& a, const plane::Shape& b, Phi::Data& data) {
  const space::Body p = space::body(a), q = space::body(b);
  if (p.outside || q.outside)
    throw Error(ErrorCode::kUnsupported, "a Phi-function of a complement, which is not a union of convex parts");
  const std::int64_t scale = common_scale(p.scale, q.scale);
  data.solid.emplace(space::at_scale(p, scale).parts, space::at_scale(q, scale).parts);
  data.a = p.parts.size();
  data.b = q.parts.size();
  data.step = data.step / Real(scale);
}

Place place(const space::Vector2& v) { return {v.x, v.y}; }
Place place(const space::Vector& v) { return {v.x, v.y, v.z}; }

template <class At>
Phi::Value public_value(const At& found, const Real& step) {
  static_assert(int(space::State::kApart) == int(Phi::State::kApart));
  return {found.at.phi * step.to_double(), found.at.normalised * step.to_double(),
          Phi::State(int(found.at.state)), place(found.at.gradient),
          std::size_t(found.pair),         found.at.active};
}

template <std::size_t N, class At>
void each(std::span<const std::array<double, N>> positions, std::span<double> values,
          std::span<std::array<double, N>> gradients, const At& at) {
  if (values.size() != positions.size() || gradients.size() != positions.size())
    throw Error(ErrorCode::kBadValue, "as many answers as positions are wanted");
  constexpr std::size_t kBlock = 64;
  plane::parallel_for((positions.size() + kBlock - 1) / kBlock, [&](std::size_t block) {
    for (std::size_t k = block * kBlock; k < std::min(positions.size(), (block + 1) * kBlock); ++k) {
      const Phi::Value found = at(positions[k]);
      values[k] = found.value;
      std::copy(found.gradient.begin(), found.gradient.end(), gradients[k].begin());
    }
  });
}

}  // namespace

Phi::Phi(const Shape& a, const Shape& b) {
  if (a.dimension() != b.dimension()) throw Error(ErrorCode::kBadValue, "shapes of the plane and of space together");
  const plane::Grid grid = api::common_grid(a.data().grid, b.data().grid);
  auto data = std::make_shared<Data>(Data{a, b, grid.step()});
  const plane::ShapePtr p = api::tree_on(a, grid), q = api::tree_on(b, grid);
  if (a.dimension() == 2)
    make_planar(*p, *q, grid.step_size(), *data);
  else
    make_solid(*p, *q, *data);
  data_ = std::move(data);
}

namespace {

exact::RealPoint steps(const Point& u, const Real& step) {
  return {api::real_of(u.x) / step, api::real_of(u.y) / step};
}
space::RealVector steps(const Point3& u, const Real& step) {
  return {api::real_of(u.x) / step, api::real_of(u.y) / step, api::real_of(u.z) / step};
}

}  // namespace

Phi::Value Phi::at(const Point& u) const { return public_value(data_->plane().at(steps(u, data_->step)), data_->step); }
Phi::Value Phi::at(const Point3& u) const {
  return public_value(data_->space().at(steps(u, data_->step)), data_->step);
}

void Phi::evaluate(std::span<const Position> positions, std::span<double> values, std::span<Position> gradients) const {
  each(positions, values, gradients, [&](const Position& u) { return at(Point{u[0], u[1]}); });
}
void Phi::evaluate(std::span<const Position3> positions, std::span<double> values,
                   std::span<Position3> gradients) const {
  each(positions, values, gradients, [&](const Position3& u) { return at(Point3{u[0], u[1], u[2]}); });
}

int Phi::compare(const Point& u, const Number& distance) const {
  const Real rho = api::real_of(distance) / data_->step;
  if (rho.sign() < 0) throw Error(ErrorCode::kBadValue, "a distance is not negative");
  return data_->plane().compare_distance(steps(u, data_->step), rho);
}
int Phi::compare(const Point3& u, const Number& distance) const {
  const Real rho = api::real_of(distance) / data_->step;
  if (rho.sign() < 0) throw Error(ErrorCode::kBadValue, "a distance is not negative");
  return data_->space().compare_distance(steps(u, data_->step), rho);
}

const Shape& Phi::a() const { return data_->first; }
const Shape& Phi::b() const { return data_->second; }
int Phi::dimension() const { return data_->planar ? 2 : 3; }
std::size_t Phi::parts_of_a() const { return data_->a; }
std::size_t Phi::parts_of_b() const { return data_->b; }

}  // namespace findspace
