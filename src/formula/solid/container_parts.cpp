// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "formula/solid/container_parts.h"

namespace findspace::formula {

std::vector<ContainerPart> container_parts(const plane::ShapePtr& shape) {
  using Kind = plane::Shape::Kind;
  const auto& children = shape->children;
  const bool keeps =
      shape->kind == Kind::kClosure || shape->kind == Kind::kRegularize || shape->kind == Kind::kInterior;
  if (keeps && container_parts(children[0]).size() > 1) return container_parts(children[0]);
  if (shape->solid || (shape->kind != Kind::kIntersection && shape->kind != Kind::kDifference)) return {{shape, false}};
  std::vector<ContainerPart> out;
  for (std::size_t k = 0; k < children.size(); ++k) {
    if (shape->kind == Kind::kDifference && k > 0)
      out.push_back({children[k], true});
    else if (children[k]->kind == Kind::kComplement)
      out.push_back({children[k]->children[0], true});
    else
      for (ContainerPart& part : container_parts(children[k])) out.push_back(std::move(part));
  }
  return out;
}

}  // namespace findspace::formula
