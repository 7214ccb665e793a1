// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "io/board/board_graphics.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "plane/contour/contour.h"
#include "plane/contour/decimal_grid.h"

namespace findspace::io {

using exact::Real;
using plane::GridPoint;

namespace {

/// Exact along an axis; else the nearest double, since radii are rational.
Real length(const Real& dx, const Real& dy) {
  if (dx.sign() == 0 || dy.sign() == 0) return abs(dx) + abs(dy);
  return plane::decimal_of(std::hypot(dx.to_double(), dy.to_double()));
}

}  // namespace

void Extent::include(double x, double y) {
  if (empty()) {
    low[0] = high[0] = x;
    low[1] = high[1] = y;
    return;
  }
  low[0] = std::min(low[0], x);
  low[1] = std::min(low[1], y);
  high[0] = std::max(high[0], x);
  high[1] = std::max(high[1], y);
}

bool Graphics::add(const Sexpr& item, const Affine& map) {
  const std::string_view head = item.head();
  if (head.substr(0, 3) != "gr_" && head.substr(0, 3) != "fp_") return false;
  const std::string_view kind = head.substr(3);
  if (kind == "line") {
    segment(point(item.need("start"), map), point(item.need("end"), map));
  } else if (kind == "arc") {
    item.find("mid") ? arc(item, map) : arc_about(item, map);
  } else if (kind == "circle") {
    circle(item, map);
  } else if (kind == "rect") {
    rectangle(item, map);
  } else if (kind == "poly") {
    add_polygon(item, map);
  } else if (kind == "curve") {
    curve(item, map);
  } else {
    return false;
  }
  return true;
}

void Graphics::add_track(const Sexpr& item) {
  const Affine map;
  item.is("arc") ? arc(item, map) : segment(point(item.need("start"), map), point(item.need("end"), map));
}

GridPoint Graphics::point(const Sexpr& xy, const Affine& map) {
  const Real x = xy.item(0).number(), y = xy.item(1).number();
  return context_.grid.nearest(map.x_of(x, y), map.y_of(x, y), context_.rounding);
}

void Graphics::segment(GridPoint from, GridPoint to) {
  if (from != to) pieces_.push_back({Piece::Kind::kSegment, from, to, {}, {}, false, true});
}

void Graphics::arc(const Sexpr& item, const Affine& map) {
  Piece piece{Piece::Kind::kThrough, point(item.need("start"), map), point(item.need("end"), map),
              point(item.need("mid"), map)};
  if (piece.from == piece.to && piece.through == piece.from) return;
  pieces_.push_back(piece);
}

/// `start` is the centre, `end` where the arc begins, `angle` how far it goes from the x axis towards the y axis.
void Graphics::arc_about(const Sexpr& item, const Affine& map) {
  const Sexpr centre = item.need("start"), start = item.need("end");
  const Real cx = centre.item(0).number(), cy = centre.item(1).number();
  const Real dx = start.item(0).number() - cx, dy = start.item(1).number() - cy;
  const Real degrees = item.need("angle").item(0).number();
  const Real radius = length(dx, dy);
  if (radius.sign() == 0) item.fail(ErrorCode::kGeometry, "an arc of radius 0");
  if (compare(abs(degrees), Real(360)) >= 0) {
    circles_.push_back({map.x_of(cx, cy), map.y_of(cx, cy), radius});
    return;
  }
  if (degrees.sign() == 0) item.fail(ErrorCode::kGeometry, "an arc of angle 0");
  const Direction d = direction(degrees);
  const Real ex = cx + dx * d.cosine - dy * d.sine, ey = cy + dx * d.sine + dy * d.cosine;
  RoundingLog& log = context_.rounding;
  Piece piece;
  piece.kind = Piece::Kind::kRadius;
  piece.from = context_.grid.nearest(map.x_of(cx + dx, cy + dy), map.y_of(cx + dx, cy + dy), log);
  piece.to = context_.grid.nearest(map.x_of(ex, ey), map.y_of(ex, ey), log);
  piece.radius = radius;
  piece.large = compare(abs(degrees), Real(180)) > 0;
  piece.ccw = degrees.sign() > 0;
  const bool meets = std::abs(piece.from.x - piece.to.x) <= gap_ && std::abs(piece.from.y - piece.to.y) <= gap_;
  if (piece.large && meets)
    circles_.push_back({map.x_of(cx, cy), map.y_of(cx, cy), radius});  // its own ends are joined
  else if (piece.from != piece.to)
    pieces_.push_back(piece);
}

void Graphics::circle(const Sexpr& item, const Affine& map) {
  const Sexpr centre = item.need("center"), on = item.need("end");
  const Real x = centre.item(0).number(), y = centre.item(1).number();
  const Real dx = on.item(0).number() - x, dy = on.item(1).number() - y;
  const Real radius = length(dx, dy);
  if (radius.sign() == 0) item.fail(ErrorCode::kGeometry, "a circle of radius 0");
  circles_.push_back({map.x_of(x, y), map.y_of(x, y), radius});
}

void Graphics::rectangle(const Sexpr& item, const Affine& map) {
  if (const auto round = item.find("radius"); round && round->item(0).number().sign() != 0)
    round->fail(ErrorCode::kUnsupported, "a rectangle with round corners is not read");
  const Sexpr a = item.need("start"), b = item.need("end");
  const Real x[2] = {a.item(0).number(), b.item(0).number()}, y[2] = {a.item(1).number(), b.item(1).number()};
  GridPoint corner[4];
  for (int k = 0; k < 4; ++k) {
    const Real &px = x[k == 1 || k == 2 ? 1 : 0], &py = y[k / 2];
    corner[k] = context_.grid.nearest(map.x_of(px, py), map.y_of(px, py), context_.rounding);
  }
  for (int k = 0; k < 4; ++k) segment(corner[k], corner[(k + 1) % 4]);
}

void Graphics::add_polygon(const Sexpr& item, const Affine& map) {
  std::optional<GridPoint> first, last;
  const auto go_to = [&](GridPoint p) {
    if (last) segment(*last, p);
    if (!first) first = p;
    last = p;
  };
  item.need("pts").each([&](const Sexpr& vertex) {
    if (vertex.is("xy")) return go_to(point(vertex, map));
    if (!vertex.is("arc")) vertex.fail(ErrorCode::kSyntax, "(xy ...) or (arc ...) is meant here");
    go_to(point(vertex.need("start"), map));
    arc(vertex, map);
    last = point(vertex.need("end"), map);
  });
  if (last) segment(*last, *first);
}

/// By segments between points of the curve, at equal parameters. The chord of a parameter step h departs from the curve
/// by at most h^2 / 8 of the second derivative, which is 6 of the second differences of the control points.
void Graphics::curve(const Sexpr& item, const Affine& map) {
  std::vector<GridPoint> control;
  item.need("pts").each([&](const Sexpr& vertex) { control.push_back(point(vertex, map)); });
  if (control.size() != 4) item.fail(ErrorCode::kSyntax, "a Bézier curve has four control points");
  double bend = 0;
  for (std::size_t k = 0; k < 2; ++k)
    bend = std::max(bend, std::hypot(double(control[k].x) - 2 * double(control[k + 1].x) + double(control[k + 2].x),
                                     double(control[k].y) - 2 * double(control[k + 1].y) + double(control[k + 2].y)));
  constexpr double kMostSegments = 10000;
  const double count = std::ceil(std::sqrt(6 * bend / 8 / double(kCurve)));
  if (count > kMostSegments) item.fail(ErrorCode::kOutOfRange, "a Bézier curve longer than any board");
  const int segments = std::max(1, int(count));
  GridPoint last = control.front();
  for (int k = 1; k <= segments; ++k) {
    const double t = double(k) / segments, s = 1 - t;
    const double weight[4] = {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
    double x = 0, y = 0;
    for (std::size_t c = 0; c < 4; ++c) {
      x += weight[c] * double(control[c].x);
      y += weight[c] * double(control[c].y);
    }
    const GridPoint next = k == segments ? control.back() : GridPoint{std::llround(x), std::llround(y)};
    segment(last, next);
    last = next;
  }
  context_.notes.push_back(item.place());
}

Extent Graphics::extent() const {
  const double step = context_.grid.step_size();
  Extent out;
  const auto add = [&](double x, double y) { out.include(x * step, y * step); };
  for (const Piece& p : pieces_) {
    const double ax = double(p.from.x), ay = double(p.from.y), bx = double(p.to.x), by = double(p.to.y);
    add(ax, ay);
    add(bx, by);
    if (p.kind == Piece::Kind::kThrough) {  // the part of a circle beyond its chord lies about `through`
      const double r = std::max(std::hypot(double(p.through.x) - ax, double(p.through.y) - ay),
                                std::hypot(double(p.through.x) - bx, double(p.through.y) - by));
      add(double(p.through.x) - r, double(p.through.y) - r);
      add(double(p.through.x) + r, double(p.through.y) + r);
    } else if (p.kind == Piece::Kind::kRadius) {
      const double r = 2 * p.radius.to_double() / step;
      for (const double s : {-r, r}) add(ax + s, ay + s);
    }
  }
  for (const Circle& c : circles_) {
    const double x = c.x.to_double(), y = c.y.to_double(), r = c.radius.to_double();
    out.include(x - r, y - r);
    out.include(x + r, y + r);
  }
  return out;
}

/// A line or a circle that is drawn twice is one.
void Graphics::drop_doubles() {
  const auto key = [](const Piece& p) {
    const bool turned = p.to < p.from, about = p.kind == Piece::Kind::kRadius;
    const GridPoint through = p.kind == Piece::Kind::kThrough ? p.through : GridPoint{};
    return std::tuple(p.kind, turned ? p.to : p.from, turned ? p.from : p.to, through, p.radius, p.large,
                      about && p.ccw != turned);
  };
  std::set<decltype(key(pieces_[0]))> known;
  std::erase_if(pieces_, [&](const Piece& p) { return !known.insert(key(p)).second; });
  std::set<std::tuple<Real, Real, Real>> round;
  std::erase_if(circles_, [&](const Circle& c) { return !round.insert({c.x, c.y, c.radius}).second; });
}

/// Whether its own ends may be joined: it goes round something.
bool Graphics::may_close(const Piece& piece) const {
  if (piece.kind != Piece::Kind::kThrough) return false;
  return std::abs(piece.through.x - piece.from.x) > gap_ || std::abs(piece.through.y - piece.from.y) > gap_;
}

/// Pairs of ends that meet no other end, each with the nearest such end within the gap.
std::map<std::size_t, std::size_t> Graphics::partners() const {
  std::map<GridPoint, int> count;
  for (std::size_t k = 0; k < 2 * pieces_.size(); ++k) ++count[end(k)];
  std::vector<std::size_t> open;
  for (std::size_t k = 0; k < 2 * pieces_.size(); ++k)
    if (count[end(k)] == 1) open.push_back(k);
  std::map<std::size_t, std::size_t> out;
  for (std::size_t i = 0; i < open.size(); ++i) {
    if (out.count(open[i]) > 0) continue;
    std::size_t best = open[i];
    std::int64_t least = gap_ * gap_ + 1;
    for (std::size_t j = i + 1; j < open.size(); ++j) {
      if (open[i] / 2 == open[j] / 2 && !may_close(pieces_[open[i] / 2])) continue;
      const std::int64_t dx = end(open[j]).x - end(open[i]).x, dy = end(open[j]).y - end(open[i]).y;
      if (std::abs(dx) > gap_ || std::abs(dy) > gap_ || dx * dx + dy * dy >= least || out.count(open[j]) > 0) continue;
      best = open[j];
      least = dx * dx + dy * dy;
    }
    if (best == open[i]) continue;
    out[open[i]] = best;
    out[best] = open[i];
  }
  return out;
}

/// Moves ends onto their partners. Where an outline is followed from its first piece on, the end that is met first
/// stays: KiCad does so.
void Graphics::join_ends() {
  drop_doubles();
  const std::map<std::size_t, std::size_t> partner = partners();
  joined_ = static_cast<int>(partner.size() / 2);
  if (partner.empty()) return;
  std::multimap<GridPoint, std::size_t> at;
  for (std::size_t k = 0; k < 2 * pieces_.size(); ++k)
    if (partner.count(k) == 0) at.emplace(end(k), k);
  std::vector<bool> done(pieces_.size(), false), moved(2 * pieces_.size(), false);
  const auto next_of = [&](std::size_t k) -> std::optional<std::size_t> {
    if (const auto joined = partner.find(k); joined != partner.end()) return joined->second;
    const auto [low, high] = at.equal_range(end(k));
    const auto found = std::find_if(low, high, [&](const auto& other) { return !done[other.second / 2]; });
    return found == high ? std::nullopt : std::optional(found->second);
  };
  for (std::size_t first = 0; first < pieces_.size(); ++first) {
    std::optional<std::size_t> k = 2 * first + 1;
    while (k && !done[*k / 2]) {
      done[*k / 2] = true;
      const std::optional<std::size_t> next = next_of(*k);
      if (next && partner.count(*k) > 0 && !moved[*k]) {
        end(*next) = end(*k);
        moved[*next] = moved[*k] = true;
      }
      k = next ? std::optional(*next ^ 1) : std::nullopt;
    }
  }
  for (const auto& [a, b] : partner)
    if (!moved[a]) {
      end(b) = end(a);
      moved[b] = true;
    }
}

void Graphics::draw(const Piece& piece, Outline& outline) const {
  const Real& step = context_.grid.step();
  const auto at = [&](std::int64_t steps) { return Real(steps) * step; };
  outline.move_to(at(piece.from.x), at(piece.from.y));
  if (piece.kind == Piece::Kind::kSegment)
    outline.line_to(at(piece.to.x), at(piece.to.y));
  else if (piece.kind == Piece::Kind::kThrough)
    outline.through_to(at(piece.through.x), at(piece.through.y), at(piece.to.x), at(piece.to.y));
  else
    outline.arc_to(piece.radius, piece.large, piece.ccw, at(piece.to.x), at(piece.to.y));
  outline.finish();
}

Drawing Graphics::drawn() {
  Outline outline(context_);
  for (const Piece& p : pieces_) draw(p, outline);
  for (const Circle& c : circles_) outline.circle(c.x, c.y, c.radius);
  return outline.take();
}

plane::ShapePtr Graphics::filled(const std::string& place, bool area) {
  Drawing drawing = drawn();
  try {
    if (!area) {
      for (const Disc& d : std::exchange(drawing.discs, {})) {
        const auto radius = static_cast<std::int64_t>(std::llround(d.radius.to_double()));
        drawing.chains.push_back({plane::circle_ring(d.center, radius), true});
      }
      return lines_of(std::move(drawing), context_, place);
    }
    join_open_chains(drawing, context_.grid.step_size());
    return shape_of(std::move(drawing), context_, place);
  } catch (const Error& e) {
    throw e.within(place);
  }
}

plane::Contour Graphics::chain() {
  Drawing drawing = drawn();
  return drawing.chains.empty() ? plane::Contour{} : std::move(drawing.chains.front().edges);
}

std::optional<std::vector<plane::ShapePtr>> Graphics::closed(const std::string& place) {
  join_ends();
  Drawing drawing = drawn();
  try {
    join_open_chains(drawing, context_.grid.step_size());
    for (const Chain& chain : drawing.chains) {
      if (chain.closed) continue;
      open_end_ = chain.edges.front().start;
      return std::nullopt;
    }
    std::vector<plane::ShapePtr> parts = parts_of(std::move(drawing), context_, place);
    if (!parts.empty()) return parts;
    if (!pieces_.empty()) open_end_ = pieces_.front().from;  // nothing but pieces shorter than the gap
    return std::nullopt;
  } catch (const Error& e) {
    throw e.within(place);
  }
}

}  // namespace findspace::io
