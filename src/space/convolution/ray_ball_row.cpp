// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/convolution/ray_ball_row.h"

#include <algorithm>
#include <cmath>

#include "exact/margins/rounding.h"
#include "exact/margins/space.h"
#include "space/convolution/ray_convolution.h"

namespace findspace::space {

using exact::Approx;
using exact::Real;

RayRow BallRow::run(int first, int last) {
  left_ = first;
  right_ = last;
  collect();
  RayRow row;
  for (int i = first; i <= last; ++i) {
    if (unresolved_[i - first] || !emit_certain(i, row)) emit_exact(i, row);
  }
  return row;
}

void BallRow::collect() {
  const int columns = right_ - left_ + 1;
  unresolved_.assign(columns, 0);
  of_.each_at(static_cast<double>(rays_.v_at(j_)), [&](int patch) {
    const auto [from, to] = rays_.columns(of_.patches_[patch], left_, right_);
    for (int i = from; i <= to; ++i) {
      if (!unresolved_[i - left_] && !add_hits(patch, i)) unresolved_[i - left_] = 1;
    }
  });
  first_.assign(columns + 1, 0);
  for (const Hit& h : hits_) ++first_[h.column - left_ + 1];
  for (int i = 0; i < columns; ++i) first_[i + 1] += first_[i];
  std::vector<int> next(first_.begin(), first_.end() - 1);
  sorted_.resize(hits_.size());
  for (const Hit& h : hits_) sorted_[next[h.column - left_]++] = h;
}

/// False where doubles cannot tell whether the line meets the patch.
bool BallRow::add_hits(int patch, int column) {
  const Patch& p = of_.patches_[patch];
  const Approx radius{of_.rounded_radius_, of_.rounded_radius_ * Approx::kUnit};
  const BallPatchMeets<Approx> meets = meet<Approx>(p, radius, column);
  const auto base_z = static_cast<double>(base_height(p));
  for (int k = 0; k < meets.count; ++k) {
    if (meets.where[k] < 0) continue;
    if (meets.where[k] == 0 || !std::isfinite(meets.height[k].error)) return false;
    const Approx at = meets.height[k] + Approx{base_z, 0};
    int jump = 0;  // of the winding number: less the weight where the line leaves outward
    if (p.kind == Kind::kFace) {
      jump = of_.body_.normals[p.feature].z > 0 ? -1 : 1;
    } else {
      int weight = p.kind == Kind::kEdge ? of_.body_.edges[p.feature].bend : 0;
      if (p.kind == Kind::kVertex && !vertex_index(p, column, meets.height[k], weight)) return false;
      if (weight == 0) continue;
      jump = k == 1 ? -weight : weight;
    }
    hits_.push_back({at.value, at.error, column, patch, static_cast<std::int8_t>(k), jump});
  }
  return true;
}

bool BallRow::vertex_index(const Patch& p, int column, const Approx& height, int& index) const {
  const RayVertex& v = of_.body_.vertices[p.feature];
  const Point& at = of_.body_.points[v.point];
  const double x = static_cast<double>(rays_.u_at(column) - at.x), y = static_cast<double>(rays_.v_at(j_) - at.y);
  int changes = 0, first = 0, last = 0;
  for (int k = 0; k < v.count; ++k) {
    const Approx3 e = exact::approx(of_.body_.points[of_.body_.corners[v.first + k].to] - at);
    const double value = x * e.x + y * e.y + height.value * e.z;
    const double size = std::fabs(x * e.x) + std::fabs(y * e.y) + std::fabs(height.value * e.z);
    // Room for the roundings here, and for the direction rounded to 2^40 parts of the radius below.
    const double tolerance =
        height.error * std::fabs(e.z) + margin::kRoundings8 * size +
        margin::kRoundedDirection * of_.rounded_radius_ * (std::fabs(e.x) + std::fabs(e.y) + std::fabs(e.z));
    if (!(std::fabs(value) > tolerance)) return false;
    const int s = value > 0 ? 1 : -1;
    changes += k > 0 && s != last;
    if (k == 0) first = s;
    last = s;
  }
  changes += first != last;
  index = 0;
  if (changes == 2) return true;
  const double scale = margin::kDirectionParts / of_.rounded_radius_;
  const Wide3 n{static_cast<int128>(x * scale), static_cast<int128>(y * scale),
                static_cast<int128>(height.value * scale)};
  index = local_index(of_.body_, v, n, exact::approx(n), 1);
  return true;
}

RayPosition BallRow::position(const Hit& h) const {
  RayPosition at;
  at.value = h.at;
  at.radius = h.error;
  at.roots = &rays_;
  at.patch = h.patch;
  at.i = h.column;
  at.j = j_;
  at.which = h.which;
  return at;
}

int BallRow::against_radius(int column, double z) const {
  ++rays_.cell_tests_;
  return compare(column, z, 0, [&] { return Real::from_double(z); });
}

void BallRow::push(RayRow& row, const RayPosition& at, int before, int here, int after) const {
  const int sense = of_.complement_ ? -1 : 1;
  if (here == before && after == before) return;
  row.events.push_back({at, static_cast<std::int8_t>(sense * here), static_cast<std::int8_t>(sense * after)});
}

/// False, with nothing written, where the order of the places is not certain.
bool BallRow::emit_certain(int column, RayRow& row) {
  const auto begin = sorted_.begin() + first_[column - left_], end = sorted_.begin() + first_[column - left_ + 1];
  std::sort(begin, end, [](const Hit& a, const Hit& b) { return a.at != b.at ? a.at < b.at : a.patch < b.patch; });
  for (auto h = begin; h != end && h + 1 != end; ++h) {
    if (!((h + 1)->at - h->at > ((h + 1)->error + h->error) * 2)) return false;
  }
  const int outside = of_.complement_ ? -1 : 1;
  int winding = of_.complement_ ? 1 : 0, before = outside;
  row.before.push_back(static_cast<std::int8_t>(of_.complement_ ? -outside : outside));
  for (auto h = begin; h != end; ++h) {
    winding += h->jump;
    int after = -1;
    if (h + 1 == end) {
      after = outside;
    } else if (winding == 0) {
      after = against_radius(column, h->at + ((h + 1)->at - h->at) / 2) < 0 ? -1 : 1;
    }
    push(row, position(*h), before, before < 0 && after < 0 ? -1 : 0, after);
    before = after;
  }
  row.first.push_back(static_cast<int>(row.events.size()));
  return true;
}

/// Whether a place on the line at least the radius away from the surface is in the solid: a sum over the faces above.
int BallRow::inside(int column, double at) const {
  const double z = lifted(at);
  const std::int64_t x = rays_.u_at(column), y = rays_.v_at(j_);
  int sum = of_.complement_ ? 1 : 0;
  const GridBox above{{x, y, static_cast<std::int64_t>(std::floor(z)) - 1}, {x, y, of_.body_.high.z}};
  of_.distance_->tree().any_meeting(above, [&](int f) {
    const Point &a = of_.body_.corner(f, 0), &b = of_.body_.corner(f, 1), &c = of_.body_.corner(f, 2);
    const Wide3& n = of_.body_.normals[f];
    const int look = exact::sign(n.z);
    if (look == 0 || exact::sign_turn_displaced(a, b, x, y) != look || exact::sign_turn_displaced(b, c, x, y) != look ||
        exact::sign_turn_displaced(c, a, x, y) != look)
      return false;
    const int128 top = n.x * (a.x - x) + n.y * (a.y - y);
    const exact::Fraction height{n.z > 0 ? top : -top, n.z > 0 ? n.z : -n.z};
    if (static_cast<double>(a.z) + exact::to_double(height) > z) sum += look;
    return false;
  });
  return sum;
}

void BallRow::emit_exact(int column, RayRow& row) {
  ++rays_.exact_lines_;
  struct Place {
    Hit hit;
    Real z;
  };
  std::vector<Place> places;
  of_.each_at(static_cast<double>(rays_.v_at(j_)), [&](int patch) {
    const Patch& p = of_.patches_[patch];
    const auto [from, to] = rays_.columns(p, column, column);
    if (from > to) return;
    const auto meets = meet<Real>(p, of_.radius_, column);
    for (int m = 0; m < meets.count; ++m) {
      if (meets.where[m] < 0) continue;
      const Real z = meets.height[m] + Real(base_height(p));
      const double at = z.to_double();
      places.push_back(
          {{at, margin::kRoundings8 * (std::fabs(at) + 1), column, patch, static_cast<std::int8_t>(m), 0}, z});
    }
  });
  std::sort(places.begin(), places.end(), [](const Place& a, const Place& b) {
    const int order = exact::compare(a.z, b.z);
    return order != 0 ? order < 0 : a.hit.patch < b.hit.patch;
  });
  places.erase(std::unique(places.begin(), places.end(), [](const Place& a, const Place& b) { return a.z == b.z; }),
               places.end());
  const auto sign_at = [&](const Real& z) {
    const double at = z.to_double();
    const int s = compare(column, at, margin::kRoundings8 * (std::fabs(at) + 1), [&] { return z; });
    return s >= 0 && inside(column, at) > 0 ? -1 : s;
  };
  const int outside = of_.complement_ ? -1 : 1;
  int before = outside;
  row.before.push_back(static_cast<std::int8_t>(of_.complement_ ? -outside : outside));
  for (std::size_t k = 0; k < places.size(); ++k) {
    const int after = k + 1 == places.size() ? outside : sign_at((places[k].z + places[k + 1].z) / Real(2));
    const int here = before * after < 0 ? 0 : sign_at(places[k].z);
    push(row, position(places[k].hit), before, here, after);
    before = after;
  }
  row.first.push_back(static_cast<int>(row.events.size()));
}

}  // namespace findspace::space
