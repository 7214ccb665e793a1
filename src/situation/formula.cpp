// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "situation/formula.h"

#include <algorithm>
#include <iterator>
#include <unordered_map>
#include <utility>

#include "situation/evaluate.h"
#include "situation/text.h"

namespace findspace::situation {
namespace {

using Op = Node::Op;

/// The tree with operands of the same operation drawn in, and with `and`, `or` of fewer than two operands resolved.
Node flattened(Node node) {
  std::vector<Node> operands;
  for (Node& operand : node.operands) {
    Node flat = flattened(std::move(operand));
    if (flat.op == node.op && (node.op == Op::kAnd || node.op == Op::kOr)) {
      std::move(flat.operands.begin(), flat.operands.end(), std::back_inserter(operands));
    } else {
      operands.push_back(std::move(flat));
    }
  }
  if (node.op == Op::kAnd || node.op == Op::kOr) {
    if (operands.empty()) return Node{node.op == Op::kAnd ? Op::kTrue : Op::kFalse, 0, {}};
    if (operands.size() == 1) return std::move(operands.front());
  }
  node.operands = std::move(operands);
  return node;
}

bool same_tree(const Node& a, const Node& b) {
  return a.op == b.op && a.atom == b.atom &&
         std::equal(a.operands.begin(), a.operands.end(), b.operands.begin(), b.operands.end(), same_tree);
}

void shift_atoms(Node& node, std::size_t by) {
  if (node.op == Op::kAtom) node.atom += by;
  for (Node& operand : node.operands) shift_atoms(operand, by);
}

Formula combine(Op op, std::span<const Formula> formulas) {
  Node root{op, 0, {}};
  std::vector<Atom> atoms;
  for (const Formula& formula : formulas) {
    root.operands.push_back(formula.root());
    shift_atoms(root.operands.back(), atoms.size());
    atoms.insert(atoms.end(), formula.atoms().begin(), formula.atoms().end());
  }
  return Formula(std::move(root), std::move(atoms));
}

/// Sign maps that may be equal have the same key; the converse need not hold.
std::string bucket(const Distance& distance) {
  std::string key(name(distance.kind));
  for (const auto* names : {&distance.first, &distance.second}) {
    for (const std::string& shape : *names) key += '\n' + shape;
    key += ';';
  }
  return key;
}

Kind exchanged(Kind kind) {
  switch (kind) {
    case Kind::kEta1:
      return Kind::kDelta1;
    case Kind::kEta2:
      return Kind::kDelta2;
    case Kind::kDelta1:
      return Kind::kEta1;
    case Kind::kDelta2:
      return Kind::kEta2;
    default:
      return kind;
  }
}

void rename(std::vector<std::string>& shapes, const std::map<std::string, std::string>& names) {
  for (std::string& shape : shapes) {
    if (const auto entry = names.find(shape); entry != names.end()) shape = entry->second;
  }
}

}  // namespace

Extremum natural_extremum(const Distance& distance) {
  if (distance.prefix != Extremum::kNone) return distance.prefix;
  return distance.kind == Kind::kGamma1 ? Extremum::kInf : Extremum::kSup;
}

Distance moving_first(const Distance& distance, std::span<const std::string> moving) {
  const auto moves = [&](const std::vector<std::string>& shapes) {
    return std::any_of(shapes.begin(), shapes.end(),
                       [&](const auto& s) { return std::find(moving.begin(), moving.end(), s) != moving.end(); });
  };
  if (moves(distance.first) || !moves(distance.second)) return distance;
  if (!is_symmetric(distance.kind) && exchanged(distance.kind) == distance.kind) return distance;
  Distance result = distance;
  result.kind = exchanged(distance.kind);
  std::swap(result.first, result.second);
  return result;
}

Atom compare(Distance distance, Relation relation, const exact::Real& level, std::string level_text) {
  Atom atom{std::move(distance), relation, level, false, {}, decimal_text(level)};
  if (atom.level_text.empty()) atom.level_text = level_text.empty() ? level.text() : std::move(level_text);
  atom.text = text(atom);
  return atom;
}

Atom minimisers(Distance distance) {
  Atom atom{std::move(distance), Relation::kEqual, exact::Real(0), true, {}, {}};
  atom.text = text(atom);
  return atom;
}

Formula::Formula(Atom atom) : Formula(Node{Op::kAtom, 0, {}}, {std::move(atom)}) {}

Formula::Formula(Node root, std::vector<Atom> atoms) : root_(flattened(std::move(root))), atoms_(std::move(atoms)) {
  std::unordered_map<std::string, std::vector<std::size_t>> buckets;
  for (const Atom& atom : atoms_) {
    SignMap map{atom.distance, atom.level, atom.minimum};
    auto& candidates = buckets[bucket(atom.distance)];
    const auto known = std::find_if(candidates.begin(), candidates.end(), [&](auto k) { return sign_maps_[k] == map; });
    if (known != candidates.end()) {
      sign_map_of_.push_back(*known);
      continue;
    }
    candidates.push_back(sign_maps_.size());
    sign_map_of_.push_back(sign_maps_.size());
    sign_maps_.push_back(std::move(map));
  }
  Program compiled = compile(root_, atoms_, sign_map_of_);
  program_ = std::move(compiled.instructions);
  entry_ = compiled.entry;
}

bool operator==(const Formula& a, const Formula& b) { return same_tree(a.root_, b.root_) && a.atoms_ == b.atoms_; }

Formula constant(bool value) { return Formula(Node{value ? Op::kTrue : Op::kFalse, 0, {}}, {}); }
Formula negation(const Formula& formula) { return combine(Op::kNot, {&formula, 1}); }
Formula conjunction(std::span<const Formula> formulas) { return combine(Op::kAnd, formulas); }
Formula disjunction(std::span<const Formula> formulas) { return combine(Op::kOr, formulas); }

Formula renamed(const Formula& formula, const std::map<std::string, std::string>& names) {
  std::vector<Atom> atoms = formula.atoms();
  for (Atom& atom : atoms) {
    rename(atom.distance.first, names);
    rename(atom.distance.second, names);
    atom.text = text(atom);
  }
  return Formula(formula.root(), std::move(atoms));
}

}  // namespace findspace::situation
