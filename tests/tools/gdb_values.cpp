// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Values for tools/gdb/findspace_printers.py. A line `/// NAME = TEXT` says what gdb prints for NAME, or for an
// expression without blanks; tests/tools/gdb_printers.py stops in `look` and compares.
#include <array>
#include <vector>

#include "exact/number/interval.h"
#include "exact/number/polynomial_root.h"
#include "exact/number/real_node.h"
#include "exact/number/wide_int.h"
#include "exact/planar/geometry_signs.h"
#include "exact/planar/offset_points.h"
#include "formula/language/parse.h"
#include "plane/complex/cell_complex.h"
#include "plane/complex/primitives.h"
#include "plane/contour/shape.h"
#include "space/body/body.h"
#include "space/box/box_complex.h"

namespace {

using namespace findspace;
using exact::Real;

// Where gdb stops, with all values of the caller in reach.
[[gnu::noinline]] void look() { asm volatile(""); }

void numbers() {
  // So that the debug information has these types where src/exact is compiled without.
  [[maybe_unused]] const exact::detail::QuadraticNode* quadratic_node = nullptr;
  [[maybe_unused]] const exact::detail::OperationNode* operation_node = nullptr;
  [[maybe_unused]] const exact::detail::RootNode* root_node = nullptr;
  /// zero = 0
  const Real zero;
  /// half = -1/2 ~ -0.5
  const Real half = Real::ratio(-1, 2);
  /// large = 170141183460469231731687303715884105727000000
  const Real large = Real::parse_decimal("170141183460469231731687303715884105727e6");
  /// golden = (1+sqrt(5))/2 ~ 1.618033989
  const Real golden = (Real(1) + sqrt(Real(5))) / Real(2);
  /// root = -3*sqrt(2) ~ -4.242640687
  const Real root = Real(-3) * sqrt(Real(2));
  /// graph = (sqrt(2)+sqrt(3))*sqrt(1+sqrt(5))-1/7 ~ 5.51698124
  const Real graph = (sqrt(Real(2)) + sqrt(Real(3))) * sqrt(Real(1) + sqrt(Real(5))) - Real::ratio(1, 7);
  /// cubic = root of [-2, 0, 0, 1] ~ 1.25992105
  const Real cubic = exact::roots_between({-2, 0, 0, 1}, 0, 2).front();
  /// wide = -1208925819614629174706176
  [[maybe_unused]] const exact::Int256 wide = exact::multiply(exact::int128(1) << 79, -2);
  /// enclosure = [0.5, 2]
  [[maybe_unused]] const exact::Interval enclosure{0.5, 2};
  look();
}

void plane_values() {
  exact::Geometry geometry;
  const auto line = geometry.add_line(3, -1, 5),
             circle = geometry.add(exact::SupportingCurve::circle_at(1, 0, sqrt(Real(2))));
  exact::add_displaced(geometry, exact::SupportingCurve::line(3, -1, 5), exact::Displacement(Real::ratio(1, 2)));
  geometry.add_grid_point(2, 1);
  geometry.add_real_point(sqrt(Real(2)), 1);
  geometry.add_crossing(line, circle, meet(geometry, line, circle).root[0]);
  /// geometry = 3 supporting_curves, 3 points, 1 of them real
  /// geometry.supporting_curves._M_impl._M_start[0] = line 3*x - y = 5
  /// geometry.supporting_curves._M_impl._M_start[1] = circle about (1, 0), radius sqrt(2)
  /// geometry.supporting_curves._M_impl._M_start[2] = line 3*x - y = 5, moved by 1/2
  /// geometry.points._M_impl._M_start[0] = (2, 1)
  /// geometry.points._M_impl._M_start[1] = real 0 ~ (1.414213562, 1)
  /// geometry.points._M_impl._M_start[2] = supporting_curves 0 and 1 meet, root -1, ~ (2, 1)
  /// geometry.reals._M_impl._M_start[0] = (sqrt(2), 1)
  /// ring[0] = segment from (0, 0)
  const plane::Contour contour{{{0, 0}}, {{8, 0}}, {{8, 6}}, {{0, 6}}};
  const plane::ContourEdge* ring = contour.data();
  /// start = (8, 6)
  [[maybe_unused]] const plane::GridPoint start = ring[2].start;
  /// square = 4 vertices, 4 edges, 2 faces in [0, 8] x [0, 6]; mark 0: 1 face; mark 1: 4 vertices, 4 edges, 1 face
  const plane::Region square = plane::region_of_rings({&contour, 1});
  /// disc = 2 vertices, 2 edges, 2 faces in [-1, 5] x [0, 6]; mark 0: 1 face; mark 1: 2 vertices, 2 edges, 1 face
  const plane::Region disc = plane::region_of_disc(2, 3, 3);
  /// everywhere = 0 vertices, 0 edges, 1 face; mark -1: 1 face
  const plane::SignMap everywhere = plane::CellComplex::uniform(-1);
  plane::Shape shape;
  shape.kind = plane::Shape::Kind::kDisc;
  shape.name = "hole";
  shape.points = {{1, 2}};
  shape.amount = 7;
  /// shape = Disc 'hole' about (1, 2), radius 7
  /// rings = Rings of 1 contour
  plane::Shape rings;
  rings.kind = plane::Shape::Kind::kRings;
  rings.contours = {contour};
  look();
}

void space_values() {
  /// corner = (1, -2, 3)
  const space::Point corner{1, -2, 3};
  /// near = (0.5, 0, -1)
  [[maybe_unused]] const space::Vector near{0.5, 0, -1};
  /// place = (1/2, sqrt(2), 0)
  const space::RealVector place{Real::ratio(1, 2), sqrt(Real(2)), 0};
  /// facet = 2*x - z - 12 = 0
  const space::Plane facet{{2, 0, -1}, -12};
  /// half_space = (2, 0, -1) . x + -12 <= 0
  const space::HalfSpace half_space(facet);
  const std::array<space::Point, 4> corners{{{0, 0, 0}, {4, 0, 0}, {0, 5, 0}, {0, 0, 6}}};
  /// tetrahedron = 4 vertices, 4 facets in [0, 4] x [0, 5] x [0, 6]
  const space::Polytope tetrahedron = space::Polytope::hull(corners);
  space::Body body;
  body.parts.push_back(space::part_of(corners, 2));
  body.parts.push_back(space::part_of({&corner, 1}, 3));
  /// body = 2 parts at scale 1
  /// body.parts._M_impl._M_start[0] = 4 vertices, 4 facets in [0, 4] x [0, 5] x [0, 6], grown by 2
  /// body.parts._M_impl._M_start[1] = ball about (1, -2, 3), radius 3
  const std::array<space::IntervalBox, 1> box{{{{{0, 1, true, true}, {0, 2, true, true}, {-1, 3, true, true}}}}};
  /// boxes = 2 x 2 x 2 coordinates in [0, 1] x [0, 2] x [-1, 3]; mark 0: 98 cells, mark 1: 27 cells
  const space::BoxComplex boxes = space::BoxComplex::of_boxes(box);
  look();
}

void formula_values() {
  /// formula = gamma1(B, A) >= 1/2 and not (eta1(B, A+C) < 0 or gamma1(B, C, along=(1, 0)) != 3)
  /// formula.content_._M_ptr->root = atom 0 and not (atom 1 or atom 2)
  /// formula.content_._M_ptr->atoms._M_impl._M_start[0] = gamma1(B, A) >= 1/2
  /// formula.content_._M_ptr->atoms._M_impl._M_start[1].distance = eta1(B, A+C)
  /// formula.content_._M_ptr->sign_maps._M_impl._M_start[0] = sign of gamma1(B, A) - 1/2
  const formula::Formula formula =
      formula::parse_formula("gamma1(B, A) >= 0.5 and not (eta1(B, A+C) < 0 or gamma1(B, C, along=(1, 0)) != 3)",
                             {.shapes = {"A", "B", "C"}, .moving = {"B"}, .extra = {}, .unit = {}});
  /// least = gamma1(B, A) -> min
  const formula::Formula least =
      formula::parse_formula("gamma1(B, A) -> min", {.shapes = {"A", "B"}, .moving = {"B"}, .extra = {}, .unit = {}});
  look();
}

}  // namespace

int main() {
  numbers();
  plane_values();
  space_values();
  formula_values();
}
