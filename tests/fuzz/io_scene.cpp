// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Any bytes are a scene or an Error. Of a scene, the promises of src/plane/contour/shape.h hold: rings have their
// direction and every vertex is on the grid. No file is opened.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "findspace/error.h"
#include "io/scene/scene.h"
#include "plane/contour/contour.h"

namespace {

using namespace findspace;

void require(bool law) {
  if (!law) std::abort();
}

void check(const plane::Shape& shape) {
  for (const plane::Contour& contour : shape.contours) {
    require(contour.size() >= 2);
    for (const plane::ContourEdge& edge : contour) {
      require(std::abs(edge.start.x) <= io::Grid::kLimit && std::abs(edge.start.y) <= io::Grid::kLimit);
    }
  }
  if (shape.kind == plane::Shape::Kind::kRings) {
    for (std::size_t i = 0; i < shape.contours.size(); ++i) {
      require(plane::orientation(shape.contours[i]) == (i == 0 ? 1 : -1));
    }
  }
  for (const plane::ShapePtr& child : shape.children) {
    if (child->name.empty()) check(*child);  // named ones are seen once, at the top
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string_view text(reinterpret_cast<const char*>(data), size);
  ReadOptions options;
  options.files = false;
  try {
    io::Scene scene = io::read_scene_text(text, "/nowhere", "fuzz.json", options);
    for (const plane::ShapePtr& shape : scene.shapes) check(*shape);
  } catch (const Error& error) {
    require(!error.message().empty());
  }
  return 0;
}
