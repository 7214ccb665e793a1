// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/complex/observe_pieces.h"

#include <algorithm>
#include <cmath>

#include "plane/base/stage_observer.h"

namespace findspace::plane {
namespace {

constexpr int kChords = 16;  // of an arc

/// A point of the upper or lower half of a circle, by its share of the way along x.
StageDrawing::Corner on_half(const exact::SupportingCurve& circle, int half, double x) {
  const double across = x - circle.x().value, radius = circle.z().value;
  const double up = std::sqrt(std::max(0.0, radius * radius - across * across));
  return {x, circle.y().value + (half > 0 ? up : -up), 0};
}

void add_piece(const exact::Geometry& geometry, const Piece& piece, StageDrawing& drawing) {
  const exact::Point &p = geometry.points[piece.p0], &q = geometry.points[piece.p1];
  StageDrawing::Corner from{p.x, p.y, 0};
  for (int k = 1; piece.half != 0 && k < kChords; ++k) {
    // Closer together at the ends, where an arc may be steep.
    const double share = (1 - std::cos(M_PI * k / kChords)) / 2;
    const StageDrawing::Corner to =
        on_half(geometry.supporting_curves[piece.supporting_curve], piece.half, p.x + share * (q.x - p.x));
    drawing.add_face({from, to});
    from = to;
  }
  drawing.add_face({from, {q.x, q.y, 0}});
}

}  // namespace

void observe_pieces(const char* stage, const char* title, const exact::Geometry& geometry,
                    std::span<const Piece> pieces) {
  StageObserver* observer = stage_observer();
  if (observer == nullptr || pieces.empty()) return;
  StageDrawing drawing;
  drawing.planar = true;
  for (const Piece& piece : pieces) add_piece(geometry, piece, drawing);
  observer->drawing(stage, title, drawing);
}

}  // namespace findspace::plane
