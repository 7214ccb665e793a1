// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "io/mesh/mesh_step.h"

#include <findspace/error.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <vector>

namespace findspace::io {
namespace {

using Vec = std::array<double, 3>;

/// A number with the point that STEP wants.
std::string real(double value) {
  std::string text = fmt::format("{}", value);
  const auto power = std::find(text.begin(), text.end(), 'e');
  if (std::find(text.begin(), power, '.') == power) text.insert(power, '.');
  std::replace(text.begin(), text.end(), 'e', 'E');
  return text;
}

/// In quotes; what is not ASCII becomes _.
std::string step_text(std::string_view text) {
  std::string out = "'";
  for (const char c : text) {
    if (c == '\'' || c == '\\') out.push_back(c);
    out.push_back(c < ' ' || c > '~' ? '_' : c);
  }
  return out + "'";
}

/// The faces that hang together by corners, in the order of their first ones.
std::vector<std::vector<std::size_t>> pieces_of(const Surface& s) {
  std::vector<int> to(s.vertices.size());
  std::iota(to.begin(), to.end(), 0);
  const auto root = [&](int v) {
    while (to[std::size_t(v)] != v) v = to[std::size_t(v)] = to[std::size_t(to[std::size_t(v)])];
    return v;
  };
  for (const auto& face : s.faces)
    for (const int v : face) to[std::size_t(root(v))] = root(face[0]);
  std::map<int, std::size_t> at;
  std::vector<std::vector<std::size_t>> out;
  for (std::size_t f = 0; f < s.faces.size(); ++f) {
    const auto [piece, fresh] = at.emplace(root(s.faces[f][0]), out.size());
    if (fresh) out.emplace_back();
    out[piece->second].push_back(f);
  }
  return out;
}

class StepWriter {
 public:
  explicit StepWriter(const Surface& surface) : s_(surface), point_(surface.vertices.size(), 0) {}

  std::string text(std::string_view title, std::string_view unit) {
    const int context = context_of(unit), application = put("APPLICATION_CONTEXT('automotive design')");
    put(fmt::format("APPLICATION_PROTOCOL_DEFINITION('','automotive_design',2000,#{})", application));
    std::map<std::string, std::vector<int>> solids;  // of each label
    std::vector<std::string> labels;
    for (const auto& piece : pieces_of(s_)) {
      const std::string label = s_.labels.empty() ? std::string(title) : s_.labels[piece[0]];
      if (solids.count(label) == 0) labels.push_back(label);
      solids[label].push_back(solid(piece));
    }
    std::vector<Part> parts;
    for (const std::string& label : labels) parts.push_back(part(label, solids[label], context, application));
    if (parts.size() > 1) assembly(title, parts, context, application);
    return fmt::format(
        "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\nFILE_NAME({},'',(''),(''),'findspace','findspace','');"
        "\n"
        "FILE_SCHEMA(('AUTOMOTIVE_DESIGN'));\nENDSEC;\nDATA;\n{}ENDSEC;\nEND-ISO-10303-21;\n",
        step_text(title), data_);
  }

 private:
  /// A product by the entities that an assembly names.
  struct Part {
    std::string label;
    int definition = 0, held = 0, place = 0;
  };

  int put(const std::string& entity) {
    data_ += fmt::format("#{}={};\n", ++count_, entity);
    return count_;
  }

  int context_of(std::string_view unit) {
    static const std::map<std::string_view, const char*> kParts{
        {"", ".MILLI."}, {"mm", ".MILLI."}, {"um", ".MICRO."}, {"cm", ".CENTI."}, {"m", "$"}};
    static const std::map<std::string_view, const char*> kInches{{"in", "25.4"}, {"mil", "0.0254"}};
    const auto part = kParts.find(unit);
    int length = put(fmt::format("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT({},.METRE.))",
                                 part == kParts.end() ? ".MILLI." : part->second));
    if (part == kParts.end()) {
      const int measure =
          put(fmt::format("LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE({}),#{})", kInches.at(unit), length));
      const int powers = put("DIMENSIONAL_EXPONENTS(1.,0.,0.,0.,0.,0.,0.)");
      length = put(fmt::format("(CONVERSION_BASED_UNIT({},#{})LENGTH_UNIT()NAMED_UNIT(#{}))",
                               unit == "in" ? "'INCH'" : "'MIL'", measure, powers));
    }
    const int angle = put("(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))");
    const int solid_angle = put("(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT())");
    return put(
        fmt::format("(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNIT_ASSIGNED_CONTEXT((#{},#{},#{}))"
                    "REPRESENTATION_CONTEXT('',''))",
                    length, angle, solid_angle));
  }

  int point(int v) {
    int& at = point_[std::size_t(v)];
    if (at == 0) at = place(s_.vertices[std::size_t(v)]);
    return at;
  }
  int place(const Vec& p) {
    return put(fmt::format("CARTESIAN_POINT('',({},{},{}))", real(p[0]), real(p[1]), real(p[2])));
  }
  int direction(const Vec& d) {
    return put(fmt::format("DIRECTION('',({},{},{}))", real(d[0]), real(d[1]), real(d[2])));
  }

  /// By the normal of Newell, and the axis that is least along it.
  int plane(const std::vector<int>& face) {
    Vec normal{};
    for (std::size_t k = 0; k < face.size(); ++k) {
      const Vec &a = s_.vertices[std::size_t(face[k])], &b = s_.vertices[std::size_t(face[(k + 1) % face.size()])];
      for (std::size_t i = 0; i < 3; ++i)
        normal[i] += (a[(i + 1) % 3] - b[(i + 1) % 3]) * (a[(i + 2) % 3] + b[(i + 2) % 3]);
    }
    const double size = std::hypot(normal[0], normal[1], normal[2]);
    if (size > 0)
      for (double& c : normal) c /= size;
    const auto least = std::size_t(
        std::min_element(normal.begin(), normal.end(), [](double a, double b) { return std::abs(a) < std::abs(b); }) -
        normal.begin());
    Vec side{};
    side[least] = 1;
    const int base = point(face[0]), up = direction(normal), across = direction(side);
    return put(fmt::format("PLANE('',#{})", put(fmt::format("AXIS2_PLACEMENT_3D('',#{},#{},#{})", base, up, across))));
  }

  /// Every side runs both ways.
  bool closed(const std::vector<std::size_t>& piece) const {
    std::map<std::pair<int, int>, int> balance;
    for (const std::size_t f : piece) {
      const std::vector<int>& face = s_.faces[f];
      for (std::size_t k = 0; k < face.size(); ++k) {
        const int a = face[k], b = face[(k + 1) % face.size()];
        balance[std::minmax(a, b)] += a < b ? 1 : -1;
      }
    }
    return std::all_of(balance.begin(), balance.end(), [](const auto& side) { return side.second == 0; });
  }

  int solid(const std::vector<std::size_t>& piece) {
    if (!closed(piece))
      throw Error(ErrorCode::kUnsupported, "STEP holds solids, and this surface is open; .obj holds it");
    std::vector<std::string> faces;
    for (const std::size_t f : piece) {
      const std::vector<int>& face = s_.faces[f];
      if (face.size() < 3)
        throw Error(ErrorCode::kUnsupported, "STEP holds solids, no lines or points; .obj holds them");
      std::vector<std::string> corners;
      for (const int v : face) corners.push_back(fmt::format("#{}", point(v)));
      const int loop = put(fmt::format("POLY_LOOP('',({}))", fmt::join(corners, ",")));
      const int bound = put(fmt::format("FACE_OUTER_BOUND('',#{},.T.)", loop)), on = plane(face);
      faces.push_back(fmt::format("#{}", put(fmt::format("FACE_SURFACE('',(#{}),#{},.T.)", bound, on))));
    }
    return put(fmt::format("FACETED_BREP('',#{})", put(fmt::format("CLOSED_SHELL('',({}))", fmt::join(faces, ",")))));
  }

  int axes() {
    const int origin = place({0, 0, 0}), up = direction({0, 0, 1}), across = direction({1, 0, 0});
    return put(fmt::format("AXIS2_PLACEMENT_3D('',#{},#{},#{})", origin, up, across));
  }

  /// The solids where they are placed.
  Part part(const std::string& label, const std::vector<int>& solids, int context, int application) {
    const int origin = axes();
    std::string items = fmt::format("#{}", origin);
    for (const int s : solids) items += fmt::format(",#{}", s);
    const int held =
        put(fmt::format("FACETED_BREP_SHAPE_REPRESENTATION({},({}),#{})", step_text(label), items, context));
    return {label, product(label, held, "part", application), held, origin};
  }

  /// The parts together, none of them moved.
  void assembly(std::string_view title, const std::vector<Part>& parts, int context, int application) {
    std::vector<int> places;
    std::string items;
    for (std::size_t k = 0; k < parts.size(); ++k) {
      places.push_back(axes());
      items += fmt::format("{}#{}", k == 0 ? "" : ",", places[k]);
    }
    const int held = put(fmt::format("SHAPE_REPRESENTATION({},({}),#{})", step_text(title), items, context));
    const int whole = product(std::string(title), held, "assembly", application);
    for (std::size_t k = 0; k < parts.size(); ++k) {
      const Part& p = parts[k];
      const int use = put(fmt::format("NEXT_ASSEMBLY_USAGE_OCCURRENCE('{}',{},'',#{},#{},$)", k + 1, step_text(p.label),
                                      whole, p.definition));
      const int shape = put(fmt::format("PRODUCT_DEFINITION_SHAPE('','',#{})", use));
      const int move = put(fmt::format("ITEM_DEFINED_TRANSFORMATION('','',#{},#{})", p.place, places[k]));
      const int relation = put(
          fmt::format("(REPRESENTATION_RELATIONSHIP('','',#{},#{})REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION(#{})"
                      "SHAPE_REPRESENTATION_RELATIONSHIP())",
                      p.held, held, move));
      put(fmt::format("CONTEXT_DEPENDENT_SHAPE_REPRESENTATION(#{},#{})", relation, shape));
    }
  }

  /// Its definition.
  int product(const std::string& label, int held, std::string_view category, int application) {
    const int kind = put(fmt::format("PRODUCT_CONTEXT('',#{},'mechanical')", application));
    const int made = put(fmt::format("PRODUCT({0},{0},'',(#{1}))", step_text(label), kind));
    const int version = put(fmt::format("PRODUCT_DEFINITION_FORMATION('','',#{})", made));
    const int stage = put(fmt::format("PRODUCT_DEFINITION_CONTEXT('part definition',#{},'design')", application));
    const int definition = put(fmt::format("PRODUCT_DEFINITION('design','',#{},#{})", version, stage));
    const int shape = put(fmt::format("PRODUCT_DEFINITION_SHAPE('','',#{})", definition));
    put(fmt::format("SHAPE_DEFINITION_REPRESENTATION(#{},#{})", shape, held));
    put(fmt::format("PRODUCT_RELATED_PRODUCT_CATEGORY('{}','',(#{}))", category, made));
    return definition;
  }

  const Surface& s_;
  std::string data_;
  int count_ = 0;
  std::vector<int> point_;  // entity of each vertex, 0 before it is written
};

}  // namespace

std::string step_text(const Surface& surface, std::string_view title, std::string_view unit) {
  return StepWriter(surface).text(title, unit);
}

}  // namespace findspace::io
