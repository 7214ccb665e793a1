// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Results as values. Region: an exact plane set, every vertex, edge and face marked as belonging or not
// (docs/results.md). SignMap: the sign of a distance minus a level at every position. Both are immutable and cheap to
// copy; reading them from many threads is safe. Numbers are in the unit of the world that made them. Guarantee: which
// cells belong, and what is counted, is exact; areas are right to rounding. Cost: a query at a point is linear in the
// edges, all else is read off what was made with the region. Keywords: marked subdivision, level set, sublevel set.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "findspace/shape.h"

namespace findspace {

class Region {
 public:
  bool empty() const;
  /// The whole plane.
  bool whole() const;
  /// As point sets of the plane; the empty set and the plane are both.
  bool open() const;
  bool closed() const;
  /// Within some disc.
  bool bounded() const;
  /// Nothing where the region is unbounded.
  std::optional<double> area() const;
  /// Connected components of the point set: faces that share only a vertex of it are one.
  std::size_t components() const;
  /// Bounded components of the complement.
  std::size_t holes() const;
  /// Exact, on boundaries too; p need not lie on the grid. Error(kSyntax) for what is no decimal.
  bool contains(const Point& p) const;
  /// As `findspace map --json` writes it (docs/results.md): cells with marks, arcs as arcs.
  std::string json() const;

  struct Data;
  explicit Region(std::shared_ptr<const Data> data) : data_(std::move(data)) {}
  const Data& data() const { return *data_; }

 private:
  std::shared_ptr<const Data> data_;
};

class SignMap {
 public:
  /// -1, 0 or +1, exact; a distance that is undefined counts as +infinity.
  int sign(const Point& p) const;
  /// The positions whose sign is one of those wanted.
  Region where(bool negative, bool zero, bool positive) const;

  struct Data;
  explicit SignMap(std::shared_ptr<const Data> data) : data_(std::move(data)) {}

 private:
  std::shared_ptr<const Data> data_;
};

}  // namespace findspace
