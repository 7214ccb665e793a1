// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What stands behind a public Region and SignMap: a marked complex on a grid, and what questions to it prepare, each
// made when first asked for. Threads: safe.
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "api/values/region_answers.h"
#include "findspace/region.h"
#include "plane/base/parallel.h"
#include "plane/contour/decimal_grid.h"
#include "plane/query/curve_net.h"
#include "plane/query/locate.h"
#include "plane/query/mark_grid.h"
#include "plane/query/summary.h"

namespace findspace {

struct Exact::Data {
  exact::Real value;
};

namespace api {

/// The marks of a complex at positions in the unit: in doubles where these decide, else exactly.
class Marks {
 public:
  /// Keeps references.
  Marks(const plane::CellComplex& complex, const plane::Grid& grid)
      : complex_(complex), grid_(grid), buckets_(complex) {}

  plane::Mark at(const Position& p) const;
  /// told(mark) of each, in parallel.
  template <class Out>
  void each(std::span<const Position> positions, Out (*told)(plane::Mark), std::span<Out> out) const {
    constexpr std::size_t kBlock = 8192;
    plane::parallel_for((positions.size() + kBlock - 1) / kBlock, [&](std::size_t block) {
      std::optional<plane::Locator> locator;  // made where doubles leave a position of the block open
      const std::size_t last = std::min(positions.size(), (block + 1) * kBlock);
      for (std::size_t k = block * kBlock; k < last; ++k) {
        std::optional<plane::Mark> mark = quick(positions[k]);
        if (!mark) {
          if (!locator) locator.emplace(complex_);
          mark = locator->mark(exactly(positions[k]));
        }
        out[k] = told(*mark);
      }
    });
  }

 private:
  std::optional<plane::Mark> quick(const Position& p) const;
  exact::RealPoint exactly(const Position& p) const;

  const plane::CellComplex& complex_;
  const plane::Grid& grid_;
  plane::MarkGrid buckets_;
};

/// What walks along the boundary show.
struct Walk {
  plane::CurveNet net;
  std::vector<Region::Vertex> vertices;
  std::vector<Region::Edge> edges;
  std::vector<Region::Component> components;

  Walk(const plane::Region& region, const plane::Summary& summary, const exact::Real& step);
};

/// The points of an arc after its first one and before its last, so many that no chord is farther from it than `bound`;
/// `around` asks for points of tangents around it instead.
void add_arc(const Region::Edge& e, const Position& from, bool forward, double bound, bool around,
             std::vector<Position>& out);

Region make_region(plane::Region cells, const plane::Grid& grid, std::string unit = {});

}  // namespace api

struct Region::Data {
  plane::Region cells;
  plane::Grid grid;
  std::string unit;

  const plane::Summary& summary() const;
  const api::Marks& marks() const;
  const api::Walk& walk() const;
  const api::RegionAnswers& answers() const;

 private:
  mutable std::once_flag summarized_{}, located_{}, walked_{}, asked_{};
  mutable std::optional<plane::Summary> summary_{};
  mutable std::optional<api::Marks> marks_{};
  mutable std::optional<api::Walk> walk_{};
  mutable std::optional<api::RegionAnswers> answers_{};

 public:
  Data(plane::Region c, plane::Grid g, std::string u) : cells(std::move(c)), grid(std::move(g)), unit(std::move(u)) {}
};

struct SignMap::Data {
  plane::SignMap map;
  plane::Grid grid;
  std::string unit;

  const api::Marks& marks() const;

 private:
  mutable std::once_flag located_{};
  mutable std::optional<api::Marks> marks_{};

 public:
  Data(plane::SignMap m, plane::Grid g, std::string u) : map(std::move(m)), grid(std::move(g)), unit(std::move(u)) {}
};

}  // namespace findspace
