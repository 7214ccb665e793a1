// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What finds the events (rotated_free_events.h) of a sector: contacts that touch, curves that meet, and both on a way.
// Guarantee: all of them, some twice, some too many. Used by rotated_free_events.cpp only.
#pragma once

#include <array>
#include <map>
#include <utility>
#include <vector>

#include "plane/rotation/rotated_free_sector.h"

namespace findspace::plane {

/// One contact, exactly the level away in the direction in which B goes free (far: against it).
void find_single(FreeSector& sector, std::size_t i);
/// Two curves that touch with opposite normals: a gap with no play, a corner on an edge.
void find_touching(FreeSector& sector, std::size_t i, std::size_t j);

/// Where curves meet. Curves on one circle are solved for once.
class MeetingFinder {
 public:
  explicit MeetingFinder(FreeSector& sector) : s_(sector) {}
  /// Two curves that meet exactly the level away.
  void corner(std::size_t i, std::size_t k);
  /// Three curves that meet in one point, B being held there.
  void meeting(std::size_t i, std::size_t k, std::size_t m);

 private:
  /// The angles at which two or three lines and circles meet; `second`: they are found.
  struct Solved {
    bool looked = false;
    std::vector<std::pair<RootPlace, bool>> places;
    template <class Find>
    void look(Find find);
  };
  FreeSector& s_;
  std::map<std::array<std::size_t, 3>, Solved> solved_;  // by FreeSector::alike, ascending
};

/// On a way (free_way.h): a contact curve passes an end of what counts of it, touches it or lies along it.
void find_single_on_way(FreeSector& sector, std::size_t i);
/// Two curves meet on the way.
void find_corner_on_way(FreeSector& sector, std::size_t i, std::size_t k);

}  // namespace findspace::plane
