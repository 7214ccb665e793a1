// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "io/write/write_planar_phi.h"

#include <fmt/format.h>

#include "io/write/phi_text.h"

namespace findspace::io {
namespace {

using exact::Real;
using space::PlanarContact;
using space::PlanarEdge;
using space::PlanarPair;
using space::Point2;

std::string point_text(const Point2& p, const Real& step) {
  return fmt::format("{},{}", (Real(p.x) * step).text(), (Real(p.y) * step).text());
}

const char* contact_name(PlanarContact contact) {
  return contact == PlanarContact::kEV ? "EV" : contact == PlanarContact::kVE ? "VE" : "EE";
}

/// [a, b, c] for coordinates in the scene's unit.
std::vector<std::string> line_numbers(const PlanarEdge& edge, const Real& step) {
  std::vector<std::string> numbers = plane_numbers({{edge.normal.x, edge.normal.y, 0}, edge.offset}, step);
  numbers.erase(numbers.begin() + 2);
  return numbers;
}

const char* form_name(const PlanarPair& pair) {
  return !pair.phi ? "discs" : pair.radius.sign() > 0 ? "rounded" : "polygons";
}

void put_planar_pair(std::string& out, const PlanarPair& pair, const Real& step) {
  put(out, "\"form\":\"{}\",", form_name(pair));
  if (pair.radius.sign() > 0) put(out, "\"radius\":{},", (pair.radius * step).text());
  const auto edges = pair.edges();
  if (!pair.phi) put(out, "\"center\":[{}],", point_text(pair.apex, step));
  out += "\"vertices\":[";
  for (std::size_t e = 0; e < edges.size(); ++e)
    put(out, "{}[{}]", e == 0 ? "" : ",", point_text(edges[e].start, step));
  out += "],\"pairs\":[";
  for (std::size_t e = 0; e < edges.size(); ++e)
    put(out, "{}[{},{}]", e == 0 ? "" : ",", edges[e].feature_p, edges[e].feature_q);
  out += "],\"edges\":[";
  for (std::size_t e = 0; e < edges.size(); ++e) {
    put(out, "{}\n{{\"vertices\":[{},{}],\"line\":[{}],\"contact\":\"{}\"}}", e == 0 ? "" : ",", e,
        (e + 1) % edges.size(), fmt::join(line_numbers(edges[e], step), ","), contact_name(edges[e].contact));
  }
  out += "]";
}

void put_value(std::string& out, const PlanarPhiReport& r) {
  const space::PlanarAt& at = r.value->at;
  put_at(out, r, fmt::format("{},{}", r.at->x.text(), r.at->y.text()),
         fmt::format("{},{}", at.gradient.x, at.gradient.y));
  if (r.phi->pair_count() == 1) {
    const auto forms = space::other_forms(r.phi->pair(0), {r.at->x / r.step, r.at->y / r.step});
    if (forms.square) put(out, ",\"square\":{}", (*forms.square * r.step * r.step).text());
    if (forms.case_free) put(out, ",\"case_free\":{}", *forms.case_free * r.step.to_double());
  }
  out += limits_json(r.limits) + "}";
}

void put_planar_table(std::string& out, const PlanarPair& pair, const Real& step) {
  const std::string radius = (pair.radius * step).text();
  if (!pair.phi) {
    put(out, "two discs: the circle about ({}) with radius {}\n", point_text(pair.apex, step), radius);
    return;
  }
  put(out, "{} edges{}\n\n    edge  contact  first - second  from                     line\n", pair.edges().size(),
      pair.radius.sign() > 0 ? fmt::format(", and the curve at distance {} around them", radius) : "");
  int number = 0;
  for (const PlanarEdge& e : pair.edges()) {
    put(out, "  {:>6}  {:<7}  {:>5} - {:<6}  {:<24} {}\n", ++number, contact_name(e.contact), e.feature_p + 1,
        e.feature_q + 1, "(" + point_text(e.start, step) + ")", half_space_text(line_numbers(e, step)));
  }
}

}  // namespace

std::string planar_phi_json(const PlanarPhiReport& r) {
  std::string out = "{\"dimension\":2,";
  put_pairs(out, r, put_planar_pair);
  if (r.value) put_value(out, r);
  return out + "}\n";
}

std::string planar_phi_table(const PlanarPhiReport& r) {
  return pairs_table(r, r.at ? r.at->x.text() + ", " + r.at->y.text() : "", put_planar_table);
}

}  // namespace findspace::io
