// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/grid/merged_curves.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace findspace::plane {
namespace {

constexpr std::size_t kFewCurves = 400;
// Of a sample of 2 * sqrt(n) about twice as many overlap others as curves overlap each one of all.
constexpr std::size_t kManyOverlaps = 8;

/// Where a curve lies on its line.
struct Lie {
  std::uint64_t key;  // the same for those on one line
  const exact::SupportingCurve* line;
  std::int64_t from, to;  // of x, or of y if it is vertical
  bool left;              // the inner side
  Index piece;

  bool same_line(const Lie& o) const { return line->a == o.line->a && line->b == o.line->b && line->c == o.line->c; }
  bool same_side(const Lie& o) const { return key == o.key && left == o.left && same_line(o); }
  friend bool operator<(const Lie& p, const Lie& q) {
    if (p.key != q.key) return p.key < q.key;
    if (!p.same_line(q)) return before(*p.line, *q.line);
    if (p.left != q.left) return p.left < q.left;
    return p.from != q.from ? p.from < q.from : p.piece < q.piece;
  }

 private:
  static bool before(const exact::SupportingCurve& k, const exact::SupportingCurve& l) {
    if (k.a != l.a) return k.a < l.a;
    return k.b != l.b ? k.b < l.b : k.c < l.c;
  }
};

const exact::SupportingCurve& line_of(const ReducedConvolution& c, Index i) {
  return c.geometry.supporting_curves[c.pieces[i].supporting_curve];
}

std::uint64_t key_of(const exact::SupportingCurve& line) {
  return (std::uint64_t(line.a) * 0x9e3779b97f4a7c15u + std::uint64_t(line.b)) * 0xbf58476d1ce4e5b9u +
         std::uint64_t(line.c);
}

Lie lie_of(const ReducedConvolution& c, Index i) {
  const Piece& piece = c.pieces[i];
  const exact::SupportingCurve& line = line_of(c, i);
  const exact::Point &p = c.geometry.points[piece.p0], &q = c.geometry.points[piece.p1];
  const bool vertical = line.b == 0;
  return {key_of(line), &line, vertical ? p.gy : p.gx, vertical ? q.gy : q.gx, c.sides[i].left, i};
}

/// Calls visit(curves) for those that become one, sorted by their first ends.
template <class Visit>
void each_run(std::vector<Lie>& lies, Visit&& visit) {
  std::sort(lies.begin(), lies.end());
  for (std::size_t first = 0; first < lies.size();) {
    std::int64_t reach = lies[first].to;
    std::size_t end = first + 1;
    for (; end < lies.size() && lies[end].same_side(lies[first]) && lies[end].from < reach; ++end)
      reach = std::max(reach, lies[end].to);
    visit(std::span<const Lie>(lies).subspan(first, end - first));
    first = end;
  }
}

/// Some curves as one.
struct Merged {
  Index first;         // the one of them that comes first
  Index starts, ends;  // those that have its ends
  bool hides_at_start, hides_at_end;
};

Merged merged(const ReducedConvolution& c, std::span<const Lie> run) {
  const Lie* last = &run[0];
  for (const Lie& l : run)
    if (l.to > last->to) last = &l;
  Merged out{run[0].piece, run[0].piece, last->piece, false, false};
  for (const Lie& l : run) {
    out.first = std::min(out.first, l.piece);
    out.hides_at_start |= l.from == run[0].from && c.sides[l.piece].hides_at_p0;
    out.hides_at_end |= l.to == last->to && c.sides[l.piece].hides_at_p1;
  }
  return out;
}

/// Takes over what is kept.
class Keeper {
 public:
  explicit Keeper(ReducedConvolution from) : from_(std::move(from)), point_(from_.geometry.points.size(), kNone) {
    out_.mask = std::move(from_.mask);
  }

  void keep(const Merged& m) {
    const Piece& piece = from_.pieces[m.first];
    const Index line = out_.geometry.add(std::move(from_.geometry.supporting_curves[piece.supporting_curve]));
    const Index p0 = point(from_.pieces[m.starts].p0), p1 = point(from_.pieces[m.ends].p1);
    out_.pieces.push_back({.supporting_curve = line, .p0 = p0, .p1 = p1});
    out_.sides.push_back(
        {.left = from_.sides[m.first].left, .hides_at_p0 = m.hides_at_start, .hides_at_p1 = m.hides_at_end});
  }

  ReducedConvolution result() && { return std::move(out_); }

 private:
  Index point(Index old) {
    if (point_[old] == kNone) {
      point_[old] = Index(out_.geometry.points.size());
      out_.geometry.points.push_back(from_.geometry.points[old]);
    }
    return point_[old];
  }

  ReducedConvolution from_, out_;
  std::vector<Index> point_;  // of what is kept
};

/// Calls visit(curve) for one of each stretch of the curves.
template <class Visit>
void each_of_sample(const ReducedConvolution& c, std::size_t size, Visit&& visit) {
  const std::size_t count = c.pieces.size();
  std::uint32_t random = 1;
  for (std::size_t k = 0, first = 0; k < size; ++k) {
    const std::size_t end = (k + 1) * count / size;
    random = random * 1664525u + 1013904223u;  // of Numerical Recipes; steps of one length could follow a pattern
    visit(Index(first + ((end - first) * (random >> 16) >> 16)));
    first = end;
  }
}

std::size_t overlaps(const ReducedConvolution& c, std::size_t sample) {
  std::vector<Lie> lies;
  lies.reserve(sample);
  each_of_sample(c, sample, [&](Index i) { lies.push_back(lie_of(c, i)); });
  std::size_t found = 0;
  each_run(lies, [&](std::span<const Lie> run) { found += run.size() - 1; });
  return found;
}

}  // namespace

bool merging_pays(const ReducedConvolution& c) {
  if (c.pieces.size() < kFewCurves) return false;
  const auto size = std::size_t(2 * std::sqrt(double(c.pieces.size())));
  std::vector<std::uint64_t> keys(size);
  auto key = keys.begin();
  each_of_sample(c, size, [&](Index i) { *key++ = key_of(line_of(c, i)); });
  std::sort(keys.begin(), keys.end());
  std::size_t more = 0;  // than one on a line
  for (std::size_t k = 1; k < size; ++k) more += keys[k] == keys[k - 1];
  return more >= kManyOverlaps && overlaps(c, size) >= kManyOverlaps;
}

ReducedConvolution merged_curves(ReducedConvolution c) {
  std::vector<Lie> lies;
  lies.reserve(c.pieces.size());
  for (Index i = 0; i < c.pieces.size(); ++i) lies.push_back(lie_of(c, i));
  std::vector<Merged> kept;
  each_run(lies, [&](std::span<const Lie> run) { kept.push_back(merged(c, run)); });
  std::sort(kept.begin(), kept.end(), [](const Merged& p, const Merged& q) { return p.first < q.first; });
  Keeper keeper(std::move(c));
  for (const Merged& m : kept) keeper.keep(m);
  return std::move(keeper).result();
}

}  // namespace findspace::plane
