// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The positions at which a set B keeps out of an open set O, asked about one place at a time, for regular sets of any
// kind: holes, arcs, several components. O is int A (contact), or all that is not A (containment); free positions are
//   F = {s : int (B + s) does not meet O}.
// The point of F nearest to a position (farthest from it) is a projection on a contact curve (contact_curves.h), an end
// of one, or a point where two of them meet: those of the curves that reach into a window are taken in the order of
// their distance, and the first that lies in F is it. Guarantee: exact; doubles only choose what is looked at, with
// tolerance. Where no other contact curve passes near, one position beside such a point, on the free side of its
// curves, tells whether it lies in F, for no boundary of F runs between them; else the exact test of rotated_contact.h
// does. Cost: prepared in O((n + m) log(n + m)), a window: its curves found (contact_index.h), those of one line or
// point taken together, and pairs of these in doubles, some ten microseconds for a point that numbers do not rule out,
// milliseconds where curves meet by threes. Source: rotated_free.h, which asks the same at all angles. Keywords:
// penetration depth, contact curve.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>

#include "plane/grid/boundary_box.h"
#include "plane/query/nearest.h"
#include "plane/rotation/contact_index.h"
#include "plane/rotation/rotated_contact.h"

namespace findspace::plane {

class FreePlaces {
 public:
  enum class Keep { kApart, kInside };

  /// Null unless both sets are regular and B is bounded. References are kept.
  static std::shared_ptr<const FreePlaces> make(const Region& a, const Region& b, Keep keep);

  FreePlaces(const FreePlaces&) = delete;
  FreePlaces& operator=(const FreePlaces&) = delete;

  /// All contact curves; nothing if there are none.
  const std::optional<GridBox>& bounds() const { return bounds_; }
  /// How many they are, or `most` if there are more.
  std::size_t curve_count(std::size_t most) const;
  bool is_free(const exact::RealPoint& s) const;

  using Curves = std::vector<ContactPair>;
  /// The curves that reach into the window, `most` of them if there are more; or those among some.
  Curves curves_in(const GridBox& window, std::size_t most) const;
  Curves curves_in(const GridBox& window, const Curves& among) const;

  /// What numbers are certain of, about the position (x, y).
  struct Certain {
    std::function<bool(double x, double y, double error)> held;   // not free, and no position within `error` of it is
    std::function<bool(double x, double y, double margin)> free;  // free, and so are all within `margin`
  };
  class From;

 private:
  FreePlaces(const Region& a, const Region& b, Keep keep);
  Curves curves_in(const RoughBox& box, std::size_t most) const;
  /// Of A, relative to a point.
  ContactFeatures features_of_a(const exact::RealPoint& about, const ChosenFeatures& chosen = {}) const;
  ContactFeatures seen_from(const exact::RealPoint& p) const;

  const Region &a_, &b_;
  Keep keep_;
  std::shared_ptr<const ContactFeatures> features_of_b_;  // that touch some of A, or all if there are few
  std::array<std::vector<Index>, 2> chosen_of_a_;         // rounds and edges that touch some of B, if not all are taken
  SignMap around_;                                        // the sign of a point's distance to A
  mutable std::mutex guard_;
  mutable std::optional<RotatedContact> contact_;  // of B with that, once it is asked for; guarded
  double tolerance_ = 0;                           // lengths below it are left to exact numbers
  std::optional<ContactCurves> curves_;
  std::optional<ContactIndex> index_;  // of these
  std::optional<GridBox> bounds_;
};

/// Seen from a position p.
class FreePlaces::From {
 public:
  From(const FreePlaces& places, const exact::RealPoint& p);

  /// Among projections, ends and meetings of these curves in the window: the free one nearest to p, or farthest from
  /// it.
  std::optional<Nearest> best(const GridBox& window, const Curves& curves, bool far, const Certain& certain) const;

 private:
  class Search;

  const FreePlaces& places_;
  exact::RealPoint p_;
  ContactCurves contacts_;  // relative to p
};

}  // namespace findspace::plane
