// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Public Phi-functions: of the plane by convex parts or curves (shape_phi.h), of space by convex parts.

#include "findspace/phi.h"

#include <fmt/format.h>

#include <numeric>
#include <optional>
#include <utility>

#include "api/query/phi_data.h"
#include "api/query/world_data.h"
#include "distance/planar/shape_phi.h"
#include "exact/planar/geometry.h"
#include "findspace/error.h"
#include "plane/base/parallel.h"
#include "space/body/body.h"
#include "space/body/rounded_phi.h"

namespace findspace {

using exact::Real;

namespace {

std::int64_t common_scale(std::int64_t a, std::int64_t b) {
  const exact::int128 scale = exact::int128(a / std::gcd(a, b)) * b;
  if (scale > plane::Grid::kLimit) throw Error(ErrorCode::kOutOfRange, "the corners of the two have no common grid");
  return std::int64_t(scale);
}

void make_planar(const plane::Shape& p, const plane::Shape& q, const plane::Grid& grid, Phi::Data& data) {
  data.planar.emplace(p, q, grid.step(), [&] {
    return std::array{api::region_on(data.first, grid, "a"), api::region_on(data.second, grid, "b")};
  });
  if (const distance::PhiParts* parts = data.planar->parts()) {
    data.a = parts->a;
    data.b = parts->b;
  }
}

void make_solid(const plane::Shape& a, const plane::Shape& b, const Real& step, Phi::Data& data) {
  const space::Body p = space::body(a), q = space::body(b);
  for (const auto& [shape, body] : {std::pair(&a, &p), std::pair(&b, &q)})
    if (body->outside)
      throw Error(ErrorCode::kUnsupported, "a complement is not a union of convex parts",
                  shape->name.empty() ? "" : fmt::format("shape '{}'", shape->name));
  const std::int64_t scale = common_scale(p.scale, q.scale);
  data.solid.emplace(space::at_scale(p, scale).parts, space::at_scale(q, scale).parts);
  data.a = p.parts.size();
  data.b = q.parts.size();
  data.step = step / Real(scale);
  const auto rounded = [&](const space::Body& body) {
    return Shape::Rounded{std::size_t(body.rounded), body.moved * step.to_double()};
  };
  data.rounded = {rounded(p), rounded(q)};
}

Place place(const space::Vector2& v) { return {v.x, v.y}; }
Place place(const space::Vector& v) { return {v.x, v.y, v.z}; }

template <class At>
Phi::Value public_value(const At& found, const Real& step) {
  static_assert(int(space::State::kApart) == int(Phi::State::kApart));
  return {found.at.phi * step.to_double(),
          found.at.normalised * step.to_double(),
          Phi::State(int(found.at.state)),
          place(found.at.gradient),
          place(found.at.normalised_gradient),
          std::size_t(found.pair),
          found.at.active};
}

template <std::size_t N, class At>
void each(std::span<const std::array<double, N>> positions, std::span<double> values,
          std::span<std::array<double, N>> gradients, const At& at) {
  if (values.size() != positions.size() || gradients.size() != positions.size())
    throw Error(ErrorCode::kBadValue, "as many answers as positions are wanted");
  constexpr std::size_t kBlock = 64;
  plane::parallel_for((positions.size() + kBlock - 1) / kBlock, [&](std::size_t block) {
    for (std::size_t k = block * kBlock; k < std::min(positions.size(), (block + 1) * kBlock); ++k) {
      const auto found = at(positions[k]);
      values[k] = found.value;
      std::copy(found.gradient.begin(), found.gradient.end(), gradients[k].begin());
    }
  });
}

}  // namespace

Phi::Phi(const Shape& a, const Shape& b) {
  if (a.dimension() != b.dimension()) throw Error(ErrorCode::kBadValue, "shapes of the plane and of space together");
  const plane::Grid grid = api::common_grid(a.data().grid, b.data().grid);
  auto data = std::make_shared<Data>(Data{a, b});
  const plane::ShapePtr p = api::tree_on(a, grid), q = api::tree_on(b, grid);
  if (a.dimension() == 2)
    make_planar(*p, *q, grid, *data);
  else
    make_solid(*p, *q, grid.step(), *data);
  data_ = std::move(data);
}

namespace {

exact::RealPoint planar_place(const Point& u) { return {api::real_of(u.x), api::real_of(u.y)}; }
space::RealVector steps(const Point3& u, const Real& step) {
  return {api::real_of(u.x) / step, api::real_of(u.y) / step, api::real_of(u.z) / step};
}

}  // namespace

Phi::Value Phi::at(const Point& u) const { return public_value(data_->plane().at(planar_place(u)), Real(1)); }
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

namespace {

Real least_distance(const Number& distance) {
  Real rho = api::real_of(distance);
  if (rho.sign() < 0) throw Error(ErrorCode::kBadValue, "a distance is not negative");
  return rho;
}

}  // namespace

int Phi::compare(const Point& u, const Number& distance) const {
  return data_->plane().compare_distance(planar_place(u), least_distance(distance));
}
int Phi::compare(const Point3& u, const Number& distance) const {
  return data_->space().compare_distance(steps(u, data_->step), least_distance(distance) / data_->step);
}

AdjustedPhi Phi::at_least(const Number& distance) const { return {*this, AdjustedPhi::Limit::kLeast, distance}; }
AdjustedPhi Phi::at_most(const Number& distance) const { return {*this, AdjustedPhi::Limit::kGreatest, distance}; }

AdjustedPhi::AdjustedPhi(Phi phi, Limit limit, Number distance)
    : phi_(std::move(phi)),
      limit_(limit),
      distance_(std::move(distance)),
      rounded_(least_distance(distance_).to_double()) {}

AdjustedPhi::Value AdjustedPhi::adjusted(const Phi::Value& found, int order) const {
  const int side = limit_ == Limit::kLeast ? 1 : -1;
  Value out{side * (found.normalised - rounded_), side * order, found.normalised_gradient};
  for (double& c : out.gradient) c *= side;
  return out;
}
AdjustedPhi::Value AdjustedPhi::at(const Point& u) const { return adjusted(phi_.at(u), phi_.compare(u, distance_)); }
AdjustedPhi::Value AdjustedPhi::at(const Point3& u) const { return adjusted(phi_.at(u), phi_.compare(u, distance_)); }

void AdjustedPhi::evaluate(std::span<const Position> positions, std::span<double> values,
                           std::span<Position> gradients) const {
  each(positions, values, gradients, [&](const Position& u) { return adjusted(phi_.at(Point{u[0], u[1]}), 0); });
}
void AdjustedPhi::evaluate(std::span<const Position3> positions, std::span<double> values,
                           std::span<Position3> gradients) const {
  each(positions, values, gradients, [&](const Position3& u) {
    return adjusted(phi_.at(Point3{u[0], u[1], u[2]}), 0);
  });
}

const Shape& Phi::a() const { return data_->first; }
const Shape& Phi::b() const { return data_->second; }
Phi::Form Phi::form() const {
  return data_->planar && data_->planar->way() != distance::Way::kParts ? Form::kCurves : Form::kParts;
}
int Phi::dimension() const { return data_->planar ? 2 : 3; }
std::size_t Phi::parts_of_a() const { return data_->a; }
std::size_t Phi::parts_of_b() const { return data_->b; }
Shape::Rounded Phi::rounded_of_a() const { return data_->rounded[0]; }
Shape::Rounded Phi::rounded_of_b() const { return data_->rounded[1]; }

}  // namespace findspace
