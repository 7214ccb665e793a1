// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "planning/pose/pose_formula.h"

#include <algorithm>
#include <array>

#include "findspace/error.h"
#include "formula/language/text.h"
#include "formula/language/which.h"

namespace findspace::planning {

using exact::Real;
using formula::Atom;
using formula::Distance;
using formula::Formula;
using formula::Kind;
using formula::Node;
using formula::Relation;

namespace {

/// How a distance answers to a small movement of the moving shape.
struct Response {
  bool lipschitz = false;     // at all levels
  bool from_zero_up = false;  // only between levels >= 0 (gamma1)
  bool as_mu = false;         // at levels <= 0 it has the signs of mu (eta1, delta1)
  bool grows = false;         // a larger moving shape makes it larger, else smaller
  bool known = true;
};

Response response(Kind kind) {
  switch (kind) {
    case Kind::kGamma1:
      return {.from_zero_up = true};
    case Kind::kEta1:
      return {.as_mu = true, .grows = true};
    case Kind::kDelta1:
      return {.as_mu = true};
    case Kind::kPenetration:
      return {.grows = true};
    case Kind::kEta2:
    case Kind::kDelta2:
      return {.known = false};
    default:
      return {.lipschitz = true};
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

  std::vector<Variant> variants() { return std::move(variants_); }

  Formula run(const Node& node, Certainty certainty) {
    std::vector<Formula> operands;
    switch (node.op) {
      case Node::Op::kTrue:
        return formula::constant(true);
      case Node::Op::kFalse:
        return formula::constant(false);
      case Node::Op::kNot:
        return negation(
            run(node.operands.front(), certainty == Certainty::kCertain ? Certainty::kPossible : Certainty::kCertain));
      case Node::Op::kAtom: {
        const Atom& a = formula_.atoms()[node.atom];
        require_plain(a);
        return certainty == Certainty::kCertain ? certain(a, a.relation) : negation(certain(a, complement(a.relation)));
      }
      case Node::Op::kAnd:
      case Node::Op::kOr:
        break;
    }
    for (const Node& n : node.operands) operands.push_back(run(n, certainty));
    return node.op == Node::Op::kAnd ? conjunction(operands) : disjunction(operands);
  }

 private:
  static void require_plain(const Atom& a) {
    if (!a.minimum && a.distance.prefix == formula::Extremum::kNone) return;
    throw Error(ErrorCode::kUnsupported, text(a) + ": not computed over positions and angles");
  }

  Formula certain(const Atom& atom, Relation relation) {
    // Nothing certain is known of sums.
    if (relation == Relation::kEqual || !atom.more.empty()) return formula::constant(false);
    if (relation == Relation::kNotEqual) {
      const std::array both{certain(atom, Relation::kLess), certain(atom, Relation::kGreater)};
      return formula::disjunction(both);
    }
    Distance d = moving_first(atom.distance, moving_);
    if (formula::is_plain_level({d, atom.level})) {
      d.mode = formula::Mode::kPlain;
      d.vector.clear();
    }
    const Response r = response(d.kind);
    if (!r.known || d.mode != formula::Mode::kPlain) return formula::constant(false);
    const bool at_most = relation == Relation::kLess || relation == Relation::kLessEqual;
    const Real level = at_most ? atom.level - bound_ : atom.level + bound_;
    if (r.as_mu && atom.level.sign() <= 0) return Formula(formula::compare(as_mu(d), relation, level));
    if (r.lipschitz || (r.from_zero_up && atom.level.sign() >= 0 && level.sign() >= 0))
      return Formula(formula::compare(d, relation, level));
    // The largest value is wanted for "at most": that of the grown shape where the distance grows with it.
    Formula of_variant(formula::compare(with(d, true, r.grows == at_most ? bound_ : -bound_), relation, atom.level));
    if (!r.from_zero_up || atom.level.sign() < 0) return of_variant;
    // Or the shape itself is so deep in the other that it cannot leave it by more than the level.
    const std::array either{of_variant, Formula(formula::compare(with(d, false, level), relation, Real()))};
    return formula::disjunction(either);
  }

  static Distance as_mu(Distance d) {
    if (d.kind == Kind::kDelta1) std::swap(d.first, d.second);
    d.kind = Kind::kMu;
    return d;
  }

  /// With variants in place of the moving shapes, or of the others.
  Distance with(Distance d, bool of_moving, const Real& by) {
    for (auto* names : {&d.first, &d.second}) {
      for (std::string& n : *names) {
        if ((std::find(moving_.begin(), moving_.end(), n) != moving_.end()) == of_moving) n = variant(n, by);
      }
    }
    return d;
  }

  std::string variant(const std::string& of, const Real& by) {
    for (const Variant& v : variants_) {
      if (v.of == of && v.by == by) return v.name;
    }
    variants_.push_back({of + " variant " + std::to_string(variants_.size()), of, by});
    return variants_.back().name;
  }

  const Formula& formula_;
  const std::vector<std::string>& moving_;
  const Real& bound_;
  std::vector<Variant> variants_;
};

}  // namespace

Hedged hedged(const Formula& formula, const std::vector<std::string>& moving, const Real& bound, Certainty certainty) {
  Hedge hedge(formula, moving, bound);
  Formula out = hedge.run(formula.root(), certainty);
  return {out, hedge.variants()};
}

}  // namespace findspace::planning
