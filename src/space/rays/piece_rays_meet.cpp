// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include <algorithm>
#include <cmath>

#include "exact/margins/rounding.h"
#include "space/rays/oblique_line.h"
#include "space/rays/piece_rays.h"

namespace findspace::space {
namespace {

using exact::Approx;
using exact::Real;

const Real& least(const Real& a, const Real& b) { return b < a ? b : a; }
const Real& most(const Real& a, const Real& b) { return a < b ? b : a; }
/// The smaller of two numbers lies between the smaller lower and the smaller upper bounds.
Approx least(const Approx& a, const Approx& b) {
  const Approx& c = b.value < a.value ? b : a;
  const double low = std::min(a.lo(), b.lo());
  return {c.value, std::max(c.error, (c.value - low) * Approx::kGrow)};
}
Approx most(const Approx& a, const Approx& b) { return -least(-a, -b); }

int certain_sign(const Real& r) { return r.sign(); }
/// 2: not certain.
int certain_sign(const Approx& a) { return a.certain() ? a.sign() : 2; }

/// By doubles alone.
bool surely_less(const Approx& a, const Approx& b) { return b.value - a.value > (a.error + b.error) * 2; }
bool surely_less(const Real&, const Real&) { return false; }

Approx rounded_number(const Real& r) {
  const double v = r.to_double();
  return {v, std::fabs(v) * margin::kRoundings4};
}

}  // namespace

/// A vector by its components across the lines and, last, along them.
std::array<Real, 3> PieceRays::components(const RealVector& v) const {
  if (grid_.oblique) {
    const std::array<RealVector, 3>& frame = grid_.oblique->frame;
    return {dot(frame[0], v), dot(frame[1], v), dot(frame[2], v)};
  }
  const auto axis = static_cast<std::size_t>(grid_.axis);
  return {v[(axis + 1) % 3], v[(axis + 2) % 3], v[axis]};
}

PieceRays::Lines PieceRays::find_lines(const RayGrid& grid, const Vector& low, const Vector& high, std::int64_t scale) {
  if (grid.oblique) return grid.oblique->may_meet(low, high, static_cast<double>(scale)) ? Lines{0, 0, 0, 0} : Lines{};
  const double parts = static_cast<double>(grid.parts) / static_cast<double>(scale);
  const auto lines = [&](int axis, std::int64_t start, std::int64_t step, int count, int& first, int& last) {
    const double from = static_cast<double>(start), width = static_cast<double>(step);
    // By less than this doubles are off.
    const double blur = margin::kRoundings8 * (std::fabs(from) / width + count + 1);
    const auto at = [&](double c) { return std::clamp((c * parts - from) / width, -1.0, static_cast<double>(count)); };
    first = std::max(0, static_cast<int>(std::ceil(at(component(low, axis)) - blur)));
    last = std::min(count - 1, static_cast<int>(std::floor(at(component(high, axis)) + blur)));
  };
  Lines out;
  lines((grid.axis + 1) % 3, grid.u, grid.du, grid.nu, out.first_column, out.last_column);
  lines((grid.axis + 2) % 3, grid.v, grid.dv, grid.nv, out.first_row, out.last_row);
  return out;
}

bool PieceRays::any_line(const RayGrid& grid, const Vector& low, const Vector& high, std::int64_t scale) {
  return !find_lines(grid, low, high, scale).none();
}

PieceRays::Piece PieceRays::aligned(const LinePiece& from, std::int64_t scale) const {
  Piece piece;
  piece.lines = find_lines(grid_, from.low, from.high, scale);
  if (piece.lines.none()) {
    piece.lines = {};
    return piece;
  }
  const double parts = static_cast<double>(grid_.parts) / static_cast<double>(scale);
  piece.low = grid_.oblique ? -exact::kInfinity : component(from.low, grid_.axis) * parts;
  piece.high = grid_.oblique ? exact::kInfinity : component(from.high, grid_.axis) * parts;
  const RealVector origin = grid_.oblique ? scaled(Real(scale), grid_.oblique->origin) : RealVector{};
  const Real unit = Real::ratio(grid_.parts, scale);
  for (const HalfSpace& h : from.planes) {
    const std::array<Real, 3> normal = components(h.normal);
    piece.exact.planes.push_back(
        {normal[0], normal[1], normal[2], (grid_.oblique ? h.value(origin) : h.offset) * unit});
    piece.rise.push_back(static_cast<std::int8_t>(normal[2].sign()));
  }
  piece.held = from.held;
  piece.round = from.round;
  piece.held_round = from.held_round;
  piece.cylinder = from.round && !is_zero(from.direction);
  const Real radius = from.radius * unit;
  piece.exact.square = radius * radius;
  piece.exact.length = dot(from.direction, from.direction);
  piece.exact.base = components(grid_.oblique ? minus(from.base, origin) : from.base);
  for (Real& c : piece.exact.base) c *= unit;
  piece.exact.direction = components(from.direction);
  piece.upright = piece.exact.direction[0].sign() == 0 && piece.exact.direction[1].sign() == 0;
  for (const auto& p : piece.exact.planes)
    piece.near.planes.push_back(
        {rounded_number(p[0]), rounded_number(p[1]), rounded_number(p[2]), rounded_number(p[3])});
  for (std::size_t k = 0; k < 3; ++k) {
    piece.near.base[k] = rounded_number(piece.exact.base[k]);
    piece.near.direction[k] = rounded_number(piece.exact.direction[k]);
  }
  piece.near.length = rounded_number(piece.exact.length);
  piece.near.square = rounded_number(piece.exact.square);
  return piece;
}

template <class T>
void PieceRays::meet_round(const Piece& piece, const Aligned<T>& d, const T& x, const T& y, Span<T>& span) {
  const T u = x - d.base[0], v = y - d.base[1];
  T a, b{}, c;  // a z^2 - 2 b z + c <= 0, z from the base
  if (piece.cylinder) {
    const T along = u * d.direction[0] + v * d.direction[1];
    a = d.direction[0] * d.direction[0] + d.direction[1] * d.direction[1];
    b = along * d.direction[2];
    c = d.length * (u * u + v * v - d.square) - along * along;
  } else {
    a = T{};
    c = u * u + v * v - d.square;
  }
  const Meets at_radius = piece.held_round ? Meets::kInside : Meets::kTouch;
  if (piece.cylinder && piece.upright) {
    const int outside = certain_sign(u * u + v * v - d.square);
    span.meets = outside == 2  ? Meets::kUnresolved
                 : outside > 0 ? Meets::kNothing
                 : outside < 0 ? Meets::kInside
                               : at_radius;
    return;
  }
  const T discriminant = piece.cylinder ? b * b - a * c : -c;
  const int real = certain_sign(discriminant);
  if (real == 2 || real < 0) {
    span.meets = real == 2 ? Meets::kUnresolved : Meets::kNothing;
    return;
  }
  const T root = sqrt(discriminant);
  span.meets = real == 0 ? at_radius : Meets::kInside;
  span.low = {true, piece.held_round, (piece.cylinder ? (b - root) / a : -root) + d.base[2]};
  span.high = {true, piece.held_round, (piece.cylinder ? (b + root) / a : root) + d.base[2]};
}

/// What a plane leaves of a line up to (`side` 1) or from (-1) a place. False if it is not certain which of two planes
/// decides whether the end is held.
template <class T>
bool PieceRays::narrow(Bound<T>& end, const T& at, int side, bool holds, bool any_held) {
  if (!end.bounded) {
    end = {true, holds, at};
    return true;
  }
  if (any_held) {
    const int order = certain_sign(at - end.at);
    if (order == 2 && end.held != holds) return false;
    if (order == 0) end.held = end.held && holds;
    if (order == -side) end.held = holds;
  }
  end.at = side > 0 ? least(end.at, at) : most(end.at, at);
  return true;
}

template <class T>
PieceRays::Span<T> PieceRays::meet(const Piece& piece, const Aligned<T>& d, const T& x, const T& y) {
  Span<T> span;
  span.meets = Meets::kInside;
  if (piece.round) meet_round(piece, d, x, y, span);
  const bool any_held = !piece.held.empty() || piece.held_round;
  for (std::size_t k = 0; k < d.planes.size(); ++k) {
    if (span.meets == Meets::kNothing || span.meets == Meets::kUnresolved) return span;
    const auto& n = d.planes[k];
    const T value = n[0] * x + n[1] * y + n[3];
    const bool holds = !piece.held.empty() && piece.held[k] != 0;
    if (piece.rise[k] == 0) {
      const int outside = certain_sign(value);
      if (outside == 2) span.meets = Meets::kUnresolved;
      if (outside == 1) span.meets = Meets::kNothing;
      if (outside == 0 && !holds) span.meets = Meets::kTouch;
      continue;
    }
    const int side = piece.rise[k] > 0 ? 1 : -1;
    if (!narrow(side > 0 ? span.high : span.low, T(-value / n[2]), side, holds, any_held))
      span.meets = Meets::kUnresolved;
    if (span.low.bounded && span.high.bounded && surely_less(span.high.at, span.low.at)) span.meets = Meets::kNothing;
  }
  if (span.meets == Meets::kNothing || span.meets == Meets::kUnresolved || !span.low.bounded || !span.high.bounded)
    return span;
  const int width = certain_sign(span.high.at - span.low.at);
  if (width == 2) span.meets = Meets::kUnresolved;
  if (width == 0 && !(span.low.held && span.high.held)) span.meets = Meets::kTouch;
  if (width == -1) span.meets = Meets::kNothing;
  return span;
}

PieceRays::Span<Real> PieceRays::meet_exactly(int piece, int i, int j) const {
  const Piece& p = pieces_[static_cast<std::size_t>(piece)];
  return meet<Real>(p, p.exact, Real(grid_.u_at(i)), Real(grid_.v_at(j)));
}

/// False if the line misses the piece.
bool PieceRays::stretch(int piece, int i, int j, Stretch& out) const {
  const Piece& p = pieces_[static_cast<std::size_t>(piece)];
  const Lines& lines = p.lines;
  if (i < lines.first_column || i > lines.last_column || j < lines.first_row || j > lines.last_row) return false;
  const Approx x{static_cast<double>(grid_.u_at(i)), 0}, y{static_cast<double>(grid_.v_at(j)), 0};
  Span<Approx> span = meet<Approx>(p, p.near, x, y);
  if (span.meets == Meets::kUnresolved) {
    const Span<Real> sure = meet_exactly(piece, i, j);
    const auto rounded = [](const Bound<Real>& b) {
      return Bound<Approx>{b.bounded, b.held, b.bounded ? rounded_number(b.at) : Approx{}};
    };
    span = {sure.meets, rounded(sure.low), rounded(sure.high)};
  }
  if (span.meets == Meets::kNothing) return false;
  const auto end = [&](const Bound<Approx>& b, std::int8_t which) {
    return b.bounded ? End{b.at.value, b.at.error, piece, which, b.held}
                     : End{which == 0 ? -exact::kInfinity : exact::kInfinity, 0, -1, 0};
  };
  out = {end(span.low, 0), end(span.high, 1), span.meets == Meets::kInside, piece};
  return true;
}

Real PieceRays::root(int patch, int which, int i, int j) const {
  const Span<Real> span = meet_exactly(patch, i, j);
  return which == 0 ? span.low.at : span.high.at;
}

}  // namespace findspace::space
