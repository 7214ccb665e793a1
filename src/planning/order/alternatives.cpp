// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "planning/order/alternatives.h"

#include <algorithm>
#include <map>
#include <utility>

#include "findspace/error.h"
#include "planning/order/relations.h"

namespace findspace::planning {
namespace {

using formula::Atom;
using formula::Formula;
using formula::Node;
using Op = Node::Op;

/// The node as a formula of its own.
class Extract {
 public:
  explicit Extract(const Formula& from) : from_(from) {}

  Formula formula(const Node& node, bool negated) {
    Node copy = taken(node);
    if (negated) copy = Node{Op::kNot, 0, {std::move(copy)}};
    return Formula(std::move(copy), std::move(atoms_));
  }

 private:
  Node taken(const Node& node) {
    Node out{node.op, 0, {}};
    if (node.op == Op::kAtom) {
      out.atom = atoms_.size();
      atoms_.push_back(from_.atoms()[node.atom]);
    }
    for (const Node& operand : node.operands) out.operands.push_back(taken(operand));
    return out;
  }

  const Formula& from_;
  std::vector<Atom> atoms_;
};

void check_size(std::size_t count) {
  if (count > kMostAlternatives)
    throw Error(ErrorCode::kUnsupported,
                "the conditions have more than 4096 alternatives (\"or\" between different pairs of shapes); "
                "place one after another instead");
}

std::vector<Alternative> both(const std::vector<Alternative>& a, const std::vector<Alternative>& b) {
  check_size(a.size() * b.size());
  std::vector<Alternative> out;
  for (const Alternative& x : a)
    for (const Alternative& y : b) {
      out.push_back(x);
      out.back().insert(out.back().end(), y.begin(), y.end());
    }
  return out;
}

class Expand {
 public:
  explicit Expand(const Condition& condition) : condition_(condition) {}

  std::vector<Alternative> run(const Node& node, bool negated) {
    Condition whole{std::make_shared<const Formula>(Extract(*condition_.formula).formula(node, negated)),
                    condition_.roles};
    if (is_single(whole)) return {{std::move(whole)}};
    if (node.op == Op::kNot) return run(node.operands[0], !negated);
    const bool conjunction = (node.op == Op::kAnd) != negated;
    std::vector<Alternative> out;
    if (conjunction) out.push_back({});
    for (const Node& operand : grouped(node)) {
      std::vector<Alternative> more = run(operand, negated);
      if (conjunction)
        out = both(out, more);
      else
        std::move(more.begin(), more.end(), std::back_inserter(out));
    }
    check_size(out.size());
    return out;
  }

 private:
  /// The operands, those that are single and on the same bodies as one operand.
  std::vector<Node> grouped(const Node& node) {
    std::map<std::vector<std::size_t>, Node> groups;
    std::vector<Node> out;
    for (const Node& operand : node.operands) {
      Condition part{std::make_shared<const Formula>(Extract(*condition_.formula).formula(operand, false)),
                     condition_.roles};
      if (!is_single(part)) {
        out.push_back(operand);
        continue;
      }
      Node& group = groups[bodies_of(*part.formula, part.roles)];
      group.op = node.op;
      group.operands.push_back(operand);
    }
    for (auto& [bodies, group] : groups) {
      if (group.operands.size() == 1)
        out.push_back(std::move(group.operands[0]));
      else
        out.push_back(std::move(group));
    }
    return out;
  }

  const Condition& condition_;
};

}  // namespace

std::vector<Alternative> alternatives(std::span<const Condition> conditions) {
  std::vector<Alternative> out{{}};
  for (const Condition& condition : conditions) {
    if (is_single(condition)) {
      for (Alternative& a : out) a.push_back(condition);
    } else {
      out = both(out, Expand(condition).run(condition.formula->root(), false));
    }
  }
  return out;
}

}  // namespace findspace::planning
