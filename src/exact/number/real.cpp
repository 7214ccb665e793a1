// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "exact/number/real.h"

#include <array>
#include <cassert>
#include <charconv>
#include <cmath>

#include "exact/number/decimal.h"
#include "exact/number/expression_sign.h"
#include "exact/number/real_node.h"
#include "exact/number/stages.h"
#include "findspace/error.h"

namespace findspace::exact {

namespace detail {

Real make_real(Quadratic value) {
  if (value.rational() && mpz_fits_slong_p(value.q.get_mpz_t()) && fits_int128(value.p)) {
    return Access::make({to_int128(value.p), mpz_get_si(value.q.get_mpz_t())});
  }
  bool cancelled = false;
  const Interval enclosure = enclose(value, cancelled);
  const NodeKind kind = value.rational() ? NodeKind::kRational : NodeKind::kQuadratic;
  return Access::adopt(new QuadraticNode(kind, enclosure, std::move(value), cancelled));
}

namespace {

/// Of a node without operands that could make a deep graph; false for others.
bool destroy_leaf(Node* node) noexcept {
  if (is_closed(*node)) {
    delete static_cast<QuadraticNode*>(node);
  } else if (node->kind == NodeKind::kPolynomialRoot) {
    delete static_cast<RootNode*>(node);
  } else {
    return false;
  }
  return true;
}

}  // namespace

void destroy(Node* node) noexcept {
  if (destroy_leaf(node)) return;
  auto* pending = static_cast<OperationNode*>(node);
  while (pending) {
    OperationNode* dead = pending;
    pending = static_cast<OperationNode*>(dead->next_to_destroy);
    for (Real* child : {&dead->a, &dead->b}) {
      Node* c = Access::take(*child);
      if (!c || c->references.fetch_sub(1, std::memory_order_acq_rel) != 1) continue;
      if (destroy_leaf(c)) continue;
      static_cast<OperationNode*>(c)->next_to_destroy = pending;
      pending = static_cast<OperationNode*>(c);
    }
    delete dead;
  }
}

namespace {

bool closed(const Real& x) { return !Access::node(x) || is_closed(*Access::node(x)); }

/// The closed form of x: that of its node, or `storage` set to its inline value.
const Quadratic& closed_of(const Real& x, Quadratic& storage) {
  if (const Node* node = Access::node(x)) return detail::closed(*node);
  const Small small = Access::small(x);
  set(storage.p, small.p);
  mpz_set_si(storage.q.get_mpz_t(), small.q);
  return storage;
}

using QuadraticOperation = std::optional<Quadratic> (*)(const Quadratic&, const Quadratic&);

std::optional<Real> closed_result(const Real& a, const Real& b, QuadraticOperation op) {
  if (!closed(a) || !closed(b)) return std::nullopt;
  Quadratic storage_a, storage_b;
  auto c = op(closed_of(a, storage_a), closed_of(b, storage_b));
  if (!c) return std::nullopt;
  return make_real(std::move(*c));
}

Real node_of(NodeKind kind, Interval enclosure, const Real& a, const Real& b) {
  return Access::adopt(new OperationNode(kind, enclosure, a, b));
}

bool is_integer(const Real& x, int value) {
  return !Access::node(x) && Access::small(x).q == 1 && Access::small(x).p == value;
}
bool same_node(const Real& a, const Real& b) { return Access::node(a) && Access::node(a) == Access::node(b); }

int integer_sign(int128 x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }

/// Rounded once, to the nearest: of the quotient more bits than a double holds, the last one set where there are more.
double rounded(const Small& x) {
  const int shift = 127 - bits(x.p);
  const auto p = static_cast<unsigned __int128>(x.p < 0 ? -x.p : x.p) << shift;
  const auto q = static_cast<unsigned __int128>(x.q);
  const unsigned __int128 quotient = p / q;
  const double size = std::ldexp(static_cast<double>(quotient | (quotient * q != p)), -shift);
  return x.p < 0 ? -size : size;
}

double rounded(const mpz_class& p, const mpz_class& q) {
  constexpr long kBits = 56;  // of the quotient, or one more
  const auto length = [](const mpz_class& x) { return static_cast<long>(mpz_sizeinbase(x.get_mpz_t(), 2)); };
  const long shift = kBits + length(q) - length(p);
  mpz_class scaled, quotient, rest;
  mpz_mul_2exp(scaled.get_mpz_t(), (shift > 0 ? p : q).get_mpz_t(), static_cast<mp_bitcnt_t>(std::abs(shift)));
  mpz_tdiv_qr(quotient.get_mpz_t(), rest.get_mpz_t(), (shift > 0 ? scaled : p).get_mpz_t(),
              (shift > 0 ? q : scaled).get_mpz_t());
  const long size = std::abs(quotient.get_si()) | (rest != 0);
  return std::ldexp(static_cast<double>(sgn(p) < 0 ? -size : size), static_cast<int>(-shift));
}

}  // namespace
}  // namespace detail

using namespace detail;

Real Real::ratio(int128 numerator, int128 denominator) {
  if (denominator == 0) throw Error(ErrorCode::kBadValue, "a fraction with denominator 0");
  if (const auto small = detail::divide(Small{numerator, 1}, Small{denominator, 1})) return Access::make(*small);
  Quadratic n = quadratic_of(numerator), d = quadratic_of(denominator);
  return make_real(quadratic_ratio(std::move(n.p), std::move(d.p)));
}

Real Real::from_double(double finite) {
  if (!std::isfinite(finite)) throw Error(ErrorCode::kBadValue, "not a finite number");
  int exponent = 0;
  const double mantissa = std::frexp(finite, &exponent);
  const auto whole = static_cast<std::int64_t>(std::ldexp(mantissa, 53));
  exponent -= 53;
  Quadratic n = quadratic_of(whole), d = quadratic_of(1);
  mpz_class& scaled = exponent >= 0 ? n.p : d.p;
  mpz_mul_2exp(scaled.get_mpz_t(), scaled.get_mpz_t(), static_cast<mp_bitcnt_t>(std::abs(exponent)));
  return make_real(quadratic_ratio(std::move(n.p), std::move(d.p)));
}

Real Real::parse_decimal(std::string_view text) { return Decimal::parse(text).value(); }

Real operator+(const Real& a, const Real& b) {
  if (!a.node_ && !b.node_) {
    if (const auto sum = add(Access::small(a), Access::small(b))) return Access::make(*sum);
  }
  if (is_integer(a, 0)) return b;
  if (is_integer(b, 0)) return a;
  if (auto c = closed_result(a, b, add)) return *c;
  return node_of(NodeKind::kAdd, a.interval() + b.interval(), a, b);
}

Real operator-(const Real& a, const Real& b) {
  if (!a.node_ && !b.node_) {
    const Small subtrahend = Access::small(b);
    if (bits(subtrahend.p) < 127) {
      const auto difference = add(Access::small(a), Small{-subtrahend.p, subtrahend.q});
      if (difference) return Access::make(*difference);
    }
  }
  if (is_integer(b, 0)) return a;
  if (is_integer(a, 0)) return -b;
  if (same_node(a, b)) return 0;
  if (auto c = closed_result(a, b, subtract)) return *c;
  return node_of(NodeKind::kSub, a.interval() - b.interval(), a, b);
}

Real operator*(const Real& a, const Real& b) {
  if (!a.node_ && !b.node_) {
    if (const auto product = multiply(Access::small(a), Access::small(b))) return Access::make(*product);
  }
  if (is_integer(a, 0) || is_integer(b, 0)) return 0;
  if (is_integer(a, 1)) return b;
  if (is_integer(b, 1)) return a;
  if (is_integer(a, -1)) return -b;
  if (is_integer(b, -1)) return -a;
  if (auto c = closed_result(a, b, multiply)) return *c;
  if (same_node(a, b) && a.node_->kind == NodeKind::kSqrt) return operation(*a.node_).a;
  Interval product = a.interval() * b.interval();
  if (same_node(a, b)) product.lo = std::max(product.lo, 0.0);
  return node_of(NodeKind::kMul, product, a, b);
}

Real operator/(const Real& a, const Real& b) {
  if (certain_sign(b.interval()) == 0 && b.sign() == 0) throw Error(ErrorCode::kBadValue, "division by zero");
  if (!a.node_ && !b.node_) {
    if (const auto quotient = divide(Access::small(a), Access::small(b))) return Access::make(*quotient);
  }
  if (is_integer(a, 0)) return 0;
  if (is_integer(b, 1)) return a;
  if (is_integer(b, -1)) return -a;
  if (same_node(a, b)) return 1;
  if (auto c = closed_result(a, b, divide)) return *c;
  return node_of(NodeKind::kDiv, a.interval() / b.interval(), a, b);
}

Real Real::operator-() const {
  if (!node_ && bits(numerator_) < 127) return Access::make({-numerator_, denominator_});
  if (closed(*this)) {
    Quadratic storage;
    return make_real(negate(closed_of(*this, storage)));
  }
  assert(node_);  // a value without a node is closed
  if (node_->kind == NodeKind::kNeg) return operation(*node_).a;
  return node_of(NodeKind::kNeg, -interval(), *this, 0);
}

Real sqrt(const Real& a) {
  const int known = certain_sign(a.interval());
  const int s = known != 0 ? known : a.sign();
  if (s < 0) throw Error(ErrorCode::kBadValue, "square root of a negative number");
  if (s == 0) return 0;
  if (closed(a)) {
    Quadratic storage;
    if (auto c = root(closed_of(a, storage))) return make_real(std::move(*c));
  }
  return node_of(NodeKind::kSqrt, sqrt(a.interval()), a, 0);
}

int Real::sign() const {
  StageCounts& counts = stage_counts();
  if (!node_) {
    ++counts.fixed;
    return integer_sign(numerator_);
  }
  if (node_->kind == NodeKind::kRational) {
    ++counts.fixed;
    return detail::sign(detail::closed(*node_));
  }
  if (node_->kind == NodeKind::kQuadratic) {
    const auto& held = static_cast<const QuadraticNode&>(*node_);
    ++(held.cancelled ? counts.quadratic : counts.filter);
    const int known = certain_sign(node_->interval);
    return known != 0 ? known : detail::sign(held.value);
  }
  if (const int known = certain_sign(node_->interval)) {
    ++counts.filter;
    return known;
  }
  return evaluate(*this, 0, true).sign;
}

int compare(const Real& a, const Real& b) {
  StageCounts& counts = stage_counts();
  if (!a.node_ && !b.node_ && a.denominator_ == b.denominator_) {
    ++counts.fixed;
    return a.numerator_ < b.numerator_ ? -1 : a.numerator_ > b.numerator_;
  }
  const Interval i = a.interval(), j = b.interval();
  if (i.hi < j.lo || i.lo > j.hi || same_node(a, b)) {
    ++counts.filter;
    return i.hi < j.lo ? -1 : i.lo > j.hi;
  }
  const Real difference = a - b;
  if (difference.node_ && difference.node_->kind == NodeKind::kQuadratic) {
    ++counts.quadratic;
    return detail::sign(detail::closed(*difference.node_));
  }
  if (!difference.node_ && a.is_closed() && !a.is_rational()) {  // one quadratic field, differing by a rational
    ++counts.quadratic;
    return integer_sign(difference.numerator_);
  }
  return difference.sign();
}

int compare_if_closed(const Real& a, const Real& b) {
  if (a.is_closed() && b.is_closed()) return compare(a, b);
  const double x = a.to_double(), y = b.to_double();
  return x < y ? -1 : x > y;
}

Real abs(const Real& x) { return x.sign() < 0 ? -x : x; }

int128 floor(const Real& x) {
  if (const auto held = x.integer()) return *held;
  constexpr int128 kMost = int128{1} << 126;
  if (compare(x, kMost) > 0 || compare(x, -kMost) < 0) {
    throw Error(ErrorCode::kOutOfRange, "a number too large to round to an integer");
  }
  if (x.is_rational()) {
    Quadratic storage;
    const Quadratic& held = closed_of(x, storage);
    mpz_class below;
    mpz_fdiv_q(below.get_mpz_t(), held.p.get_mpz_t(), held.q.get_mpz_t());
    return to_int128(below);
  }
  // From the nearest double (exact as an integer once it is past 2^53), then corrected by exact comparisons.
  auto guess = static_cast<int128>(std::floor(x.to_double()));
  for (Real rest = x - guess; compare(rest, 0) < 0 || compare(rest, 1) >= 0; rest = x - guess) {
    const auto step = static_cast<int128>(std::floor(rest.to_double()));
    guess += step != 0 ? step : compare(rest, 0) < 0 ? -1 : 1;
  }
  return guess;
}

int128 round(const Real& x) { return x.sign() < 0 ? -floor(-x + Real::ratio(1, 2)) : floor(x + Real::ratio(1, 2)); }

double Real::to_double() const {
  if (!node_) return denominator_ == 1 ? static_cast<double>(numerator_) : rounded(Small{numerator_, denominator_});
  if (node_->kind == NodeKind::kRational) {
    const Quadratic& value = detail::closed(*node_);
    return rounded(value.p, value.q);
  }
  constexpr int kRelativeBits = 60;  // then rounded once to 53
  return evaluate(*this, kRelativeBits, false).value;
}

std::optional<std::array<int128, 2>> Real::fraction() const {
  if (!node_) return std::array<int128, 2>{numerator_, denominator_};
  if (node_->kind != NodeKind::kRational) return std::nullopt;
  const Quadratic& value = closed(*node_);
  if (!fits_int128(value.p) || !fits_int128(value.q)) return std::nullopt;
  return std::array<int128, 2>{to_int128(value.p), to_int128(value.q)};
}

std::string Real::text() const {
  if (node_ || denominator_ != 1) {
    std::array<char, 64> buffer;
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), to_double()).ptr;
    return {buffer.data(), end};
  }
  return quadratic_of(numerator_).p.get_str();
}

}  // namespace findspace::exact
