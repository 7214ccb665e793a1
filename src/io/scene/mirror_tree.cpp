// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "io/scene/mirror_tree.h"

#include <map>

#include "findspace/error.h"
#include "plane/build/transform.h"
#include "plane/contour/contour.h"
#include "plane/sum/minkowski.h"

namespace findspace::io {
namespace {

using plane::Contour;
using plane::Shape;
using plane::ShapePtr;

Contour mirrored_edges(const Contour& contour) {
  Contour out;
  for (const plane::ContourEdge& e : contour) {
    plane::ContourEdge& m = out.emplace_back(e);
    m.start.y = -m.start.y;
    m.ccw = !m.ccw;
    if (e.arc) m.arc = std::make_shared<const plane::ArcCircle>(plane::ArcCircle{e.arc->cx, -e.arc->cy, e.arc->r});
  }
  return out;
}

class Mirror {
 public:
  ShapePtr of(const ShapePtr& shape) {
    if (const auto found = done_.find(shape.get()); found != done_.end()) return found->second;
    if (shape->solid) throw Error(ErrorCode::kUnsupported, "\"mirror\" about an axis is for shapes in the plane");
    Shape out = *shape;
    if (out.cells)
      out.cells = std::make_shared<const plane::CellComplex>(plane::mirrored(plane::mirrored_in_y_axis(*out.cells)));
    for (ShapePtr& child : out.children) child = of(child);
    for (plane::GridPoint& p : out.points) p.y = -p.y;
    for (Contour& c : out.contours) {
      c = mirrored_edges(c);
      if (out.kind == Shape::Kind::kRings) c = plane::reversed(c);  // rings keep their direction
    }
    out.degrees = -out.degrees;
    return done_[shape.get()] = std::make_shared<const Shape>(std::move(out));
  }

 private:
  std::map<const Shape*, ShapePtr> done_;
};

}  // namespace

ShapePtr mirrored_in_x_axis(const ShapePtr& shape) { return Mirror().of(shape); }

}  // namespace findspace::io
