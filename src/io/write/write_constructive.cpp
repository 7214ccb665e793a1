// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "io/write/write_constructive.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <vector>

#include "io/write/write_cells.h"
#include "io/write/write_json.h"
#include "plane/complex/simplify.h"
#include "plane/query/topology.h"

namespace findspace::io {
namespace {

using exact::Real;
using plane::Index;
using plane::kNone;
using plane::Region;
using Texts = std::vector<std::string>;

std::string node(const char* kind, const Texts& items) {
  return fmt::format("{{\"{}\": [{}]}}", kind, fmt::join(items, ",\n  "));
}
std::string united(const Texts& items) { return items.size() == 1 ? items[0] : node("union", items); }

/// `from` less `taken`; `from` is not empty.
std::string less(const Texts& from, const Texts& taken) {
  if (taken.empty()) return united(from);
  Texts all{united(from)};
  all.insert(all.end(), taken.begin(), taken.end());
  return node("difference", all);
}

/// Which cells belong to the region about a cell.
class Around {
 public:
  explicit Around(const Region& region) : c_(region) {}

  bool in_face(Index h) const { return c_.faces[c_.face(h)].mark != 0; }
  bool touches_face_edge(Index e) const { return in_face(2 * e) || in_face(2 * e + 1); }

  bool touches_face(Index v) const {
    if (c_.vertices[v].out == kNone) return c_.faces[c_.vertices[v].face].mark != 0;
    return any_around(v, [&](Index h) { return in_face(h); });
  }
  bool is_whisker(Index e) const { return c_.edges[e].mark != 0 && !touches_face_edge(e); }
  bool ends_whisker(Index v) const {
    return any_around(v, [&](Index h) { return is_whisker(h / 2); });
  }
  bool ends_gap(Index v) const {
    return any_around(v, [&](Index h) { return c_.edges[h / 2].mark == 0 && touches_face_edge(h / 2); });
  }

 private:
  template <class Test>
  bool any_around(Index v, Test test) const {
    const Index first = c_.vertices[v].out;
    if (first == kNone) return false;
    Index h = first;
    do {
      if (test(h)) return true;
      h = c_.clockwise(h);
    } while (h != first);
    return false;
  }

  const Region& c_;
};

/// Cells as the shapes that a scene states, where they are such.
class Primitives {
 public:
  Primitives(const Region& region, const Real& step) : c_(region), step_(step) {}

  /// A vertex as its coordinates.
  std::optional<std::string> place(Index v) const {
    const exact::Point& p = c_.point(v);
    if (p.kind != exact::Point::Kind::kGrid) return std::nullopt;
    const auto x = decimal(p.gx), y = decimal(p.gy);
    return x && y ? std::optional(fmt::format("[{}, {}]", *x, *y)) : std::nullopt;
  }

  std::optional<std::string> disc(const plane::Face& face) const {
    const std::vector<Index> walk = ring(face.outer);
    const exact::SupportingCurve& k = c_.supporting_curve(walk[0] / 2);
    const bool whole = k.circle && k.grid && std::all_of(walk.begin(), walk.end(), [&](Index h) {
                         return exact::same_supporting_curve(c_.supporting_curve(h / 2), k);
                       });
    if (!whole || !face.inner.empty()) return std::nullopt;
    const auto x = decimal(k.a), y = decimal(k.b), r = decimal(k.w());
    if (!x || !y || !r) return std::nullopt;
    return fmt::format(R"({{"disc": {{"center": [{}, {}], "radius": {}}}}})", *x, *y, *r);
  }

  std::optional<std::string> polygon(const plane::Face& face) const {
    std::set<Index> seen;
    const auto outer = corners(face.outer, seen);
    if (!outer) return std::nullopt;
    Texts holes;
    for (const Index start : face.inner) {
      // A curve inside the face is not a hole: it is missing from it, or belongs like the face.
      const std::vector<Index> walk = ring(start);
      if (std::any_of(walk.begin(), walk.end(), [&](Index h) { return c_.face(h) == c_.face(h ^ 1u); }))
        return std::nullopt;
      const auto hole = corners(start, seen);
      if (!hole) return std::nullopt;
      holes.push_back(*hole);
    }
    const std::string rest = holes.empty() ? "" : fmt::format(", \"holes\": [{}]", fmt::join(holes, ", "));
    return fmt::format("{{\"polygon\": {}{}}}", *outer, rest);
  }

 private:
  /// A length as the decimal a scene would state, or nothing where there is none.
  std::optional<std::string> decimal(const Real& steps) const {
    const Real value = steps * step_;
    if (!value.is_rational()) return std::nullopt;
    std::string text = json_number(value.to_double());
    if (text[0] == '"' || text == "null" || Real::parse_decimal(text) != value) return std::nullopt;
    return text;
  }

  std::vector<Index> ring(Index start) const {
    std::vector<Index> walk{start};
    for (Index h = c_.next(start); h != start; h = c_.next(h)) walk.push_back(h);
    return walk;
  }

  /// The vertices of a ring of segments; nothing where it is not one that polygons may have.
  std::optional<std::string> corners(Index start, std::set<Index>& seen) const {
    Texts places;
    for (const Index h : ring(start)) {
      const auto at = place(c_.origin(h));
      if (c_.is_arc(h / 2) || !at || !seen.insert(c_.origin(h)).second) return std::nullopt;
      places.push_back(*at);
    }
    return fmt::format("[{}]", fmt::join(places, ", "));
  }

  const Region& c_;
  const Real& step_;
};

class Constructive {
 public:
  Constructive(const Region& region, const Real& step)
      : c_(region), step_(step), around_(region), primitives_(region, step) {}

  std::string text() {
    Texts sum;
    if (const Texts faces = closed_faces(); !faces.empty()) sum.push_back(less(faces, missing()));
    if (const Texts edges = whiskers(); !edges.empty())
      sum.push_back(less(edges, points([&](Index v) { return c_.vertices[v].mark == 0 && around_.ends_whisker(v); })));
    const Texts single = points(
        [&](Index v) { return c_.vertices[v].mark != 0 && !around_.touches_face(v) && !around_.ends_whisker(v); });
    sum.insert(sum.end(), single.begin(), single.end());
    return sum.empty() ? nothing() : united(sum);
  }

 private:
  /// A point less itself: scenes have no empty shape.
  static std::string nothing() { return R"({"difference": [{"points": [[0, 0]]}, {"points": [[0, 0]]}]})"; }

  /// The set of these cells alone, as "cells".
  template <class Face, class Edge, class Vertex>
  std::string cells(Face face, Edge edge, Vertex vertex, bool closed) const {
    Region part = c_;
    for (Index f = 0; f < part.faces.size(); ++f) part.faces[f].mark = face(f);
    for (Index e = 0; e < part.edges.size(); ++e) part.edges[e].mark = edge(e);
    for (Index v = 0; v < part.vertices.size(); ++v) part.vertices[v].mark = vertex(v);
    part = plane::simplify(std::move(part));
    if (closed) part = plane::closure(std::move(part));
    return "{\"cells\": " + cells_json(part, step_, "") + "}";
  }
  static bool none(Index) { return false; }

  Texts closed_faces() const {
    Texts out;
    std::set<Index> others;
    for (Index f = 0; f < c_.faces.size(); ++f) {
      if (c_.faces[f].mark == 0) continue;
      std::optional<std::string> simple = primitives_.disc(c_.faces[f]);
      if (!simple) simple = primitives_.polygon(c_.faces[f]);
      if (simple)
        out.push_back(*simple);
      else
        others.insert(f);
    }
    if (!others.empty()) out.push_back(cells([&](Index f) { return others.count(f) > 0; }, none, none, true));
    return out;
  }

  /// Closed edges: segments between grid points, the others as cells.
  template <class Wanted>
  Texts closed_edges(Wanted wanted) const {
    Texts out;
    std::set<Index> others;
    for (Index e = 0; e < c_.edges.size(); ++e) {
      if (!wanted(e)) continue;
      const auto from = primitives_.place(c_.edges[e].v0), to = primitives_.place(c_.edges[e].v1);
      if (!c_.is_arc(e) && from && to)
        out.push_back(fmt::format("{{\"polyline\": [{}, {}]}}", *from, *to));
      else
        others.insert(e);
    }
    if (!others.empty())
      out.push_back(cells(
          none, [&](Index e) { return others.count(e) > 0; }, none, true));
    return out;
  }

  template <class Wanted>
  Texts points(Wanted wanted) const {
    Texts places, out;
    std::set<Index> others;
    for (Index v = 0; v < c_.vertices.size(); ++v) {
      if (!wanted(v)) continue;
      if (const auto at = primitives_.place(v))
        places.push_back(*at);
      else
        others.insert(v);
    }
    if (!places.empty()) out.push_back(fmt::format("{{\"points\": [{}]}}", fmt::join(places, ", ")));
    if (!others.empty())
      out.push_back(cells(
          none, none, [&](Index v) { return others.count(v) > 0; }, false));
    return out;
  }

  Texts missing() const {
    Texts out;
    const Texts edges = closed_edges([&](Index e) { return c_.edges[e].mark == 0 && around_.touches_face_edge(e); });
    if (!edges.empty())
      out.push_back(less(edges, points([&](Index v) { return c_.vertices[v].mark != 0 && around_.ends_gap(v); })));
    const Texts gaps =
        points([&](Index v) { return c_.vertices[v].mark == 0 && around_.touches_face(v) && !around_.ends_gap(v); });
    out.insert(out.end(), gaps.begin(), gaps.end());
    return out;
  }

  Texts whiskers() const {
    return closed_edges([&](Index e) { return around_.is_whisker(e); });
  }

  const Region& c_;
  const Real& step_;
  Around around_;
  Primitives primitives_;
};

}  // namespace

std::string constructive_json(const Region& region, const Real& step) {
  if (region.faces[0].mark == 0) return Constructive(region, step).text();
  const Region rest = plane::complement(region);
  return fmt::format("{{\"complement\": {}}}", Constructive(rest, step).text());
}

std::string constructive_scene(const Region& region, std::string_view name, const plane::Grid& grid,
                               std::string_view unit) {
  std::string out = "{\n  \"findspace\": 1,\n";
  if (!unit.empty()) out += fmt::format("  \"unit\": {},\n", json_string(unit));
  out += fmt::format("  \"grid\": {},\n", json_number(grid.step().to_double()));
  return out + fmt::format("  \"shapes\": {{{}: {}}}\n}}\n", json_string(name), constructive_json(region, grid.step()));
}

}  // namespace findspace::io
