// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The exact reals of a curve, where it has some: its radius or displacement, and a point that is no grid point. Most
// curves have none, and those of one offset share theirs, so a curve holds one pointer to them. An immutable value.
// Guarantee: the numbers are those given. Cost: one allocation where there are some; a copy counts references. Threads:
// reading and copying from many is safe. Keywords: flyweight, intrusive pointer.
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <utility>

#include "exact/number/real.h"

namespace findspace::exact {

struct RealPoint {
  Real x, y;
};

class CurveReals {
 public:
  CurveReals() noexcept = default;
  CurveReals(const Real& w)  // NOLINT: implicit on purpose
      : kept_(is_plain_zero(w) ? nullptr : new Kept(std::nullopt, w)) {}
  CurveReals(RealPoint at, const Real& w) : kept_(new Kept(std::move(at), w)) {}
  CurveReals(const CurveReals& other) noexcept : kept_(other.kept_) {
    if (kept_) kept_->references.fetch_add(1, std::memory_order_relaxed);
  }
  CurveReals(CurveReals&& other) noexcept : kept_(std::exchange(other.kept_, nullptr)) {}
  CurveReals& operator=(CurveReals other) noexcept {
    std::swap(kept_, other.kept_);
    return *this;
  }
  ~CurveReals() {
    if (kept_ && kept_->references.fetch_sub(1, std::memory_order_acq_rel) == 1) delete kept_;
  }

  /// Radius or displacement; 0 where there is none.
  const Real& w() const {
    static const Real zero;
    return kept_ ? kept_->w : zero;
  }
  /// Null where there is none.
  const RealPoint* point() const { return kept_ && kept_->point ? &*kept_->point : nullptr; }

 private:
  struct Kept {
    Kept(std::optional<RealPoint> at, Real of) : point(std::move(at)), w(std::move(of)) {}
    std::atomic<std::uint32_t> references{1};
    const std::optional<RealPoint> point;
    const Real w;
  };

  static bool is_plain_zero(const Real& w) { return w.is_rational() && w.sign() == 0; }

  Kept* kept_ = nullptr;
};

}  // namespace findspace::exact
