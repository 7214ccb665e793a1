// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "io/write_phi.h"

#include <findspace/error.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>

namespace findspace::io {
namespace {

using exact::int128;
using exact::Real;
using space::ContactSurface;
using space::Point;

using Buffer = fmt::memory_buffer;

template <class... Args>
void put(Buffer& out, fmt::format_string<Args...> format, Args&&... args) {
  fmt::format_to(std::back_inserter(out), format, std::forward<Args>(args)...);
}

/// step = numerator / denominator in lowest terms.
std::array<int128, 2> fraction(const Real& step) {
  int128 denominator = 1;
  for (int i = 0; i < 36; ++i) {
    if (const auto numerator = (step * Real(denominator)).integer()) {
      const int128 g = exact::gcd(*numerator, denominator);
      return {*numerator / g, denominator / g};
    }
    // Steps are decimals over the scale of convex parts; both come off in turn.
    if (const auto inverse = (Real(1) / step).integer()) return {1, *inverse};
    denominator *= 10;
  }
  throw Error(ErrorCode::kUnsupported, "the grid is too fine for planes in integers");
}

std::string coordinate(std::int64_t steps, const Real& step) { return (Real(steps) * step).text(); }

std::string point_text(const Point& p, const Real& step) {
  return fmt::format("[{},{},{}]", coordinate(p.x, step), coordinate(p.y, step), coordinate(p.z, step));
}

const char* state_name(space::State state) {
  return state == space::State::kOverlap ? "overlap" : state == space::State::kContact ? "contact" : "apart";
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

void put_surface(Buffer& out, const ContactSurface& s, const Real& step) {
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

void put_value(Buffer& out, const PhiReport& r) {
  const double step = r.step.to_double();
  const space::PhiAt& at = r.value->at;
  put(out, "\"at\":{{\"position\":[{},{},{}],\"phi\":{},\"normalised\":{},\"distance\":{},\"state\":\"{}\",",
      r.at[0]->text(), r.at[1]->text(), r.at[2]->text(), at.max_form * step,
      (at.state == space::State::kApart ? at.distance : at.max_form) * step, at.distance * step, state_name(at.state));
  put(out, "\"gradient\":[{},{},{}],\"active\":[{}],\"pair\":[{},{}]}}", at.gradient.x, at.gradient.y, at.gradient.z,
      fmt::join(at.active, ","), r.value->pair / r.parts_second, r.value->pair % r.parts_second);
}

/// "6y - 5z + 29 <= 0"
std::string plane_text(const std::vector<std::string>& numbers) {
  constexpr std::string_view kNames[] = {"x", "y", "z", ""};
  std::string text;
  for (std::size_t k = 0; k < 4; ++k) {
    std::string n = numbers[k];
    if (n == "0") continue;
    const bool negative = n[0] == '-';
    if (negative) n.erase(0, 1);
    if (n == "1" && k < 3) n.clear();
    text += text.empty() ? (negative ? "-" : "") : (negative ? " - " : " + ");
    text += n + std::string(kNames[k]);
  }
  return text + " <= 0";
}

void put_table(Buffer& out, const ContactSurface& s, const Real& step) {
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
        plane_text(plane_numbers(s.plane(f), step)), fmt::join(ring, " "));
  }
}

}  // namespace

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
  Buffer out;
  put(out, "{{");
  if (r.phi->pair_count() == 1) {
    put_surface(out, r.phi->pair(0).surface(), r.step);
  } else {
    put(out, "\"parts\":[");
    for (int k = 0; k < r.phi->pair_count(); ++k) {
      put(out, "{}\n{{\"first\":{},\"second\":{},", k == 0 ? "" : ",", k / r.parts_second, k % r.parts_second);
      put_surface(out, r.phi->pair(k).surface(), r.step);
      put(out, "}}");
    }
    put(out, "]");
  }
  if (r.value) {
    put(out, ",\n");
    put_value(out, r);
  }
  put(out, "}}\n");
  return fmt::to_string(out);
}

std::string phi_table(const PhiReport& r) {
  Buffer out;
  put(out, "Phi-function of {} and {}, {} translated by u: {} - {}\n", r.first, r.second, r.second, r.first, r.second);
  for (int k = 0; k < r.phi->pair_count(); ++k) {
    if (r.phi->pair_count() > 1)
      put(out, "\npart {} of {}, part {} of {}\n", k / r.parts_second + 1, r.first, k % r.parts_second + 1, r.second);
    put_table(out, r.phi->pair(k).surface(), r.step);
  }
  if (r.value) {
    const double step = r.step.to_double();
    const space::PhiAt& at = r.value->at;
    put(out, "\nat ({}, {}, {}): {}, Phi = {}", r.at[0]->text(), r.at[1]->text(), r.at[2]->text(), state_name(at.state),
        at.max_form * step);
    if (at.state == space::State::kApart) put(out, ", distance {}", at.distance * step);
    put(out, "\n");
  }
  return fmt::to_string(out);
}

Surface phi_surface(const PhiReport& r) {
  Surface surface;
  const double step = r.step.to_double();
  for (int k = 0; k < r.phi->pair_count(); ++k) {
    const ContactSurface& s = r.phi->pair(k).surface();
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
