// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Bodies of the literature that are not convex (Stoyan 2004, Egeblad 2009, Liu 2015): for all ordered
// pairs, overlap on rays against the exact Phi-function of their convex parts, at 1000 random positions and at events.
#include <findspace/error.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <memory>
#include <numeric>
#include <random>

#include "io/mesh/read_mesh.h"
#include "space/body/convex_parts.h"
#include "space/convolution/mesh_crossing.h"
#include "space/convolution/ray_pair.h"
#include "space/mesh/mesh.h"
#include "space/phi/phi_union.h"
#include "space/polytope/convex_region.h"

namespace findspace {
namespace io_real_bodies {

using exact::Real;
using space::ConvexParts;
using space::RayGrid;
using space::Triangles;

/// Beyond it the common grid of the parts of two bodies is too fine for integers: so it is for four pairs.
constexpr std::int64_t kMostScale = 1 << 20;

struct RealBody {
  std::string name;
  Triangles surface;
  ConvexParts parts;
};

std::vector<RealBody> read_all() {
  const std::filesystem::path root = std::filesystem::path(FINDSPACE_SHARED) / "data" / "3d";
  std::vector<std::filesystem::path> files;
  for (const char* folder :
       {"stoyan2004/nonconvex", "stoyan2004/nonconvex/sanitized", "egeblad2009/Merged", "liu2015"}) {
    if (!std::filesystem::exists(root / folder)) continue;
    for (const auto& entry : std::filesystem::directory_iterator(root / folder)) {
      const std::string ending = entry.path().extension().string();
      if (ending == ".obj" || ending == ".stl") files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  std::vector<RealBody> bodies;
  for (const auto& file : files) {
    io::ReadContext context;
    context.grid = io::Grid(Real::ratio(1, 100000));
    try {
      const space::Mesh mesh = io::read_mesh(file, context, [](const auto&) { return Real(1); });
      RealBody body{file.filename().string(), triangles(mesh), convex_parts(mesh)};
      const space::RaySheet surface(body.surface);
      // Parts whose vertices had to be rounded are no exact oracle.
      if (!self_contact(surface).crossing && body.parts.rounded == 0) bodies.push_back(std::move(body));
    } catch (const Error& e) {
      // Some files are not closed as they stand, or lists of convex parts that overlap.
      EXPECT_EQ(e.code(), ErrorCode::kGeometry) << e.what();
    }
  }
  return bodies;
}

/// The sign of the overlap of the bodies' parts at p (grid steps), each with vertices on a grid of its own: by cutting
/// the parts of one with the planes of the other. Slower than PhiUnion, which needs one grid for both.
class CutOracle {
 public:
  CutOracle(const ConvexParts& a, const ConvexParts& b) : b_(b) {
    for (const space::Polytope& part : a.parts) {
      space::RealVector low = at(part.vertices()[0], a.scale), high = low;
      for (const space::Point& v : part.vertices()) {
        const space::RealVector c = at(v, a.scale);
        for (std::size_t k = 0; k < 3; ++k) {
          low[k] = std::min(low[k], c[k]);
          high[k] = std::max(high[k], c[k]);
        }
      }
      regions_.emplace_back(low, high);
      for (const space::Plane& plane : part.planes()) regions_.back().cut(half_space(plane, a.scale, {}));
    }
  }

  int sign_at(const space::RealVector& p) const {
    int sign = 1;
    for (const space::ConvexRegion& region : regions_) {
      for (const space::Polytope& part : b_.parts) {
        space::ConvexRegion common = region;
        for (const space::Plane& plane : part.planes()) {
          const space::HalfSpace h = half_space(plane, b_.scale, p);
          if (!common.empty() && common.sides(h).outside) common.cut(h);
        }
        if (common.dimension() == 3) return -1;
        if (!common.empty()) sign = 0;
      }
    }
    return sign;
  }

 private:
  static space::RealVector at(const space::Point& v, std::int64_t scale) {
    return space::scaled(Real::ratio(1, scale), space::real(v));
  }
  /// Moved by p.
  static space::HalfSpace half_space(const space::Plane& plane, std::int64_t scale, const space::RealVector& p) {
    const space::RealVector n = space::real(plane.normal);
    return {n, Real(plane.offset) / Real(scale) - space::dot(n, p)};
  }

  std::vector<space::ConvexRegion> regions_;
  const ConvexParts& b_;
};

void compare(const RealBody& a, const RealBody& b, std::mt19937& random, int places, int& overlaps) {
  const std::int64_t scale = std::lcm(a.parts.scale, b.parts.scale);
  const auto oracle = [&]() -> std::function<int(const space::RealVector&)> {
    if (scale > kMostScale)
      return [cuts = std::make_shared<CutOracle>(a.parts, b.parts)](const auto& p) { return cuts->sign_at(p); };
    auto phi = std::make_shared<space::PhiUnion>(at_scale(a.parts, scale), at_scale(b.parts, scale));
    return [phi, scale](const auto& p) { return phi->sign_at(space::scaled(Real(scale), p)); };
  }();
  SCOPED_TRACE(a.name + " " + b.name);
  const space::RayBody body(a.surface), other(b.surface);
  const RayGrid grid = space::ray_grid(body.low - other.high, body.high - other.low, 2, 16);
  const space::PairRays rays(a.surface, b.surface, grid);
  const auto pick = [&](std::int64_t low, std::int64_t high) {
    return std::uniform_int_distribution<std::int64_t>(low, high)(random);
  };
  const auto check = [&](int i, int j, const Real& z, int sign) {
    const Real unit = Real::ratio(1, grid.parts);
    const int truth = oracle({Real(grid.u_at(i)) * unit, Real(grid.v_at(j)) * unit, z * unit});
    ASSERT_EQ(sign, truth) << a.name << " " << b.name << ": line " << i << " " << j << " at " << z.text();
    overlaps += truth < 0;
  };
  const std::vector<space::RayRow> rows = space::all_rows(rays);
  for (int k = 0; k < places; ++k) {
    const int i = static_cast<int>(pick(0, grid.nu - 1)), j = static_cast<int>(pick(0, grid.nv - 1));
    const space::RayRow& row = rows[static_cast<std::size_t>(j)];
    const Real z(pick((body.low.z - other.high.z) * grid.parts, (body.high.z - other.low.z) * grid.parts));
    check(i, j, z, sign_at(row, i, z));
    const int first = row.first[static_cast<std::size_t>(i)], last = row.first[static_cast<std::size_t>(i) + 1];
    if (first == last) continue;
    const auto& event = row.events[static_cast<std::size_t>(pick(first, last - 1))];
    check(i, j, event.at.to_real(), event.here);
  }
}

TEST(RealBodies, OverlapOnRaysIsThatOfTheConvexParts) {
  const std::vector<RealBody> bodies = read_all();
  if (bodies.empty()) GTEST_SKIP() << "the data sets are not here";
  EXPECT_GT(bodies.size(), 15U);
  std::mt19937 random(11);
  int overlaps = 0;
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t a = 0; a < bodies.size(); ++a) {
    for (std::size_t b = 0; b < bodies.size(); ++b) pairs.emplace_back(a, b);
  }
  for (const auto& [a, b] : pairs) compare(bodies[a], bodies[b], random, 1000, overlaps);
  EXPECT_GE(pairs.size(), 950U);
  EXPECT_GT(overlaps, 1000);
}

}  // namespace io_real_bodies
}  // namespace findspace
