// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Where the names of solids stand in a view of space: on the solid, where nothing nearer hides it and no other name
// is; else beside it, with a line to it. Smaller solids choose first. A name that finds no free place is left out.
// Cost: the solids times the places tried, squared. Keywords: label placement, callout.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "plane/query/summary.h"

namespace findspace::io {

/// A solid as it is seen, in pixels.
struct NamedSolid {
  std::string name;
  std::vector<plane::Place> around;  // the corners of its convex hull in order
  std::vector<plane::Place> faces;   // places on it: the middles of its largest faces that are seen
  double depth = 0;                  // of its middle, towards the eye
  bool glass = false;                // hides nothing
  bool wire = false;                 // of lines only: `faces` lie on them, and names stand beside these
  const char* colour = "#33383d";
};

/// Of the ring's first corner with all others: the area of a convex ring.
double area_on_page(const std::vector<plane::Place>& ring);
/// The corners of the convex hull in order.
std::vector<plane::Place> hull_on_page(std::vector<plane::Place> points);

class SpaceNames {
 public:
  /// Of a picture with these bounds.
  explicit SpaceNames(const plane::Bounds& picture) : picture_(picture) {}

  void avoid(const plane::Bounds& box) { taken_.push_back(box); }
  /// Names cross no more of this line than they must.
  void shun(const plane::Place& from, const plane::Place& to);
  /// A text about the first of these places that is free.
  void put_text(std::string_view text, const std::vector<plane::Place>& places, const char* colour);
  void name(std::vector<NamedSolid> solids);
  /// What was put.
  const std::string& svg() const { return out_; }

 private:
  bool is_free(const plane::Bounds& box) const;
  void put(std::string_view text, const plane::Place& middle, const char* colour);
  struct Sized;
  /// Whether nothing nearer hides the place from the eye.
  static bool is_seen(const std::vector<Sized>& solids, std::size_t k, const plane::Place& p);
  /// From a name at `middle`, which stands beside the solid.
  void put_leader(const std::vector<Sized>& solids, std::size_t k, const plane::Place& middle);
  double against(const std::vector<Sized>& solids, std::size_t k, const plane::Bounds& box) const;
  void name_one(const std::vector<Sized>& solids, std::size_t k);

  plane::Bounds picture_;
  std::vector<plane::Bounds> taken_;
  std::vector<plane::Place> shunned_;  // points of lines
  std::string out_;
};

}  // namespace findspace::io
