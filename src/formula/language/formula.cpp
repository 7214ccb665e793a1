// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "formula/language/formula.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "formula/language/evaluate.h"

namespace findspace::formula {
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

/// Sign maps that are equal have the same key; the converse need not hold.
std::size_t bucket(const Distance& distance) {
  std::size_t key = static_cast<std::size_t>(distance.kind);
  for (const auto* names : {&distance.first, &distance.second})
    for (const std::string& shape : *names) key = 31 * key + std::hash<std::string>()(shape);
  return key;
}

bool same_sign_map(const Atom& a, const Atom& b) {
  return a.minimum == b.minimum && a.distance == b.distance && a.level == b.level && a.more == b.more;
}

/// The same with the level, as far as it is a rational number.
std::size_t bucket(const Atom& atom) {
  const std::size_t key = bucket(atom.distance);
  return atom.level.is_rational() ? 31 * key + std::hash<double>()(atom.level.to_double()) : key;
}

/// Of every atom the first one that has the same sign map.
std::vector<std::size_t> first_alike(const std::vector<Atom>& atoms) {
  std::vector<std::pair<std::size_t, std::size_t>> by_key;
  by_key.reserve(atoms.size());
  for (const Atom& atom : atoms) by_key.emplace_back(bucket(atom), by_key.size());
  std::sort(by_key.begin(), by_key.end());
  std::vector<std::size_t> first(atoms.size());
  for (auto begin = by_key.begin(), at = begin; at != by_key.end(); ++at) {
    if (at->first != begin->first) begin = at;
    const std::size_t k = at->second;
    const auto alike = [&](const auto& other) {
      return first[other.second] == other.second && same_sign_map(atoms[other.second], atoms[k]);
    };
    const auto known = std::find_if(begin, at, alike);
    first[k] = known == at ? k : known->second;
  }
  return first;
}

/// The node over atoms that are added to `atoms`.
Node taken(const Node& node, const Formula& from, std::vector<Atom>& atoms) {
  Node out{node.op, 0, {}};
  if (node.op == Op::kAtom) {
    out.atom = atoms.size();
    atoms.push_back(from.atoms()[node.atom]);
  }
  for (const Node& operand : node.operands) out.operands.push_back(taken(operand, from, atoms));
  return out;
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

Extremum opposite(Extremum prefix) {
  if (prefix == Extremum::kNone) return prefix;
  return prefix == Extremum::kInf ? Extremum::kSup : Extremum::kInf;
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
  result.spelled = nullptr;
  result.lists.clear();
  std::swap(result.first, result.second);
  return result;
}

Atom compare(Distance distance, Relation relation, exact::Real level, std::string written) {
  return {std::move(distance), relation, std::move(level), false, std::move(written)};
}

Atom minimisers(Distance distance) { return {std::move(distance), Relation::kEqual, exact::Real(0), true, {}}; }

std::set<std::string> Formula::shapes() const {
  std::set<std::string> out;
  const auto add = [&](const Distance& d) {
    out.insert(d.first.begin(), d.first.end());
    out.insert(d.second.begin(), d.second.end());
  };
  for (const Atom& a : atoms()) {
    add(a.distance);
    for (const SumTerm& t : a.more) add(t.distance);
  }
  return out;
}

Formula::Formula(Atom atom) : Formula(Node{Op::kAtom, 0, {}}, {std::move(atom)}) {}

Formula::Formula(Node root, std::vector<Atom> atoms) {
  const auto made = std::make_shared<Content>(Content{flattened(std::move(root)), std::move(atoms)});
  const std::vector<std::size_t> first = first_alike(made->atoms);
  made->sign_map_of.reserve(made->atoms.size());
  made->sign_maps.reserve(made->atoms.size());
  for (std::size_t k = 0; k < made->atoms.size(); ++k) {
    const Atom& atom = made->atoms[k];
    made->sign_map_of.push_back(first[k] == k ? made->sign_maps.size() : made->sign_map_of[first[k]]);
    if (first[k] == k) made->sign_maps.push_back({atom.distance, atom.level, atom.minimum, atom.more});
  }
  Program compiled = compile(made->root, made->atoms, made->sign_map_of);
  made->program = std::move(compiled.instructions);
  made->entry = compiled.entry;
  content_ = made;
}

bool operator==(const Formula& a, const Formula& b) {
  return a.content_ == b.content_ || (same_tree(a.root(), b.root()) && a.atoms() == b.atoms());
}

bool has_sums(const Formula& formula) {
  return std::any_of(formula.atoms().begin(), formula.atoms().end(), [](const Atom& a) { return !a.more.empty(); });
}

Formula constant(bool value) { return Formula(Node{value ? Op::kTrue : Op::kFalse, 0, {}}, {}); }
Formula negation(const Formula& formula) { return combine(Op::kNot, {&formula, 1}); }
Formula conjunction(std::span<const Formula> formulas) { return combine(Op::kAnd, formulas); }
Formula disjunction(std::span<const Formula> formulas) { return combine(Op::kOr, formulas); }

Formula part_of(const Formula& formula, const Node& node) {
  std::vector<Atom> atoms;
  Node root = taken(node, formula, atoms);
  return Formula(std::move(root), std::move(atoms));
}

Formula renamed(const Formula& formula, const std::map<std::string, std::string>& names) {
  std::vector<Atom> atoms = formula.atoms();
  for (Atom& atom : atoms) {
    rename(atom.distance.first, names);
    rename(atom.distance.second, names);
    for (SumTerm& term : atom.more) {
      rename(term.distance.first, names);
      rename(term.distance.second, names);
    }
  }
  return Formula(formula.root(), std::move(atoms));
}

std::vector<Distance> distances_of(const Objective& objective) {
  if (objective.kind == Objective::Kind::kDistance) return {objective.distance};
  std::vector<Distance> out;
  for (const SumTerm& term : objective.terms) out.push_back(term.distance);
  return out;
}

}  // namespace findspace::formula
