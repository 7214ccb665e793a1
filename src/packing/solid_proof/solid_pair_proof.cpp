// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "packing/solid_proof/solid_pair_proof.h"

#include <findspace/error.h>

#include <algorithm>

#include "space/body/cell_parts.h"

namespace findspace::packing {
namespace {

std::vector<space::Polytope> polytopes_of(const space::Body& body, std::int64_t scale) {
  std::vector<space::Polytope> result;
  for (const space::BodyPart& part : space::at_scale(body, scale).parts) result.push_back(*part.core);
  return result;
}

}  // namespace

std::shared_ptr<const space::SurfaceSet> surfaces_of(const SolidForm& form, std::int64_t scale) {
  auto set = std::make_shared<space::SurfaceSet>();
  const bool in_range =
      form.surface.empty() ? set->add(form.body, scale) : set->add(form.surface, scale / form.surface_scale);
  if (!in_range) throw Error(ErrorCode::kOutOfRange, "a part has too many digits for an exact proof");
  return set;
}

SolidPairProof::SolidPairProof(const SolidProblem& problem, const SolidForm& a, const SolidForm& b) {
  const std::optional<std::int64_t> common = common_scale(a.body, b.body);
  if (a.is_exact() && b.is_exact() && common) {
    steps_ = bounded_product(problem.steps(), *common);
    if (a.has_balls() || b.has_balls()) {
      round_.emplace(space::at_scale(a.body, *common).parts, space::at_scale(b.body, *common).parts);
      return;
    }
    phi_.emplace(polytopes_of(a.body, *common), polytopes_of(b.body, *common));
    return;
  }
  const auto scale_of = [](const SolidForm& form) {
    return form.surface.empty() ? form.body.scale : form.surface_scale;
  };
  const std::int64_t scale = space::joint_scale(scale_of(a), scale_of(b));
  steps_ = bounded_product(problem.steps(), scale);
  gaps_.emplace(surfaces_of(a, scale), surfaces_of(b, scale));
}

space::RealVector SolidPairProof::in_steps(const std::array<Fraction, 3>& u) const {
  return {packing::in_steps(u[0], steps_), packing::in_steps(u[1], steps_), packing::in_steps(u[2], steps_)};
}

bool SolidPairProof::interiors_meet(const std::array<Fraction, 3>& u) const {
  if (gaps_) return gaps_->relation(in_steps(u)) != space::SurfaceGaps::Relation::kApart;
  if (round_) return round_->compare_distance(in_steps(u), exact::Real(0)) < 0;
  return phi_->sign_at(in_steps(u)) < 0;
}

bool SolidPairProof::is_nearer(const std::array<Fraction, 3>& u, const Fraction& gap) const {
  const space::RealVector at = in_steps(u);
  const exact::Real least = packing::in_steps(gap, steps_);
  if (gaps_) return gaps_->gap(at, gaps_->near(at)).value < least;
  if (round_) return round_->compare_distance(at, least) < 0;
  return phi_->squared_distance(at) < least * least;
}

double SolidPairProof::depth(const std::array<Fraction, 3>& u) const {
  if (round_) return std::max(0.0, -round_->at(in_steps(u)).at.normalised / double(steps_));
  if (!phi_) return 0;
  return std::max(0.0, -phi_->max_form(space::rounded(in_steps(u))) / double(steps_));
}

}  // namespace findspace::packing
