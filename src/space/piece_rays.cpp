// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/piece_rays.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "space/oblique_line.h"

namespace findspace::space {
namespace {

using exact::Approx;
using exact::Real;

constexpr double kFar = std::numeric_limits<double>::infinity();

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

Approx rounded_number(const Real& r) {
  const double v = r.to_double();
  return {v, std::fabs(v) * 0x1p-51};
}

double component(const Vector& v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

}  // namespace

PieceRays::PieceRays(const std::vector<LinePiece>& pieces, std::int64_t scale, const RayGrid& grid, Of of)
    : grid_(grid), of_(of) {
  for (const LinePiece& p : pieces) pieces_.push_back(turned(p, scale));
  first_.assign(static_cast<std::size_t>(grid.nv) + 1, 0);
  for (const Piece& p : pieces_) {
    for (int j = p.first_row; j <= p.last_row; ++j) ++first_[static_cast<std::size_t>(j) + 1];
  }
  for (int j = 0; j < grid.nv; ++j) first_[static_cast<std::size_t>(j) + 1] += first_[static_cast<std::size_t>(j)];
  of_row_.resize(first_.back());
  std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
  for (std::size_t k = 0; k < pieces_.size(); ++k) {
    for (int j = pieces_[k].first_row; j <= pieces_[k].last_row; ++j)
      of_row_[next[static_cast<std::size_t>(j)]++] = static_cast<int>(k);
  }
}

/// A vector by its components across the lines and, last, along them.
std::array<Real, 3> PieceRays::components(const RealVector& v) const {
  if (grid_.oblique) {
    const std::array<RealVector, 3>& frame = grid_.oblique->frame;
    return {dot(frame[0], v), dot(frame[1], v), dot(frame[2], v)};
  }
  const auto axis = static_cast<std::size_t>(grid_.axis);
  return {v[(axis + 1) % 3], v[(axis + 2) % 3], v[axis]};
}

/// False if no line meets it.
bool PieceRays::find_lines(const LinePiece& from, std::int64_t scale, Piece& piece) const {
  if (grid_.oblique) {
    if (!grid_.oblique->may_meet(from.low, from.high, static_cast<double>(scale))) return false;
    piece.last_column = piece.last_row = 0;
    return true;
  }
  const double parts = static_cast<double>(grid_.parts) / static_cast<double>(scale);
  const auto lines = [&](int axis, std::int64_t start, std::int64_t step, int count, int& first, int& last) {
    const auto at = [&](double c) {
      return std::clamp((c * parts - static_cast<double>(start)) / static_cast<double>(step), -1.0,
                        static_cast<double>(count));
    };
    first = std::max(0, static_cast<int>(std::floor(at(component(from.low, axis)))));
    last = std::min(count - 1, static_cast<int>(std::ceil(at(component(from.high, axis)))));
  };
  lines((grid_.axis + 1) % 3, grid_.u, grid_.du, grid_.nu, piece.first_column, piece.last_column);
  lines((grid_.axis + 2) % 3, grid_.v, grid_.dv, grid_.nv, piece.first_row, piece.last_row);
  return piece.first_column <= piece.last_column && piece.first_row <= piece.last_row;
}

PieceRays::Piece PieceRays::turned(const LinePiece& from, std::int64_t scale) const {
  Piece piece;
  if (!find_lines(from, scale, piece)) return piece;
  const RealVector origin = grid_.oblique ? scaled(Real(scale), grid_.oblique->origin) : RealVector{};
  const Real unit = Real::ratio(grid_.parts, scale);
  for (const HalfSpace& h : from.planes) {
    const std::array<Real, 3> normal = components(h.normal);
    piece.exact.planes.push_back(
        {normal[0], normal[1], normal[2], (grid_.oblique ? h.value(origin) : h.offset) * unit});
    piece.rise.push_back(static_cast<std::int8_t>(normal[2].sign()));
  }
  piece.round = from.round;
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
void PieceRays::meet_round(const Piece& piece, const Turned<T>& d, const T& x, const T& y, Span<T>& span) {
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
  if (piece.cylinder && piece.upright) {
    const int outside = certain_sign(u * u + v * v - d.square);
    span.meets = outside == 2  ? Meets::kUnsure
                 : outside > 0 ? Meets::kNothing
                 : outside < 0 ? Meets::kInside
                               : Meets::kTouch;
    return;
  }
  const T discriminant = piece.cylinder ? b * b - a * c : -c;
  const int real = certain_sign(discriminant);
  if (real == 2 || real < 0) {
    span.meets = real == 2 ? Meets::kUnsure : Meets::kNothing;
    return;
  }
  const T root = sqrt(discriminant);
  span.meets = real == 0 ? Meets::kTouch : Meets::kInside;
  span.bounded_low = span.bounded_high = true;
  span.low = (piece.cylinder ? (b - root) / a : -root) + d.base[2];
  span.high = (piece.cylinder ? (b + root) / a : root) + d.base[2];
}

template <class T>
PieceRays::Span<T> PieceRays::meet(const Piece& piece, const Turned<T>& d, const T& x, const T& y) {
  Span<T> span;
  span.meets = Meets::kInside;
  if (piece.round) meet_round(piece, d, x, y, span);
  for (std::size_t k = 0; k < d.planes.size(); ++k) {
    if (span.meets == Meets::kNothing || span.meets == Meets::kUnsure) return span;
    const auto& n = d.planes[k];
    const T value = n[0] * x + n[1] * y + n[3];
    if (piece.rise[k] == 0) {
      const int outside = certain_sign(value);
      if (outside == 2) span.meets = Meets::kUnsure;
      if (outside == 1) span.meets = Meets::kNothing;
      if (outside == 0) span.meets = Meets::kTouch;
      continue;
    }
    const T at = -value / n[2];
    if (piece.rise[k] > 0) {
      span.high = span.bounded_high ? least(span.high, at) : at;
      span.bounded_high = true;
    } else {
      span.low = span.bounded_low ? most(span.low, at) : at;
      span.bounded_low = true;
    }
  }
  if (span.meets == Meets::kNothing || span.meets == Meets::kUnsure || !span.bounded_low || !span.bounded_high)
    return span;
  const int width = certain_sign(span.high - span.low);
  if (width == 2) span.meets = Meets::kUnsure;
  if (width == 0) span.meets = Meets::kTouch;
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
  if (i < p.first_column || i > p.last_column || j < p.first_row || j > p.last_row) return false;
  const Approx x{static_cast<double>(grid_.u_at(i)), 0}, y{static_cast<double>(grid_.v_at(j)), 0};
  Span<Approx> span = meet<Approx>(p, p.near, x, y);
  if (span.meets == Meets::kUnsure) {
    const Span<Real> sure = meet_exactly(piece, i, j);
    span.meets = sure.meets;
    span.bounded_low = sure.bounded_low, span.bounded_high = sure.bounded_high;
    if (sure.meets != Meets::kNothing) span.low = rounded_number(sure.low), span.high = rounded_number(sure.high);
  }
  if (span.meets == Meets::kNothing) return false;
  out.low = span.bounded_low ? End{span.low.value, span.low.error, piece, 0} : End{-kFar, 0, -1, 0};
  out.high = span.bounded_high ? End{span.high.value, span.high.error, piece, 1} : End{kFar, 0, -1, 0};
  out.inside = span.meets == Meets::kInside;
  return true;
}

Real PieceRays::root(int patch, int which, int i, int j) const {
  const Span<Real> span = meet_exactly(patch, i, j);
  return which == 0 ? span.low : span.high;
}

int PieceRays::compare_ends(const End& a, const End& b, int i, int j) const {
  const double gap = a.value - b.value, blur = (a.error + b.error) * 2;
  if (a.piece < 0 || b.piece < 0) return a.value < b.value ? -1 : a.value > b.value ? 1 : 0;
  if (gap > blur) return 1;
  if (gap < -blur) return -1;
  if (a.piece == b.piece && a.which == b.which) return 0;
  return exact::compare(root(a.piece, a.which, i, j), root(b.piece, b.which, i, j));
}

RayPosition PieceRays::position(const End& e, int i, int j) const {
  RayPosition at;
  at.value = e.value, at.radius = e.error;
  at.roots = this;
  at.patch = e.piece, at.which = e.which;
  at.i = i, at.j = j;
  return at;
}

/// Disjoint, in order: of the closed stretches, or of the open ones of those with an inside.
std::vector<PieceRays::Stretch> PieceRays::united(std::vector<Stretch> all, bool open, int i, int j) const {
  if (open) std::erase_if(all, [](const Stretch& s) { return !s.inside; });
  std::stable_sort(all.begin(), all.end(),
                   [&](const Stretch& a, const Stretch& b) { return compare_ends(a.low, b.low, i, j) < 0; });
  std::vector<Stretch> out;
  for (const Stretch& s : all) {
    const int gap = out.empty() ? 1 : compare_ends(s.low, out.back().high, i, j);
    if (open ? gap >= 0 : gap > 0)
      out.push_back(s);
    else if (compare_ends(s.high, out.back().high, i, j) > 0)
      out.back().high = s.high;
  }
  return out;
}

std::vector<PieceRays::Stretch> PieceRays::common(const std::vector<Stretch>& all, bool open, int i, int j) const {
  if (all.size() < pieces_.size()) return {};
  Stretch both{{-kFar, 0, -1, 0}, {kFar, 0, -1, 0}, true};
  for (const Stretch& s : all) {
    if (open && !s.inside) return {};
    if (compare_ends(s.low, both.low, i, j) > 0) both.low = s.low;
    if (compare_ends(s.high, both.high, i, j) < 0) both.high = s.high;
  }
  const int width = compare_ends(both.high, both.low, i, j);
  if (width < 0 || (open && width == 0)) return {};
  return {both};
}

void PieceRays::put(const std::vector<Stretch>& stretches, bool open, int i, int j, RayRow& row) const {
  const auto in = static_cast<std::int8_t>(-1), out = static_cast<std::int8_t>(1), at_end = open ? out : in;
  row.before.push_back(!stretches.empty() && stretches[0].low.piece < 0 ? in : out);
  for (std::size_t k = 0; k < stretches.size(); ++k) {
    const Stretch& s = stretches[k];
    // Open stretches may meet in a place that neither holds, closed ones may be a single place.
    const bool meets_before = k > 0 && compare_ends(s.low, stretches[k - 1].high, i, j) == 0;
    if (s.low.piece >= 0 && !meets_before) row.events.push_back({position(s.low, i, j), at_end, in});
    if (s.high.piece < 0) continue;
    if (compare_ends(s.low, s.high, i, j) == 0) {
      row.events.back().after = out;
      continue;
    }
    const bool meets_next = k + 1 < stretches.size() && compare_ends(s.high, stretches[k + 1].low, i, j) == 0;
    row.events.push_back({position(s.high, i, j), at_end, meets_next ? in : out});
  }
  row.first.push_back(static_cast<int>(row.events.size()));
}

RayRow PieceRays::row(int j) const {
  std::array<RayRow, 2> rows;  // the open set, the closed one
  std::vector<Stretch> all;
  for (int i = 0; i < grid_.nu; ++i) {
    all.clear();
    for (std::size_t k = first_[static_cast<std::size_t>(j)]; k < first_[static_cast<std::size_t>(j) + 1]; ++k) {
      Stretch s;
      if (stretch(of_row_[k], i, j, s)) all.push_back(s);
    }
    for (const bool open : {true, false})
      put(of_ == Of::kUnion ? united(all, open, i, j) : common(all, open, i, j), open, i, j, rows[open ? 0 : 1]);
  }
  return combined(rows, [](std::span<const std::int8_t> s) {
    return static_cast<std::int8_t>(s[0] < 0 ? -1 : s[1] < 0 ? 0 : 1);
  });
}

}  // namespace findspace::space
