// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/planar_least/extremum.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "distance/planar_features/point_set.h"
#include "distance/planar_least/extremum_candidates.h"
#include "distance/planar_least/level_cover.h"
#include "distance/planar_least/level_probe.h"
#include "distance/planar_least/level_windows.h"
#include "exact/margins/planar_distance.h"
#include "exact/margins/plane.h"
#include "plane/base/real_vector.h"
#include "plane/complex/overlay.h"
#include "plane/query/locate.h"
#include "plane/query/moved.h"
#include "plane/query/topology.h"

namespace findspace::distance {

using exact::Real;
using exact::RealPoint;
using plane::CellComplex;
using plane::Region;
using plane::operator-;

namespace {

constexpr int kMostProbes = 120;
constexpr std::size_t kManyEdges = 60;  // from here on a sign map costs more than many values

/// A number between the two with few digits.
double simple_between(double low, double high) {
  double grain = std::exp2(std::floor(std::log2(high - low)) - 2);
  double middle = low + (high - low) / 2, round = std::round(middle / grain) * grain;
  return round > low && round < high ? round : middle;
}

class ExtremumSearch {
 public:
  ExtremumSearch(const TDistance& f, const Region& s, Sense sense)
      : f_(f),
        s_(s),
        closure_(plane::closure(s)),
        whole_(plane::is_whole(s)),
        sense_(sense),
        rotation_(sense == Sense::kMinimum ? 1 : -1) {}

  Extremum run(const std::optional<Bracket>& known);

 private:
  CellComplex probe(const Real& level, const Region& over);
  /// The cells of the closure of S at the last level that was reached, and beyond.
  const CellComplex& reached();
  void set_reached(const Real& level, CellComplex cells);
  void cover();
  void open_windows();
  RealPoint start() const {
    return whole_ || closure_.vertices.empty() ? f_.seed() : closure_.geometry.exact(closure_.vertices[0].point);
  }
  double number(const Real& level) const { return rotation_ * near_value(level); }
  bool reaches(const Real& level);
  bool accept(const Real& level);
  bool grows_without_end() const;
  double extent() const;
  Extremum none() const { return no_optimum<Region>(sense_); }
  Extremum infinite(bool below) const;
  bool bracket(const Real& value);
  bool take(const Bracket& known);
  bool try_near(const std::vector<Real>& all, double number);
  bool try_candidates();
  void climb(double step);
  void enclose();
  void pin_down();
  bool take_lowest(Extremum& out) const;
  Extremum proven();
  Extremum enclosed();

  const TDistance& f_;
  const Region& s_;
  Region closure_;
  bool whole_;
  Sense sense_;
  int rotation_;
  double bad_ = 0, good_ = 0, scale_ = 1;  // rotated so that less is better: the extremum is in (bad, good]
  std::optional<Real> reached_level_;      // the last one that was reached
  std::optional<CellComplex> reached_;     // its cells, made when asked for
  std::optional<LevelCover> cover_;
  std::optional<LevelWindows> windows_;  // within the cover
  std::vector<Real> refused_;
  std::optional<Bracket> known_;
  Real level_, beyond_;   // the extremum; where it is enclosed: what is reached, and what is not
  CellComplex accepted_;  // probed at it over the closure
  bool value_only_ = false;
};

CellComplex ExtremumSearch::probe(const Real& level, const Region& over) {
  if (windows_ && windows_->hold(level)) {
    if (auto cells = windows_->probe(level, over)) return *std::move(cells);
  }
  return distance::probe(f_, level, over, rotation_);
}

const CellComplex& ExtremumSearch::reached() {
  if (!reached_) reached_ = reached_level_ ? probe(*reached_level_, closure_) : CellComplex{};
  return *reached_;
}

void ExtremumSearch::set_reached(const Real& level, CellComplex cells) {
  reached_level_ = level;
  reached_ = std::move(cells);
  if (windows_) windows_->shrink(*reached_, level, bad_);
}

bool ExtremumSearch::reaches(const Real& level) {
  if (const auto known = cover_ ? cover_->is_passed(level) : std::nullopt) {
    (*known ? good_ : bad_) = number(level);
    if (*known) {
      reached_level_ = level;
      reached_.reset();
    }
    return *known;
  }
  CellComplex c = probe(level, closure_);
  bool yes = has_mark(c, kOn) || has_mark(c, kBeyond);
  (yes ? good_ : bad_) = number(level);
  if (yes) set_reached(level, std::move(c));
  return yes;
}

/// Is this the extremum? Narrows the bracket if not.
bool ExtremumSearch::accept(const Real& level) {
  CellComplex c = probe(level, closure_);
  if (has_mark(c, kBeyond)) {
    good_ = number(level);
    set_reached(level, std::move(c));
    return false;
  }
  if (!has_mark(c, kOn)) {
    bad_ = number(level);
    return false;
  }
  level_ = level;
  accepted_ = std::move(c);
  return true;
}

/// Where sign maps cost much, values tell most of what is asked.
void ExtremumSearch::cover() {
  const auto size = f_.size();
  if (size && size->edges >= kManyEdges) cover_ = LevelCover::of(f_, closure_, rotation_, start());
}

/// Where candidates are to be tried, around all that is as good as the levels asked for then.
void ExtremumSearch::open_windows() {
  if (!cover_) return;
  windows_.emplace(f_, closure_, rotation_);
  const double slack = scale_ * margin::kTryCandidates * margin::kUpward;
  if (cover_->narrow(slack, slack / 2))
    windows_->open(cover_->boxes(), Real::from_double(rotation_ * cover_->most()), cover_->low());
}

/// Whether f tends to infinity within S: far away it is positive then. It is 0 there where it is max(0, -g), and
/// negative about the complement of a bounded shape.
bool ExtremumSearch::grows_without_end() const { return s_.faces[0].mark > 0 && f_.sign_map(Real()).faces[0].mark > 0; }

double ExtremumSearch::extent() const {
  double most = 1;
  for (const auto& v : closure_.vertices) {
    const auto& p = closure_.geometry.points[v.point];
    most = std::max({most, std::abs(p.x), std::abs(p.y)});
  }
  return most;
}

/// f is +infinity or, `below`, -infinity everywhere: it changes no faster than the position.
Extremum ExtremumSearch::infinite(bool below) const {
  Extremum e = none();
  if (!below) return e;
  e.set_lowest(Way::kMap);
  e.at = s_;
  return e;
}

/// Around the extremum, from the value at some position; false where there is no bound.
bool ExtremumSearch::bracket(const Real& value) {
  good_ = rotation_ * value.to_double();
  scale_ = std::max(scale_, std::abs(good_));
  good_ += scale_ * margin::kBracketSlack;
  double step = std::max(1.0, scale_ / 8);
  const auto is_reached = [this](double number) {
    const Real level = Real::from_double(rotation_ * number);
    if (cover_) cover_->decide(level);
    return reaches(level);
  };
  for (bad_ = good_ - step; is_reached(bad_); step *= 2) {
    bad_ = good_ - step;
    if (bad_ < -margin::kBeyondAll) return false;
  }
  // Over the whole plane nothing else says how large all is.
  scale_ = std::max({scale_, std::abs(bad_), std::abs(good_)});
  return true;
}

/// Begins with what is known, if the level that is said to be reached is.
bool ExtremumSearch::take(const Bracket& known) {
  const double tolerance = scale_ * margin::kKnownNumber;
  const double good = rotation_ * known.reached + tolerance;
  if (!reaches(Real::from_double(rotation_ * good))) return false;
  bad_ = std::min(rotation_ * known.bound - tolerance, good - 2 * tolerance);
  known_ = known;
  return true;
}

/// The candidate next to a number, if one is as near as rounding.
bool ExtremumSearch::try_near(const std::vector<Real>& all, double number) {
  const auto far = [number](const Real& l) { return std::abs(near_value(l) - number); };
  const auto best =
      std::min_element(all.begin(), all.end(), [&](const auto& l, const auto& m) { return far(l) < far(m); });
  if (far(*best) > scale_ * margin::kNearCandidate) return false;
  if (accept(*best)) return true;
  refused_.push_back(*best);
  return false;
}

bool ExtremumSearch::try_candidates() {
  double low = bad_ - scale_ * margin::kBracketEnds, high = good_ + scale_ * margin::kBracketEnds;
  auto all =
      extremum_candidates(f_, whole_ ? nullptr : &closure_, reached(), std::min(rotation_ * low, rotation_ * high),
                          std::max(rotation_ * low, rotation_ * high));
  std::erase_if(all, [&](const Real& l) {
    return std::any_of(refused_.begin(), refused_.end(), [&](const Real& r) { return near_value(r) == near_value(l); });
  });
  if (all.empty()) return false;
  if (known_ && try_near(all, std::exchange(known_, std::nullopt)->reached)) return true;
  // Candidates of one value are tried; several values are decided apart by bisection first.
  double spread = std::abs(near_value(all.front()) - near_value(all.back()));
  if (spread > scale_ * margin::kOneCandidate) return false;
  for (std::size_t k = 0; k < all.size() && k < 3; ++k) {
    if (accept(all[k])) return true;
    refused_.push_back(all[k]);
  }
  return false;
}

/// At the level that was accepted.
Extremum ExtremumSearch::proven() {
  Extremum e = none();
  e.set_exact(level_, Way::kMap);
  if (value_only_) return e;
  if (!whole_) e.at = on_level(probe(level_, s_));
  e.attained = whole_ || !plane::is_empty(e.at);
  if (whole_ || !e.attained) e.at = on_level(std::move(accepted_));
  return e;
}

Extremum ExtremumSearch::enclosed() {
  Extremum e = none();
  e.set_enclosed(level_, beyond_, Way::kMap);
  if (value_only_) return e;
  const ComponentPoints found = one_point_a_component(reached());
  e.within = found.within;
  e.at = point_set(found.points);
  const std::array<const Region*, 2> beside{&closure_, &s_};
  const CellComplex lacking = probe(level_, plane::subtract(beside));
  e.attained = whole_ || !(has_mark(lacking, kOn) || has_mark(lacking, kBeyond));
  return e;
}

/// The family knows its least value, and a position of the closure of S has it.
bool ExtremumSearch::take_lowest(Extremum& out) const {
  const auto lowest = rotation_ > 0 ? f_.lowest() : std::nullopt;
  if (!lowest || (!whole_ && plane::mark_of(closure_, plane::locate(closure_, lowest->at)) <= 0)) return false;
  out = none();
  out.set_exact(lowest->level, Way::kMap);
  out.at = point_set({&lowest->at, 1});
  out.attained = whole_ || plane::mark_of(s_, plane::locate(s_, lowest->at)) > 0;
  return true;
}

/// To a good end that is reached, whatever the value at the start was.
void ExtremumSearch::climb(double step) {
  for (; !reaches(Real::from_double(rotation_ * good_)); step *= 2) good_ += step;
}

/// What was rounded at the ends of the bracket, by exact sign maps: (bad, good] holds the extremum.
void ExtremumSearch::enclose() {
  double step = std::max(good_ - bad_, scale_ * margin::kNarrowestBracket);
  climb(step);
  for (double low = bad_; reaches(Real::from_double(rotation_ * low)); step *= 2) low = good_ - step;
  level_ = Real::from_double(rotation_ * good_);
  beyond_ = Real::from_double(rotation_ * bad_);
}

/// Where two opposite level curves meet, positions as good as the level lie as far apart as the square root of what it
/// is off: the bracket is narrowed, past doubles, until they are decided, or lie no nearer (curves and faces of best
/// ones).
void ExtremumSearch::pin_down() {
  constexpr int kSteps = 12, kMostRounds = 10;
  double within = one_point_a_component(reached()).within;
  for (int round = 0; round < kMostRounds && within > scale_ * margin::kPlacesDecided; ++round) {
    for (int k = 0; k < kSteps; ++k) {
      const Real middle = (level_ + beyond_) / Real(2);
      CellComplex c = probe(middle, closure_);
      const bool yes = has_mark(c, kOn) || has_mark(c, kBeyond);
      (yes ? level_ : beyond_) = middle;
      if (yes) set_reached(middle, std::move(c));
    }
    const double now = one_point_a_component(reached()).within;
    if (now >= within / 2) return;
    within = now;
  }
}

Extremum ExtremumSearch::run(const std::optional<Bracket>& known) {
  value_only_ = known && known->value_only;
  if (plane::is_empty(s_) || !f_.defined()) return none();
  if (rotation_ < 0 && grows_without_end()) return no_optimum<Region>(sense_, true);
  if (Extremum out; take_lowest(out)) return out;
  for (const Real& l : f_.special_levels())
    if (accept(l)) return proven();
  scale_ = extent();
  if (!known || !take(*known)) {
    const auto value = f_.value(start());
    if (!value || value->minus_infinity) return infinite(value.has_value());
    cover();
    if (!bracket(value->value)) return no_optimum<Region>(sense_, true);
    open_windows();
  }
  for (int probes = 0; probes < kMostProbes; ++probes) {
    double width = good_ - bad_;
    if (width < scale_ * margin::kTryCandidates && !reached_level_) climb(width);
    if (width < scale_ * margin::kTryCandidates && probes % 2 == 0 && try_candidates()) return proven();
    width = good_ - bad_;
    double least = std::max(std::abs(good_) * margin::kNarrowBracket, scale_ * margin::kNarrowestBracket);
    if (width <= least) break;
    reaches(Real::from_double(rotation_ * simple_between(bad_, good_)));
  }
  enclose();
  if (!value_only_) pin_down();
  return enclosed();
}

}  // namespace

Extremum extremum(const TDistance& f, const Region& s, Sense sense, const std::optional<Bracket>& known) {
  if (const auto there = f.elsewhere()) {
    Extremum e = extremum(there->in, plane::moved(s, there->by), sense, known);
    e.at = plane::moved(std::move(e.at), -there->by);
    return e;
  }
  return ExtremumSearch(f, s, sense).run(known);
}

Extremum least(const TDistance& f) { return extremum(f, CellComplex::uniform(1), Sense::kMinimum); }

}  // namespace findspace::distance
