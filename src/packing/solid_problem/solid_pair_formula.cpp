// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "packing/solid_problem/solid_pair_formula.h"

#include <findspace/error.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "formula/language/parse.h"
#include "formula/language/which.h"
#include "packing/problem/pair_formula.h"
#include "space/polytope/solid.h"
#include "space/shape/box_shape.h"

namespace findspace::packing {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

bool is_flat(const SolidForm& form) {
  return form.is_exact() && std::all_of(form.body.parts.begin(), form.body.parts.end(),
                                        [](const space::BodyPart& p) { return p.core && p.radius.sign() == 0; });
}

/// As a set of boxes: its surface, or its convex parts.
std::optional<space::BoxComplex> boxes_of(const SolidForm& form) {
  plane::Shape whole;
  whole.kind = plane::Shape::Kind::kUnion;
  const auto add = [&](space::Solid::Form kind, space::Mesh mesh) {
    space::Solid solid;
    solid.form = kind;
    solid.mesh = std::move(mesh);
    plane::Shape piece;
    piece.solid = std::make_shared<const space::Solid>(std::move(solid));
    whole.children.push_back(std::make_shared<const plane::Shape>(std::move(piece)));
  };
  for (const space::RaySolid& solid : form.surface) {
    space::Mesh mesh{solid.surface.points, {}};
    for (const auto& face : solid.surface.faces) mesh.faces.emplace_back(face.begin(), face.end());
    add(space::Solid::Form::kMesh, std::move(mesh));
  }
  if (form.surface.empty()) {
    if (!is_flat(form)) return std::nullopt;
    for (const space::BodyPart& part : form.body.parts) {
      const auto corners = part.vertices();
      add(space::Solid::Form::kPolytope, {{corners.begin(), corners.end()}, {}});
    }
  }
  const std::int64_t scale = form.surface.empty() ? form.body.scale : form.surface_scale;
  return scale == 1 ? space::box_complex(whole) : std::nullopt;
}

bool has_direction(const formula::Formula& where) {
  return std::any_of(where.atoms().begin(), where.atoms().end(),
                     [](const formula::Atom& atom) { return formula::is_directional(atom.distance); });
}

/// Throws Error where no distances of the form are known, or none along a direction.
void check_known(const SolidForm& form, bool with_direction) {
  if (!form.is_exact() && form.surface_scale != 1)
    throw Error(ErrorCode::kUnsupported, "conditions of a mesh that is turned off the axes are not known");
  if (with_direction && !boxes_of(form))
    throw Error(ErrorCode::kUnsupported,
                "a condition along a direction is of solids with faces parallel to the axes, or unions of boxes");
}

/// With a direction as boxes too, which tell it.
formula::SpaceShape shape_of(const SolidForm& form, bool with_direction) {
  formula::SpaceShape shape;
  if (with_direction) shape.boxes = boxes_of(form);
  shape.body = std::make_shared<const space::Body>(form.body);
  if (!form.is_exact()) shape.surfaces = std::make_shared<const std::vector<space::RaySolid>>(form.surface);
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

void check_conditions(const SolidProblem& problem, const std::string& place) {
  enum Asked : char { kNothing, kDistance, kDirection };
  std::vector<Asked> asked(problem.parts.size(), kNothing);
  std::map<std::string, Asked> known;  // a formula of all pairs is stated for each
  for (const PairCondition& condition : problem.conditions) {
    const auto [formula, is_new] = known.try_emplace(condition.where, kDistance);
    if (is_new && has_direction(parse_condition(condition.where, 3))) formula->second = kDirection;
    const Asked here = formula->second;
    for (const std::size_t part : {condition.first, condition.second}) asked[part] = std::max(asked[part], here);
  }
  for (std::size_t k = 0; k < asked.size(); ++k) {
    const SolidPart& part = problem.parts[k];
    try {
      if (asked[k] == kNothing) continue;
      for (const SolidForm& form : part.forms) check_known(form, asked[k] == kDirection);
    } catch (const Error& e) {
      throw e.within(fmt::format("{}: part '{}'", place, part.name));
    }
  }
}

SolidPairFormula::SolidPairFormula(const SolidProblem& problem, std::size_t first, const SolidForm& a,
                                   std::size_t second, const SolidForm& b)
    : steps_(double(problem.steps())), gap_(problem.gap_of(first, second).to_double()) {
  const std::optional<std::int64_t> common = common_scale(a.body, b.body);
  if (is_flat(a) && is_flat(b) && common) {
    phi_.emplace(polytopes_of(a.body, *common), polytopes_of(b.body, *common));
    phi_steps_ = steps_ * double(*common);
    corners_a_ = corners_of(a, steps_);
    corners_b_ = corners_of(b, steps_);
  }
  const auto add = [&](const PairCondition& condition, bool reversed) {
    formula::Context context;
    context.dimension = 3;
    context.shapes = {"self", "other"};
    context.moving = {reversed ? "self" : "other"};
    const formula::Formula asked = formula::parse_formula(condition.where, context);
    const bool with_direction = has_direction(asked);
    jumps_ = jumps_ || with_direction;
    formula::SpaceWorld world;
    world.shapes.emplace("self", shape_of(reversed ? b : a, with_direction));
    world.shapes.emplace("other", shape_of(reversed ? a : b, with_direction));
    world.moving = context.moving;
    world.step = exact::Real(1) / exact::Real(problem.steps());
    conditions_.push_back(
        {std::make_shared<const formula::SpaceSolver>(std::move(world)), reversed ? asked : for_other(asked)});
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

double SolidPairFormula::slack(const space::Vector& u, double room, double contact) const {
  double least = kInfinite;
  for (const Condition& c : conditions_) least = std::min(least, slack(c, c.where.root(), true, u, {room, contact}));
  return least;
}

double SolidPairFormula::slack(const Condition& c, const formula::Node& node, bool wanted, const space::Vector& u,
                               const Margins& margins) const {
  using Op = formula::Node::Op;
  if (node.op == Op::kTrue || node.op == Op::kFalse) return (node.op == Op::kTrue) == wanted ? kInfinite : -kInfinite;
  if (node.op == Op::kAtom) return slack(c, c.where.atoms()[node.atom], wanted, u, margins);
  if (node.op == Op::kNot) return slack(c, node.operands[0], !wanted, u, margins);
  const bool of_all = (node.op == Op::kAnd) == wanted;
  double result = of_all ? kInfinite : -kInfinite;
  for (const formula::Node& operand : node.operands) {
    const double one = slack(c, operand, wanted, u, margins);
    result = of_all ? std::min(result, one) : std::max(result, one);
  }
  return result;
}

double SolidPairFormula::slack(const Condition& c, const formula::Atom& atom, bool wanted, const space::Vector& u,
                               const Margins& margins) const {
  using Relation = formula::Relation;
  const double above = value(c, atom.distance, u) - atom.level.to_double();
  double result = above;
  if (atom.relation == Relation::kLess || atom.relation == Relation::kLessEqual) result = -above;
  if (atom.relation == Relation::kEqual) result = -std::abs(above);
  if (atom.relation == Relation::kNotEqual) result = std::abs(above);
  const double beyond = is_tight(atom, wanted, margins.room) ? -margins.contact : margins.room;
  return (wanted ? result : -result) - beyond;
}

bool SolidPairFormula::is_tight(const formula::Atom& atom, bool wanted, double room) const {
  using Relation = formula::Relation;
  if (atom.relation == (wanted ? Relation::kEqual : Relation::kNotEqual)) return true;
  const bool is_gap = atom.distance.mode == formula::Mode::kPlain &&
                      (atom.distance.kind == formula::Kind::kGamma1 || atom.distance.kind == formula::Kind::kD1);
  return is_gap && atom.relation == (wanted ? Relation::kLessEqual : Relation::kGreater) &&
         atom.level.to_double() <= gap_ + room;
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
