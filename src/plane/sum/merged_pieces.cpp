// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/sum/merged_pieces.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "exact/planar/geometry_signs.h"

namespace findspace::plane {
namespace {

using exact::Geometry;

bool is_rational(const Geometry& g, Index point) {
  const exact::Point& p = g.points[point];
  if (p.kind == exact::Point::Kind::kGrid) return true;
  return p.kind == exact::Point::Kind::kReal && g.reals[p.i].x.is_rational() && g.reals[p.i].y.is_rational();
}

/// Of each point the first that is the same.
std::vector<Index> first_equal_points(const Geometry& g) {
  constexpr double kParts = 16;  // of a grid step: points that are the same are rarely in different ones
  struct Rough {
    double x, y;
    Index point;
  };
  std::vector<Rough> rough;
  for (Index p = 0; p < g.points.size(); ++p)
    if (is_rational(g, p)) rough.push_back({std::round(g.points[p].x * kParts), std::round(g.points[p].y * kParts), p});
  std::sort(rough.begin(), rough.end(),
            [](const Rough& p, const Rough& q) { return std::tie(p.x, p.y, p.point) < std::tie(q.x, q.y, q.point); });
  std::vector<Index> first(g.points.size());
  std::iota(first.begin(), first.end(), 0u);
  std::vector<Index> different;  // of one rough place
  for (std::size_t k = 0; k < rough.size(); ++k) {
    const Index point = rough[k].point;
    if (k > 0 && (rough[k].x != rough[k - 1].x || rough[k].y != rough[k - 1].y)) different.clear();
    const auto same =
        std::find_if(different.begin(), different.end(), [&](Index known) { return compare_xy(g, known, point) == 0; });
    if (same == different.end())
      different.push_back(point);
    else
      first[point] = *same;
  }
  return first;
}

auto corner_key(const Corner& c) { return std::tuple(c.in, c.out, c.rotation, c.extra); }

class Merger {
 public:
  explicit Merger(ConvolutionBuilder& c) : c_(c), number_(c.curves.pieces.size()) {}

  void run() {
    const std::vector<Index> first = first_equal_points(c_.curves.geometry);
    std::vector<char> shared(first.size(), 0);
    for (Index p = 0; p < first.size(); ++p)
      if (first[p] != p) shared[first[p]] = 1;
    for (Piece& p : c_.curves.pieces) {
      p.p0 = first[p.p0];
      p.p1 = first[p.p1];
      // Where others end as well a piece is not smooth: that says that all that end there meet nowhere else.
      p.smooth0 &= !shared[p.p0];
      p.smooth1 &= !shared[p.p1];
    }
    number_pieces();
    move_corners();
    c_.curves.pieces = std::move(pieces_);
    c_.chains = std::move(chains_);
    c_.curves.forward.clear();
  }

 private:
  auto key(Index k) const {
    const Piece& p = c_.curves.pieces[k];
    return std::tuple(p.p0, p.p1, p.half, c_.chains[k].forward, c_.chains[k].displaced_left);
  }

  bool same(Index k, Index other) const {
    const Piece &p = c_.curves.pieces[k], &q = c_.curves.pieces[other];
    const auto& curves = c_.curves.geometry.supporting_curves;
    return key(k) == key(other) &&
           (p.half == 0 || same_supporting_curve(curves[p.supporting_curve], curves[q.supporting_curve]));
  }

  /// Of equal pieces the first stays, in the order of these.
  void number_pieces() {
    std::vector<Index> order(number_.size()), first(number_.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(),
              [&](Index p, Index q) { return std::tuple(key(p), p) < std::tuple(key(q), q); });
    for (std::size_t k = 0; k < order.size(); ++k)
      first[order[k]] = k > 0 && same(first[order[k - 1]], order[k]) ? first[order[k - 1]] : order[k];
    for (Index k = 0; k < number_.size(); ++k) {
      if (first[k] == k) {
        number_[k] = Index(pieces_.size());
        pieces_.push_back(c_.curves.pieces[k]);
        chains_.push_back(c_.chains[k]);
      } else {
        number_[k] = number_[first[k]];
        chains_[number_[k]].weight += c_.chains[k].weight;
      }
    }
  }

  void move_corners() {
    for (Corner& corner : c_.corners) {
      corner.in = number_[corner.in];
      corner.out = number_[corner.out];
    }
    auto& corners = c_.corners;
    std::sort(corners.begin(), corners.end(),
              [](const Corner& p, const Corner& q) { return corner_key(p) < corner_key(q); });
    std::size_t count = 0;
    for (const Corner& corner : corners) {
      if (count > 0 && corner_key(corners[count - 1]) == corner_key(corner))
        corners[count - 1].weight += corner.weight;
      else
        corners[count++] = corner;
    }
    corners.resize(count);
  }

  ConvolutionBuilder& c_;
  std::vector<Index> number_;  // of each piece before, what it is now
  std::vector<Piece> pieces_;
  std::vector<Chain> chains_;
};

}  // namespace

void merge_equal_pieces(ConvolutionBuilder& convolution) { Merger(convolution).run(); }

}  // namespace findspace::plane
