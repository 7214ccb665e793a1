// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Public sets of space as surfaces and as text; shapes of space as the text that brings them back.

#include <fmt/format.h>

#include <array>
#include <span>
#include <vector>

#include "api/query/space_region_data.h"
#include "findspace/error.h"
#include "findspace/text.h"
#include "formula/language/text.h"
#include "io/draw/draw_bodies.h"
#include "io/mesh/space_surface.h"
#include "io/question/ray_map.h"
#include "io/write/write_json_space.h"
#include "space/body/body.h"
#include "space/box/box_operations.h"
#include "space/box/box_topology.h"
#include "space/polytope/solid.h"

namespace findspace {

using exact::Real;

std::string Surface::text(std::string_view ending, std::string_view unit, std::string_view name) const {
  return io::surface_text({vertices, faces, {}}, name, ending, unit);
}

std::vector<std::string> Surface::endings() { return {io::kSurfaceEndings.begin(), io::kSurfaceEndings.end()}; }

std::string Surface::scene_json(std::string_view name, std::string_view unit) const {
  const auto corner = [](const Position3& v) {
    return fmt::format("[{}, {}, {}]", json_number(v[0]), json_number(v[1]), json_number(v[2]));
  };
  const auto face = [](const std::vector<int>& f) { return fmt::format("[{}]", fmt::join(f, ", ")); };
  return fmt::format(
      "{{\"findspace\": 1, {}\"shapes\": {{{}: {{\"mesh\": {{\"vertices\": {},\n \"faces\": {}}}}}}}}}\n",
      unit.empty() ? "" : fmt::format("\"unit\": {}, ", json_string(unit)), json_string(name),
      json_list(vertices, corner), json_list(faces, face));
}

Surface SpaceRegion::surface() const {
  const auto& convex = data_->region.convex;
  io::Surface made =
      convex ? io::convex_surface(convex->set, data_->step) : io::box_surface(data_->region.boxes, data_->step);
  return {std::move(made.vertices), std::move(made.faces)};
}

namespace {

/// What the closure of its interior leaves of a set.
space::BoxComplex without_volume(const space::BoxComplex& set) {
  const space::BoxComplex solid = space::regularized(set);
  const std::array<const space::BoxComplex*, 2> both{&set, &solid};
  return space::overlay(both, [](std::span<const space::Mark> m) { return space::Mark(m[0] != 0 && m[1] == 0); })
      .simplified();
}

/// The corners of a flat box that is cut off at the window: of a sheet in order around it.
std::vector<Position3> corners_of(const space::IntervalBox& box, const Real& step, const SpaceRegion::Bounds3& window) {
  Position3 from{}, to{};
  std::vector<std::size_t> wide;
  for (std::size_t k = 0; k < 3; ++k) {
    from[k] = box[k].from ? (*box[k].from * step).to_double() : window.low[k];
    to[k] = box[k].to ? (*box[k].to * step).to_double() : window.high[k];
    if (!(box[k].from && box[k].to && *box[k].from == *box[k].to)) wide.push_back(k);
  }
  std::vector<Position3> out{from};
  if (wide.empty()) return out;
  const auto add = [&](std::initializer_list<std::size_t> far) {
    Position3 p = from;
    for (const std::size_t k : far) p[k] = to[k];
    out.push_back(p);
  };
  add({wide[0]});
  if (wide.size() == 1) return out;
  add({wide[0], wide[1]});
  add({wide[1]});
  return out;
}

SpaceRegion::Thin thin_boxes(const space::BoxComplex& set, const Real& step, const SpaceRegion::Bounds3& window) {
  SpaceRegion::Thin out;
  for (const space::IntervalBox& box : without_volume(set).boxes()) {
    std::vector<Position3> corners = corners_of(box, step, window);
    if (corners.size() == 1)
      out.points.push_back(corners[0]);
    else
      (corners.size() == 2 ? out.curves : out.sheets).push_back(std::move(corners));
  }
  return out;
}

SpaceRegion::Thin thin_convex(const space::ConvexSet& set, const Real& step) {
  SpaceRegion::Thin out;
  const int dimension = set.region.dimension();
  if (!set.frontier || dimension == 3) return out;
  std::vector<Position3> corners = io::convex_surface(set, step).vertices;
  if (dimension == 2) {
    std::vector<Position3> sheet;
    for (const int v : set.region.circuit(set.region.facets().at(0))) sheet.push_back(corners[std::size_t(v)]);
    out.sheets.push_back(std::move(sheet));
  } else if (dimension == 1) {
    out.curves.push_back(std::move(corners));
  } else {
    out.points = std::move(corners);
  }
  return out;
}

}  // namespace

SpaceRegion::Thin SpaceRegion::thin(const Bounds3& window) const {
  const auto& convex = data_->region.convex;
  return convex ? thin_convex(convex->set, data_->step) : thin_boxes(data_->region.boxes, data_->step, window);
}

std::string SpaceRegion::svg() const { return surface().text(".svg", data_->unit); }

std::string SpaceRegion::json() const {
  const auto& convex = data_->region.convex;
  return convex ? io::space_json(convex->set, data_->summary, data_->step, data_->unit)
                : io::space_json(data_->region.boxes, data_->summary, data_->step, data_->unit);
}

namespace {

/// A tree of solids as a scene states it, every number in full.
class SolidText {
 public:
  explicit SolidText(const Real& step) : step_(step) {}

  std::string tree(const plane::Shape& shape) const {
    using Kind = plane::Shape::Kind;
    if (const space::Solid* solid = space::solid_of(shape)) return primitive(*solid);
    switch (shape.kind) {
      case Kind::kTranslate:
        return fmt::format("{{\"translate\": [{}, {}, {}], \"of\": {}}}", length(Real(shape.points[0].x)),
                           length(Real(shape.points[0].y)), length(Real(shape.lift)), tree(*shape.children[0]));
      case Kind::kOffset:
        return fmt::format("{{\"offset\": {}, \"of\": {}}}", length(shape.amount), tree(*shape.children[0]));
      default:
        return node(shape);
    }
  }

 private:
  std::string length(const Real& steps) const {
    std::string text = formula::decimal_text(steps * step_);
    if (text.empty()) throw Error(ErrorCode::kUnsupported, "a length that is not a decimal cannot be written");
    return text;
  }

  std::string node(const plane::Shape& shape) const {
    static const std::map<plane::Shape::Kind, const char*> kWords{
        {plane::Shape::Kind::kUnion, "union"},
        {plane::Shape::Kind::kIntersection, "intersection"},
        {plane::Shape::Kind::kDifference, "difference"},
        {plane::Shape::Kind::kComplement, "complement"},
        {plane::Shape::Kind::kInterior, "interior"},
        {plane::Shape::Kind::kClosure, "closure"},
        {plane::Shape::Kind::kBoundary, "boundary"},
        {plane::Shape::Kind::kRegularize, "regularize"},
        {plane::Shape::Kind::kMirror, "mirror"},
        {plane::Shape::Kind::kMinkowskiSum, "minkowski_sum"},
        {plane::Shape::Kind::kMinkowskiDifference, "minkowski_difference"},
        {plane::Shape::Kind::kHull, "hull"}};
    const auto word = kWords.find(shape.kind);
    if (word == kWords.end()) throw Error(ErrorCode::kUnsupported, "this construction of solids cannot be written");
    std::vector<std::string> operands;
    for (const plane::ShapePtr& child : shape.children) operands.push_back(tree(*child));
    const bool several = shape.kind == plane::Shape::Kind::kUnion || shape.kind == plane::Shape::Kind::kIntersection ||
                         shape.kind == plane::Shape::Kind::kDifference ||
                         shape.kind == plane::Shape::Kind::kMinkowskiSum ||
                         shape.kind == plane::Shape::Kind::kMinkowskiDifference;
    const std::string list = fmt::format("{}", fmt::join(operands, ", "));
    return fmt::format("{{\"{}\": {}}}", word->second, several ? "[" + list + "]" : list);
  }

  std::string vertices(const std::vector<space::Point>& points) const {
    std::vector<std::string> out;
    for (const space::Point& p : points)
      out.push_back(fmt::format("[{}, {}, {}]", length(Real(p.x)), length(Real(p.y)), length(Real(p.z))));
    return fmt::format("[{}]", fmt::join(out, ", "));
  }

  std::string ring(const plane::Contour& contour) const {
    std::vector<std::string> out;
    for (const plane::ContourEdge& e : contour) {
      if (e.arc) throw Error(ErrorCode::kUnsupported, "a prism with arcs cannot be written");
      out.push_back(fmt::format("[{}, {}]", length(Real(e.start.x)), length(Real(e.start.y))));
    }
    return fmt::format("[{}]", fmt::join(out, ", "));
  }

  std::string primitive(const space::Solid& solid) const {
    using Form = space::Solid::Form;
    std::vector<std::string> parts;
    switch (solid.form) {
      case Form::kPolytope:
        return fmt::format("{{\"polytope\": {}}}", vertices(solid.mesh.vertices));
      case Form::kBall: {
        const std::string center = vertices({solid.mesh.vertices[0]});
        return fmt::format("{{\"ball\": {{\"center\": {}, \"radius\": {}}}}}", center.substr(1, center.size() - 2),
                           length(solid.radius));
      }
      case Form::kPrism:
        for (std::size_t k = 1; k < solid.contours.size(); ++k) parts.push_back(ring(solid.contours[k]));
        return fmt::format("{{\"prism\": {{\"polygon\": {}, \"holes\": [{}], \"z\": [{}, {}]}}}}",
                           ring(solid.contours[0]), fmt::join(parts, ", "), length(Real(solid.low)),
                           length(Real(solid.high)));
      case Form::kMesh:
        break;
    }
    for (const auto& face : solid.mesh.faces) parts.push_back(fmt::format("[{}]", fmt::join(face, ", ")));
    return fmt::format("{{\"mesh\": {{\"vertices\": {}, \"faces\": [{}]}}}}", vertices(solid.mesh.vertices),
                       fmt::join(parts, ", "));
  }

  const Real& step_;
};

}  // namespace

Surface Shape::surface() const {
  if (dimension() == 2) throw Error(ErrorCode::kUnsupported, "a shape of the plane has no surface");
  io::SolidSurface made = io::solid_surface(*data_->tree, data_->grid.step());
  return {std::move(made.surface.vertices), std::move(made.surface.faces), std::move(made.lost)};
}

Surface Shape::drawn_surface(int lines) const {
  if (dimension() == 2) throw Error(ErrorCode::kUnsupported, "a shape of the plane has no surface");
  io::Surface made;
  if (const auto boundary = formula::shape_boundary(*data_->tree))
    made = io::surface_of(*boundary, data_->grid.step());
  else if (lines > 0)
    made = io::surface_on_lines(*data_->tree, lines, data_->grid.step_size());
  return {std::move(made.vertices), std::move(made.faces)};
}

std::string Shape::svg() const {
  if (dimension() == 2) return region().svg();
  const space::Body body = space::body(*data_->tree);
  io::BodiesPicture picture{"", "", {}, {}, {}, data_->grid.step_size()};
  picture.bodies.push_back({"", &body});
  return io::bodies_svg(picture);
}

std::string Shape::exact_json() const {
  return dimension() == 2 ? region().exact_json() : SolidText(data_->grid.step()).tree(*data_->tree);
}

}  // namespace findspace
