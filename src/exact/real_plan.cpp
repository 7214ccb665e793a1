// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "exact/real_plan.h"

#include <algorithm>
#include <cmath>

namespace findspace::exact::detail {

template <class Accept>
int StepTable::find_or_put(std::uint64_t key, int step, Accept accept) {
  if (2 * (used_ + 1) > slots_.size()) grow();
  for (std::size_t i = start(key);; i = (i + 1) & (slots_.size() - 1)) {
    Slot& slot = slots_[i];
    if (slot.step < 0) {
      slot = {key, step};
      ++used_;
      return -1;
    }
    if (slot.key == key && accept(slot.step)) return slot.step;
  }
}

int StepTable::find(std::uint64_t key) const {
  for (std::size_t i = start(key); slots_[i].step >= 0; i = (i + 1) & (slots_.size() - 1)) {
    if (slots_[i].key == key) return slots_[i].step;
  }
  return -1;
}

void StepTable::put(std::uint64_t key, int step) {
  find_or_put(key, step, [](int) { return true; });
}

void StepTable::grow() {
  std::vector<Slot> old(slots_.size() * 2);
  old.swap(slots_);
  used_ = 0;
  for (const Slot& slot : old) {
    if (slot.step >= 0) find_or_put(slot.key, slot.step, [](int) { return false; });
  }
}

namespace {

std::uint64_t key_of(const Node* node) { return reinterpret_cast<std::uintptr_t>(node); }

bool is_leaf(const Real& x) { return !Access::node(x) || is_closed(*Access::node(x)); }

StepKind step_kind(NodeKind kind) {
  switch (kind) {
    case NodeKind::kNeg:
      return StepKind::kNeg;
    case NodeKind::kAdd:
      return StepKind::kAdd;
    case NodeKind::kSub:
      return StepKind::kSub;
    case NodeKind::kMul:
      return StepKind::kMul;
    case NodeKind::kDiv:
      return StepKind::kDiv;
    case NodeKind::kSqrt:
      return StepKind::kSqrt;
    default:
      return StepKind::kLeaf;
  }
}

}  // namespace

Plan::Plan(const Real& x) {
  steps_.reserve(32);
  root_ = build(x);
}

bool Plan::is_zero() const { return steps_[root_].kind == StepKind::kSmall && steps_[root_].small.p == 0; }

int Plan::small_step(const Small& value) {
  const auto next = static_cast<int>(steps_.size());
  const auto key = (static_cast<std::uint64_t>(value.p) ^ static_cast<std::uint64_t>(value.p >> 64) << 17) +
                   static_cast<std::uint64_t>(value.q) * 0x2545F4914F6CDD1DULL;
  const int found = leaves_.find_or_put(key, next, [&](int step) {
    const Step& s = steps_[step];
    return s.kind == StepKind::kSmall && s.small.p == value.p && s.small.q == value.q;
  });
  if (found >= 0) return found;
  const Interval interval = value.q == 1 ? enclose(value.p) : enclose(value.p) / enclose(value.q);
  steps_.push_back({StepKind::kSmall, -1, -1, nullptr, interval, value});
  return next;
}

int Plan::plain_root_step(const Closed& leaf) {
  for (int i = 0; i < static_cast<int>(steps_.size()); ++i) {
    if (steps_[i].kind == StepKind::kPlainRoot && steps_[i].leaf->n == leaf.n) return i;
  }
  steps_.push_back({StepKind::kPlainRoot, -1, -1, &leaf, sqrt(enclose(leaf.n)), {}});
  return static_cast<int>(steps_.size()) - 1;
}

int Plan::leaf_step(const Real& x) {
  const Node* node = Access::node(x);
  if (!node) return small_step(Access::small(x));
  const Closed& value = closed(*node);
  const int root = value.rational() ? -1 : plain_root_step(value);
  const auto next = static_cast<int>(steps_.size());
  const int found = leaves_.find_or_put(hash(value), next, [&](int step) {
    return steps_[step].kind == StepKind::kLeaf && same(*steps_[step].leaf, value);
  });
  if (found >= 0) return found;
  steps_.push_back({StepKind::kLeaf, root, -1, &value, node->interval, {}});
  return next;
}

int Plan::operation_step(const OperationNode& node, int a, int b) {
  const StepKind kind = step_kind(node.kind);
  if ((kind == StepKind::kAdd || kind == StepKind::kMul) && a > b) std::swap(a, b);
  if (kind == StepKind::kSub && a == b) return small_step(Small{});
  const std::uint64_t key =
      static_cast<std::uint64_t>(kind) << 60 | static_cast<std::uint64_t>(a) << 30 | static_cast<std::uint64_t>(b + 1);
  const auto next = static_cast<int>(steps_.size());
  const int found = operations_.find_or_put(key, next, [](int) { return true; });
  if (found >= 0) return found;
  steps_.push_back({kind, a, b, nullptr, node.interval, {}});
  return next;
}

int Plan::step_of(const Real& x) {
  const Node* node = Access::node(x);
  if (!node) return small_step(Access::small(x));
  int step = of_node_.find(key_of(node));
  if (step >= 0 || !is_closed(*node)) return step;
  step = leaf_step(x);
  of_node_.put(key_of(node), step);
  return step;
}

int Plan::build(const Real& x) {
  if (is_leaf(x)) return leaf_step(x);
  std::vector<const Real*> open{&x};
  while (!open.empty()) {
    const Real& top = *open.back();
    if (of_node_.find(key_of(Access::node(top))) >= 0) {
      open.pop_back();
      continue;
    }
    const OperationNode& node = operation(*Access::node(top));
    const bool unary = node.kind == NodeKind::kNeg || node.kind == NodeKind::kSqrt;
    const int a = step_of(node.a), b = unary ? -1 : step_of(node.b);
    if (a < 0) open.push_back(&node.a);
    if (b < 0 && !unary) open.push_back(&node.b);
    if (a < 0 || (b < 0 && !unary)) continue;
    of_node_.put(key_of(&node), operation_step(node, a, b));
    open.pop_back();
  }
  return of_node_.find(key_of(Access::node(x)));
}

namespace {

struct Bound {
  double u = 0, l = 0;  // log2, rounded up
};

double up(double log_value) {
  return log_value == -kInfinity ? log_value : log_value + std::abs(log_value) * 1e-14 + 1e-12;
}

/// log2 |z| <= result; -infinity for 0.
double log2_of(const mpz_class& z) {
  if (sgn(z) == 0) return -kInfinity;
  long exponent = 0;
  const double mantissa = mpz_get_d_2exp(&exponent, z.get_mpz_t());
  return up(std::log2(std::abs(mantissa) * (1 + 1e-15)) + static_cast<double>(exponent));
}

double log2_of(const Interval& a) { return up(std::log2(std::max(std::abs(a.lo), std::abs(a.hi)))); }

/// log2(2^x + 2^y) <= result.
double log2_sum(double x, double y) {
  const double high = std::max(x, y), low = std::min(x, y);
  if (low == -kInfinity || high - low > 80) return up(high);
  return up(high + std::log2(1 + std::exp2(low - high)));
}

Bound bound_of(const Step& step, const std::vector<Bound>& bounds) {
  const Bound a = step.a >= 0 ? bounds[step.a] : Bound{}, b = step.b >= 0 ? bounds[step.b] : Bound{};
  switch (step.kind) {
    case StepKind::kSmall:
      return {log2_of(enclose(step.small.p)), log2_of(enclose(step.small.q))};
    case StepKind::kPlainRoot:
      return {log2_of(step.leaf->n) / 2, 0};
    case StepKind::kLeaf:
      if (step.leaf->rational()) return {log2_of(step.leaf->p), log2_of(step.leaf->q)};
      return {log2_sum(log2_of(step.leaf->p), log2_of(step.leaf->r) + a.u), log2_of(step.leaf->q)};
    case StepKind::kNeg:
      return a;
    case StepKind::kAdd:
    case StepKind::kSub:
      return {log2_sum(a.u + b.l, a.l + b.u), up(a.l + b.l)};
    case StepKind::kMul:
      return {up(a.u + b.u), up(a.l + b.l)};
    case StepKind::kDiv:
      return {up(a.u + b.l), up(a.l + b.u)};
    case StepKind::kSqrt:
      if (a.u >= a.l) return {up((a.u + a.l) / 2), a.l};
      return {a.u, up((a.u + a.l) / 2)};
  }
  return {};
}

double largest(const Interval& a) { return std::max(-a.lo, a.hi); }
double smallest(const Interval& a) { return a.lo > 0 ? a.lo : a.hi < 0 ? -a.hi : 0; }

}  // namespace

double Plan::log2_degree() const {
  // Products of the independent n found so far, modulo squares; past kMostProducts new ones are taken as independent.
  constexpr std::size_t kMostProducts = 16;
  std::vector<mpz_class> products;
  double degree = 0;
  for (const Step& step : steps_) {
    if (step.kind == StepKind::kSqrt) ++degree;
    if (step.kind != StepKind::kPlainRoot) continue;
    const mpz_class& n = step.leaf->n;
    const bool dependent =
        std::any_of(products.begin(), products.end(), [&](const mpz_class& m) { return perfect_square_product(m, n); });
    if (dependent) continue;
    ++degree;
    const std::size_t before = products.size();
    if (before >= kMostProducts) continue;
    for (std::size_t i = 0; i < before; ++i) products.emplace_back(products[i] * n);
    products.push_back(n);
  }
  return degree;
}

double Plan::separation_bits() const {
  std::vector<Bound> bounds;
  bounds.reserve(steps_.size());
  for (const Step& step : steps_) bounds.push_back(bound_of(step, bounds));
  const Bound& result = bounds[root_];
  return up(result.l + std::max(result.u, 0.0) * (std::exp2(log2_degree()) - 1));
}

double Plan::error_bits() const {
  std::vector<double> errors;
  errors.reserve(steps_.size());
  for (const Step& step : steps_) {
    const double ea = step.a >= 0 ? errors[step.a] : 0, eb = step.b >= 0 ? errors[step.b] : 0;
    const Interval a = step.a >= 0 ? steps_[step.a].interval : Interval{};
    const Interval b = step.b >= 0 ? steps_[step.b].interval : Interval{};
    double carried = ea + eb;
    if (step.kind == StepKind::kMul) carried = 2 * (ea * largest(b) + eb * largest(a));
    if (step.kind == StepKind::kDiv) carried = 4 * (ea + 2 * eb * largest(a) / smallest(b)) / smallest(b);
    if (step.kind == StepKind::kSqrt) carried = 2 * ea / std::sqrt(smallest(a));
    if (step.kind == StepKind::kLeaf) {  // the terms of p + r sqrt n may be larger than their sum
      const double q = smallest(enclose(step.leaf->q));
      carried = (largest(enclose(step.leaf->p)) + largest(enclose(step.leaf->r)) * (ea + largest(a))) / q;
    }
    errors.push_back(carried + largest(step.interval));
  }
  const double error = errors[root_];
  return error < kInfinity ? std::log2(std::max(error, 1e-300)) : kInfinity;  // false for NaN as well
}

}  // namespace findspace::exact::detail
