// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The kinds of parts, and how deep any two of them overlap at any position, in doubles. Two convex parts overlap where
// all planes of their Phi-function are negative; their depth is minus the greatest. The depth of two unions is the sum
// over all pairs of convex parts. So along any line it is concave between the ends of the pairs' intervals, and least
// at one of them. With a gap the planes lie farther out by it. A pair's planes are made when it is first looked at, by
// any thread. Guarantee: that of doubles; it steers a search, proofs do not use it. Source: phi.md 2, 10. Keywords:
// penetration depth, configuration-space obstacle, no-fit polyhedron.
#pragma once

#include <algorithm>
#include <atomic>
#include <memory>
#include <mutex>
#include <span>
#include <utility>
#include <vector>

#include "packing/solid_problem/solid_problem.h"
#include "space/phi/plane_scan.h"

namespace findspace::packing {

using space::Vector;

inline Vector operator+(const Vector& a, const Vector& b) { return space::plus(a, b); }
inline Vector operator*(double s, const Vector& a) { return space::scaled(s, a); }

/// The open set of the positions of B + u where it overlaps A, of two convex parts.
struct ConvexOverlap {
  Vector low, high;  // its box
  std::span<const space::PlaneBlock> planes;

  bool may_hold(const Vector& u) const {
    return u.x > low.x && u.y > low.y && u.z > low.z && u.x < high.x && u.y < high.y && u.z < high.z;
  }
  /// 0 where there is none.
  double depth(const Vector& u) const;
  /// t with u + t way in the set, where the line comes deeper than `shallow`; crossed elsewhere.
  space::LineStretch stretch(const Vector& u, const Vector& way, double shallow) const;
  space::Highest highest(const Vector& u) const { return space::scan_planes(planes.data(), planes.size(), u); }
  Vector normal(int plane) const {
    const space::PlaneBlock& b = planes[std::size_t(plane) / 8];
    return {b.x[plane % 8], b.y[plane % 8], b.z[plane % 8]};
  }
};

/// Of two kinds.
class OverlapPair {
 public:
  Vector low, high;  // the box of all
  std::vector<ConvexOverlap> overlaps;

  bool may_hold(const Vector& u) const {
    return u.x > low.x && u.y > low.y && u.z > low.z && u.x < high.x && u.y < high.y && u.z < high.z;
  }
  double depth(const Vector& u, double shallow) const;

 private:
  friend class SolidTable;
  std::vector<space::PlaneBlock> blocks_;
};

/// A part where it stands, relative to the corner within the edges.
struct SolidPose {
  std::size_t variant = 0;
  Vector at;
};

/// A form of a part that fits the floor; of forms that look the same, moved, only the first.
struct SolidVariant {
  std::size_t part = 0, form = 0;
  Vector low, high;  // the box about its origin
};

class SolidTable {
 public:
  /// The problem must live as long.
  explicit SolidTable(const SolidProblem& problem);

  const std::vector<SolidVariant>& variants() const { return variants_; }
  const std::vector<std::size_t>& variants_of(std::size_t part) const { return of_part_[part]; }
  /// The pose of a placed part.
  SolidPose pose_of(const SolidPlaced& item) const;
  /// Of the floor within the edges.
  double width() const { return width_; }
  double depth() const { return depth_; }
  /// Of the floor, which all margins are relative to.
  double size() const { return std::max(width_, depth_); }
  double gap() const { return gap_; }
  double edge() const { return edge_; }
  /// The highest part in its lowest form; no layout is lower.
  double tallest() const { return tallest_; }

  /// How a copy of b overlaps one of a at the origin, or the other way round with all positions reflected: sign -1.
  struct Link {
    const OverlapPair& pair;
    double sign;
  };
  Link link(std::size_t a, std::size_t b) const {
    const double sign = a <= b ? 1 : -1;
    if (a > b) std::swap(a, b);
    const std::atomic<const OverlapPair*>& known = pairs_[a * variants_.size() + b];
    if (const OverlapPair* pair = known.load(std::memory_order_acquire)) return {*pair, sign};
    return {make(a, b), sign};
  }

 private:
  const SolidForm& form_of(const SolidVariant& v) const { return problem_.parts[v.part].forms[v.form]; }
  void add_variants(std::size_t part);
  const OverlapPair& make(std::size_t a, std::size_t b) const;

  const SolidProblem& problem_;
  double width_, depth_, gap_, edge_, tallest_ = 0;
  std::vector<SolidVariant> variants_;
  std::vector<std::vector<std::size_t>> of_part_;
  mutable std::vector<std::atomic<const OverlapPair*>> pairs_;
  mutable std::vector<std::unique_ptr<const OverlapPair>> made_;
  mutable std::mutex guard_;
};

}  // namespace findspace::packing
