// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/planar/derived.h"

#include <algorithm>
#include <array>

#include "exact/margins/rounding.h"
#include "plane/base/real_vector.h"
#include "plane/complex/overlay.h"
#include "plane/query/moved.h"
#include "plane/sum/minkowski.h"

namespace findspace::distance {

using exact::Real;
using exact::RealPoint;
using plane::CellComplex;
using plane::Mark;
using plane::SignMap;
using plane::operator+;
using plane::operator-;

namespace {

LevelCurve rotated_round(LevelCurve f) {
  f.k = -f.k;  // f(level) becomes f(-level)
  return f;
}

/// Minus a form.
SmoothForm opposite(SmoothForm f) {
  return {-f.value, -f.gx, -f.gy, -f.above, -f.below, [of = std::move(f.curve)] { return rotated_round(of()); }};
}

bool is_above_everywhere(const SignMap& map) {
  return map.faces.size() == 1 && map.faces[0].mark > 0 && map.edges.empty() && map.vertices.empty();
}

class CutOff : public TDistance {
 public:
  CutOff(TDistancePointer f, Real floor, bool negated)
      : f_(std::move(f)), floor_(std::move(floor)), negated_(negated) {}

  bool defined() const override { return negated_ || f_->defined(); }

  SignMap sign_map(const Real& level) const override {
    if (!defined()) return CellComplex::uniform(1);
    int above = compare(level, floor_);
    if (above < 0) return CellComplex::uniform(1);
    int rotation = negated_ ? -1 : 1;
    SignMap m = f_->sign_map(negated_ ? -level : level);
    return plane::remark(std::move(m), [=](Mark k) { return Mark(above > 0 ? rotation * k : rotation * k > 0); });
  }

  std::optional<PlanarAnswer> value(const RealPoint& p) const override {
    auto v = f_->value(p);
    if (!v) return negated_ ? std::optional(exact_answer(floor_, Way::kMap)) : std::nullopt;
    if (v->minus_infinity) return negated_ ? std::nullopt : std::optional(exact_answer(floor_, Way::kMap));
    if (negated_) v = minus(*std::move(v));
    for (auto* x : {v->enclosed ? &v->enclosed->lower : nullptr, v->enclosed ? &v->enclosed->upper : nullptr})
      if (x && *x && **x < floor_) *x = floor_;
    if (v->value < floor_) v->value = floor_;
    return v;
  }

  RealPoint seed() const override { return f_->seed(); }

  std::vector<NearLevelCurve> level_curves(const RealPoint& p, double tolerance) const override {
    auto out = f_->level_curves(p, tolerance);
    if (negated_)
      for (NearLevelCurve& n : out) n.curve = rotated_round(std::move(n.curve));
    return out;
  }

  std::optional<std::vector<SmoothForm>> forms(const RealPoint& p, double radius) const override {
    auto out = f_->forms(p, radius);
    const auto v = f_->value(p);
    if (!out || !v || v->minus_infinity) return std::nullopt;
    const double above = (negated_ ? -1 : 1) * near_value(v->value) - near_value(floor_);
    const double reach = radius * margin::kUpward + margin::kUpwardSteps;
    if (above < -reach) out->clear();
    if (negated_)
      for (SmoothForm& form : *out) form = opposite(std::move(form));
    if (above <= reach) {
      out->push_back({near_value(floor_)});
      out->back().curve = [floor = floor_] { return LevelCurve::line(Real(), Real(), -floor, Real(1)); };
    }
    return out;
  }

  std::optional<Size> size() const override {
    auto out = f_->size();
    if (out && negated_) out->reach = std::nullopt;  // it is the floor far away
    return out;
  }

  /// For levels above the floor, where nothing is cut off.
  TDistancePointer near(const plane::PieceBox& window, double low, double high) const override {
    if (floor_.interval().hi >= low) return nullptr;
    auto f = negated_ ? f_->near(window, -high, -low) : f_->near(window, low, high);
    return f ? std::make_shared<CutOff>(std::move(f), floor_, negated_) : nullptr;
  }

  std::optional<Lowest> lowest() const override {
    auto l = negated_ ? std::nullopt : f_->lowest();
    return l && l->level > floor_ ? l : std::nullopt;
  }

  std::vector<Real> special_levels() const override {
    auto out = f_->special_levels();
    if (negated_)
      for (Real& l : out) l = -l;
    out.push_back(floor_);
    return out;
  }

 private:
  TDistancePointer f_;
  Real floor_;
  bool negated_;
};

class Greater : public TDistance {
 public:
  Greater(TDistancePointer f, TDistancePointer g) : f_(std::move(f)), g_(std::move(g)) {}

  bool defined() const override { return f_->defined() && g_->defined(); }

  SignMap sign_map(const Real& level) const override {
    if (!defined()) return CellComplex::uniform(1);
    // Of a small and a large shape the second is above at once: the large one stands out of the small one everywhere.
    SignMap g = g_->sign_map(level);
    if (is_above_everywhere(g)) return g;
    SignMap f = f_->sign_map(level);
    if (is_above_everywhere(f)) return f;
    std::array<const CellComplex*, 2> both{&f, &g};
    return plane::overlay(both, [](std::span<const Mark> m) { return std::max(m[0], m[1]); });
  }

  std::optional<PlanarAnswer> value(const RealPoint& p) const override {
    auto f = f_->value(p), g = g_->value(p);
    if (!f || !g) return std::nullopt;
    return distance::greater(*std::move(f), *std::move(g));
  }

  RealPoint seed() const override { return f_->seed(); }

  std::optional<Size> size() const override {
    auto f = f_->size(), g = g_->size();
    if (!f || !g) return std::nullopt;
    return Size{f->edges + g->edges, f->reach ? f->reach : g->reach};
  }

  TDistancePointer near(const plane::PieceBox& window, double low, double high) const override {
    auto f = f_->near(window, low, high), g = f ? g_->near(window, low, high) : nullptr;
    return g ? std::make_shared<Greater>(std::move(f), std::move(g)) : nullptr;
  }

  std::vector<NearLevelCurve> level_curves(const RealPoint& p, double tolerance) const override {
    auto out = f_->level_curves(p, tolerance), more = g_->level_curves(p, tolerance);
    out.insert(out.end(), more.begin(), more.end());
    return out;
  }

  std::vector<Real> special_levels() const override {
    auto out = f_->special_levels(), more = g_->special_levels();
    out.insert(out.end(), more.begin(), more.end());
    return out;
  }

 private:
  TDistancePointer f_, g_;
};

class Reflected : public TDistance {
 public:
  explicit Reflected(TDistancePointer f) : f_(std::move(f)) {}

  bool defined() const override { return f_->defined(); }
  SignMap sign_map(const Real& level) const override { return mirrored(f_->sign_map(level)); }

  std::optional<PlanarAnswer> value(const RealPoint& p) const override {
    auto v = f_->value({-p.x, -p.y});
    if (v && v->nearest) v->nearest = RealPoint{-v->nearest->x, -v->nearest->y};
    return v;
  }

  RealPoint seed() const override {
    RealPoint p = f_->seed();
    return {-p.x, -p.y};
  }

  std::optional<Size> size() const override { return f_->size(); }

  TDistancePointer near(const plane::PieceBox& window, double low, double high) const override {
    auto f = f_->near({-window.x1, -window.y1, -window.x0, -window.y0}, low, high);
    return f ? std::make_shared<Reflected>(std::move(f)) : nullptr;
  }

  std::vector<NearLevelCurve> level_curves(const RealPoint& p, double tolerance) const override {
    auto out = f_->level_curves({-p.x, -p.y}, tolerance);
    for (NearLevelCurve& n : out) n.curve = n.curve.reflected();
    return out;
  }

  std::optional<Lowest> lowest() const override {
    auto l = f_->lowest();
    if (l) l->at = {-l->at.x, -l->at.y};
    return l;
  }

  std::vector<Real> special_levels() const override { return f_->special_levels(); }

 private:
  TDistancePointer f_;
};

class Displaced : public TDistance {
 public:
  Displaced(TDistancePointer f, RealPoint by) : f_(std::move(f)), by_(std::move(by)) {}

  bool defined() const override { return f_->defined(); }
  SignMap sign_map(const Real& level) const override { return plane::moved(f_->sign_map(level), -by_); }

  std::optional<PlanarAnswer> value(const RealPoint& p) const override {
    auto v = f_->value(p + by_);
    if (v && v->nearest) v->nearest = *v->nearest - by_;
    return v;
  }

  RealPoint seed() const override { return f_->seed() - by_; }

  std::vector<NearLevelCurve> level_curves(const RealPoint& p, double tolerance) const override {
    auto out = f_->level_curves(p + by_, tolerance);
    for (NearLevelCurve& n : out) n.curve = n.curve.moved(by_);
    return out;
  }

  std::optional<Lowest> lowest() const override {
    auto l = f_->lowest();
    if (l) l->at = l->at - by_;
    return l;
  }

  std::optional<Elsewhere> elsewhere() const override { return Elsewhere{*f_, by_}; }
  std::vector<Real> special_levels() const override { return f_->special_levels(); }

 private:
  TDistancePointer f_;
  RealPoint by_;
};

}  // namespace

TDistancePointer cut_off(TDistancePointer f, Real floor, bool negated) {
  return std::make_shared<CutOff>(std::move(f), std::move(floor), negated);
}

TDistancePointer greater(TDistancePointer f, TDistancePointer g) {
  return std::make_shared<Greater>(std::move(f), std::move(g));
}

TDistancePointer reflected(TDistancePointer f) { return std::make_shared<Reflected>(std::move(f)); }

TDistancePointer displaced(TDistancePointer f, RealPoint by) {
  return std::make_shared<Displaced>(std::move(f), std::move(by));
}

}  // namespace findspace::distance
