// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/query/summary_connect.h"

#include <algorithm>
#include <utility>

#include "plane/base/union_find.h"

namespace findspace::plane {
namespace {

/// All cells in one numbering: faces, then edges, then vertices.
struct CellNumbers {
  explicit CellNumbers(const Region& s) : s(s), edges(Index(s.faces.size())), vertices(edges + Index(s.edges.size())) {}
  Index count() const { return vertices + Index(s.vertices.size()); }
  Mark mark(Index cell) const {
    if (cell < edges) return s.faces[cell].mark;
    return cell < vertices ? s.edges[cell - edges].mark : s.vertices[cell - vertices].mark;
  }

  /// Calls visit(p, q) for all pairs of cells of which one is in the closure of the other (some pairs twice).
  template <class Visit>
  void for_incident_pairs(Visit visit) const {
    for (Index h = 0; h < s.half_edges.size(); ++h) {
      Index face = s.face(h), edge = edges + h / 2, vertex = vertices + s.origin(h);
      visit(edge, face);
      visit(vertex, edge);
      visit(vertex, face);
    }
    for (Index v = 0; v < s.vertices.size(); ++v) {
      if (s.vertices[v].out == kNone) visit(vertices + v, s.vertices[v].face);
    }
  }

  const Region& s;
  Index edges, vertices;
};

using Pairs = std::vector<std::pair<Index, Index>>;

void sort_once(Pairs& pairs) {
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
}

/// Counts for every component its children in the tree of adjacent components; each pair is given one way at least.
void count_children(Connection& c, Pairs adjacent) {
  sort_once(adjacent);
  const std::size_t one_way = adjacent.size();
  adjacent.reserve(2 * one_way);
  for (std::size_t k = 0; k < one_way; ++k) adjacent.emplace_back(adjacent[k].second, adjacent[k].first);
  sort_once(adjacent);
  std::vector<Index> start(c.count() + 1, 0);
  for (const auto& [from, to] : adjacent) ++start[from + 1];
  for (Index k = 0; k < c.count(); ++k) start[k + 1] += start[k];
  c.holes.assign(c.count(), 0);
  std::vector<Index> parent(c.count(), kNone), queue{0};
  parent[0] = 0;
  for (std::size_t k = 0; k < queue.size(); ++k) {
    for (Index i = start[queue[k]]; i < start[queue[k] + 1]; ++i) {
      Index child = adjacent[i].second;
      if (parent[child] != kNone) continue;
      parent[child] = queue[k];
      ++c.holes[queue[k]];
      queue.push_back(child);
    }
  }
}

}  // namespace

Connection connect(const Region& s) {
  CellNumbers cells(s);
  UnionFind sets(cells.count());
  cells.for_incident_pairs([&](Index p, Index q) {
    if (cells.mark(p) == cells.mark(q)) sets.unite(p, q);
  });
  Connection c;
  std::vector<Index> number(cells.count(), kNone), component(cells.count());
  for (Index cell = 0; cell < cells.count(); ++cell) {
    Index& n = number[sets.find(cell)];
    if (n == kNone) {
      n = c.count();
      c.mark.push_back(cells.mark(cell));
    }
    component[cell] = n;
  }
  Pairs adjacent;
  cells.for_incident_pairs([&](Index p, Index q) {
    if (component[p] == component[q]) return;
    const std::pair<Index, Index> both = std::minmax(component[p], component[q]);
    if (adjacent.empty() || adjacent.back() != both) adjacent.push_back(both);  // neighbours mostly repeat
  });
  count_children(c, std::move(adjacent));
  c.faces.assign(component.begin(), component.begin() + cells.edges);
  c.edges.assign(component.begin() + cells.edges, component.begin() + cells.vertices);
  c.vertices.assign(component.begin() + cells.vertices, component.end());
  return c;
}

}  // namespace findspace::plane
