// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "io/write/write_phi.h"

#include <findspace/error.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "io/write/phi_text.h"

namespace findspace::io {
namespace {

using exact::int128;
using exact::Real;
using space::ContactSurface;
using space::Point;
using space::RoundedPair;

/// step = numerator / denominator in lowest terms.
std::array<int128, 2> fraction(const Real& step) {
  if (const auto parts = step.fraction()) return *parts;
  throw Error(ErrorCode::kUnsupported, "the grid is too fine for planes in integers");
}

std::string coordinate(std::int64_t steps, const Real& step) { return (Real(steps) * step).text(); }

std::string point_text(const Point& p, const Real& step) {
  return fmt::format("[{},{},{}]", coordinate(p.x, step), coordinate(p.y, step), coordinate(p.z, step));
}

/// The vertices of the features that meet in a facet, as indices into `pairs`: which vertices of A and of B.
std::array<std::vector<int>, 2> feature_vertices(const ContactSurface& s, int f) {
  std::array<std::vector<int>, 2> features;
  for (const int v : s.circuit(f)) {
    for (int k = 0; k < 2; ++k) features[k].push_back(s.vertex_pair(v)[k]);
  }
  for (auto& list : features) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  return features;
}

void put_surface(std::string& out, const ContactSurface& s, const Real& step) {
  put(out, "\"vertices\":[");
  for (int v = 0; v < s.vertex_count(); ++v) put(out, "{}{}", v == 0 ? "" : ",", point_text(s.vertices()[v], step));
  put(out, "],\"pairs\":[");
  for (int v = 0; v < s.vertex_count(); ++v)
    put(out, "{}[{},{}]", v == 0 ? "" : ",", s.vertex_pair(v)[0], s.vertex_pair(v)[1]);
  put(out, "],\"edges\":{},\"facets\":[", s.edge_count());
  for (int f = 0; f < s.facet_count(); ++f) {
    const auto [a, b] = feature_vertices(s, f);
    put(out, "{}\n{{\"vertices\":[{}],\"plane\":[{}],\"contact\":\"{}\",\"first\":[{}],\"second\":[{}]}}",
        f == 0 ? "" : ",", fmt::join(s.circuit(f), ","), fmt::join(plane_numbers(s.plane(f), step), ","),
        space::contact_name(s.contact(f)), fmt::join(a, ","), fmt::join(b, ","));
  }
  put(out, "]");
}

std::string corners_text(const std::vector<Point>& corners, const Real& step) {
  std::string out;
  for (const Point& p : corners) put(out, "{}{}", out.empty() ? "[" : ",", point_text(p, step));
  return out + "]";
}

const char* form_name(const RoundedPair& pair) {
  return pair.balls() ? "balls" : !pair.phi || pair.radius.sign() > 0 ? "rounded" : "polytopes";
}

void put_pair(std::string& out, const RoundedPair& pair, const Real& step) {
  put(out, "\"form\":\"{}\",", form_name(pair));
  if (pair.radius.sign() > 0) put(out, "\"radius\":{},", (pair.radius * step).text());
  if (pair.phi)
    put_surface(out, pair.phi->surface(), step);
  else if (pair.balls())
    put(out, "\"center\":{},\"vertices\":[],\"facets\":[]", point_text(pair.flat[0], step));
  else
    put(out, "\"vertices\":{},\"facets\":[]", corners_text(pair.flat, step));
}

/// Of two balls: |u|^2 - R^2.
Real square_form(const PhiReport& r) {
  const RoundedPair& pair = r.phi->pair(0);
  const Point& apex = pair.flat[0];
  const Real x = *r.at[0] - Real(apex.x) * r.step, y = *r.at[1] - Real(apex.y) * r.step,
             z = *r.at[2] - Real(apex.z) * r.step, radius = pair.radius * r.step;
  return x * x + y * y + z * z - radius * radius;
}

std::string position_text(const PhiReport& r, const char* separator) {
  return fmt::format("{}{}{}{}{}", r.at[0]->text(), separator, r.at[1]->text(), separator, r.at[2]->text());
}

void put_value(std::string& out, const PhiReport& r) {
  const space::RoundedAt& at = r.value->at;
  put_at(out, r, position_text(r, ","), fmt::format("{},{},{}", at.gradient.x, at.gradient.y, at.gradient.z));
  if (r.phi->pair_count() == 1 && r.phi->pair(0).balls()) put(out, ",\"square\":{}", square_form(r).text());
  put(out, "{}}}", limits_json(r.limits));
}

void put_table(std::string& out, const RoundedPair& pair, const Real& step) {
  const std::string radius = (pair.radius * step).text();
  if (pair.balls()) {
    put(out, "two balls: the sphere about {} with radius {}\n", point_text(pair.flat[0], step), radius);
    return;
  }
  if (!pair.phi) {
    put(out, "the surface at distance {} around the {} {}\n", radius, pair.flat.size() == 2 ? "segment" : "polygon",
        corners_text(pair.flat, step));
    return;
  }
  if (pair.radius.sign() > 0) put(out, "the surface at distance {} around:\n", radius);
  const ContactSurface& s = pair.phi->surface();
  put(out, "{} vertices, {} edges, {} facets\n\n  vertex  position                 first - second\n", s.vertex_count(),
      s.edge_count(), s.facet_count());
  for (int v = 0; v < s.vertex_count(); ++v) {
    const Point& p = s.vertices()[v];
    const std::string at =
        fmt::format("({}, {}, {})", coordinate(p.x, step), coordinate(p.y, step), coordinate(p.z, step));
    put(out, "  {:>6}  {:<24} {} - {}\n", v + 1, at, s.vertex_pair(v)[0] + 1, s.vertex_pair(v)[1] + 1);
  }
  put(out, "\n   facet  contact  plane                          vertices\n");
  for (int f = 0; f < s.facet_count(); ++f) {
    std::vector<int> ring(s.circuit(f).begin(), s.circuit(f).end());
    for (int& v : ring) ++v;
    put(out, "  {:>6}  {:<7}  {:<30} {}\n", f + 1, space::contact_name(s.contact(f)),
        half_space_text(plane_numbers(s.plane(f), step)), fmt::join(ring, " "));
  }
}

}  // namespace

std::string half_space_text(const std::vector<std::string>& numbers) {
  constexpr std::string_view kNames = "xyz";
  std::string text;
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    const bool constant = k + 1 == numbers.size();
    std::string n = numbers[k];
    if (n == "0") continue;
    const bool negative = n[0] == '-';
    if (negative) n.erase(0, 1);
    if (n == "1" && !constant) n.clear();
    text += text.empty() ? (negative ? "-" : "") : (negative ? " - " : " + ");
    text += n;
    if (!constant) text += kNames[k];
  }
  return text + " <= 0";
}

const char* state_name(space::State state) {
  return state == space::State::kOverlap ? "overlap" : state == space::State::kContact ? "contact" : "apart";
}

std::string limits_json(const std::vector<PhiLimit>& limits) {
  std::string out;
  for (const PhiLimit& limit : limits) {
    out += fmt::format("{}{{\"limit\":\"{}\",\"distance\":{},\"value\":{},\"sign\":{}}}", out.empty() ? "" : ",",
                       limit.minimum ? "minimum" : "maximum", limit.distance.text(), limit.value, limit.sign);
  }
  return out.empty() ? out : ",\"adjusted\":[" + out + "]";
}

std::string limits_table(const std::vector<PhiLimit>& limits) {
  std::string out;
  for (const PhiLimit& limit : limits) {
    out += fmt::format("at {} {} apart: {}, adjusted Phi = {}\n", limit.minimum ? "least" : "most",
                       limit.distance.text(), limit.sign >= 0 ? "yes" : "no", limit.value);
  }
  return out;
}

std::vector<std::string> plane_numbers(const space::Plane& plane, const Real& step) {
  // In steps: n . X + D <= 0 with X = x q / p for the step p / q, so (q n) . x + p D <= 0; n is coprime, so is (p, q).
  const auto [p, q] = fraction(step);
  const int128 g = plane.offset == 0 ? q : exact::gcd(q, plane.offset);
  std::vector<std::string> numbers;
  for (const int128 n : {plane.normal.x, plane.normal.y, plane.normal.z})
    numbers.push_back((Real(n) * Real(q / g)).text());
  numbers.push_back((Real(plane.offset / g) * Real(p)).text());
  return numbers;
}

std::string phi_json(const PhiReport& r) {
  std::string out = "{";
  put_pairs(out, r, put_pair);
  if (r.value) put_value(out, r);
  return out + "}\n";
}

std::string phi_table(const PhiReport& r) { return pairs_table(r, r.value ? position_text(r, ", ") : "", put_table); }

Surface phi_surface(const PhiReport& r) {
  Surface surface;
  const double step = r.step.to_double();
  for (int k = 0; k < r.phi->pair_count(); ++k) {
    const RoundedPair& pair = r.phi->pair(k);
    if (pair.radius.sign() > 0) {
      throw Error(ErrorCode::kUnsupported,
                  "the contact surface of a round body is not a polyhedron, and mesh formats have nothing else");
    }
    const ContactSurface& s = pair.phi->surface();
    const int base = static_cast<int>(surface.vertices.size());
    for (const Point& p : s.vertices()) {
      surface.vertices.push_back(
          {static_cast<double>(p.x) * step, static_cast<double>(p.y) * step, static_cast<double>(p.z) * step});
    }
    for (int f = 0; f < s.facet_count(); ++f) {
      std::vector<int>& ring = surface.faces.emplace_back(s.circuit(f).begin(), s.circuit(f).end());
      for (int& v : ring) v += base;
      surface.labels.emplace_back(space::contact_name(s.contact(f)));
    }
  }
  return surface;
}

}  // namespace findspace::io
