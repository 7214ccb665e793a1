// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/rotation/free_places.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "exact/margins/plane.h"
#include "plane/query/topology.h"
#include "plane/rotation/curve_meetings.h"

namespace findspace::plane {

using exact::ExactAngle;
using exact::Real;
using exact::RealPoint;

namespace {

constexpr double kBeside = 64;  // tolerances: how far beside a point a position is tried

/// The sign of a point's distance to a regular set.
SignMap signs(Region r) {
  for (Face& f : r.faces) f.mark = f.mark > 0 ? -1 : 1;
  for (Edge& e : r.edges) e.mark = 0;
  for (Vertex& v : r.vertices) v.mark = 0;
  return r;
}

double size_of(const Region& r) {
  double size = 1;
  for (const Vertex& v : r.vertices) {
    const exact::Point& p = r.geometry.points[v.point];
    size = std::max({size, std::abs(p.x), std::abs(p.y)});
  }
  return size;
}

}  // namespace

std::shared_ptr<const FreePlaces> FreePlaces::make(const Region& a, const Region& b, Keep keep) {
  if (!is_bounded(b) || !is_regular(a) || !is_regular(b)) return nullptr;
  return std::shared_ptr<const FreePlaces>(new FreePlaces(a, b, keep));
}

FreePlaces::FreePlaces(const Region& a, const Region& b, Keep keep)
    : a_(a), b_(b), keep_(keep), around_(signs(a)), tolerance_(margin::kRotatedTolerance * (size_of(a) + size_of(b))) {
  // Of the larger set those that touch some of the other.
  ContactFeatures fixed;
  if (a.edges.size() > b.edges.size()) {
    features_of_b_ = std::make_shared<ContactFeatures>(contact_features(b, {}, is_in));
    fixed = features_of_a({}, [&](const FeatureOutline& f) {
      const bool touches = may_touch_one(*features_of_b_, false, f);
      if (touches) chosen_of_a_[f.edge].push_back(f.number);
      return touches;
    });
  } else {
    fixed = features_of_a({});
    features_of_b_ = std::make_shared<ContactFeatures>(
        contact_features(b, {}, is_in, [&](const FeatureOutline& f) { return may_touch_one(fixed, true, f); }));
  }
  curves_.emplace(features_of_b_, std::move(fixed));
  index_.emplace(*curves_, tolerance_);
  if (const std::optional<RoughBox> whole = index_->bounds())
    bounds_ = GridBox{std::llround(whole->x0) - 1, std::llround(whole->y0) - 1, std::llround(whole->x1) + 1,
                      std::llround(whole->y1) + 1};
}

ContactFeatures FreePlaces::features_of_a(const RealPoint& about, const ChosenFeatures& chosen) const {
  return contact_features(a_, about, keep_ == Keep::kApart ? is_in : is_out, chosen);
}

bool FreePlaces::is_free(const RealPoint& s) const {
  const std::lock_guard lock(guard_);
  if (!contact_) contact_.emplace(RotatedContact::Pair{b_, around_, {}, {}});
  const MarkSet held = keep_ == Keep::kApart ? kNegative : kPositive;
  return (contact_->marks_met(ExactAngle{}, held, s) & held) == 0;
}

std::size_t FreePlaces::curve_count(std::size_t most) const {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  std::size_t count = 0;
  index_->visit({-kFar, -kFar, kFar, kFar}, [&](const ContactPair&) { return ++count < most; });
  return count;
}

FreePlaces::Curves FreePlaces::curves_in(const RoughBox& box, std::size_t most) const {
  Curves out;
  index_->visit(box, [&](const ContactPair& k) {
    out.push_back(k);
    return out.size() < most;
  });
  if (out.size() < most) std::sort(out.begin(), out.end());
  return out;
}

FreePlaces::Curves FreePlaces::curves_in(const GridBox& w, std::size_t most) const {
  return curves_in(RoughBox{double(w.x0), double(w.y0), double(w.x1), double(w.y1)}, most);
}

FreePlaces::Curves FreePlaces::curves_in(const GridBox& w, const Curves& among) const {
  const RoughBox box{double(w.x0), double(w.y0), double(w.x1), double(w.y1)};
  Curves out;
  for (const ContactPair& k : among)
    if (!box.apart(index_->box(k))) out.push_back(k);
  return out;
}

/// The features of A that the curves are of, and they have the same numbers, wherever they are seen from.
ContactFeatures FreePlaces::seen_from(const RealPoint& p) const {
  if (a_.edges.size() <= b_.edges.size()) return features_of_a(p);
  std::array<std::size_t, 2> next{0, 0};
  return features_of_a(p, [&](const FeatureOutline& f) {
    const std::vector<Index>& chosen = chosen_of_a_[f.edge];
    std::size_t& k = next[f.edge];
    const bool taken = k < chosen.size() && chosen[k] == f.number;
    k += taken;
    return taken;
  });
}

FreePlaces::From::From(const FreePlaces& places, const RealPoint& p)
    : places_(places), p_(p), contacts_(places.features_of_b_, places.seen_from(p)) {}

/// Everything relative to p.
class FreePlaces::From::Search {
 public:
  Search(const From& from, const GridBox& w, const Curves& which, bool far, const Certain& certain)
      : f_(from.places_),
        p_(from.p_),
        x_(rough(p_.x)),
        y_(rough(p_.y)),
        far_(far),
        certain_(certain),
        curves_(from.contacts_),
        pairs_(which) {
    window_ = {double(w.x0) - x_, double(w.y0) - y_, double(w.x1) - x_, double(w.y1) - y_};
    for (const ContactPair& k : pairs_) rough_.push_back(curves_.rough(k, 0));
    make_bundles();
    for (std::size_t i = 0; i < bundles_.size(); ++i) {
      add_projections(bundles_[i]);
      for (std::size_t k = i + 1; k < bundles_.size(); ++k) add_meetings(bundles_[i], bundles_[k]);
    }
    std::sort(candidates_.begin(), candidates_.end(),
              [&](const Candidate& c, const Candidate& d) { return place_in_order(c) < place_in_order(d); });
  }

  std::optional<Nearest> run() const {
    std::optional<Nearest> best;
    Real least;  // the best one's square
    double reached = 0;
    for (const Candidate& c : candidates_) {
      const double off = f_.tolerance_ + c.off;
      if (best && (far_ ? c.distance < reached - off : c.distance > reached + off)) continue;
      if (certain_.held(c.at.real() + x_, c.at.imag() + y_, off)) continue;
      const std::optional<bool> free = is_free(c);
      if (free && !*free) continue;
      const std::optional<RealVector> s = exact_point(c);
      if (!s) continue;
      // Many may be equally far, on one circle about p: of squares that is mostly seen at once.
      Real square = plane::dot(*s, *s);
      if (best && (far_ ? square <= least : square >= least)) continue;
      const RealVector at = *s + p_;
      if (!free && !f_.is_free(at)) continue;
      least = square;
      best = Nearest{sqrt(square), at, {}};
      reached = best->distance.to_double();
    }
    return best;
  }

 private:
  struct Candidate {
    RoughPoint at;
    double distance, off;       // off: how far `at` may be off
    std::size_t first, second;  // of the curves; equal for a projection
  };

  /// Of those in one place, where many curves meet, such on lines come first: roots of circles cost much to compare.
  double place_in_order(const Candidate& c) const {
    const double least = far_ ? -c.distance : c.distance;
    return rough_[c.first].line && rough_[c.second].line ? least - f_.tolerance_ : least + c.off;
  }

  void add(RoughPoint at, double off, std::size_t first, std::size_t second) {
    const double tolerance = f_.tolerance_ + off;
    if (RoughBox{at.real() - tolerance, at.imag() - tolerance, at.real() + tolerance, at.imag() + tolerance}.apart(
            window_))
      return;
    candidates_.push_back({at, length(at), off, first, second});
  }

  /// Curves on one line, or in one point, seen from the same side: where some of them is, as good as one.
  using Bundle = std::vector<std::size_t>;

  /// Of a corner: its curves are many where shapes have edges on one line, as combs do.
  bool is_of_corner(std::size_t i) const {
    const ContactPair& k = pairs_[i];
    using Kind = ContactPair::Kind;
    const bool fixed = k.kind == Kind::kFixedEdge || curves_.fixed().rounds[k.fixed].r == 0;
    return fixed && (k.kind == Kind::kTurningEdge || curves_.rotating().rounds[k.rotating].r == 0);
  }

  /// What curves of a bundle have in common, in numbers.
  std::array<double, 4> key(std::size_t i) const {
    const RoughCurve& c = rough_[i];
    if (c.line) return {1, c.normal.real(), c.normal.imag(), c.offset()};
    return {0, c.center.real(), c.center.imag(), 0};
  }

  bool goes_with(std::size_t i, std::size_t k) const {
    if (rough_[i].line != rough_[k].line || !is_of_corner(i) || !is_of_corner(k)) return false;
    const auto p = key(i), q = key(k);
    if (rough_[i].line ? p[1] != q[1] || p[2] != q[2] || std::abs(p[3] - q[3]) > f_.tolerance_
                       : std::max(std::abs(p[1] - q[1]), std::abs(p[2] - q[2])) > f_.tolerance_)
      return false;
    const ExactCurve c = curves_.exact(pairs_[i], ExactAngle{}), d = curves_.exact(pairs_[k], ExactAngle{});
    if (!c.line) return c.center == d.center;
    return plane::cross(c.normal, d.normal).sign() == 0 && c.normal.x * d.offset == d.normal.x * c.offset &&
           c.normal.y * d.offset == d.normal.y * c.offset;
  }

  void make_bundles() {
    std::vector<std::pair<std::array<double, 4>, std::size_t>> order;
    for (std::size_t i = 0; i < rough_.size(); ++i) order.push_back({key(i), i});
    std::sort(order.begin(), order.end());
    for (const auto& [key, i] : order) {
      if (bundles_.empty() || !goes_with(bundles_.back().front(), i)) bundles_.emplace_back();
      bundles_.back().push_back(i);
    }
    // By their first curves, as these are told.
    for (Bundle& b : bundles_) std::sort(b.begin(), b.end());
    std::sort(bundles_.begin(), bundles_.end());
  }

  void add_projections(const Bundle& bundle) {
    for (const std::size_t i : bundle) {
      const std::vector<RoughPoint> found = rough_projections(rough_[i], f_.tolerance_);
      for (RoughPoint s : found) add(s, 0, i, i);
      if (!found.empty()) return;
    }
  }

  std::optional<std::size_t> one_that_holds(const Bundle& bundle, RoughPoint at, double tolerance) const {
    for (const std::size_t i : bundle)
      if (rough_[i].holds(at, tolerance)) return i;
    return std::nullopt;
  }

  void add_meetings(const Bundle& a, const Bundle& b) {
    for (const RoughMeeting& m :
         rough_meetings(rough_[a.front()], rough_[b.front()], margin::kRoughCurveError * f_.tolerance_)) {
      const double tolerance = f_.tolerance_ + m.off;
      const auto i = one_that_holds(a, m.at, tolerance);
      if (!i) continue;
      const auto k = one_that_holds(b, m.at, tolerance);
      if (k) add(m.at, m.off, *i, *k);
    }
  }

  /// By a position beside it, if numbers tell.
  std::optional<bool> is_free(const Candidate& c) const {
    const double step = kBeside * (f_.tolerance_ + c.off), reach = 2 * step;
    const RoughPoint u = rough_[c.first].normal_at(c.at), v = rough_[c.second].normal_at(c.at);
    const double along = length(u + v) / 2;  // the cosine of half the angle between them
    if (along < margin::kOpenCurves || std::min(bend(c.first), bend(c.second)) < 8 * reach / along) return std::nullopt;
    const RoughPoint way = (u + v) / (2 * along);
    const double x = c.at.real() + x_, y = c.at.imag() + y_;
    bool alone = true;
    f_.index_->visit({x - reach, y - reach, x + reach, y + reach}, [&](const ContactPair& k) {
      return alone = k == pairs_[c.first] || k == pairs_[c.second] || leaves_alone(k, c, way, reach);
    });
    if (!alone) return std::nullopt;
    const double bx = x + step * way.real(), by = y + step * way.imag(), margin = step * along / 4;
    if (certain_.free(bx, by, margin)) return true;
    if (certain_.held(bx, by, margin)) return false;
    return std::nullopt;
  }

  /// Another curve does not pass within reach, or the candidate lies on its free side, and the way leads away from it.
  bool leaves_alone(const ContactPair& k, const Candidate& c, RoughPoint way, double reach) const {
    const RoughCurve r = curves_.rough(k, 0);
    const double round = length(c.at - r.center) - std::abs(r.radius);
    const double over = r.line ? dot(r.normal, c.at) - r.offset() : r.radius > 0 ? round : -round;
    if (std::abs(over) > reach || !r.holds(c.at, reach)) return true;
    return over > 2 * (f_.tolerance_ + c.off) && (r.line || std::abs(r.radius) > 8 * reach) &&
           dot(r.normal_at(c.at), way) > margin::kOpenCurves;
  }

  double bend(std::size_t i) const {
    return rough_[i].line ? std::numeric_limits<double>::infinity() : std::abs(rough_[i].radius);
  }

  /// Nothing where the curves do not meet after all.
  std::optional<RealVector> exact_point(const Candidate& c) const {
    const ExactCurve e = curves_.exact(pairs_[c.first], ExactAngle{});
    if (c.first == c.second) return exact_projection(e, c.at);
    return exact_meeting(e, curves_.exact(pairs_[c.second], ExactAngle{}), c.at);
  }

  const FreePlaces& f_;
  const RealPoint& p_;
  double x_, y_;
  bool far_;
  const Certain& certain_;
  const ContactCurves& curves_;
  RoughBox window_;
  const Curves& pairs_;
  std::vector<RoughCurve> rough_;
  std::vector<Bundle> bundles_;
  std::vector<Candidate> candidates_;
};

std::optional<Nearest> FreePlaces::From::best(const GridBox& window, const Curves& curves, bool far,
                                              const Certain& certain) const {
  return Search(*this, window, curves, far, certain).run();
}

}  // namespace findspace::plane
