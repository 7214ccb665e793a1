// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "packing/compaction/free_half_planes.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "exact/margins/packing.h"

namespace findspace::packing {
namespace {

/// What is left of an edge, and the half-plane on its free side.
struct Piece {
  Vec from, to;
  HalfPlane beside;

  Vec nearest(Vec p) const {
    const Vec way = to - from;
    const double square = dot(way, way);
    const double along = square > 0 ? std::clamp(dot(p - from, way) / square, 0.0, 1.0) : 0;
    return from + along * way;
  }
};

/// What of the piece lies more than `slack` inside the half-plane; false where nothing does.
bool clip(Piece& piece, const HalfPlane& h, double slack) {
  const double a = dot(h.normal, piece.from) - h.offset - slack, b = dot(h.normal, piece.to) - h.offset - slack;
  if (a <= 0 && b <= 0) return false;
  if (a >= 0 && b >= 0) return true;
  const Vec meeting = piece.from + (a / (a - b)) * (piece.to - piece.from);
  (a < 0 ? piece.from : piece.to) = meeting;
  return true;
}

bool clip_to_box(Piece& piece, Vec at, double reach) {
  return clip(piece, {{1, 0}, at.x - reach}, 0) && clip(piece, {{-1, 0}, -at.x - reach}, 0) &&
         clip(piece, {{0, 1}, at.y - reach}, 0) && clip(piece, {{0, -1}, -at.y - reach}, 0);
}

std::vector<Piece> pieces_near(const NoFitPolygon& polygon, Vec at, double reach) {
  std::vector<Piece> pieces;
  for (const NoFitEdge& edge : polygon.edges) {
    const Vec way = edge.to - edge.from;
    const double length = std::sqrt(dot(way, way));
    if (edge.slit || length <= 0) continue;
    const Vec normal = (1 / length) * Vec{way.y, -way.x};
    Piece piece{edge.from, edge.to, {normal, dot(normal, edge.from)}};
    if (clip_to_box(piece, at, reach)) pieces.push_back(piece);
  }
  return pieces;
}

/// The half-plane that shuts out the nearest piece of one or more. Of several as near, that whose line is farthest from
/// the position.
HalfPlane shut_out(const std::vector<Piece>& pieces, Vec at, double slack) {
  double nearest = std::numeric_limits<double>::infinity(), farthest_line = 0;
  const Piece* best = &pieces.front();
  for (const Piece& piece : pieces) {
    const Vec off = at - piece.nearest(at);
    const double distance = std::sqrt(dot(off, off)), line = dot(piece.beside.normal, at) - piece.beside.offset;
    const bool nearer = distance < nearest - slack;
    if (!nearer && !(distance <= nearest + slack && line > farthest_line)) continue;
    nearest = std::min(nearest, distance);
    best = &piece;
    farthest_line = line;
  }
  if (farthest_line >= 0.3 * nearest - slack) return best->beside;
  const Vec projection = best->nearest(at);
  const Vec normal = (1 / nearest) * (at - projection);
  return {normal, dot(normal, projection)};
}

/// In a slit there is no way but along it.
void keep_to_slits(const NoFitPolygon& polygon, Vec at, double slack, std::vector<HalfPlane>& result) {
  for (const NoFitEdge& edge : polygon.edges) {
    if (!edge.slit) continue;
    const Vec way = edge.to - edge.from;
    const double length = std::sqrt(dot(way, way));
    const Vec along = length > 0 ? (1 / length) * way : Vec{1, 0}, across{along.y, -along.x};
    const Vec off = at - Piece{edge.from, edge.to, {}}.nearest(at);
    if (dot(off, off) > slack * slack) continue;
    for (const Vec normal : {across, Vec{-across.x, -across.y}}) result.push_back({normal, dot(normal, edge.from)});
    result.push_back({along, dot(along, edge.from)});
    result.push_back({Vec{-along.x, -along.y}, -dot(along, edge.to)});
  }
}

}  // namespace

void free_half_planes(const NoFitPolygon& polygon, Vec at, double reach, double size, std::vector<HalfPlane>& result) {
  const double slack = size * margin::kPieceLeft;
  std::vector<Piece> pieces = pieces_near(polygon, at, reach);
  result.clear();
  keep_to_slits(polygon, at, slack, result);
  while (!pieces.empty()) {
    const std::size_t before = pieces.size();
    const HalfPlane h = shut_out(pieces, at, slack);
    result.push_back(h);
    std::erase_if(pieces, [&](Piece& piece) { return !clip(piece, h, slack); });
    if (pieces.size() == before) break;
  }
}

}  // namespace findspace::packing
