// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/rotation/rotated_free_events.h"

#include <algorithm>
#include <cmath>

#include "exact/margins/plane.h"
#include "plane/base/parallel.h"
#include "plane/rotation/rotated_free_sector.h"

namespace findspace::plane {
namespace {

constexpr std::size_t kSectors = 16;

int order(const FreeEvent& p, const FreeEvent& q) {
  if (std::abs(p.degrees - q.degrees) > margin::kNearAngles) return p.degrees < q.degrees ? -1 : 1;
  return compare(exact::Angle{p.rotation, {}}, exact::Angle{q.rotation, {}});
}

/// Each once.
std::vector<FreeEvent> merged(std::vector<FreeEvent> all) {
  std::sort(all.begin(), all.end(), [](const auto& p, const auto& q) { return order(p, q) < 0; });
  all.erase(std::unique(all.begin(), all.end(), [](const auto& p, const auto& q) { return order(p, q) == 0; }),
            all.end());
  return all;
}

}  // namespace

std::vector<FreeEvent> free_events(const FreeQuestion& question) {
  const ContactTies ties(question.curves);
  std::vector<std::vector<FreeEvent>> found(kSectors);
  parallel_for(kSectors, [&](std::size_t k) {
    const double half = kPi / kSectors;
    FreeSector sector(question, ties, double(2 * k + 1) * half, half);
    sector.run(question.curves.pairs(double(2 * k + 1) * half, half));
    found[k] = std::move(sector.found);
  });
  std::vector<FreeEvent> all;
  for (auto& f : found) std::move(f.begin(), f.end(), std::back_inserter(all));
  return merged(std::move(all));
}

}  // namespace findspace::plane
