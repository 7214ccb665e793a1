// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "planning/pose_formula.h"

#include <algorithm>
#include <array>

#include "findspace/error.h"
#include "situation/text.h"

namespace findspace::planning {

using exact::Real;
using situation::Atom;
using situation::Distance;
using situation::Formula;
using situation::Kind;
using situation::Node;
using situation::Relation;

std::string eroded_name(const std::string& shape) { return shape + " eroded"; }
std::string grown_name(const std::string& shape) { return shape + " grown"; }

namespace {

/// How a distance answers to a small movement of the moving shape.
struct Response {
  bool lipschitz = false;       // at all levels
  bool from_zero_up = false;    // only between levels >= 0 (gamma1)
  bool from_zero_down = false;  // only between levels <= 0 (eta1, delta1)
  bool grows = false;           // a larger moving shape makes it larger, else smaller
  bool known = true;
};

Response response(Kind kind) {
  switch (kind) {
    case Kind::kGamma1: return {.from_zero_up = true};
    case Kind::kEta1: return {.from_zero_down = true, .grows = true};
    case Kind::kDelta1: return {.from_zero_down = true};
    case Kind::kPenetration: return {.grows = true};
    case Kind::kEta2:
    case Kind::kDelta2: return {.known = false};
    default: return {.lipschitz = true};
  }
}

Relation complement(Relation r) {
  constexpr std::array kOpposite{Relation::kGreaterEqual, Relation::kGreater, Relation::kNotEqual,
                                 Relation::kEqual,        Relation::kLess,    Relation::kLessEqual};
  return kOpposite[std::size_t(r)];
}

class Hedge {
 public:
  Hedge(const Formula& formula, const std::vector<std::string>& moving, const Real& bound)
      : formula_(formula), moving_(moving), bound_(bound) {}

  Formula run(const Node& node, Certainty certainty) const {
    std::vector<Formula> operands;
    switch (node.op) {
      case Node::Op::kTrue: return situation::constant(true);
      case Node::Op::kFalse: return situation::constant(false);
      case Node::Op::kNot:
        return negation(run(node.operands.front(), certainty == Certainty::kCertain ? Certainty::kPossible : Certainty::kCertain));
      case Node::Op::kAtom: {
        const Atom& a = formula_.atoms()[node.atom];
        require_plain(a);
        return certainty == Certainty::kCertain ? certain(a, a.relation) : negation(certain(a, complement(a.relation)));
      }
      case Node::Op::kAnd:
      case Node::Op::kOr: break;
    }
    for (const Node& n : node.operands) operands.push_back(run(n, certainty));
    return node.op == Node::Op::kAnd ? conjunction(operands) : disjunction(operands);
  }

 private:
  static void require_plain(const Atom& a) {
    if (!a.minimum && a.distance.mode == situation::Mode::kPlain && a.distance.prefix == situation::Extremum::kNone) return;
    throw Error(ErrorCode::kUnsupported, a.text + ": not computed over positions and angles");
  }

  Formula certain(const Atom& atom, Relation relation) const {
    if (relation == Relation::kEqual) return situation::constant(false);
    if (relation == Relation::kNotEqual) {
      const std::array both{certain(atom, Relation::kLess), certain(atom, Relation::kGreater)};
      return situation::disjunction(both);
    }
    const Distance d = moving_first(atom.distance, moving_);
    const Response r = response(d.kind);
    if (!r.known) return situation::constant(false);
    const bool at_most = relation == Relation::kLess || relation == Relation::kLessEqual;
    const Real level = at_most ? atom.level - bound_ : atom.level + bound_;
    const bool both_up = atom.level.sign() >= 0 && level.sign() >= 0, both_down = atom.level.sign() <= 0 && level.sign() <= 0;
    if (r.lipschitz || (r.from_zero_up && both_up) || (r.from_zero_down && both_down))
      return Formula(situation::compare(d, relation, level));
    // The largest value is wanted for "at most": that of the grown shape where the distance grows with it.
    return Formula(situation::compare(with(d, r.grows == at_most ? grown_name : eroded_name), relation, atom.level));
  }

  Distance with(Distance d, std::string (*variant)(const std::string&)) const {
    for (auto* names : {&d.first, &d.second}) {
      for (std::string& n : *names) {
        if (std::find(moving_.begin(), moving_.end(), n) != moving_.end()) n = variant(n);
      }
    }
    return d;
  }

  const Formula& formula_;
  const std::vector<std::string>& moving_;
  const Real& bound_;
};

}  // namespace

Formula hedged(const Formula& formula, const std::vector<std::string>& moving, const Real& bound, Certainty certainty) {
  return Hedge(formula, moving, bound).run(formula.root(), certainty);
}

}  // namespace findspace::planning
