// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Questions to regions and sign maps, and what they are made of.

#include "findspace/region.h"

#include <algorithm>
#include <cmath>

#include "api/values/region_data.h"
#include "api/values/shape_data.h"
#include "findspace/error.h"
#include "plane/complex/extent.h"
#include "plane/complex/overlay.h"
#include "plane/offset/plain_sum.h"
#include "plane/query/in_order.h"
#include "plane/query/topology.h"
#include "plane/walk/unite.h"

namespace findspace {

using plane::Mark;

namespace api {

Region make_region(plane::Region cells, const plane::Grid& grid, std::string unit) {
  return Region(std::make_shared<const Region::Data>(plane::in_order(std::move(cells)), grid, std::move(unit)));
}

std::optional<Mark> Marks::quick(const Position& p) const {
  const plane::Grid::Steps x = grid_.steps_near(p[0]), y = grid_.steps_near(p[1]);
  if (!std::isfinite(x.value) || !std::isfinite(y.value))
    throw Error(ErrorCode::kBadValue, "a position must be finite");
  return buckets_.mark({x.value, y.value, std::max(x.error, y.error)});
}

exact::RealPoint Marks::exactly(const Position& p) const {
  return {plane::decimal_of(p[0]) / grid_.step(), plane::decimal_of(p[1]) / grid_.step()};
}

Mark Marks::at(const Position& p) const {
  if (const auto mark = quick(p)) return *mark;
  return plane::mark_of(complex_, plane::locate(complex_, exactly(p)));
}

}  // namespace api

namespace {

exact::RealPoint steps(const Point& p, const plane::Grid& grid) {
  return {api::real_of(p.x) / grid.step(), api::real_of(p.y) / grid.step()};
}

Position position(const exact::RealPoint& p, const exact::Real& step) {
  return {(p.x * step).to_double(), (p.y * step).to_double()};
}

bool belongs(Mark m) { return m > 0; }
std::int8_t sign_of(Mark m) { return m; }

void same_grid(const Region& a, const Region& b) {
  if (a.data().grid.step() != b.data().grid.step())
    throw Error(ErrorCode::kBadValue, "regions on different grids; make shapes of them first");
}

template <class Combine>
Region combined(const Region& a, const Region& b, Combine combine) {
  same_grid(a, b);
  const plane::Region* both[] = {&a.data().cells, &b.data().cells};
  return api::make_region(combine(std::span<const plane::Region* const>(both)), a.data().grid, a.data().unit);
}

Region changed(const Region& r, plane::Region (*change)(plane::Region)) {
  return api::make_region(change(r.data().cells), r.data().grid, r.data().unit);
}

std::optional<Bounds> public_bounds(const std::optional<plane::Bounds>& b) {
  return b ? std::optional(Bounds{b->low, b->high}) : std::nullopt;
}

}  // namespace

const plane::Summary& Region::Data::summary() const {
  std::call_once(summarized_, [&] { summary_ = plane::summarize(cells, grid.step()); });
  return *summary_;
}

const api::Marks& Region::Data::marks() const {
  std::call_once(located_, [&] { marks_.emplace(cells, grid); });
  return *marks_;
}

const api::Marks& SignMap::Data::marks() const {
  std::call_once(located_, [&] { marks_.emplace(map, grid); });
  return *marks_;
}

const api::Walk& Region::Data::walk() const {
  std::call_once(walked_, [&] { walk_.emplace(cells, summary(), grid.step()); });
  return *walk_;
}

const api::RegionAnswers& Region::Data::answers() const {
  std::call_once(asked_, [&] { answers_.emplace(cells, grid.step()); });
  return *answers_;
}

bool Region::empty() const { return plane::is_empty(data_->cells); }
bool Region::whole() const { return plane::is_whole(data_->cells); }
bool Region::open() const { return plane::is_open(data_->cells); }
bool Region::closed() const { return plane::is_closed(data_->cells); }
bool Region::bounded() const { return plane::is_bounded(data_->cells); }
std::optional<double> Region::area() const { return data_->summary().area; }
std::optional<Bounds> Region::bounds() const { return public_bounds(data_->summary().bbox); }
std::size_t Region::holes() const { return std::size_t(data_->summary().holes); }

bool Region::contains(const Point& p) const {
  return belongs(plane::mark_of(data_->cells, plane::locate(data_->cells, steps(p, data_->grid))));
}
bool Region::contains_position(const Position& p) const { return belongs(data_->marks().at(p)); }
void Region::contains(std::span<const Position> positions, std::span<bool> inside) const {
  if (inside.size() != positions.size()) throw Error(ErrorCode::kBadValue, "as many answers as positions are wanted");
  data_->marks().each(positions, belongs, inside);
}

const std::vector<Region::Vertex>& Region::vertices() const { return data_->walk().vertices; }
const std::vector<Region::Edge>& Region::edges() const { return data_->walk().edges; }
const std::vector<Region::Component>& Region::components() const { return data_->walk().components; }

ExactPoint Region::exact(std::size_t vertex) const {
  const plane::Index v = data_->walk().net.vertices().at(vertex);
  const exact::RealPoint p = data_->cells.geometry.exact(data_->cells.vertices[v].point);
  const exact::Real& step = data_->grid.step();
  return {Exact(std::make_shared<const Exact::Data>(Exact::Data{p.x * step})),
          Exact(std::make_shared<const Exact::Data>(Exact::Data{p.y * step}))};
}

std::optional<Region::Nearest> Region::nearest(const Position& to) const {
  if (empty()) return std::nullopt;
  if (contains(to)) return Nearest{to, 0, true};
  const exact::Real& step = data_->grid.step();
  const auto found = data_->answers().nearest({plane::decimal_of(to[0]) / step, plane::decimal_of(to[1]) / step});
  return Nearest{position(found->at, step), (found->distance * step).to_double(), found->attained};
}

std::optional<Position> Region::snapped(const Position& to, const Number& within) const {
  const exact::Real& step = data_->grid.step();
  const auto found = data_->answers().snapped({plane::decimal_of(to[0]) / step, plane::decimal_of(to[1]) / step},
                                              api::real_of(within) / step);
  return found ? std::optional(position(*found, step)) : std::nullopt;
}

std::optional<Position> Region::some() const {
  const auto found = api::position_in(data_->cells);
  return found ? std::optional(position(*found, data_->grid.step())) : std::nullopt;
}

std::optional<Bounds> Region::extent() const {
  const auto box = plane::extent(data_->cells);
  const double size = data_->grid.step_size();
  if (!box) return std::nullopt;
  return Bounds{{box->x0 * size, box->y0 * size}, {box->x1 * size, box->y1 * size}};
}

Region operator|(const Region& a, const Region& b) { return combined(a, b, plane::unite); }
Region operator&(const Region& a, const Region& b) { return combined(a, b, plane::intersect); }
Region operator-(const Region& a, const Region& b) { return combined(a, b, plane::subtract); }
Region Region::complement() const { return changed(*this, plane::complement); }
Region Region::interior() const { return changed(*this, plane::interior); }
Region Region::closure() const { return changed(*this, plane::closure); }
Region Region::boundary() const { return changed(*this, plane::boundary); }
Region Region::regularized() const { return changed(*this, plane::regularize); }

Region Region::offset(const Number& radius) const {
  const exact::Real amount = data_->grid.steps(api::real_of(radius));
  if (amount.sign() == 0) return *this;
  return api::make_region(plane::plain_offset(data_->cells, amount), data_->grid, data_->unit);
}

bool operator==(const Region& a, const Region& b) {
  if (a.data_ == b.data_) return true;
  same_grid(a, b);
  const plane::CellComplex* both[] = {&a.data().cells, &b.data().cells};
  return plane::is_empty(plane::overlay(both, [](std::span<const Mark> m) { return Mark(m[0] != m[1]); }));
}

int SignMap::sign(const Point& p) const {
  return plane::mark_of(data_->map, plane::locate(data_->map, steps(p, data_->grid)));
}

void SignMap::signs(std::span<const Position> positions, std::span<std::int8_t> out) const {
  if (out.size() != positions.size()) throw Error(ErrorCode::kBadValue, "as many answers as positions are given");
  data_->marks().each(positions, sign_of, out);
}

Region SignMap::where(bool negative, bool zero, bool positive) const {
  const auto wanted = [=](Mark m) { return Mark(m < 0 ? negative : m == 0 ? zero : positive); };
  return api::make_region(plane::remark(data_->map, wanted), data_->grid, data_->unit);
}

}  // namespace findspace
