// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include <fcl/geometry/shape/convex.h>
#include <fcl/narrowphase/collision.h>

#include <memory>

#include "phi_rivals.h"

namespace phi_bench {
namespace {

std::shared_ptr<fcl::Convexd> convex(const Body& body) {
  auto vertices = std::make_shared<std::vector<fcl::Vector3d>>();
  for (const auto& v : body.vertices) vertices->emplace_back(v[0], v[1], v[2]);
  auto faces = std::make_shared<std::vector<int>>();
  for (const auto& face : body.faces) {
    faces->push_back(static_cast<int>(face.size()));
    faces->insert(faces->end(), face.begin(), face.end());
  }
  return std::make_shared<fcl::Convexd>(vertices, static_cast<int>(body.faces.size()), faces);
}

}  // namespace

DepthQuery depth_with_fcl(const Body& a, const Body& b) {
  auto p = convex(a), q = convex(b);
  fcl::CollisionRequestd request(1, true);
  request.gjk_solver_type = fcl::GST_LIBCCD;
  return [p, q, request](const std::array<double, 3>& u) {
    fcl::CollisionResultd result;
    fcl::Transform3d at = fcl::Transform3d::Identity(), moved = fcl::Transform3d::Identity();
    moved.translation() = fcl::Vector3d(u[0], u[1], u[2]);
    fcl::collide(p.get(), at, q.get(), moved, request, result);
    return result.numContacts() == 0 ? 0.0 : result.getContact(0).penetration_depth;
  };
}

}  // namespace phi_bench
