// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The formula ("formula") as a value: distances compared with levels, combined by and, or, not.
//
// A formula is a predicate on the signs of its *sign maps*: the distinct pairs (distance, level) that occur in it, and
// the distinct `distance -> min`. Whoever knows at some place the sign of every distance minus its level (a cell of a
// subdivision, an interval, one position) gets the truth there from evaluate(), so
//     S = { p : evaluate(formula, signs(p)) }
// is exact wherever the signs are. evaluate.h has the evaluation, parse.h reads formulas, text.h writes them.
//
// Invariant of Formula: the tree, the list of atoms, the sign maps and the program describe the same predicate; an
// `and` has no `and` among its operands (nor an `or` an `or`) and at least two operands. Values are immutable.
//
// Keywords: Boolean formula, constraint, predicate, syntax tree, level set, sign vector.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "exact/number/real.h"
#include "formula/language/names.h"

namespace findspace::formula {

/// Over the time of a motion: kNone stands for the natural one, see natural_extremum().
enum class Extremum : std::uint8_t { kNone, kInf, kSup };

/// kPlain: translations in all directions; kAlong: both ways along a direction; kToward: one way, that in which the
/// moving shape goes; kRotation: rotations of the moving shape about a point, the value is an angle in degrees.
enum class Mode : std::uint8_t { kPlain, kAlong, kToward, kRotation };

/// omega(first, second). A list of several names is the union of those shapes.
struct Distance {
  Kind kind = Kind::kGamma1;
  Extremum prefix = Extremum::kNone;
  Mode mode = Mode::kPlain;
  std::vector<exact::Real> vector;  // direction, or centre of rotation in the scene's unit; empty if mode is kPlain
  std::vector<std::string> first, second;
  std::string vector_text;                // "(1, 0)": the vector as it is printed; exact, no part of the value
  const DistanceName* spelled = nullptr;  // the word of its writer, where there is one; no part of the value
  bool turning = false;                   // so its writer calls kRotation, not "rotating"; no part of the value
  std::vector<std::string> lists{};       // the two of a rule `between`, as its writer has them; no part of the value

  friend bool operator==(const Distance& a, const Distance& b) {
    return a.kind == b.kind && a.prefix == b.prefix && a.mode == b.mode && a.first == b.first && a.second == b.second &&
           a.vector == b.vector;
  }
};

/// Of -f that which is minus the one of f.
Extremum opposite(Extremum prefix);

/// The extremum over time that a distance without prefix means: gamma1 its infimum, every other distance its supremum,
/// so that a constraint holds at every instant.
Extremum natural_extremum(const Distance& distance);

/// weight * distance: a summand.
struct SumTerm {
  exact::Real weight;
  Distance distance;
  friend bool operator==(const SumTerm&, const SumTerm&) = default;
};

/// The same value with the moving shape as first argument, where the distance allows it: symmetric distances exchange
/// their arguments, eta(A, B) is delta(B, A). The directed ones (mu, h, dstar) come back unchanged.
Distance moving_first(const Distance& distance, std::span<const std::string> moving);

/// `distance relation level`, or `distance -> min` if `minimum` (then relation is kEqual and level 0). With `more` the
/// sum distance + more[0] + ... is compared: "gap(B, A) <= gap(B, C)" has the weight -1 in it.
struct Atom {
  Distance distance;
  Relation relation = Relation::kEqual;
  exact::Real level;  // in the scene's unit; degrees if the distance rotates
  bool minimum = false;
  std::string written;  // the level as it was written, for one that is not a finite decimal ("1mm" in inches)
  const PredicateName* predicate = nullptr;  // the word of its writer, where that is one; no part of the value
  std::vector<SumTerm> more{};

  friend bool operator==(const Atom& a, const Atom& b) {
    return a.distance == b.distance && a.relation == b.relation && a.minimum == b.minimum && a.level == b.level &&
           a.more == b.more;
  }
};

/// A level that is not a finite decimal is printed as `written`, or without that rounded.
Atom compare(Distance distance, Relation relation, exact::Real level, std::string written = {});
/// distance -> min: the set of global minimisers.
Atom minimisers(Distance distance);

/// What a formula needs to know at a place: the sign of distance - level, or for `minimum` 0 at a global minimiser and
/// +1 elsewhere. Where the distance is undefined it counts as +infinity: sign +1.
struct SignMap {
  Distance distance;
  exact::Real level;
  bool minimum = false;
  std::vector<SumTerm> more{};  // as an atom's
  friend bool operator==(const SignMap&, const SignMap&) = default;
};

struct Node {
  enum class Op : std::uint8_t { kTrue, kFalse, kAtom, kNot, kAnd, kOr };
  Op op = Op::kTrue;
  std::size_t atom = 0;        // of kAtom: index into atoms()
  std::vector<Node> operands;  // one of kNot, two or more of kAnd and kOr
};

/// One step of a compiled formula: look at one sign, go on at one of two places (or stop, if negative).
struct Instruction {
  static constexpr std::int32_t kTrue = -1, kFalse = -2;
  std::uint32_t sign_map;
  std::uint32_t accepted;  // bit 0: sign -1, bit 1: sign 0, bit 2: sign +1
  std::int32_t on_true, on_false;
};

/// Cheap to copy: copies share what never changes.
class Formula {
 public:
  /// `true`: the formula that always holds.
  Formula() : Formula(Node{}, {}) {}
  explicit Formula(Atom atom);
  /// Any tree over the given atoms; every atom is used once, in the order of the tree's leaves. Nested `and` and `or`
  /// are flattened. Precondition: operands as Node says, or none (`and` of nothing is true, `or` of nothing false) or
  /// one.
  Formula(Node root, std::vector<Atom> atoms);
  Formula(const Formula&) = default;  // no move: what was moved from would be no formula
  Formula& operator=(const Formula&) = default;

  const Node& root() const { return content_->root; }
  /// From left to right, one for each occurrence.
  const std::vector<Atom>& atoms() const { return content_->atoms; }
  /// The names of all shapes that it speaks of.
  std::set<std::string> shapes() const;
  /// The distinct ones, in order of first occurrence.
  const std::vector<SignMap>& sign_maps() const { return content_->sign_maps; }
  /// The index into sign_maps() that decides atoms()[atom].
  std::size_t sign_map_of(std::size_t atom) const { return content_->sign_map_of[atom]; }

  std::span<const Instruction> program() const { return content_->program; }
  /// Where the program begins: an index, or Instruction::kTrue or kFalse for a constant.
  std::int32_t entry() const { return content_->entry; }

  /// The same tree with the same atoms (not merely an equivalent formula).
  friend bool operator==(const Formula& a, const Formula& b);

 private:
  struct Content {
    Node root;
    std::vector<Atom> atoms;
    std::vector<SignMap> sign_maps{};
    std::vector<std::size_t> sign_map_of{};
    std::vector<Instruction> program{};
    std::int32_t entry = Instruction::kTrue;
  };
  std::shared_ptr<const Content> content_;
};

/// Whether some atom compares a sum of distances.
bool has_sums(const Formula& formula);

Formula constant(bool value);
Formula negation(const Formula& formula);
/// Of none: true (conjunction), false (disjunction).
Formula conjunction(std::span<const Formula> formulas);
Formula disjunction(std::span<const Formula> formulas);

/// A node of the formula's tree as a formula of its own.
Formula part_of(const Formula& formula, const Node& node);

/// The formula with shapes renamed, e.g. {"self": "A1", "other": "A0"}; names that are not in the map stay.
Formula renamed(const Formula& formula, const std::map<std::string, std::string>& names);

/// What the scene keys `minimize` and `maximize` take.
struct Objective {
  enum class Kind : std::uint8_t { kDistance, kX, kY, kZ, kDistanceToPoint, kSum };
  Kind kind = Kind::kDistance;
  Distance distance;               // of kDistance
  bool negated = false;            // of kDistance: the objective is -distance (`margin` is -eta1)
  std::vector<exact::Real> point;  // of kDistanceToPoint, in the scene's unit
  std::string point_text;          // "[1, 2]"; no part of the value
  std::vector<SumTerm> terms{};    // of kSum

  friend bool operator==(const Objective& a, const Objective& b) {
    return a.kind == b.kind && a.negated == b.negated && a.distance == b.distance && a.point == b.point &&
           a.terms == b.terms;
  }
};

/// The distances of an objective: none of a coordinate or a point.
std::vector<Distance> distances_of(const Objective& objective);

}  // namespace findspace::formula
