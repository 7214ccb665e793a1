// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "io/write/write_cells.h"

#include <fmt/format.h>

#include <vector>

#include "exact/number/real_text.h"
#include "io/write/write_json.h"

namespace findspace::io {
namespace {

using exact::Real;
using exact::SupportingCurve;
using plane::Index;
using plane::kNone;

class CellsText {
 public:
  explicit CellsText(const plane::Region& region) : c_(region) {}

  std::string text(const Real& step, std::string_view unit) {
    number_supporting_curves();
    const std::string size = number(step);
    std::string body = fmt::format(",\n    \"outside\": {},\n    \"supporting_curves\": {}", truth(c_.faces[0].mark),
                                   supporting_curves());
    body += fmt::format(",\n    \"vertices\": {},\n    \"edges\": {}}}", vertices(), edges());
    std::string head = fmt::format("{{\"step\": {}", size);
    if (!unit.empty()) head += fmt::format(", \"unit\": {}", json_string(unit));
    std::vector<std::string> definitions;
    for (const std::string& d : numbers_.definitions()) definitions.push_back(json_string(d));
    if (!definitions.empty()) head += fmt::format(",\n    \"numbers\": {}", lines(definitions));
    return head + body;
  }

 private:
  static const char* truth(int mark) { return mark != 0 ? "true" : "false"; }

  static std::string lines(const std::vector<std::string>& items) {
    return items.empty() ? "[]" : fmt::format("[\n      {}]", fmt::join(items, ",\n      "));
  }

  /// Integers that every reader of JSON takes exactly stand bare, all else is quoted.
  std::string number(const Real& x) {
    constexpr exact::int128 kMost = exact::int128(1) << 53;
    const auto whole = x.integer();
    if (whole && *whole <= kMost && *whole >= -kMost) return x.text();
    return json_string(numbers_.text(x));
  }

  /// Only supporting curves of edges and of vertices' definitions, in their order: the roots of crossings depend on it.
  void number_supporting_curves() {
    supporting_curve_number_.assign(c_.geometry.supporting_curves.size(), kNone);
    for (const plane::Edge& e : c_.edges) supporting_curve_number_[e.supporting_curve] = 0;
    for (const plane::Vertex& v : c_.vertices) {
      const exact::Point& p = c_.geometry.points[v.point];
      if (p.kind == exact::Point::Kind::kCross) supporting_curve_number_[p.i] = supporting_curve_number_[p.j] = 0;
    }
    Index next = 0;
    for (Index& n : supporting_curve_number_) {
      if (n != kNone) n = next++;
    }
  }

  std::string supporting_curve(const SupportingCurve& k) {
    if (k.circle) {
      return fmt::format("{{\"circle\": [{}, {}, {}]}}", number(k.center_x()), number(k.center_y()), number(k.w()));
    }
    const Real offset = k.displaced() ? Real(k.c) : k.offset();
    const std::string shift = k.displaced() ? fmt::format(", \"shift\": {}", number(k.w())) : "";
    return fmt::format("{{\"line\": [{}, {}, {}]{}}}", k.a, k.b, number(offset), shift);
  }

  std::string supporting_curves() {
    std::vector<std::string> items;
    for (std::size_t k = 0; k < c_.geometry.supporting_curves.size(); ++k) {
      if (supporting_curve_number_[k] != kNone) items.push_back(supporting_curve(c_.geometry.supporting_curves[k]));
    }
    return lines(items);
  }

  std::string place(const exact::Point& p) {
    if (p.kind == exact::Point::Kind::kCross) {
      return fmt::format("\"on\": [{}, {}], \"root\": {}", supporting_curve_number_[p.i], supporting_curve_number_[p.j],
                         int(p.root));
    }
    if (p.kind == exact::Point::Kind::kGrid) return fmt::format("\"at\": [{}, {}]", number(p.gx), number(p.gy));
    const exact::RealPoint& at = c_.geometry.reals[p.i];
    return fmt::format("\"at\": [{}, {}]", number(at.x), number(at.y));
  }

  std::string vertices() {
    std::vector<std::string> items;
    for (const plane::Vertex& v : c_.vertices) {
      std::string text = fmt::format("{{{}, \"in\": {}", place(c_.geometry.points[v.point]), truth(v.mark));
      if (v.out == kNone) text += fmt::format(", \"around\": {}", truth(c_.faces[v.face].mark));
      items.push_back(text + "}");
    }
    return lines(items);
  }

  std::string edges() {
    std::vector<std::string> items;
    for (Index e = 0; e < c_.edges.size(); ++e) {
      const plane::Edge& edge = c_.edges[e];
      const std::string half = edge.half == 0 ? "" : fmt::format(", \"half\": {}", int(edge.half));
      items.push_back(fmt::format(R"({{"on": {}{}, "from": {}, "to": {}, "in": {}, "left": {}, "right": {}}})",
                                  supporting_curve_number_[edge.supporting_curve], half, edge.v0, edge.v1,
                                  truth(edge.mark), truth(c_.faces[c_.face(2 * e)].mark),
                                  truth(c_.faces[c_.face(2 * e + 1)].mark)));
    }
    return lines(items);
  }

  const plane::Region& c_;
  std::vector<Index> supporting_curve_number_;
  exact::RealWriter numbers_;
};

}  // namespace

std::string cells_json(const plane::Region& region, const Real& step, std::string_view unit) {
  return CellsText(region).text(step, unit);
}

}  // namespace findspace::io
