// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "distance/rays/protrusion_end.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "exact/margins/space_distance.h"

namespace findspace::distance {

namespace {

using space::Vector;

constexpr int kMostEndSteps = 10;
/// Of each kind, those that are least fulfilled.
constexpr std::size_t kMostRows = 6;

/// What a step (of x, and of the place) has to fulfil: factors . step >= least.
struct EndRow {
  std::array<double, 4> factors;
  double least;
};
using EndStep = std::array<double, 4>;
/// Where four rows are equalities.
struct EndCorner {
  EndStep step;
  EndStep inward{};  // from there: distances grow by 1, and the planes hold
};

double value_of(const EndRow& row, const EndStep& step) {
  double sum = -row.least;
  for (std::size_t c = 0; c < 4; ++c) sum += row.factors[c] * step[c];
  return sum;
}

/// Of which the first are distances.
std::optional<EndCorner> corner_of(const std::array<const EndRow*, 4>& rows, std::size_t distances) {
  double m[4][6];
  for (std::size_t r = 0; r < 4; ++r) {
    for (std::size_t c = 0; c < 4; ++c) m[r][c] = rows[r]->factors[c];
    m[r][4] = rows[r]->least;
    m[r][5] = r < distances ? 1 : 0;
  }
  for (std::size_t c = 0; c < 4; ++c) {
    std::size_t top = c;
    for (std::size_t r = c + 1; r < 4; ++r) {
      if (std::fabs(m[r][c]) > std::fabs(m[top][c])) top = r;
    }
    if (std::fabs(m[top][c]) < margin::kEndPivot) return std::nullopt;
    std::swap(m[top], m[c]);
    for (std::size_t r = 0; r < 4; ++r) {
      if (r == c) continue;
      const double factor = m[r][c] / m[c][c];
      for (std::size_t k = c; k < 6; ++k) m[r][k] -= factor * m[c][k];
    }
  }
  EndCorner out{};
  for (std::size_t c = 0; c < 4; ++c) {
    out.step[c] = m[c][4] / m[c][c];
    out.inward[c] = m[c][5] / m[c][c];
  }
  return out;
}

void keep_least_fulfilled(std::vector<EndRow>& rows) {
  std::sort(rows.begin(), rows.end(), [](const EndRow& a, const EndRow& b) { return a.least > b.least; });
  const auto same = [](const EndRow& a, const EndRow& b) {
    double apart = 0;
    for (std::size_t c = 0; c < 4; ++c) apart += std::fabs(a.factors[c] - b.factors[c]);
    return apart < margin::kEndPivot;
  };
  std::vector<EndRow> kept;
  for (const EndRow& row : rows) {
    if (kept.size() == kMostRows) break;
    if (std::none_of(kept.begin(), kept.end(), [&](const EndRow& k) { return same(k, row); })) kept.push_back(row);
  }
  rows = std::move(kept);
}

class OutermostPlace {
 public:
  OutermostPlace(const EndField& a, const EndQuestion& q) : a_(a), q_(q) {}

  std::optional<EndPlace> run(const Vector& x, double at) {
    double reach = q_.reach;
    EndPlace out{x, at, {}, 0};
    for (int count = 0; count < kMostEndSteps; ++count) {
      std::vector<EndRow> distances = distance_rows(out.x, reach), planes = plane_rows(out.x, out.at, reach);
      const std::optional<EndCorner> next = best(distances, planes, reach);
      if (!next) return count > 0 ? std::optional(out) : std::nullopt;
      const EndStep &step = next->step, &inward = next->inward;
      out = {space::plus(out.x, {step[0], step[1], step[2]}),
             out.at + step[3],
             {inward[0], inward[1], inward[2]},
             inward[3]};
      double length = 0;
      for (const double c : step) length = std::max(length, std::fabs(c));
      if (length <= q_.noise) break;
      // What was near then may be so again, but no farther steps are expected.
      reach = std::clamp(4 * length, 1024 * q_.noise, reach);  // no sign: what is looked at
    }
    return out;
  }

 private:
  std::vector<EndRow> distance_rows(const Vector& x, double reach) const {
    std::vector<EndRow> out;
    for (const Tangent& t : a_.tangents(x, q_.target - reach, q_.target + reach))
      out.push_back({{t.slope.x, t.slope.y, t.slope.z, 0}, q_.target - t.value});
    keep_least_fulfilled(out);
    return out;
  }

  std::vector<EndRow> plane_rows(const Vector& x, double at, double reach) const {
    std::vector<EndRow> out;
    const Vector off = x - space::plus(q_.start, space::scaled(at, q_.unit));
    for (const NearPlane& p : q_.planes) {
      const double beyond = p.approx_value(off) + q_.room;
      if (beyond < -reach) continue;
      out.push_back({{-p.unit.x, -p.unit.y, -p.unit.z, space::dot(p.unit, q_.unit)}, beyond});
    }
    keep_least_fulfilled(out);
    return out;
  }

  /// The corner of the rows that is farthest along the way, in reach.
  std::optional<EndCorner> best(const std::vector<EndRow>& distances, const std::vector<EndRow>& planes, double reach) {
    std::vector<const EndRow*> rows;
    for (const EndRow& r : distances) rows.push_back(&r);
    for (const EndRow& r : planes) rows.push_back(&r);
    const std::size_t n = rows.size();
    std::optional<EndCorner> found;
    const auto offer = [&](std::size_t a, std::size_t b, std::size_t c, std::size_t d) {
      if (a >= distances.size() || d < distances.size()) return;  // one of each kind
      const std::size_t of_distances = b >= distances.size() ? 1 : c >= distances.size() ? 2 : 3;
      const std::optional<EndCorner> corner = corner_of({rows[a], rows[b], rows[c], rows[d]}, of_distances);
      if (!corner) return;
      const EndStep& step = corner->step;
      if (found && !((step[3] - found->step[3]) * q_.way > 0)) return;
      for (const double s : step) {
        if (!(std::fabs(s) <= 4 * reach)) return;
      }
      const double tolerance = margin::kEndPivot * reach;
      if (std::all_of(rows.begin(), rows.end(), [&](const EndRow* r) { return value_of(*r, step) >= -tolerance; }))
        found = corner;
    };
    for (std::size_t a = 0; a < n; ++a) {
      for (std::size_t b = a + 1; b < n; ++b) {
        for (std::size_t c = b + 1; c < n; ++c) {
          for (std::size_t d = c + 1; d < n; ++d) offer(a, b, c, d);
        }
      }
    }
    return found;
  }

  const EndField& a_;
  const EndQuestion& q_;
};

}  // namespace

std::optional<EndPlace> outermost_place(const EndField& a, const EndQuestion& q, Vector x, double at) {
  return OutermostPlace(a, q).run(x, at);
}

}  // namespace findspace::distance
