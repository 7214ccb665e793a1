// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "distance/over_time.h"

#include <algorithm>

#include "plane/moved.h"
#include "plane/overlay.h"
#include "plane/path_region.h"
#include "plane/swept.h"

namespace findspace::distance {

using exact::Real;
using exact::RealPoint;
using plane::CellComplex;
using plane::Mark;
using plane::SignMap;
using plane::operator+;
using plane::operator-;

namespace {

SignMap negated(SignMap m) {
  return remark(std::move(m), [](Mark k) { return Mark(-k); });
}

class OverTime : public PositionFunction {
 public:
  OverTime(TDistancePointer f, RelativePath path, Sense sense)
      : f_(std::move(f)), path_(std::move(path)), sense_(sense) {}

  bool defined() const override { return f_->defined(); }

  SignMap sign_map(const Real& level) const override {
    SignMap m = f_->sign_map(level);
    if (sense_ == Sense::kMinimum) return least_along(m, path_);
    return negated(least_along(negated(std::move(m)), path_));
  }

  std::optional<Value> value(const RealPoint& p) const override {
    if (!defined()) return std::nullopt;
    RelativePath moved = path_;
    for (RealPoint& w : moved) w = w + p;
    const Extremum e = extremum(*f_, plane::region_of_path(moved), sense_);
    if (!e.exists) return std::nullopt;
    return Value{e.level, std::nullopt};
  }

 private:
  TDistancePointer f_;
  RelativePath path_;
  Sense sense_;
};

class AtInstant : public PositionFunction {
 public:
  AtInstant(PositionFunctionPointer f, const RealPoint& by) : f_(std::move(f)), by_(by) {}

  bool defined() const override { return f_->defined(); }
  SignMap sign_map(const Real& level) const override { return plane::moved(f_->sign_map(level), -by_); }

  std::optional<Value> value(const RealPoint& p) const override {
    auto v = f_->value(p + by_);
    if (v && v->nearest) v->nearest = *v->nearest - by_;
    return v;
  }

 private:
  PositionFunctionPointer f_;
  RealPoint by_;
};

}  // namespace

PositionFunctionPointer over_time(TDistancePointer f, RelativePath path, Sense sense) {
  return std::make_shared<OverTime>(std::move(f), std::move(path), sense);
}

PositionFunctionPointer at_instant(PositionFunctionPointer f, const RealPoint& by) {
  return std::make_shared<AtInstant>(std::move(f), by);
}

}  // namespace findspace::distance
