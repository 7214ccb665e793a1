// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/rotation/rotated_free.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "exact/margins/plane.h"
#include "plane/base/search_work.h"
#include "plane/query/topology.h"
#include "plane/rotation/curve_meetings.h"

namespace findspace::plane {

using exact::ExactAngle;
using exact::Real;
using Kind = ContactPair::Kind;

namespace {

// Cells of work, as measured: of exact steps by the depth of the angle.
constexpr std::array<long, kAngleDepths> kOfLine{1, 25, 12, 20, 50}, kOfArc{5, 10, 20, 80, 230};
constexpr std::size_t kPairsOfCurves = 2000;

RoughPoint unit(const ExactAngle& t) { return {t.cos.to_double(), t.sin.to_double()}; }

}  // namespace

RotatedFree::RotatedFree(const Pair& pair, Keep keep, std::optional<FreeWay> way)
    : pair_(pair),
      keep_(keep),
      way_(std::move(way)),
      curves_(contact_features(pair.rotating, pair.about, is_in),
              contact_features(pair.fixed, pair.to, keep == Keep::kApart ? is_in : is_out)),
      rotation_(pair.rotating, pair.about, is_in),
      open_(pair.fixed, pair.to, keep == Keep::kApart ? is_in : is_out),
      tolerance_(margin::kRotatedTolerance * std::max({1.0, rotation_.reach(), open_.reach()})) {}

/// F has places as far as one likes: A leaves out a bounded part of the plane or none, and B fits beside that.
bool RotatedFree::has_no_end() const {
  if (keep_ == Keep::kApart || is_bounded(pair_.fixed)) return false;
  return is_bounded(pair_.rotating) || pair_.fixed.vertices.empty();
}

/// The signs at single angles. One thread at a time.
class RotatedFree::Look {
 public:
  Look(const RotatedFree& free, const Real& level, bool far)
      : f_(free), level_(level), rough_level_(level.to_double()), far_(far), contact_(contact_pair(free.pair_)) {
    if (f_.keep_ == Keep::kApart) {
      const Pair& p = f_.pair_;
      back_ = std::make_unique<RotatedContact>(RotatedContact::Pair{p.fixed, p.around_rotation, p.to, p.about});
    }
  }

  Mark sign(const ExactAngle& rotation, AngleDepth depth) {
    depth_ = depth;
    prepare(rotation);
    count_cells(1 + long(pairs_.size() * pairs_.size() / kPairsOfCurves));
    return far_ ? farthest() : nearest();
  }

 private:
  struct Candidate {
    RoughPoint at;
    double distance, off;       // off: how far `at` may be off
    std::size_t first, second;  // of curves_; equal for a projection, kNone for the origin and for the way
  };

  static RotatedContact::Pair contact_pair(const Pair& p) { return {p.rotating, p.around_fixed, p.about, p.to}; }

  void prepare(const ExactAngle& rotation) {
    rotation_ = rotation;
    const double angle = rotation.degrees() * kPi / 180;
    here_.emplace(f_.rotation_.rotated(unit(rotation)));
    pairs_ = f_.curves_.pairs(angle, 0);
    rough_.clear();
    for (const ContactPair& k : pairs_) rough_.push_back(f_.curves_.rough(k, angle));
    candidates_.clear();
    add({RoughPoint(), 0}, kNone, kNone);
    for (std::size_t i = 0; i < rough_.size(); ++i) {
      if (!far_ && rough_[i].least() > rough_level_ + f_.tolerance_) continue;
      if (f_.way_) {
        add_crossings(i, f_.way_->rough(angle, 1));
        continue;
      }
      for (RoughPoint s : rough_projections(rough_[i], f_.tolerance_)) add({s, 0}, i, i);
      for (std::size_t k = i + 1; k < rough_.size(); ++k) {
        if (!far_ && rough_[k].least() > rough_level_ + f_.tolerance_) continue;
        if (never_cross(i, k)) continue;
        for (const RoughMeeting& m : rough_meetings(rough_[i], rough_[k], margin::kRoughCurveError * f_.tolerance_)) {
          const double tolerance = f_.tolerance_ + m.off;
          if (rough_[i].holds(m.at, tolerance) && rough_[k].holds(m.at, tolerance)) add(m, i, k);
        }
      }
    }
    std::sort(candidates_.begin(), candidates_.end(),
              [](const Candidate& p, const Candidate& q) { return p.distance < q.distance; });
  }

  /// Lines that are parallel, or circles that are one, at every angle.
  bool never_cross(std::size_t i, std::size_t k) const {
    const ContactPair &p = pairs_[i], &q = pairs_[k];
    if (p.kind != q.kind) return false;
    const ContactFeatures &a = f_.curves_.fixed(), &b = f_.curves_.rotating();
    if (p.kind == Kind::kRounds) {
      return a.rounds[p.fixed].center == a.rounds[q.fixed].center &&
             b.rounds[p.rotating].center == b.rounds[q.rotating].center;
    }
    if (std::abs((std::conj(rough_[i].normal) * rough_[k].normal).imag()) > margin::kOneDirection) return false;
    const bool fixed = p.kind == Kind::kFixedEdge;
    const EdgeFeature &e = fixed ? a.edges[p.fixed] : b.edges[p.rotating],
                      &g = fixed ? a.edges[q.fixed] : b.edges[q.rotating];
    return plane::cross(exact_normal(e), exact_normal(g)).sign() == 0;
  }

  void add(const RoughMeeting& m, std::size_t first, std::size_t second) {
    const double d = std::abs(m.at);
    if (!far_ && d > rough_level_ + f_.tolerance_ + m.off) return;
    candidates_.push_back({m.at, d, m.off, first, second});
  }

  void add_crossings(std::size_t i, const RoughCurve& way) {
    for (const RoughMeeting& m : rough_meetings(rough_[i], way, margin::kRoughCurveError * f_.tolerance_)) {
      const double tolerance = f_.tolerance_ + m.off;
      const bool ahead = way.p != RoughPoint() || m.at.real() * way.q.real() + m.at.imag() * way.q.imag() >= -tolerance;
      if (ahead && rough_[i].holds(m.at, tolerance)) add(m, i, kNone);
    }
  }

  bool surely_not_free(const Candidate& c) const {
    if (f_.keep_ == Keep::kNotWithin) return false;
    return surely_meets(*here_, f_.open_, c.at, f_.keep_ == Keep::kApart, f_.tolerance_ + c.off);
  }

  bool is_free(const RealVector& s) {
    if (f_.keep_ == Keep::kNotWithin) return meets(contact_, rotation_, kZero | kPositive, s);
    if (f_.keep_ == Keep::kInside) return !meets(contact_, rotation_, kPositive, s);
    if (meets(contact_, rotation_, kNegative, s)) return false;
    return !meets(*back_, -rotation_, kNegative, -((-rotation_)(s)));
  }

  bool meets(RotatedContact& contact, const ExactAngle& angle, MarkSet marks, const RealVector& s) {
    const bool met = (contact.marks_met(angle, marks, s) & marks) != 0;
    AngleDepth depth = depth_;
    if (depth == AngleDepth::kRational && !(s.x.is_rational() && s.y.is_rational())) depth = AngleDepth::kClosed;
    const RotatedContact::Steps& steps = contact.steps();
    count_cells(1 + kOfLine[std::size_t(depth)] * steps.lines + kOfArc[std::size_t(depth)] * steps.arcs);
    return met;
  }

  /// The exact point; nothing where the curves do not meet after all.
  std::optional<RealVector> exact_point(const Candidate& c) const {
    if (c.first == kNone) return RealVector{};
    const ExactCurve first = f_.curves_.exact(pairs_[c.first], rotation_);
    if (c.first == c.second) return exact_projection(first, c.at);
    const ExactCurve other =
        c.second == kNone ? f_.way_->exact(rotation_) : f_.curves_.exact(pairs_[c.second], rotation_);
    const std::optional<RealVector> best = exact_meeting(first, other, c.at);
    if (best && f_.way_ && !f_.way_->both_ways) {
      const RealVector& u = f_.way_->along;
      if (plane::dot(f_.way_->rotations ? rotation_(u) : u, *best).sign() < 0) return std::nullopt;
    }
    return best;
  }

  /// The sign of a candidate's distance minus the level, if it is free.
  std::optional<Mark> of_free(const Candidate& c) {
    if (surely_not_free(c)) return std::nullopt;
    const double over = c.distance - rough_level_;
    const std::optional<RealVector> s = exact_point(c);
    if (!s || !is_free(*s)) return std::nullopt;
    if (std::abs(over) > f_.tolerance_ * margin::kRotatedSum + c.off) return Mark(over > 0 ? 1 : -1);
    return Mark(compare(plane::dot(*s, *s), level_ * level_));
  }

  Mark nearest() {
    Mark least = 1;
    for (const Candidate& c : candidates_) {
      if (least == 0 && c.distance > rough_level_ + f_.tolerance_ + c.off) continue;
      const std::optional<Mark> m = of_free(c);
      if (m && *m < 0) return -1;
      if (m) least = std::min(least, *m);
    }
    return least;
  }

  Mark farthest() {
    std::optional<Mark> most;
    for (auto c = candidates_.rbegin(); c != candidates_.rend(); ++c) {
      if (most && c->distance < rough_level_ - f_.tolerance_ - c->off) continue;
      const std::optional<Mark> m = of_free(*c);
      if (m && *m > 0) return 1;
      if (m && (!most || *m > *most)) most = m;
    }
    return most ? *most : Mark(1);
  }

  const RotatedFree& f_;
  const Real& level_;
  double rough_level_;
  bool far_;
  RotatedContact contact_;
  std::unique_ptr<RotatedContact> back_;
  ExactAngle rotation_;
  AngleDepth depth_ = AngleDepth::kRational;
  std::optional<RoughSet> here_;
  std::vector<ContactPair> pairs_;
  std::vector<RoughCurve> rough_;
  std::vector<Candidate> candidates_;
};

RotationMap RotatedFree::rotation_map(const Real& level, bool far, const RotationMap& within) const {
  if (far && has_no_end()) return RotationMap::uniform(1);
  const FreeQuestion question{curves_, rotation_, open_,      keep_ == Keep::kApart,
                              level,   far,       tolerance_, way_ ? &*way_ : nullptr};
  std::vector<ExactAngle> events;
  std::vector<AngleDepth> depths;
  for (FreeEvent& e : free_events(question)) {
    events.push_back(std::move(e.rotation));
    depths.push_back(e.depth);
  }
  return marks_within(within, events, [&]() -> AngleMark {
    const auto look = std::make_shared<Look>(*this, level, far);
    return [look, &depths](std::size_t place, const ExactAngle& angle) {
      return look->sign(angle, place % 2 == 0 ? depths[place / 2] : AngleDepth::kRational);
    };
  });
}

}  // namespace findspace::plane
