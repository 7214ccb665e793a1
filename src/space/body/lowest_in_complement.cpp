// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/body/lowest_in_complement.h"

#include "plane/base/search_work.h"
#include "plane/base/subdivide.h"

namespace findspace::space {

using exact::Real;

namespace {

/// By the values of the forms, one after the other.
struct FormValues {
  std::vector<Real> values;
  bool operator<(const FormValues& other) const {
    for (std::size_t k = 0; k < values.size(); ++k) {
      if (const int order = compare(values[k], other.values[k]); order != 0) return order < 0;
    }
    return false;
  }
};

/// Of a vertex of the piece that is least.
template <class Key>
struct ComplementPiece {
  ConvexRegion region;
  std::size_t least = 0;
  Key key;
  bool operator<(const ComplementPiece& other) const { return other.key < key; }
};

template <class KeyOf>
auto piece_of(ConvexRegion region, const KeyOf& key_of) {
  using Key = std::invoke_result_t<KeyOf, const ConvexRegion::Vertex&>;
  const auto vertices = region.vertices();
  std::size_t least = 0;
  Key key = key_of(vertices[0]);
  for (std::size_t v = 1; v < vertices.size(); ++v) {
    Key next = key_of(vertices[v]);
    if (!(next < key)) continue;
    key = std::move(next);
    least = v;
  }
  return ComplementPiece<Key>{std::move(region), least, std::move(key)};
}

/// The point of what the sets leave whose key, which is least at vertices, is least.
template <class KeyOf>
exact::Tried<std::optional<RealVector>> least_in_complement(const OpenUnion& cover, const ConvexRegion& within,
                                                            const KeyOf& key_of) {
  using Piece = decltype(piece_of(within, key_of));
  plane::Subdivision<Piece> queue;
  std::optional<RealVector> found;
  if (!within.empty()) queue.push(piece_of(within, key_of));
  const plane::SearchQuestion question;
  queue.run([&](const Piece&) { return found.has_value() || question.work().spent(); },
            [&](Piece top) {
              plane::count_cell();
              const RealVector& least = top.region.vertices()[top.least].at;
              const int set = cover.covering(least);
              if (set < 0) {
                found = least;
                return;
              }
              for (const HalfSpace& h : cover.planes(static_cast<std::size_t>(set))) {
                plane::count_cell();
                const ConvexRegion::Sides sides = top.region.sides(h);
                if (!sides.on && !sides.outside) continue;
                ConvexRegion beyond = top.region;
                beyond.cut(h.opposite());
                if (!beyond.empty()) queue.push(piece_of(std::move(beyond), key_of));
                top.region.cut(h);
                if (top.region.empty()) break;
              }
            });
  if (!found && !queue.empty())
    return plane::search_spent("the lowest or farthest place outside a union of convex sets was not found");
  return found;
}

}  // namespace

std::optional<RealVector> lowest_in_complement(const OpenUnion& cover, const ConvexRegion& within,
                                               std::span<const RealVector> forms) {
  return least_in_complement(cover, within,
                             [&](const ConvexRegion::Vertex& v) {
                               FormValues key;
                               for (const RealVector& f : forms) key.values.push_back(dot(f, v.at));
                               return key;
                             })
      .or_throw();
}

exact::Tried<std::optional<RealVector>> farthest_in_complement(const OpenUnion& cover, const RealVector& low,
                                                               const RealVector& high, const RealVector& p) {
  for (int k = 0; k < 3; ++k) {
    if (high[k] < low[k]) return std::optional<RealVector>();
  }
  const Vector near = space::rounded(p);
  return least_in_complement(cover, ConvexRegion(low, high),
                             [&](const ConvexRegion::Vertex& v) { return -length(v.near - near); });
}

}  // namespace findspace::space
