// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/rotation/rotated_free_events.h"

#include <algorithm>
#include <cmath>

#include "exact/margins/plane.h"
#include "plane/base/counted_tasks.h"
#include "plane/base/search_work.h"
#include "plane/rotation/rotated_free_finders.h"

namespace findspace::plane {
namespace {

constexpr std::size_t kSectors = 16;
constexpr std::size_t kFew = 14;  // pairs, for which a sector is not halved
constexpr double kNarrow = 0.01;  // no sign: radians, sectors are not halved below

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

/// Three curves of which two touch at every angle (contact_joints.h) are passed over: where they hold B, the third
/// touches one of the two.
void find_meetings(FreeSector& sector, const ContactTies& ties) {
  const std::vector<ContactPair>& pairs = sector.pairs();
  const MeetingSpots& spots = sector.spots();
  MeetingFinder finder(sector);
  count_cells(long(pairs.size() * pairs.size() / 200));
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    find_single(sector, i);
    for (std::size_t k = i + 1; k < pairs.size(); ++k) {
      find_touching(sector, i, k);
      if (!spots.may_meet(i, k)) continue;
      if (spots.may_meet_at_level(i, k)) finder.corner(i, k);
      if (ties.never_cross(pairs[i], pairs[k])) continue;
      for (std::size_t m = k + 1; m < pairs.size(); ++m)
        if (spots.may_meet(i, k, m) && !ties.never_cross(pairs[i], pairs[m]) && !ties.never_cross(pairs[k], pairs[m]))
          finder.meeting(i, k, m);
    }
  }
}

void find_meetings_on_way(FreeSector& sector) {
  for (std::size_t i = 0; i < sector.pairs().size(); ++i) {
    find_single_on_way(sector, i);
    for (std::size_t k = i + 1; k < sector.pairs().size(); ++k) {
      find_touching(sector, i, k);
      if (sector.spots().may_meet(i, k)) find_corner_on_way(sector, i, k);
    }
  }
}

/// Of the angles between middle - half and middle + half; some twice, some too many. `pairs`: those that can touch
/// there.
std::vector<FreeEvent> sector_events(const FreeQuestion& q, const ContactTies& ties, std::vector<ContactPair> pairs,
                                     double middle, double half) {
  if (!q.far) {
    const double level = q.level.to_double();
    std::erase_if(pairs, [&](const ContactPair& k) {
      return q.curves.rough(k, middle).least() > level + MeetingSpots::travel(q.curves, k, half) + q.tolerance;
    });
  }
  if (pairs.size() <= kFew || half <= kNarrow) {
    FreeSector sector(q, ties, std::move(pairs), middle, half);
    q.way ? find_meetings_on_way(sector) : find_meetings(sector, ties);
    return std::move(sector.found);
  }
  std::vector<FreeEvent> found;
  for (double at : {middle - half / 2, middle + half / 2}) {
    auto more = sector_events(q, ties, q.curves.pairs(pairs, at, half / 2), at, half / 2);
    std::move(more.begin(), more.end(), std::back_inserter(found));
  }
  return found;
}

}  // namespace

std::vector<FreeEvent> free_events(const FreeQuestion& question) {
  const ContactTies ties(question.curves);
  std::vector<std::vector<FreeEvent>> found(kSectors);
  counted_tasks(kSectors, [&](std::size_t k) {
    const double half = kPi / kSectors, middle = double(2 * k + 1) * half;
    found[k] = sector_events(question, ties, question.curves.pairs(middle, half), middle, half);
  });
  std::vector<FreeEvent> all;
  for (auto& f : found) std::move(f.begin(), f.end(), std::back_inserter(all));
  return merged(std::move(all));
}

}  // namespace findspace::plane
