// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/rays/corner_rays.h"

#include <algorithm>
#include <optional>

#include "exact/margins/rounding.h"
#include "space/rays/piece_rays.h"

namespace findspace::distance {

namespace {

using exact::Real;
using exact::Tried;
using space::Point;
using space::RayEvent;
using space::RayGrid;
using space::RayPosition;
using space::RayRow;

class StretchesOfSource : public LineStretches {
 public:
  explicit StretchesOfSource(space::RaySourcePointer source) : source_(std::move(source)) {}
  Tried<RayRow> try_row(int j, const RayRow* within) const override {
    Tried<RayRow> row = source_->try_row(j);
    if (!row || !within) return row;
    const std::array<RayRow, 2> both{*within, *std::move(row)};
    return space::combined(both, [](std::span<const std::int8_t> s) { return std::max(s[0], s[1]); });
  }

 private:
  space::RaySourcePointer source_;
};

/// An end of a stretch, and the corner that it is the end of. Of ends at one place that of the first corner counts.
struct CornerEnd {
  RayPosition at;
  int corner = -1;
};
struct CornerStretch {
  CornerEnd from, to;
};

std::vector<CornerStretch> of_one_corner(const RayRow& row, int i, int corner) {
  std::vector<CornerStretch> out;
  for (const EventStretch& s : stretches_on(row, i)) out.push_back({{s.first->at, corner}, {s.last->at, corner}});
  return out;
}

/// The first of two ends by their order, times `sense`.
const CornerEnd& nearer_end(const CornerEnd& a, const CornerEnd& b, int sense) {
  const int order = compare_positions(a.at, b.at) * sense;
  return order != 0 ? (order < 0 ? a : b) : a.corner <= b.corner ? a : b;
}

/// What two lists of disjoint stretches have in common, in order.
std::vector<CornerStretch> common(const std::vector<CornerStretch>& a, const std::vector<CornerStretch>& b) {
  std::vector<CornerStretch> out;
  for (std::size_t k = 0, m = 0; k < a.size() && m < b.size();) {
    const CornerEnd &from = nearer_end(a[k].from, b[m].from, -1), &to = nearer_end(a[k].to, b[m].to, 1);
    if (compare_positions(from.at, to.at) <= 0) out.push_back({from, to});
    const int order = compare_positions(a[k].to.at, b[m].to.at);
    if (order <= 0) ++k;
    if (order >= 0) ++m;
  }
  return out;
}

class CornerRays : public LineStretches {
 public:
  CornerRays(std::vector<Point> corners, const std::vector<space::RaySolid>& solids, const Real& level,
             const RayGrid& grid, std::function<bool(const space::Extent&)> certain)
      : grid_(grid), certain_(std::move(certain)), corners_(std::move(corners)) {
    std::vector<std::shared_ptr<const space::BallSurface>> surfaces;
    for (const space::RaySolid& s : solids) {
      if (!s.ball())
        surfaces.push_back(
            std::make_shared<const space::BallSurface>(s.surface, level, grid, space::BallSurface::Side::kSolid));
    }
    for (const Point& v : corners_) {
      Sources& made = sources_.emplace_back();
      for (const auto& surface : surfaces)
        made.surfaces.push_back(std::make_unique<const space::BallRays>(surface, v, grid));
      std::vector<space::LinePiece> balls;
      for (const space::RaySolid& s : solids) {
        if (s.ball()) balls.push_back(space::ball_piece(space::real(s.center - v), s.radius + level));
      }
      if (!balls.empty()) made.balls = std::make_unique<const space::PieceRays>(balls, 1, grid);
    }
    put_outer_first();
  }

  Tried<RayRow> try_row(int j, const RayRow* within) const override {
    std::vector<int> order = order_;
    std::vector<std::optional<RayRow>> balls(sources_.size());  // rows of those that were asked
    RayRow out;
    for (int i = 0; i < grid_.nu; ++i) {
      std::vector<CornerStretch> left;
      if (within) left = of_one_corner(*within, i, -1);
      bool all = !within;  // nothing was cut away yet
      for (std::size_t k = 0; k < order.size() && (all || !left.empty()); ++k) {
        const int corner = order[k];
        if (!all && stays_within(corner, i, j, left)) continue;
        const std::vector<CornerStretch> more = of_corner(corner, i, j, balls[static_cast<std::size_t>(corner)]);
        left = all ? more : common(left, more);
        all = false;
        if (left.empty())
          std::rotate(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(k),
                      order.begin() + static_cast<std::ptrdiff_t>(k) + 1);
      }
      put(left, out);
    }
    return out;
  }

 private:
  struct Sources {
    std::vector<std::unique_ptr<const space::BallRays>> surfaces;
    std::unique_ptr<const space::PieceRays> balls;
  };

  /// They cut away most.
  void put_outer_first() {
    space::Extent box = space::everywhere();
    std::swap(box.low, box.high);
    for (const Point& v : corners_) box.add({exact::approx(v), exact::approx(v)});
    const auto out = [middle = box.middle(), this](int k) {
      return space::length(exact::approx(corners_[static_cast<std::size_t>(k)]) - middle);
    };
    for (std::size_t k = 0; k < corners_.size(); ++k) order_.push_back(static_cast<int>(k));
    std::stable_sort(order_.begin(), order_.end(), [&](int a, int b) { return out(a) > out(b); });
  }

  /// Whether the corner is certainly within the level all along the stretches.
  bool stays_within(int corner, int i, int j, const std::vector<CornerStretch>& stretches) const {
    if (grid_.oblique) return false;
    const auto axis = static_cast<std::size_t>(grid_.axis);
    const double parts = static_cast<double>(grid_.parts);
    const space::Vector v = exact::approx(corners_[static_cast<std::size_t>(corner)]);
    return std::all_of(stretches.begin(), stretches.end(), [&](const CornerStretch& s) {
      std::array<double, 3> low{}, high{};
      low[(axis + 1) % 3] = high[(axis + 1) % 3] = static_cast<double>(grid_.u_at(i)) / parts;
      low[(axis + 2) % 3] = high[(axis + 2) % 3] = static_cast<double>(grid_.v_at(j)) / parts;
      low[axis] = (s.from.at.value - s.from.at.radius) / parts;
      high[axis] = (s.to.at.value + s.to.at.radius) / parts;
      return certain_({space::plus(v, {low[0], low[1], low[2]}), space::plus(v, {high[0], high[1], high[2]})});
    });
  }

  std::vector<CornerStretch> of_corner(int corner, int i, int j, std::optional<RayRow>& balls) const {
    const Sources& of = sources_[static_cast<std::size_t>(corner)];
    if (!of.balls && of.surfaces.size() == 1) return of_one_corner(of.surfaces[0]->line(i, j), 0, corner);
    std::vector<RayRow> rows;
    for (const auto& s : of.surfaces) rows.push_back(s->line(i, j));
    if (of.balls) {
      if (!balls) balls = of.balls->row(j);
      const auto line = static_cast<std::size_t>(i);
      RayRow& one = rows.emplace_back();
      one.before.push_back(balls->before[line]);
      one.events.assign(balls->events.begin() + balls->first[line], balls->events.begin() + balls->first[line + 1]);
      one.first.push_back(static_cast<int>(one.events.size()));
    }
    const RayRow least =
        space::combined(rows, [](std::span<const std::int8_t> s) { return *std::min_element(s.begin(), s.end()); });
    return of_one_corner(least, 0, corner);
  }

  static void put(const std::vector<CornerStretch>& stretches, RayRow& out) {
    out.before.push_back(1);
    for (const CornerStretch& s : stretches) {
      if (compare_positions(s.from.at, s.to.at) == 0) {
        out.events.push_back({nearer_end(s.from, s.to, 1).at, 0, 1});
        continue;
      }
      out.events.push_back({s.from.at, 0, -1});
      out.events.push_back({s.to.at, 0, 1});
    }
    out.first.push_back(static_cast<int>(out.events.size()));
  }

  RayGrid grid_;
  std::function<bool(const space::Extent&)> certain_;
  std::vector<Point> corners_;
  std::vector<int> order_;
  std::vector<Sources> sources_;
};

}  // namespace

std::vector<EventStretch> stretches_on(const RayRow& row, int i) {
  std::vector<EventStretch> out;
  bool open = false;
  for (int e = row.first[static_cast<std::size_t>(i)]; e < row.first[static_cast<std::size_t>(i) + 1]; ++e) {
    const RayEvent& event = row.events[static_cast<std::size_t>(e)];
    if (!open && event.here > 0) continue;
    if (!open) out.push_back({&event, &event});
    open = event.after <= 0;
    out.back().last = &event;
  }
  return out;
}

std::unique_ptr<LineStretches> stretches_of(space::RaySourcePointer source) {
  return std::make_unique<StretchesOfSource>(std::move(source));
}

std::unique_ptr<LineStretches> corner_stretches(std::vector<Point> corners, const std::vector<space::RaySolid>& solids,
                                                const Real& level, const RayGrid& grid,
                                                std::function<bool(const space::Extent&)> certain) {
  return std::make_unique<CornerRays>(std::move(corners), solids, level, grid, std::move(certain));
}

}  // namespace findspace::distance
