// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "formula/explain/failing_cells.h"

#include "plane/base/stop_check.h"

namespace findspace::formula {

FailingParts::FailingParts(const Demands& demands) : demand_(demands.size()) {
  add(demands.formula().root(), true, 0);
  failures_.resize(parent_.size());
  for (const std::uint32_t part : never_) always_ = always_ || climb(part);
  touched_.clear();  // these stay
}

void FailingParts::add(const Node& node, bool positive, std::uint32_t parent) {
  using Op = Node::Op;
  if (node.op == Op::kNot) return add(node.operands.front(), !positive, parent);
  const auto part = static_cast<std::uint32_t>(parent_.size());
  parent_.push_back(parent);
  need_.push_back(1);
  if (node.op == Op::kAtom) demand_[node.atom] = part;
  if (node.op == (positive ? Op::kFalse : Op::kTrue)) never_.push_back(part);
  if (node.op == (positive ? Op::kOr : Op::kAnd)) {
    need_.back() = static_cast<std::uint32_t>(node.operands.size());
    if (node.operands.empty()) never_.push_back(part);
  }
  for (const Node& operand : node.operands) add(operand, positive, part);
}

bool FailingParts::climb(std::uint32_t part) {
  while (part != 0) {
    part = parent_[part];
    touched_.push_back(part);
    if (++failures_[part] != need_[part]) return false;
  }
  return true;
}

std::size_t FailingParts::forget() {
  const std::size_t looks = touched_.size();
  for (const std::uint32_t part : touched_) --failures_[part];
  touched_.clear();
  return looks;
}

FailingCells::FailingCells(const Demands& demands, const std::vector<MetDemands>& cells)
    : parts_(demands), demands_(demands.size()) {
  for (const MetDemands& met : cells) {
    for (std::size_t k = 0; k < met.size(); ++k)
      if (!met[k]) failing_.push_back(static_cast<std::uint32_t>(k));
    start_.push_back(failing_.size());
  }
  most_ = size() + 2 * failing_.size();
}

void FailingCells::pay() {
  if (plane::StopCheck* const check = plane::stop_check()) check->poll();
  work_.charge(looks_ / kLooksAUnit, kManyDemands);
  looks_ %= kLooksAUnit;
}

}  // namespace findspace::formula
