// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/complex/side_by_side.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "plane/base/union_find.h"

namespace findspace::plane {
namespace {

/// Boxes by ascending starts along the axis on which they spread farther; those that are open, by slabs of the other.
class Sweep {
 public:
  explicit Sweep(std::span<const PieceBox> boxes) : boxes_(boxes) {
    PieceBox all = boxes[0];
    for (const PieceBox& b : boxes) all = joined(all, b);
    wide_ = all.x1 - all.x0 >= all.y1 - all.y0;
    bottom_ = wide_ ? all.y0 : all.x0;
    open_.resize(std::size_t(std::sqrt(double(boxes.size()))) + 1, kNone);
    const double height = (wide_ ? all.y1 : all.x1) - bottom_;
    slabs_per_step_ = height > 0 ? double(open_.size()) / height : 0;
    items_.reserve(2 * boxes.size());
  }

  /// Calls f(i, k) for all pairs of boxes that meet, until it returns false.
  template <class F>
  void pairs(F&& f) {
    std::vector<Index> order(boxes_.size());
    std::iota(order.begin(), order.end(), Index(0));
    std::sort(order.begin(), order.end(), [&](Index i, Index k) { return from(i) < from(k); });
    for (const Index k : order) {
      const std::size_t first = first_slab(k), last = slab(wide_ ? boxes_[k].y1 : boxes_[k].x1);
      for (std::size_t s = first; s <= last; ++s) {
        Index* end = &open_[s];
        while (*end != kNone) {
          Item& item = items_[*end];
          if (to(item.box) < from(k)) {
            close(*end);
            continue;
          }
          const Index i = item.box;  // of several slabs in the first
          if (boxes_[i].meets(boxes_[k]) && (s == first || s == first_slab(i)) && !f(i, k)) return;
          end = &item.next;
        }
        open(*end, k);
      }
    }
  }

 private:
  /// Of the boxes that are open in a slab, in the order in which they were opened.
  struct Item {
    Index box, next;
  };

  /// `end`: where the number of the next item stands.
  void open(Index& end, Index box) {
    const Index item = free_ != kNone ? free_ : Index(items_.size());
    end = item;
    if (free_ == kNone) return void(items_.push_back({box, kNone}));
    free_ = items_[item].next;
    items_[item] = {box, kNone};
  }
  void close(Index& link) {
    const Index item = link;
    link = items_[item].next;
    items_[item].next = free_;
    free_ = item;
  }

  double from(Index k) const { return wide_ ? boxes_[k].x0 : boxes_[k].y0; }
  double to(Index k) const { return wide_ ? boxes_[k].x1 : boxes_[k].y1; }
  std::size_t first_slab(Index k) const { return slab(wide_ ? boxes_[k].y0 : boxes_[k].x0); }
  std::size_t slab(double at) const {
    const double steps = (at - bottom_) * slabs_per_step_;  // of the box of nothing infinite, or no number
    return steps > 0 ? std::size_t(std::min(steps, double(open_.size() - 1))) : 0;
  }

  std::span<const PieceBox> boxes_;
  bool wide_ = true;
  double bottom_ = 0, slabs_per_step_ = 0;
  std::vector<Index> open_;  // slab -> its first item
  std::vector<Item> items_;
  Index free_ = kNone;  // an item that is not in use, and so on
};

/// In the order of their first members.
IndexGroups by_set(UnionFind& same, std::size_t size) {
  std::vector<Index> group_of(size, kNone);
  Index count = 0;
  for (Index k = 0; k < size; ++k) {
    const Index first = same.find(k);  // the least of its set
    group_of[k] = first == k ? count++ : group_of[first];
  }
  return {group_of, count};
}

IndexGroups groups_that_meet(const std::vector<PieceBox>& boxes) {
  UnionFind same(boxes.size());
  meeting_boxes(boxes, [&](Index i, Index k) {
    same.unite(i, k);
    return true;
  });
  return by_set(same, boxes.size());
}

bool holds(const PieceBox& a, const PieceBox& b) {
  return a.x0 <= b.x0 && b.x1 <= a.x1 && a.y0 <= b.y0 && b.y1 <= a.y1;
}

Index shifted(Index k, Index by) { return k == kNone ? kNone : k + by; }

}  // namespace

IndexGroups::IndexGroups(std::span<const Index> of, std::size_t count) : members_(of.size()), start_(count + 1, 0) {
  for (const Index group : of) ++start_[group + 1];
  std::partial_sum(start_.begin(), start_.end(), start_.begin());
  std::vector<Index> at(start_.begin(), start_.end() - 1);
  for (Index k = 0; k < of.size(); ++k) members_[at[of[k]]++] = k;
}

void meeting_boxes(std::span<const PieceBox> boxes, const std::function<bool(Index, Index)>& visit) {
  if (!boxes.empty()) Sweep(boxes).pairs(visit);
}

IndexGroups groups_apart(const std::vector<PieceBox>& boxes) {
  IndexGroups groups = groups_that_meet(boxes);
  if (groups.size() < 2 || groups.size() == boxes.size()) return groups;
  std::vector<PieceBox> around;
  around.reserve(groups.size());
  UnionFind same(boxes.size());
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const std::span<const Index> group = groups[g];
    around.push_back(boxes[group[0]]);
    for (const Index k : group) {
      around.back() = joined(around.back(), boxes[k]);
      same.unite(group[0], k);
    }
  }
  meeting_boxes(around, [&](Index i, Index k) {
    if (holds(around[i], around[k]) || holds(around[k], around[i])) same.unite(groups[i][0], groups[k][0]);
    return true;
  });
  return by_set(same, boxes.size());
}

Index append(exact::Geometry& to, const exact::Geometry& from) {
  const Index supporting_curves = Index(to.supporting_curves.size()), points = Index(to.points.size()),
              reals = Index(to.reals.size());
  to.supporting_curves.insert(to.supporting_curves.end(), from.supporting_curves.begin(), from.supporting_curves.end());
  to.reals.insert(to.reals.end(), from.reals.begin(), from.reals.end());
  for (exact::Point p : from.points) {
    if (p.kind == exact::Point::Kind::kCross) {
      p.i += supporting_curves;
      p.j += supporting_curves;
    }
    if (p.kind == exact::Point::Kind::kReal) p.i += reals;
    to.points.push_back(p);
  }
  return points;
}

void put_beside(CellComplex& to, const CellComplex& from) {
  const Index supporting_curve = Index(to.geometry.supporting_curves.size()),
              point = append(to.geometry, from.geometry), vertex = Index(to.vertices.size()),
              half = Index(to.half_edges.size()), face = Index(to.faces.size()) - 1;
  const auto new_face = [face](Index f) { return f == 0 || f == kNone ? f : f + face; };
  for (const Vertex& v : from.vertices)
    to.vertices.push_back({v.point + point, v.mark, shifted(v.out, half), new_face(v.face)});
  for (const Edge& e : from.edges)
    to.edges.push_back({e.v0 + vertex, e.v1 + vertex, e.supporting_curve + supporting_curve, e.half, e.mark});
  for (const HalfEdge& h : from.half_edges) to.half_edges.push_back({shifted(h.next, half), new_face(h.face)});
  for (std::size_t f = 0; f < from.faces.size(); ++f) {
    const Face& was = from.faces[f];
    if (f > 0) to.faces.push_back({was.mark, shifted(was.outer, half), {}, {}});
    Face& now = f > 0 ? to.faces.back() : to.faces[0];
    for (const Index h : was.inner) now.inner.push_back(h + half);
    for (const Index v : was.isolated) now.isolated.push_back(v + vertex);
  }
}

Region side_by_side(std::span<const Region* const> regions) {
  Region out = Region::uniform(0);
  std::size_t points = 0, supporting_curves = 0, vertices = 0, edges = 0, faces = 1;
  for (const Region* r : regions) {
    points += r->geometry.points.size();
    supporting_curves += r->geometry.supporting_curves.size();
    vertices += r->vertices.size();
    edges += r->edges.size();
    faces += r->faces.size() - 1;
  }
  out.geometry.points.reserve(points);
  out.geometry.supporting_curves.reserve(supporting_curves);
  out.vertices.reserve(vertices);
  out.edges.reserve(edges);
  out.half_edges.reserve(2 * edges);
  out.faces.reserve(faces);
  for (const Region* r : regions) put_beside(out, *r);
  return out;
}

}  // namespace findspace::plane
