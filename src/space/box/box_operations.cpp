// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "space/box/box_operations.h"

#include <algorithm>

namespace findspace::space {

using exact::Real;

namespace {

/// The same marks on a grid with more coordinates.
BoxComplex refined(const BoxComplex& set, const Axes& more) {
  Axes at = set.at();
  std::array<std::vector<int>, 3> old;
  for (int k = 0; k < 3; ++k) {
    at[k].insert(at[k].end(), more[k].begin(), more[k].end());
    sort_axis(at[k]);
  }
  BoxComplex out(at);
  if (out.too_fine()) return out;
  for (int k = 0; k < 3; ++k) {
    // A new coordinate lies in some old cell; an open interval lies where the coordinate before it does, or beyond
    // that.
    int last = 0;
    for (int c = 0; c < out.cells(k); ++c) {
      if (c % 2 == 1) {
        last = set.cell_of(k, out.at()[k][static_cast<std::size_t>(c / 2)]);
        old[k].push_back(last);
      } else {
        old[k].push_back(last % 2 == 1 ? last + 1 : last);
      }
    }
  }
  for (int z = 0; z < out.cells(2); ++z) {
    for (int y = 0; y < out.cells(1); ++y) {
      for (int x = 0; x < out.cells(0); ++x)
        out.set_mark(x, y, z, set.mark(old[0][std::size_t(x)], old[1][std::size_t(y)], old[2][std::size_t(z)]));
    }
  }
  return out;
}

bool too_fine(const BoxComplex* set) { return set->too_fine(); }

}  // namespace

BoxComplex overlay(std::span<const BoxComplex* const> sets, const std::function<Mark(std::span<const Mark>)>& combine) {
  if (std::any_of(sets.begin(), sets.end(), too_fine)) return BoxComplex::without_cells();
  Axes all;
  for (const BoxComplex* s : sets) {
    for (int k = 0; k < 3; ++k) all[k].insert(all[k].end(), s->at()[k].begin(), s->at()[k].end());
  }
  std::vector<BoxComplex> fine;
  for (const BoxComplex* s : sets) {
    fine.push_back(refined(*s, all));
    if (fine.back().too_fine()) return fine.back();
  }
  if (fine.empty()) return BoxComplex({}, combine({}));
  BoxComplex out = fine[0];
  std::vector<Mark> marks(fine.size());
  std::size_t cell = 0;
  return out.remarked([&](Mark) {
    const auto row = static_cast<std::size_t>(out.cells(0)), column = static_cast<std::size_t>(out.cells(1));
    const int x = static_cast<int>(cell % row), y = static_cast<int>(cell / row % column),
              z = static_cast<int>(cell / row / column);
    ++cell;
    for (std::size_t i = 0; i < fine.size(); ++i) marks[i] = fine[i].mark(x, y, z);
    return combine(marks);
  });
}

BoxComplex mirrored(const BoxComplex& set) {
  if (set.too_fine()) return set;
  Axes at;
  for (int k = 0; k < 3; ++k) {
    for (auto it = set.at()[k].rbegin(); it != set.at()[k].rend(); ++it) at[k].push_back(-*it);
  }
  return {std::move(at), std::vector<Mark>(set.marks().rbegin(), set.marks().rend())};
}

BoxComplex translated(const BoxComplex& set, const RealVector& by) {
  if (set.too_fine()) return set;
  Axes at = set.at();
  for (int k = 0; k < 3; ++k) {
    for (Real& c : at[k]) c += by[k];
  }
  return {std::move(at), std::vector<Mark>(set.marks().begin(), set.marks().end())};
}

BoxComplex sum(const BoxComplex& a, const BoxComplex& b) {
  if (a.too_fine() || b.too_fine()) return BoxComplex::without_cells();
  const auto ends = [](const std::optional<Real>& p, const std::optional<Real>& q) {
    return p && q ? std::optional<Real>(*p + *q) : std::nullopt;
  };
  std::vector<IntervalBox> sums;
  const std::vector<IntervalBox> of_b = b.boxes();
  for (const IntervalBox& p : a.boxes()) {
    for (const IntervalBox& q : of_b) {
      IntervalBox s;
      for (int k = 0; k < 3; ++k) {
        s[k] = {ends(p[k].from, q[k].from), ends(p[k].to, q[k].to), p[k].from_in && q[k].from_in,
                p[k].to_in && q[k].to_in};
      }
      sums.push_back(std::move(s));
    }
  }
  return BoxComplex::of_boxes(sums);
}

std::optional<RealVector> nearest(std::span<const IntervalBox> boxes, const RealVector& p) {
  std::optional<RealVector> best;
  Real least;
  for (const IntervalBox& box : boxes) {
    RealVector q = p;
    for (int k = 0; k < 3; ++k) {
      if (box[k].from && q[k] < *box[k].from) q[k] = *box[k].from;
      if (box[k].to && *box[k].to < q[k]) q[k] = *box[k].to;
    }
    const RealVector off = minus(q, p);
    const Real square = dot(off, off);
    if (best && !(square < least)) continue;
    best = q;
    least = square;
  }
  return best;
}

std::optional<RealVector> farthest(std::span<const IntervalBox> boxes, const RealVector& p) {
  std::optional<RealVector> best;
  Real most;
  for (const IntervalBox& box : boxes) {
    RealVector q;
    for (int k = 0; k < 3; ++k) {
      if (!box[k].from || !box[k].to) return std::nullopt;
      q[k] = *box[k].to - p[k] < p[k] - *box[k].from ? *box[k].from : *box[k].to;
    }
    const RealVector off = minus(q, p);
    const Real square = dot(off, off);
    if (best && !(most < square)) continue;
    best = q;
    most = square;
  }
  return best;
}

}  // namespace findspace::space
