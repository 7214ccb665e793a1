// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "exact/number/root_balls.h"

#include "exact/number/real_balls.h"

namespace findspace::exact::detail {

RootNode::RootNode(Interval enclosure, std::vector<Real> polynomial, std::unique_ptr<RootBalls> found)
    : Node(NodeKind::kPolynomialRoot, enclosure), coefficients(std::move(polynomial)), balls(std::move(found)) {}
RootNode::~RootNode() = default;

OwnBall ball_of(const Real& x, mpfr_prec_t precision) {
  OwnBall out(precision);
  out.ball.set(Balls(Plan(x), precision).root());
  return out;
}

/// A polynomial and its derivative in balls.
class PolynomialBalls {
 public:
  PolynomialBalls(const std::vector<Real>& polynomial, mpfr_prec_t precision) : precision_(precision) {
    for (const Real& c : polynomial) coefficients_.push_back(ball_of(c, precision));
  }

  OwnBall value(const Ball& x) const {
    OwnBall out(precision_), product(precision_);
    out.ball.set(coefficients_.back().ball);
    for (std::size_t k = coefficients_.size() - 1; k-- > 0;) {
      product.ball.multiply(out.ball, x);
      out.ball.add(product.ball, coefficients_[k].ball);
    }
    return out;
  }

  OwnBall slope(const Ball& x) const {
    OwnBall out(precision_), product(precision_), term(precision_);
    out.ball.set(std::int64_t{0});
    mpz_class factor;
    for (std::size_t k = coefficients_.size(); k-- > 1;) {
      factor = static_cast<unsigned long>(k);
      product.ball.multiply(out.ball, x);
      term.ball.multiply(coefficients_[k].ball, factor.get_mpz_t());
      out.ball.add(product.ball, term.ball);
    }
    return out;
  }

 private:
  mpfr_prec_t precision_;
  std::vector<OwnBall> coefficients_;
};

/// The method at one precision.
class RootBalls::Newton {
 public:
  Newton(const RootBalls& root, const std::vector<Real>& polynomial, mpfr_prec_t precision)
      : x(precision), p_(polynomial, precision), middle_(precision), step_(precision), next_(precision) {
    x.ball.set_between(ball_of(root.lo_, precision).ball, ball_of(root.hi_, precision).ball);
  }

  /// Whether x became narrower by 2^-bits, else it stays.
  bool step(int bits) {
    middle_.ball.set_middle(x.ball);
    step_.ball.divide(p_.value(middle_.ball).ball, p_.slope(x.ball).ball);
    next_.ball.subtract(middle_.ball, step_.ball);
    if (!next_.ball.radius().finite() || !next_.ball.narrower_than(x.ball, bits)) return false;
    x.ball.set(next_.ball);
    return true;
  }

  OwnBall x;

 private:
  PolynomialBalls p_;
  OwnBall middle_, step_, next_;
};

bool RootBalls::converges(const std::vector<Real>& polynomial, mpfr_prec_t precision) const {
  // Bounds of magnitudes, powers of two, may double from one step to the next for each factor x.
  return Newton(*this, polynomial, precision).step(int(polynomial.size()) + 4);
}

OwnBall RootBalls::refined(const std::vector<Real>& polynomial, mpfr_prec_t precision, const Ball* start) const {
  Newton newton(*this, polynomial, precision);
  if (start != nullptr) newton.x.ball.set(*start);
  while (newton.step(1)) {
  }
  return std::move(newton.x);
}

const Ball& RootBalls::at(const std::vector<Real>& polynomial, mpfr_prec_t precision) {
  const std::lock_guard<std::mutex> lock(mutex_);
  std::size_t level = 0;
  while ((mpfr_prec_t(128) << level) < precision) ++level;
  while (levels_.size() <= level) {
    const Ball* start = levels_.empty() ? nullptr : &levels_.back()->ball;
    levels_.push_back(std::make_unique<OwnBall>(refined(polynomial, mpfr_prec_t(128) << levels_.size(), start)));
  }
  return levels_[level]->ball;
}

}  // namespace findspace::exact::detail
