// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "io/write_json_space.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "io/json_text.h"
#include "situation/text.h"

namespace findspace::io {
namespace {

using exact::Real;
using space::Place3;
using space::PlaceBox;

std::string triple(const Place3& p) {
  return fmt::format("[{}, {}, {}]", json_number(p[0]), json_number(p[1]), json_number(p[2]));
}
std::string box(const std::optional<PlaceBox>& b) {
  return b ? fmt::format("[{}, {}]", triple(b->low), triple(b->high)) : "null";
}
Place3 place(const space::RealVector& p) { return {p[0].to_double(), p[1].to_double(), p[2].to_double()}; }

std::string component_text(const space::SpaceComponent& c) {
  return fmt::format(
      R"({{"dimension": {}, "volume": {}, "dangling_area": {}, "dangling_length": {}, "holes": {}, "sample": {}, "bbox": {}}})",
      c.dimension, number(c.volume), json_number(c.dangling_area), json_number(c.dangling_length), c.holes,
      triple(c.sample), box(c.bbox));
}

std::string box_text(const space::IntervalBox& b, const Real& step) {
  std::array<std::string, 4> rows;
  for (const space::Interval& i : b) {
    const char* separator = rows[0].empty() ? "" : ", ";
    put(rows[0], "{}{}", separator, i.from ? json_number((*i.from * step).to_double()) : "null");
    put(rows[1], "{}{}", separator, i.to ? json_number((*i.to * step).to_double()) : "null");
    put(rows[2], "{}{}", separator, truth(i.from_in));
    put(rows[3], "{}{}", separator, truth(i.to_in));
  }
  return fmt::format(R"({{"from": [{}], "to": [{}], "from_in": [{}], "to_in": [{}]}})", rows[0], rows[1], rows[2],
                     rows[3]);
}

/// "nearest": [..], "points": [[..], [..]], as far as known.
std::string witness_text(const situation::SpaceDistanceAt& d) {
  std::string out;
  if (d.nearest) put(out, "\"nearest\": {}", triple(*d.nearest));
  if (d.points)
    put(out, "{}\"points\": [{}, {}]", out.empty() ? "" : ", ", triple((*d.points)[0]), triple((*d.points)[1]));
  return out;
}

void put_summary(std::string& out, const space::SpaceSummary& s, std::string_view unit) {
  put(out, R"(  "dimension": 3, "empty": {}, "whole": {}, "bounded": {},)", truth(s.empty), truth(s.whole),
      truth(s.bounded));
  put(out, "\n  \"open\": {}, \"closed\": {}, \"regular\": {},\n", truth(s.open), truth(s.closed), truth(s.regular));
  if (!unit.empty()) put(out, "  \"unit\": {},\n", json_string(unit));
  put(out, "  \"volume\": {}, \"dangling_area\": {}, \"dangling_length\": {},\n", number(s.volume),
      json_number(s.dangling_area), json_number(s.dangling_length));
  put(out, "  \"crack_area\": {}, \"crack_length\": {}, \"holes\": {},\n", json_number(s.crack_area),
      json_number(s.crack_length), s.holes);
  put(out, "  \"isolated\": {}, \"bbox\": {},\n", list(s.isolated, triple), box(s.bbox));
  put(out, "  \"components\": {},\n", list(s.components, component_text, true));
}

void put_extreme(std::string& out, const ExtremeValue* extreme) {
  if (extreme == nullptr) return;
  put(out, "  \"{}\": {}, \"attained\": {},\n", extreme->maximum ? "maximum" : "minimum",
      extreme->unbounded && !extreme->maximum ? "\"-inf\"" : number(extreme->value), truth(extreme->attained));
}

}  // namespace

std::string space_json(const space::BoxComplex& set, const space::SpaceSummary& s, const Real& step,
                       std::string_view unit, const ExtremeValue* extreme) {
  std::string out = "{\n";
  put_summary(out, s, unit);
  put_extreme(out, extreme);
  put(out, "  \"boxes\": {}\n",
      list(
          set.boxes(), [&](const space::IntervalBox& b) { return box_text(b, step); }, true));
  return out + "}\n";
}

std::string space_json(const space::ConvexSet& set, const space::SpaceSummary& s, const Real& step,
                       std::string_view unit, const ExtremeValue* extreme) {
  std::string out = "{\n";
  put_summary(out, s, unit);
  put_extreme(out, extreme);
  const Surface surface = convex_surface(set, step);
  const auto corners = [](const std::vector<int>& face) { return fmt::format("[{}]", fmt::join(face, ", ")); };
  put(out, "  \"polytope\": {{\"inside\": {}, \"frontier\": {}, \"outside\": {},\n    \"vertices\": {},\n",
      truth(set.inside), truth(set.frontier), truth(set.outside), list(surface.vertices, triple, true));
  if (set.radius.sign() > 0) put(out, "    \"radius\": {},\n", number((set.radius * step).to_double()));
  put(out, "    \"facets\": {}}}\n", list(surface.faces, corners));
  return out + "}\n";
}

std::string space_check_json(const situation::SpaceSolver::Check& check, const space::RealVector& at,
                             std::string_view unit, const situation::SpaceNearest* nearest) {
  std::string out = fmt::format("{{{}\"at\": {}, \"true\": {},\n  \"atoms\": ", unit_key(unit), triple(place(at)),
                                truth(check.holds));
  std::map<std::string, std::optional<double>> distances;
  out += list(
      check.atoms,
      [&](const situation::SpaceAtomAt& a) {
        distances[a.distance.text] = a.distance.value;
        const std::string lacks = a.lacks ? fmt::format(R"( "lacks": {},)", json_number(*a.lacks)) : "";
        return fmt::format(R"({{"text": {}, "value": {}, "true": {},{} "witness": {{{}}}}})",
                           json_string(situation::text(a.atom)), number(a.distance.value), truth(a.holds), lacks,
                           witness_text(a.distance));
      },
      true);
  out += ",\n  \"distances\": {";
  const char* separator = "";
  for (const auto& [text, value] : distances) {
    put(out, "{}{}: {}", separator, json_string(text), number(value));
    separator = ", ";
  }
  out += "}";
  if (nearest != nullptr) {
    put(out, ",\n  \"nearest_feasible\": {{\"at\": {}, \"distance\": {}, \"attained\": {}}}",
        triple(place(nearest->at)), json_number(nearest->distance.to_double()), truth(nearest->attained));
  }
  return out + "\n}\n";
}

std::string space_measure_json(const std::vector<situation::SpaceDistanceAt>& distances, const space::RealVector& at,
                               std::string_view unit) {
  std::string out = fmt::format("{{{}\"at\": {},\n  \"distances\": {{", unit_key(unit), triple(place(at))), witnesses;
  const char* separator = "\n    ";
  const char* between = "\n    ";
  for (const auto& d : distances) {
    put(out, "{}{}: {}", separator, json_string(d.text), number(d.value));
    separator = ",\n    ";
    const std::string witness = witness_text(d);
    if (witness.empty()) continue;
    put(witnesses, "{}{}: {{{}}}", between, json_string(d.text), witness);
    between = ",\n    ";
  }
  return out + "\n  },\n  \"witnesses\": {" + witnesses + "\n  }\n}\n";
}

Surface box_surface(const space::BoxComplex& set, const Real& step) {
  const space::BoxComplex solid = set.interior();
  Surface surface;
  std::map<std::array<int, 3>, int> numbers;
  const auto vertex = [&](const std::array<int, 3>& at) {
    const auto [found, fresh] = numbers.emplace(at, static_cast<int>(surface.vertices.size()));
    if (fresh) {
      Place3 p{};
      for (std::size_t k = 0; k < 3; ++k) p[k] = (solid.at()[k][std::size_t(at[k] / 2)] * step).to_double();
      surface.vertices.push_back(p);
    }
    return found->second;
  };
  const auto in = [&](const std::array<int, 3>& c) { return solid.mark(c[0], c[1], c[2]) != 0; };
  std::array<int, 3> c{};
  for (c[2] = 0; c[2] < solid.cells(2); ++c[2]) {
    for (c[1] = 0; c[1] < solid.cells(1); ++c[1]) {
      for (c[0] = 0; c[0] < solid.cells(0); ++c[0]) {
        for (std::size_t k = 0; k < 3; ++k) {
          const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
          // An open face between two open boxes; unbounded ones have no corners to draw.
          if (c[k] % 2 == 0 || c[i] % 2 == 1 || c[j] % 2 == 1) continue;
          if (c[i] == 0 || c[j] == 0 || c[i] == solid.cells(int(i)) - 1 || c[j] == solid.cells(int(j)) - 1) continue;
          std::array<int, 3> below = c, above = c;
          --below[k], ++above[k];
          if (in(below) == in(above)) continue;
          std::vector<int> face;
          for (const auto& [di, dj] : {std::pair{-1, -1}, std::pair{1, -1}, std::pair{1, 1}, std::pair{-1, 1}}) {
            std::array<int, 3> at = c;
            at[i] += di, at[j] += dj;
            face.push_back(vertex(at));
          }
          if (in(above)) std::reverse(face.begin(), face.end());
          surface.faces.push_back(std::move(face));
        }
      }
    }
  }
  return surface;
}

Surface convex_surface(const space::ConvexSet& set, const Real& step) {
  Surface surface;
  for (const auto& v : set.region.vertices())
    surface.vertices.push_back(
        {(v.at[0] * step).to_double(), (v.at[1] * step).to_double(), (v.at[2] * step).to_double()});
  if (set.region.dimension() < 3) return surface;
  for (const int k : set.region.facets()) surface.faces.push_back(set.region.circuit(k));
  return surface;
}

}  // namespace findspace::io
