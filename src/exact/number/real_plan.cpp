// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "exact/number/real_plan.h"

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
  steps_.push_back({StepKind::kSmall, -1, -1, nullptr, nullptr, interval, value});
  return next;
}

int Plan::plain_root_step(const Quadratic& leaf) {
  for (int i = 0; i < static_cast<int>(steps_.size()); ++i) {
    if (steps_[i].kind == StepKind::kPlainRoot && steps_[i].leaf->n == leaf.n) return i;
  }
  steps_.push_back({StepKind::kPlainRoot, -1, -1, &leaf, nullptr, sqrt(enclose(leaf.n)), {}});
  return static_cast<int>(steps_.size()) - 1;
}

int Plan::leaf_step(const Real& x) {
  const Node* node = Access::node(x);
  if (!node) return small_step(Access::small(x));
  const Quadratic& value = closed(*node);
  const int root = value.rational() ? -1 : plain_root_step(value);
  const auto next = static_cast<int>(steps_.size());
  const int found = leaves_.find_or_put(hash(value), next, [&](int step) {
    return steps_[step].kind == StepKind::kLeaf && same(*steps_[step].leaf, value);
  });
  if (found >= 0) return found;
  steps_.push_back({StepKind::kLeaf, root, -1, &value, nullptr, node->interval, {}});
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
  steps_.push_back({kind, a, b, nullptr, nullptr, node.interval, {}});
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

int Plan::polynomial_step(const RootNode& node) {
  Step step{StepKind::kPolynomialRoot, -1, -1, nullptr, &node, node.interval, {}};
  step.first = static_cast<int>(coefficients_.size());
  for (const Real& c : node.coefficients) coefficients_.push_back(step_of(c));
  steps_.push_back(step);
  return static_cast<int>(steps_.size()) - 1;
}

/// Whether all operands have steps; those that have none go to `open`.
bool Plan::operands_ready(const Node& node, std::vector<const Real*>& open) {
  const std::size_t before = open.size();
  const auto need = [&](const Real& operand) {
    if (step_of(operand) < 0) open.push_back(&operand);
  };
  if (node.kind == NodeKind::kPolynomialRoot) {
    for (const Real& c : static_cast<const RootNode&>(node).coefficients) need(c);
  } else {
    need(operation(node).a);
    if (!is_unary(node.kind)) need(operation(node).b);
  }
  return open.size() == before;
}

int Plan::build(const Real& x) {
  if (is_leaf(x)) return leaf_step(x);
  std::vector<const Real*> open{&x};
  while (!open.empty()) {
    const Node& top = *Access::node(*open.back());
    if (of_node_.find(key_of(&top)) >= 0) {
      open.pop_back();
      continue;
    }
    if (!operands_ready(top, open)) continue;
    if (top.kind == NodeKind::kPolynomialRoot) {
      of_node_.put(key_of(&top), polynomial_step(static_cast<const RootNode&>(top)));
    } else {
      const OperationNode& node = operation(top);
      of_node_.put(key_of(&top), operation_step(node, step_of(node.a), is_unary(node.kind) ? -1 : step_of(node.b)));
    }
    open.pop_back();
  }
  return of_node_.find(key_of(Access::node(x)));
}

namespace {

double largest(const Interval& a) { return std::max(-a.lo, a.hi); }
double smallest(const Interval& a) { return a.lo > 0 ? a.lo : a.hi < 0 ? -a.hi : 0; }

}  // namespace

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
