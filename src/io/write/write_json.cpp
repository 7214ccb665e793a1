// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "io/write/write_json.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "io/write/json_text.h"
#include "io/write/write_cells.h"

namespace findspace::io {
namespace {

using plane::Bounds;
using plane::CurveNet;
using plane::Index;
using plane::kNone;
using plane::Place;
using plane::Twofold;
using Curve = CurveNet::Curve;
using Ring = CurveNet::Ring;
using Side = CurveNet::Side;

std::string pair(const Place& p) { return fmt::format("[{}, {}]", json_number(p[0]), json_number(p[1])); }
std::string box(const std::optional<Bounds>& b) {
  return b ? fmt::format("[{}, {}]", pair(b->low), pair(b->high)) : "null";
}

std::string component_text(const plane::Component& c) {
  return fmt::format(R"({{"dimension": {}, "area": {}, "dangling_length": {}, "holes": {}, "sample": {}, "bbox": {}}})",
                     c.dimension, number(c.area), json_number(c.dangling_length), c.holes, pair(c.sample), box(c.bbox));
}

void put_summary(std::string& out, const plane::Summary& s, std::string_view unit) {
  const std::string measures = fmt::format(R"(  "area": {}, "dangling_length": {}, "crack_length": {})", number(s.area),
                                           json_number(s.dangling_length), json_number(s.crack_length));
  put_set(
      out, 2, s, unit, measures, [](const Place& p) { return pair(p); },
      [](const std::optional<Bounds>& b) { return box(b); },
      [](const plane::Component& c) { return component_text(c); });
}

// Cells may be very many, so they are appended number by number, without texts between.

void put_number(std::string& out, double value) {
  if (value != 0 && std::isfinite(value))
    fmt::format_to(std::back_inserter(out), "{}", value);
  else
    out += json_number(value);
}

void put_index(std::string& out, Index k) {
  const fmt::format_int digits(k);
  out.append(digits.data(), digits.size());
}

void put_place(std::string& out, const Place& p) {
  out += "[";
  put_number(out, p[0]);
  out += ", ";
  put_number(out, p[1]);
  out += "]";
}

void put_vertex(std::string& out, const CurveNet& net, Index v) {
  out += "{\"at\": ";
  put_place(out, net.at(v));
  out.append(", \"in\": ").append(truth(net.complex().vertices[v].mark)).append("}");
}

void put_curve(std::string& out, const CurveNet& net, const Curve& k) {
  out += "{\"from\": ";
  put_index(out, net.number(k.from));
  out += ", \"to\": ";
  put_index(out, net.number(k.to));
  out.append(", \"in\": ").append(truth(k.mark));
  if (k.arc) {
    out += ", \"arc\": {\"center\": ";
    put_place(out, k.center);
    out += ", \"radius\": ";
    put_number(out, k.radius);
    out += ", \"ccw\": true}";
  }
  out += "}";
}

void put_ring(std::string& out, const Ring& ring) {
  const char* separator = "[";
  for (const Side& s : ring) {
    out += separator;
    put_index(out, s.curve);
    separator = ", ";
  }
  out += ring.empty() ? "[]" : "]";
}

/// Hole by hole: that around everything may have very many.
void put_face(FlowingText& out, const CurveNet& net, const plane::Face& f) {
  out.text() += "{";
  if (f.outer != kNone) {
    out.text() += "\"outer\": ";
    put_ring(out.text(), net.ring(f.outer));
    out.text() += ", ";
  }
  out.text() += "\"holes\": ";
  put_items(out, f.inner, [&](Index h) { put_ring(out.text(), net.ring(h)); });
  if (!f.isolated.empty()) {
    out.text() += ", \"points\": ";
    put_items(out, f.isolated, [&](Index v) { put_index(out.text(), net.number(v)); });
  }
  put(out.text(), ", \"in\": {}}}", truth(f.mark));
}

void put_cells(FlowingText& out, const CurveNet& net) {
  constexpr bool kLines = true;
  out.text() += "  \"cells\": {\n    \"vertices\": ";
  put_items(
      out, net.vertices(), [&](Index v) { put_vertex(out.text(), net, v); }, kLines);
  out.text() += ",\n    \"edges\": ";
  put_items(
      out, net.curves(), [&](const Curve& k) { put_curve(out.text(), net, k); }, kLines);
  out.text() += ",\n    \"faces\": ";
  put_items(
      out, net.complex().faces, [&](const plane::Face& f) { put_face(out, net, f); }, kLines);
  out.text() += "\n  }";
}

}  // namespace

std::string closed_form_text(const distance::SceneAnswer& answer) {
  const auto text = distance::closed_form(answer);
  if (!text || exact::Real::parse_decimal(json_number(answer.value.to_double())) == answer.value) return "";
  return json_string(*text);
}

std::string how_known_members(const distance::OptimalValue& best) {
  if (!best.answer) return "";
  const std::string closed = closed_form_text(*best.answer);
  std::string out = closed.empty() ? "" : fmt::format(R"( "closed_form": {},)", closed);
  if (best.proven()) return out;
  const distance::OutwardEnds ends = distance::outward(best.answer->bounds());
  const std::string lower = json_number(ends.lower), upper = json_number(ends.upper);
  put(out, R"( "proven": false, "value_side": {}, "lower": {}, "upper": {}, "bound": {},)",
      json_string(distance::name(best.answer->side)), lower, upper, best.maximum() ? upper : lower);
  if (best.within > 0 && std::isfinite(best.within)) put(out, R"( "within": {},)", json_number(best.within));
  return out;
}

std::string optimum_members(const distance::OptimalValue& best) {
  const auto value = best.value();
  const std::string none = best.unbounded && !best.maximum() ? "\"-inf\"" : "null";
  return fmt::format(R"("{}": {}, "attained": {},{})", best.maximum() ? "maximum" : "minimum",
                     value ? json_number(value->to_double()) : none, truth(best.attained), how_known_members(best));
}

std::string region_json(const plane::Region& region, const plane::Summary& summary, const exact::Real& step,
                        std::string_view unit, const distance::OptimalValue* best, bool exact) {
  std::string out;
  region_json(region, summary, step, unit, best, exact, [&out](std::string_view part) { out += part; });
  return out;
}

void region_json(const plane::Region& region, const plane::Summary& summary, const exact::Real& step,
                 std::string_view unit, const distance::OptimalValue* best, bool exact, const Sink& sink) {
  const std::string cells = exact ? cells_json(region, step, unit) : "";
  const CurveNet net(region, step);
  FlowingText out(sink);
  out.text() = "{\n";
  put_summary(out.text(), summary, unit);
  if (best != nullptr) put_optimum(out.text(), *best);
  put_cells(out, net);
  if (exact) out.text().append(",\n  \"exact\": ").append(cells);
  out.text() += "\n}\n";
  out.finish();
}

std::string intervals_json(const std::vector<plane::LineInterval>& intervals, const exact::Real& step,
                           std::string_view unit, const distance::OptimalValue* best, std::string_view side,
                           const std::vector<plane::LineInterval>& undecided) {
  const Twofold factor(step);
  auto end = [&](const std::optional<exact::Real>& t) {
    return t ? json_number((Twofold(*t) * factor).value()) : "null";
  };
  auto text = [&](const plane::LineInterval& i) {
    return fmt::format(R"({{"from": {}, "to": {}, "from_in": {}, "to_in": {}}})", end(i.from), end(i.to),
                       truth(i.from_in), truth(i.to_in));
  };
  std::string members;
  if (best != nullptr) members = " " + optimum_members(*best);
  const std::string bound = side.empty() ? "" : fmt::format(" \"side\": {},", json_string(side));
  const std::string open = undecided.empty() ? "" : fmt::format(", \"undecided\": {}", list(undecided, text));
  return fmt::format("{{{}\"empty\": {},{}{} \"intervals\": {}{}}}\n", unit_key(unit), truth(intervals.empty()), bound,
                     members, list(intervals, text), open);
}

}  // namespace findspace::io
