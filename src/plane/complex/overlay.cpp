// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/complex/overlay.h"

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <string_view>
#include <unordered_map>

#include "plane/base/arena.h"
#include "plane/complex/arrangement.h"
#include "plane/complex/face_walk.h"
#include "plane/complex/refinement.h"
#include "plane/complex/side_by_side.h"
#include "plane/complex/simplify.h"

namespace findspace::plane {
namespace {

using exact::Geometry;

/// Where a piece of the overlay comes from.
struct Source {
  Index operand, edge;
};

struct Input {
  Geometry geometry;
  std::vector<Piece> pieces;
  std::vector<Source> source;
  std::vector<Index> point_offset;  // operand -> its first point
  std::vector<Index> isolated;
};

void reserve(Input& in, std::span<const CellComplex* const> operands) {
  std::size_t supporting_curves = 0, points = 0, edges = 0;
  for (const CellComplex* c : operands) {
    supporting_curves += c->geometry.supporting_curves.size();
    points += c->geometry.points.size();
    edges += c->edges.size();
  }
  in.geometry.supporting_curves.reserve(supporting_curves);
  in.geometry.points.reserve(points + points / 4);  // and some crossings
  in.pieces.reserve(edges);
  in.source.reserve(edges);
  in.point_offset.reserve(operands.size());
}

Input gather(std::span<const CellComplex* const> operands) {
  Input in;
  reserve(in, operands);
  for (Index k = 0; k < operands.size(); ++k) {
    const CellComplex& c = *operands[k];
    Index supporting_curve = Index(in.geometry.supporting_curves.size()), point = append(in.geometry, c.geometry);
    in.point_offset.push_back(point);
    for (Index e = 0; e < c.edges.size(); ++e) {
      const Edge& d = c.edges[e];
      in.pieces.push_back({.supporting_curve = d.supporting_curve + supporting_curve,
                           .p0 = c.vertices[d.v0].point + point,
                           .p1 = c.vertices[d.v1].point + point,
                           .half = d.half,
                           .group = k});
      in.source.push_back({k, e});
    }
    for (const Vertex& v : c.vertices)
      if (v.out == kNone) in.isolated.push_back(v.point + point);
  }
  return in;
}

/// The marks of all operands on all cells of the common refinement.
class Labels {
 public:
  Labels(const Arrangement& a, const Input& in, std::span<const CellComplex* const> operands)
      : a_(a), in_(in), operands_(operands), width_(operands.size()) {
    label_faces();
    label_edges();
    label_vertices();
  }

  /// What the rule says of the marks on each face, edge and vertex.
  template <class Value, class Rule>
  CellValues<Value> evaluate(const Rule& rule) const {
    auto apply = [&](const std::vector<Mark>& rows, std::size_t count) {
      std::vector<Value> out(count);
      for (std::size_t k = 0; k < count; ++k) out[k] = rule(std::span<const Mark>(rows.data() + k * width_, width_));
      return out;
    };
    return {apply(faces_, a_.face_count), apply(edges_, a_.edge_count()), apply(vertices_, a_.vertex_count())};
  }

 private:
  std::span<Mark> row(std::vector<Mark>& rows, Index k) { return {rows.data() + k * width_, width_}; }

  /// Copies face f's row to `to` and changes it to the row on the other side of half-edge h.
  void cross(Index h, std::span<const Mark> from, std::span<Mark> to) {
    std::copy(from.begin(), from.end(), to.begin());
    for (Index k = a_.cover_start[h / 2]; k < a_.cover_start[h / 2 + 1]; ++k) {
      const Source& s = in_.source[a_.cover[k]];
      const CellComplex& c = *operands_[s.operand];
      // Pieces and operand edges both run from the smaller to the larger end, so sides correspond.
      to[s.operand] = c.faces[c.face(2 * s.edge + (h & 1u ? 0 : 1))].mark;
    }
  }

  void label_faces() {
    faces_.resize(std::size_t(a_.face_count) * width_);
    for (Index k = 0; k < width_; ++k) faces_[k] = operands_[k]->faces[0].mark;
    walk_faces(a_, [&](Index h) { cross(h, row(faces_, a_.face[h]), row(faces_, a_.face[h ^ 1u])); });
  }

  void label_edges() {
    edges_.resize(std::size_t(a_.edge_count()) * width_);
    for (Index e = 0; e < a_.edge_count(); ++e) {
      auto from = row(faces_, a_.face[2 * e]), to = row(edges_, e);
      std::copy(from.begin(), from.end(), to.begin());
      for (Index k = a_.cover_start[e]; k < a_.cover_start[e + 1]; ++k) {
        const Source& s = in_.source[a_.cover[k]];
        to[s.operand] = operands_[s.operand]->edges[s.edge].mark;
      }
    }
  }

  void label_vertices() {
    vertices_.resize(std::size_t(a_.vertex_count()) * width_);
    for (Index v = 0; v < a_.vertex_count(); ++v) {
      auto from = row(faces_, a_.some_face(v)), to = row(vertices_, v);
      std::copy(from.begin(), from.end(), to.begin());
    }
    for (Index i = 0; i < a_.pieces.size(); ++i) {
      const Source& s = in_.source[i];
      for (Index k = a_.chain_start[i] + 1; k < a_.chain_start[i + 1]; ++k)
        row(vertices_, a_.edges[a_.chain[k]].v0)[s.operand] = operands_[s.operand]->edges[s.edge].mark;
    }
    for (Index k = 0; k < width_; ++k)
      for (const Vertex& v : operands_[k]->vertices)
        row(vertices_, a_.point_vertex[v.point + in_.point_offset[k]])[k] = v.mark;
  }

  const Arrangement& a_;
  const Input& in_;
  std::span<const CellComplex* const> operands_;
  std::size_t width_;
  std::vector<Mark> faces_, edges_, vertices_;
};

/// On every cell the sum over the marks of the operands.
class Weights {
 public:
  Weights(const Arrangement& a, const Input& in, std::span<const CellComplex* const> operands, const SignSum& sum)
      : a_(a), in_(in), operands_(operands), sum_(sum) {
    weigh_faces();
    weigh_edges();
    weigh_vertices();
  }

  template <class Rule>
  Marks evaluate(Rule&& rule) const {
    auto apply = [&](const std::vector<std::int32_t>& sums) {
      std::vector<Mark> out(sums.size());
      for (std::size_t k = 0; k < sums.size(); ++k) out[k] = rule(sums[k]);
      return out;
    };
    return {apply(faces_), apply(edges_), apply(vertices_)};
  }

 private:
  std::int32_t weight(Index operand, Mark mark) const { return sum_.of(operand, mark); }
  Mark face_mark(const Source& s, Index side) const {
    const CellComplex& c = *operands_[s.operand];
    return c.faces[c.face(2 * s.edge + side)].mark;
  }

  void weigh_faces() {
    faces_.resize(a_.face_count);
    faces_[0] = sum_.first;
    for (Index k = 0; k < operands_.size(); ++k) faces_[0] += weight(k, operands_[k]->faces[0].mark);
    walk_faces(a_, [&](Index h) {
      std::int32_t sum = faces_[a_.face[h]];
      // Pieces and operand edges both run from the smaller to the larger end, so sides correspond.
      for (Index k = a_.cover_start[h / 2]; k < a_.cover_start[h / 2 + 1]; ++k) {
        const Source& s = in_.source[a_.cover[k]];
        sum += weight(s.operand, face_mark(s, ~h & 1u)) - weight(s.operand, face_mark(s, h & 1u));
      }
      faces_[a_.face[h ^ 1u]] = sum;
    });
  }

  void weigh_edges() {
    edges_.resize(a_.edge_count());
    for (Index e = 0; e < a_.edge_count(); ++e) {
      edges_[e] = faces_[a_.face[2 * e]];
      for (Index k = a_.cover_start[e]; k < a_.cover_start[e + 1]; ++k) {
        const Source& s = in_.source[a_.cover[k]];
        edges_[e] += weight(s.operand, operands_[s.operand]->edges[s.edge].mark) - weight(s.operand, face_mark(s, 0));
      }
    }
  }

  /// Starts from the face in the sector after the first half-edge; an operand with something at the vertex counts there
  /// with the mark of that instead of the mark of its face in that sector.
  void weigh_vertices() {
    vertices_.resize(a_.vertex_count());
    for (Index v = 0; v < a_.vertex_count(); ++v) vertices_[v] = faces_[a_.some_face(v)];
    for (Index i = 0; i < a_.pieces.size(); ++i) {
      const Source& s = in_.source[i];
      for (Index k = a_.chain_start[i] + 1; k < a_.chain_start[i + 1]; ++k) {
        bool left = passes(0, a_.rank[2 * a_.chain[k]], a_.rank[2 * a_.chain[k - 1] + 1]);
        vertices_[a_.edges[a_.chain[k]].v0] +=
            weight(s.operand, operands_[s.operand]->edges[s.edge].mark) - weight(s.operand, face_mark(s, left ? 0 : 1));
      }
    }
    Index piece = 0;
    for (Index k = 0; k < operands_.size(); ++k) {
      const CellComplex& c = *operands_[k];
      for (const Vertex& v : c.vertices)
        vertices_[a_.point_vertex[v.point + in_.point_offset[k]]] +=
            weight(k, v.mark) - weight(k, c.faces[v.out == kNone ? v.face : c.face(face_before(c, v.out, piece))].mark);
      piece += Index(c.edges.size());
    }
  }

  /// Of the operand's half-edges around the origin of `out`, the last one before or at the first of the arrangement's,
  /// going counter-clockwise; `piece` is the operand's first.
  Index face_before(const CellComplex& c, Index out, Index piece) const {
    Index best = kNone, best_rank = 0, h = out;
    do {
      Index i = piece + h / 2;
      Index rank = a_.rank[h & 1u ? 2 * a_.chain[a_.chain_start[i + 1] - 1] + 1 : 2 * a_.chain[a_.chain_start[i]]];
      if (rank == 0) return h;
      if (best == kNone || rank > best_rank) {
        best = h;
        best_rank = rank;
      }
      h = c.clockwise(h);
    } while (h != out);
    return best;
  }

  const Arrangement& a_;
  const Input& in_;
  std::span<const CellComplex* const> operands_;
  const SignSum& sum_;
  std::vector<std::int32_t> faces_, edges_, vertices_;
};

/// Where the sum satisfies the rule. Cost: one arrangement, whatever the number of operands.
template <class Rule>
Region region_of_sum(Input in, std::span<const CellComplex* const> operands, const SignSum& sum, Rule&& rule) {
  Arena arena(in.pieces.size());
  Arrangement a = arrange(std::move(in.geometry), std::move(in.pieces), in.isolated, arena.memory());
  return extract(std::move(a), Weights(a, in, operands, sum).evaluate(rule));
}

/// Where the sum of the weights of the regions that contain a cell satisfies the rule.
template <class Rule>
Region combine(std::span<const Region* const> regions, std::span<const std::int32_t> weight, Rule&& rule) {
  if (regions.size() == 1) return *regions[0];
  SignSum sum;
  for (const std::int32_t w : weight) sum.added.push_back({0, 0, w});
  return region_of_sum(gather(regions), regions, sum, rule);
}

}  // namespace

CellComplex overlay(std::span<const CellComplex* const> operands,
                    const std::function<Mark(std::span<const Mark>)>& rule) {
  if (operands.size() == 1) return remark(*operands[0], [&](Mark m) { return rule({&m, 1}); });
  Input in = gather(operands);
  Arena arena(in.pieces.size());
  Arrangement a = arrange(std::move(in.geometry), std::move(in.pieces), in.isolated, arena.memory());
  const auto [faces, edges, vertices] = Labels(a, in, operands).evaluate<Mark>(rule);
  return extract(std::move(a), {faces, edges, vertices});
}

Refinement::Refinement(std::span<const CellComplex* const> operands, WorkBudget& work, std::string_view what)
    : width_(operands.size()), cells_(kHeap) {
  if (operands.size() == 1) {
    alone_ = *operands[0];
    std::set<Mark> marks;
    for (const Vertex& v : alone_->vertices) marks.insert(v.mark);
    for (const Edge& e : alone_->edges) marks.insert(e.mark);
    for (const Face& f : alone_->faces) marks.insert(f.mark);
    kind_marks_.assign(marks.begin(), marks.end());
    kinds_ = marks.size();
    return;
  }
  Input in = gather(operands);
  cells_ = arrange(std::move(in.geometry), std::move(in.pieces), in.isolated);
  const std::size_t cells = cells_.face_count + cells_.edge_count() + cells_.vertex_count();
  work.charge(cells * width_ / kMarksAUnit, what);
  const Labels labels(cells_, in, operands);
  std::unordered_map<std::string_view, Index> known;
  kind_ = labels.evaluate<Index>([&](std::span<const Mark> marks) {
    const std::string_view row(reinterpret_cast<const char*>(marks.data()), marks.size());
    const auto [at, is_new] = known.emplace(row, Index(known.size()));
    if (is_new) kind_marks_.insert(kind_marks_.end(), marks.begin(), marks.end());
    return at->second;
  });
  kinds_ = known.size();
  // What extract() does not read.
  cells_.pieces.clear();
  for (auto* list :
       {&cells_.point_vertex, &cells_.cover_start, &cells_.cover, &cells_.chain_start, &cells_.chain, &cells_.rank})
    list->clear();
}

CellComplex Refinement::complex(std::span<const Mark> of_kind) const {
  if (alone_)
    return remark(*alone_, [&](Mark m) {
      return of_kind[std::size_t(std::find(kind_marks_.begin(), kind_marks_.end(), m) - kind_marks_.begin())];
    });
  const auto marked = [&](const std::vector<Index>& kinds) {
    std::vector<Mark> out(kinds.size());
    for (std::size_t k = 0; k < kinds.size(); ++k) out[k] = of_kind[kinds[k]];
    return out;
  };
  const std::vector<Mark> faces = marked(kind_.faces), edges = marked(kind_.edges), vertices = marked(kind_.vertices);
  return extract(Arrangement(cells_), {faces, edges, vertices});
}

Region summed(std::span<const SignMap* const> maps, const SignSum& sum, bool apart) {
  const auto holds = [](std::int32_t value) { return Mark(value > 0); };
  if (maps.size() == 1) return remark(*maps[0], [&](Mark m) { return holds(sum.first + sum.of(0, m)); });
  Input in = gather(maps);
  if (apart) {
    for (Piece& p : in.pieces) p.group = 0;
  }
  return region_of_sum(std::move(in), maps, sum, holds);
}

Region unite_arranged(std::span<const Region* const> regions) {
  std::vector<std::int32_t> ones(regions.size(), 1);
  return combine(regions, ones, [](std::int32_t sum) { return Mark(sum > 0); });
}

Region intersect(std::span<const Region* const> regions) {
  std::vector<std::int32_t> ones(regions.size(), 1);
  return combine(regions, ones, [all = std::int32_t(regions.size())](std::int32_t sum) { return Mark(sum == all); });
}

Region subtract(std::span<const Region* const> regions) {
  std::vector<std::int32_t> weight(regions.size(), -1);
  weight[0] = 1;
  return combine(regions, weight, [](std::int32_t sum) { return Mark(sum == 1); });
}

CellComplex remark(CellComplex complex, const std::function<Mark(Mark)>& rule) {
  std::array<std::optional<Mark>, 256> made;  // by mark + 128
  std::array<bool, 256> taken{};
  bool all_differ = true;
  auto change = [&](Mark& m) {
    auto& to = made[std::size_t(m + 128)];
    if (!to) {
      to = rule(m);
      bool& used = taken[std::size_t(*to + 128)];
      all_differ &= !used;
      used = true;
    }
    m = *to;
  };
  for (Vertex& v : complex.vertices) change(v.mark);
  for (Edge& e : complex.edges) change(e.mark);
  for (Face& f : complex.faces) change(f.mark);
  if (all_differ) return complex;  // what differed still differs
  return simplify(std::move(complex));
}

}  // namespace findspace::plane
