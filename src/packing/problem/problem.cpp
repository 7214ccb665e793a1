// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "packing/problem/problem.h"

#include <findspace/error.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numbers>

#include "packing/problem/round_part.h"

namespace findspace::packing {
namespace {

double twice_area(const Ring& ring) {
  double sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const LatticePoint p = ring[i] - ring[0], q = ring[(i + 1) % ring.size()] - ring[0];
    sum += double(p.x) * double(q.y) - double(p.y) * double(q.x);
  }
  return sum;
}

/// The area of a shape where x <= most: the integral of min(x, most) dy along its rings.
double area_left_of(const Polygon& shape, double most) {
  double sum = 0;
  for (const Ring& ring : shape.rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const LatticePoint &p = ring[i], &q = ring[(i + 1) % ring.size()];
      const double u = double(p.x) - most, v = double(q.x) - most;  // the mean of min(., 0) from u to v
      const double low = std::min(u, v), high = std::max(u, v);
      const double mean = high <= 0 ? (u + v) / 2 : low >= 0 ? 0 : -low * low / (high - low) / 2;
      sum += (mean + most) * (double(q.y) - double(p.y));
    }
  }
  return sum;
}

double area_left_of(const Sheet& sheet, double most) {
  return sheet.round ? sheet.round->area_left_of(most) : area_left_of(sheet.shape, most);
}

/// +1 where the ring runs counter-clockwise: the turn at its lowest, leftmost vertex.
int direction(const Ring& ring) {
  const auto less = [](const LatticePoint& p, const LatticePoint& q) { return p.y != q.y ? p.y < q.y : p.x < q.x; };
  const std::size_t n = ring.size(), low = std::size_t(std::min_element(ring.begin(), ring.end(), less) - ring.begin());
  return exact::turn_sign(ring[(low + n - 1) % n], ring[low], ring[(low + 1) % n]);
}

void drop_repeated(Ring& ring) {
  ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
  while (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
}

/// Vertices amid a straight line go, so that the turn at every vertex is one.
void drop_straight(Ring& ring) {
  for (std::size_t i = 0; i < ring.size() && ring.size() > 2;) {
    const std::size_t n = ring.size();
    const LatticePoint &p = ring[(i + n - 1) % n], &q = ring[i], &r = ring[(i + 1) % n];
    const bool straight = exact::turn_sign(p, q, r) == 0 && exact::dot_sign(q - p, r - q) > 0;
    if (straight)
      ring.erase(ring.begin() + std::ptrdiff_t(i));
    else
      ++i;
  }
}

bool edges_meet(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c, const LatticePoint& d) {
  const int s = exact::turn_sign(a, b, c), t = exact::turn_sign(a, b, d);
  const int u = exact::turn_sign(c, d, a), v = exact::turn_sign(c, d, b);
  if (s * t < 0 && u * v < 0) return true;
  return (s == 0 && exact::is_between(a, b, c)) || (t == 0 && exact::is_between(a, b, d)) ||
         (u == 0 && exact::is_between(c, d, a)) || (v == 0 && exact::is_between(c, d, b));
}

/// The points of the error are grid steps: one corner, or where two edges start.
void check_simple(const Ring& ring, const std::string& place) {
  const std::size_t n = ring.size();
  const auto fail = [&](const char* why, std::initializer_list<LatticePoint> corners) {
    Error error(ErrorCode::kGeometry, why, place);
    for (const LatticePoint& p : corners) error.at(double(p.x), double(p.y));
    throw error;
  };
  if (n < 3) fail("an outline has fewer than three corners", {});
  for (std::size_t i = 0; i < n; ++i) {
    const LatticePoint& corner = ring[(i + 1) % n];
    if (exact::turn_sign(ring[i], corner, ring[(i + 2) % n]) == 0) fail("an outline turns back on itself", {corner});
    for (std::size_t j = i + 2; j < n; ++j)
      if ((j + 1) % n != i && edges_meet(ring[i], ring[i + 1], ring[j], ring[(j + 1) % n]))
        fail("an outline meets itself", {ring[i], ring[j]});
  }
}

LatticePoint quarter_turns(const LatticePoint& p, int quarters) {
  switch (quarters) {
    case 1:
      return {-p.y, p.x};
    case 2:
      return {-p.x, -p.y};
    case 3:
      return {p.y, -p.x};
    default:
      return p;
  }
}

LatticePoint rotated(const LatticePoint& p, const Fraction& angle) {
  const int128 d = angle.denominator();
  if (is_quarter(angle)) return quarter_turns(p, int((angle.numerator() / 90 % 4 + 4) % 4));
  const int128 rest = angle.numerator() % (360 * d);
  const long double radians =
      static_cast<long double>(rest) / static_cast<long double>(d) / 180 * std::numbers::pi_v<long double>;
  const long double c = std::cos(radians), s = std::sin(radians), x = static_cast<long double>(p.x),
                    y = static_cast<long double>(p.y);
  return {int128(std::round(c * x - s * y)), int128(std::round(s * x + c * y))};
}

/// From above -180 to 180 degrees.
Fraction within_half_turn(const Fraction& angle) {
  const int128 turn = 360 * angle.denominator();
  int128 rest = angle.numerator() % turn;
  if (rest <= -turn / 2) rest += turn;
  if (rest > turn / 2) rest -= turn;
  return Fraction(rest, angle.denominator());
}

}  // namespace

Part::Off Part::nearest_angle(const Fraction& angle) const {
  Off best{0, Fraction(360)};
  for (std::size_t k = 0; k < angles.size(); ++k) {
    const Fraction by = within_half_turn(angle - angles[k]);
    if (std::max(by, Fraction() - by) < std::max(best.by, Fraction() - best.by)) best = {k, by};
  }
  return best;
}

bool Part::allows(const Fraction& angle, bool is_mirrored) const {
  const Fraction by = nearest_angle(angle).by;
  return (mirrored || !is_mirrored) && by <= tilt && Fraction() - by <= tilt;
}

bool Problem::has_round_parts() const {
  const auto is_round = [](const auto& one) { return one.round != nullptr; };
  const auto has_round = [&](const Sheet& sheet) {
    return is_round(sheet) || std::any_of(sheet.zones.begin(), sheet.zones.end(), is_round);
  };
  return std::any_of(parts.begin(), parts.end(), is_round) || std::any_of(sheets.begin(), sheets.end(), has_round);
}

int Problem::free_copies(std::size_t part) const {
  const auto of_part = [&](const FixedPart& f) { return f.placed.part == part; };
  return parts[part].demand - int(std::count_if(fixed.begin(), fixed.end(), of_part));
}

std::size_t sheets_with_fixed(const Problem& problem, std::size_t kind) {
  std::size_t count = 0;
  for (const FixedPart& f : problem.fixed)
    if (f.kind == kind) count = std::max(count, f.placed.sheet + 1);
  return problem.on_sheets() ? count : 0;
}

bool is_fixed_part(const Layout& layout, const Placed& item, const FixedPart& fixed) {
  const Placed& p = fixed.placed;
  if (item.part != p.part || item.mirrored != p.mirrored || item.x != p.x || item.y != p.y) return false;
  if (within_half_turn(item.angle - p.angle) != 0) return false;
  if (layout.sheets.empty()) return item.sheet == 0;
  if (item.sheet >= layout.sheets.size() || layout.sheets[item.sheet] != fixed.kind) return false;
  const auto here = layout.sheets.begin() + std::ptrdiff_t(item.sheet);
  return std::size_t(std::count(layout.sheets.begin(), here, fixed.kind)) == p.sheet;
}

namespace {

Part still(Polygon shape) {
  Part part;
  part.shape = std::move(shape);
  return part;
}

Part still(const std::shared_ptr<const RoundPart>& round) {
  Part part = still(round->at(0, false).about);
  part.round = round;
  return part;
}

/// All about an outline, up to more than the edge beyond a box.
Part frame_about(const Problem& problem, const Ring& outline, const LatticeBox& box) {
  Polygon frame = box_about(problem, box);
  frame.rings.emplace_back(outline.rbegin(), outline.rend());
  return still(std::move(frame));
}

void add_holes(const Polygon& shape, std::vector<Part>& result) {
  for (std::size_t hole = 1; hole < shape.rings.size(); ++hole)
    result.push_back(still({{Ring(shape.rings[hole].rbegin(), shape.rings[hole].rend())}}));
}

}  // namespace

Polygon box_about(const Problem& problem, const LatticeBox& box) {
  const int128 out = bounded_product(problem.steps(), int128(std::ceil(problem.edge.to_double())) + 1);
  return {{{{box.low.x - out, box.low.y - out},
            {box.high.x + out, box.low.y - out},
            {box.high.x + out, box.high.y + out},
            {box.low.x - out, box.high.y + out}}}};
}

LatticeBox box_of(const Sheet& sheet) { return sheet.round ? sheet.round->at(0, false).box : box_of(sheet.shape); }

std::vector<Part> walls_of(const Problem& problem, const Sheet& sheet, const Zone& zone) {
  if (zone.round) return {still(zone.holds ? zone.about : zone.round)};
  if (!zone.holds) return {still(zone.shape)};
  std::vector<Part> result{frame_about(problem, zone.shape.rings[0], box_of(sheet))};
  add_holes(zone.shape, result);
  return result;
}

std::vector<Part> obstacles_of(const Problem& problem, const Sheet& sheet) {
  if (sheet.about) return {still(sheet.about)};
  std::vector<Part> result;
  const LatticeBox box = box_of(sheet.shape);
  const Ring& outline = sheet.shape.rings[0];
  const Ring corners{box.low, {box.high.x, box.low.y}, box.high, {box.low.x, box.high.y}};
  const auto is_corner = [&](const LatticePoint& p) { return std::count(corners.begin(), corners.end(), p) > 0; };
  if (outline.size() != 4 || !std::all_of(outline.begin(), outline.end(), is_corner)) {
    result.push_back(frame_about(problem, outline, box));
  }
  add_holes(sheet.shape, result);
  return result;
}

std::size_t Problem::items() const {
  std::size_t count = 0;
  for (const Part& part : parts) count += std::size_t(part.demand);
  return count;
}

Polygon make_polygon(std::vector<Ring> rings, const std::string& place) {
  for (std::size_t i = 0; i < rings.size(); ++i) {
    drop_repeated(rings[i]);
    drop_straight(rings[i]);
    check_simple(rings[i], place);
    if (direction(rings[i]) != (i == 0 ? 1 : -1)) std::reverse(rings[i].begin(), rings[i].end());
  }
  if (rings.empty()) throw Error(ErrorCode::kGeometry, "a part without an outline", place);
  return {std::move(rings)};
}

LatticeBox box_of(const Polygon& shape) {
  LatticeBox box{shape.rings[0][0], shape.rings[0][0]};
  for (const LatticePoint& p : shape.rings[0]) {
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
  }
  return box;
}

bool is_quarter(const Fraction& angle) { return angle.denominator() == 1 && angle.numerator() % 90 == 0; }

Polygon rotated(const Polygon& shape, const Fraction& angle, bool mirrored) {
  Polygon result = shape;
  for (Ring& ring : result.rings) {
    for (LatticePoint& p : ring) p = rotated(LatticePoint{mirrored ? -p.x : p.x, p.y}, angle);
    if (mirrored) std::reverse(ring.begin(), ring.end());
  }
  return result;
}

Polygon rotated(const Part& part, const Fraction& angle, bool mirrored) {
  return part.round ? part.round->at(angle, mirrored).about : rotated(part.shape, angle, mirrored);
}

LatticeBox box_of(const Part& part, const Fraction& angle, bool mirrored) {
  return part.round ? part.round->at(angle, mirrored).box : box_of(rotated(part.shape, angle, mirrored));
}

double twice_area(const Sheet& sheet) { return sheet.round ? sheet.round->twice_area() : twice_area(sheet.shape); }

double twice_area(const Part& part) { return part.round ? part.round->twice_area() : twice_area(part.shape); }

double twice_area(const Polygon& shape) {
  double sum = 0;
  for (const Ring& ring : shape.rings) sum += twice_area(ring);
  return sum;
}

double area(const Problem& problem) {
  double sum = 0;
  const double steps = double(problem.steps());
  for (const Part& part : problem.parts) sum += part.demand * (twice_area(part) / 2 / steps / steps);
  return sum;
}

double area(const Problem& problem, const Layout& layout) {
  double sum = 0;
  const double steps = double(problem.steps());
  for (const Placed& item : layout.items) sum += twice_area(problem.parts[item.part]) / 2 / steps / steps;
  return sum;
}

Fraction top_of(const Problem& problem, const Layout& layout) {
  Fraction top = 0;
  for (const Placed& item : layout.items) {
    const LatticeBox box = box_of(problem.parts[item.part], item.angle, item.mirrored);
    top = std::max(top, item.y + Fraction(box.high.y, problem.steps()) + problem.edge);
  }
  return top;
}

double container_area(const Problem& problem, const Layout& layout) {
  if (!problem.on_sheets()) return height_of(problem, layout).to_double() * layout.length.to_double();
  const double steps = double(problem.steps());
  double sum = 0;
  for (std::size_t k = 0; k < layout.sheets.size(); ++k) {
    const Sheet& sheet = problem.sheets[layout.sheets[k]];
    const bool last = k + 1 == layout.sheets.size();
    sum += (last ? area_left_of(sheet, layout.length.to_double() * steps) : twice_area(sheet) / 2) / steps / steps;
  }
  return sum;
}

}  // namespace findspace::packing
