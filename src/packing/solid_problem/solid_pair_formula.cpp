// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "packing/solid_problem/solid_pair_formula.h"

#include <findspace/error.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "formula/language/parse.h"
#include "packing/problem/pair_formula.h"

namespace findspace::packing {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

bool is_flat(const SolidForm& form) {
  return form.is_exact() && std::all_of(form.body.parts.begin(), form.body.parts.end(),
                                        [](const space::BodyPart& p) { return p.core && p.radius.sign() == 0; });
}

formula::SpaceShape shape_of(const SolidForm& form) {
  formula::SpaceShape shape;
  shape.body = std::make_shared<const space::Body>(form.body);
  if (form.is_exact()) return shape;
  if (form.surface_scale != 1)
    throw Error(ErrorCode::kUnsupported, "conditions of a mesh that is turned off the axes are not known");
  shape.surfaces = std::make_shared<const std::vector<space::RaySolid>>(form.surface);
  return shape;
}

std::vector<space::Polytope> polytopes_of(const space::Body& body, std::int64_t scale) {
  std::vector<space::Polytope> result;
  for (const space::BodyPart& part : space::at_scale(body, scale).parts) result.push_back(*part.core);
  return result;
}

/// Those of the convex hull would do.
std::vector<space::Vector> corners_of(const SolidForm& form, double steps) {
  std::vector<space::Vector> corners;
  const double unit = steps * double(form.body.scale);
  for (const space::BodyPart& part : form.body.parts)
    for (const space::Point& p : part.vertices())
      corners.push_back({double(p.x) / unit, double(p.y) / unit, double(p.z) / unit});
  return corners;
}

exact::Real real(const Fraction& value) { return exact::Real(value.numerator()) / exact::Real(value.denominator()); }

}  // namespace

SolidPairFormula::SolidPairFormula(const SolidProblem& problem, std::size_t first, const SolidForm& a,
                                   std::size_t second, const SolidForm& b)
    : steps_(double(problem.steps())) {
  const std::optional<std::int64_t> common = common_scale(a.body, b.body);
  if (is_flat(a) && is_flat(b) && common) {
    phi_.emplace(polytopes_of(a.body, *common), polytopes_of(b.body, *common));
    phi_steps_ = steps_ * double(*common);
    corners_a_ = corners_of(a, steps_);
    corners_b_ = corners_of(b, steps_);
  }
  const auto add = [&](const PairCondition& condition, bool reversed) {
    formula::SpaceWorld world;
    world.shapes.emplace("self", shape_of(reversed ? b : a));
    world.shapes.emplace("other", shape_of(reversed ? a : b));
    world.moving = {reversed ? "self" : "other"};
    world.step = exact::Real(1) / exact::Real(problem.steps());
    formula::Context context;
    context.dimension = 3;
    context.shapes = {"self", "other"};
    context.moving = world.moving;
    conditions_.push_back({std::make_shared<const formula::SpaceSolver>(std::move(world)),
                           formula::parse_formula(condition.where, context), reversed});
  };
  for (const PairCondition& condition : problem.conditions) {
    if (condition.first == first && condition.second == second) add(condition, false);
    if (condition.first == second && condition.second == first) add(condition, true);
  }
}

bool SolidPairFormula::holds(const std::array<Fraction, 3>& u) const {
  const space::RealVector at{real(u[0]), real(u[1]), real(u[2])};
  return std::all_of(conditions_.begin(), conditions_.end(),
                     [&](const Condition& c) { return c.solver->check(c.where, at).holds; });
}

double SolidPairFormula::slack(const space::Vector& u) const {
  double least = kInfinite;
  for (const Condition& c : conditions_) least = std::min(least, slack(c, c.where.root(), u));
  return least;
}

double SolidPairFormula::slack(const Condition& c, const formula::Node& node, const space::Vector& u) const {
  using Op = formula::Node::Op;
  if (node.op == Op::kTrue || node.op == Op::kFalse) return node.op == Op::kTrue ? kInfinite : -kInfinite;
  if (node.op == Op::kAtom) return slack(c, c.where.atoms()[node.atom], u);
  if (node.op == Op::kNot) return -slack(c, node.operands[0], u);
  double result = node.op == Op::kAnd ? kInfinite : -kInfinite;
  for (const formula::Node& operand : node.operands) {
    const double one = slack(c, operand, u);
    result = node.op == Op::kAnd ? std::min(result, one) : std::max(result, one);
  }
  return result;
}

double SolidPairFormula::slack(const Condition& c, const formula::Atom& atom, const space::Vector& u) const {
  double sum = value(c, atom.distance, u) - atom.level.to_double(), weights = 1;
  for (const formula::SumTerm& term : atom.more) {
    sum += term.weight.to_double() * value(c, term.distance, u);
    weights += std::abs(term.weight.to_double());
  }
  const double above = sum / weights;
  switch (atom.relation) {
    case formula::Relation::kLess:
    case formula::Relation::kLessEqual:
      return -above;
    case formula::Relation::kGreater:
    case formula::Relation::kGreaterEqual:
      return above;
    case formula::Relation::kNotEqual:
      return std::abs(above);
    case formula::Relation::kEqual:
      break;
  }
  return -std::abs(above);
}

double SolidPairFormula::value(const Condition& c, const formula::Distance& distance, const space::Vector& u) const {
  using formula::Kind;
  if (phi_ && distance.mode == formula::Mode::kPlain) {
    if (distance.kind == Kind::kGamma2 || distance.kind == Kind::kD2) return reach(u);
    const double gap = phi_->normalised(space::scaled(phi_steps_, u)) / phi_steps_;
    if (distance.kind == Kind::kGamma1) return gap;
    if (distance.kind == Kind::kD1) return std::max(gap, 0.0);
    if (distance.kind == Kind::kPenetration) return std::max(-gap, 0.0);
  }
  const auto steps = [&](double x) { return exact::Real::from_double(x * steps_); };
  const auto answer = c.solver->value(distance, {steps(u.x), steps(u.y), steps(u.z)});
  if (!answer) return kInfinite;
  if (answer->minus_infinity) return -kInfinite;
  return answer->value.to_double() / steps_;
}

double SolidPairFormula::reach(const space::Vector& u) const {
  double most = 0;
  for (const space::Vector& p : corners_a_)
    for (const space::Vector& q : corners_b_) {
      const double x = q.x + u.x - p.x, y = q.y + u.y - p.y, z = q.z + u.z - p.z;
      most = std::max(most, x * x + y * y + z * z);
    }
  return std::sqrt(most);
}

}  // namespace findspace::packing
