// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/convex_sum.h"

#include "plane/primitives.h"

namespace findspace::plane {
namespace {

/// The step after which directions leave the lower half: the first with an angle in [0, 180). Nothing if the part is
/// not a convex polygon: one ring that turns left everywhere and round once.
std::optional<std::size_t> first_step(const Part& part) {
  if (part.flat || part.unbounded || part.paths.size() != 1 || part.paths[0].lonely) return std::nullopt;
  const auto& steps = part.paths[0].steps;
  std::optional<std::size_t> first;
  for (std::size_t k = 0; k < steps.size(); ++k) {
    const Step &s = steps[k], &before = steps[k == 0 ? steps.size() - 1 : k - 1];
    if (s.arc || !s.from.grid() || !s.start.grid() || !before.start.grid() || cross_sign(before.start, s.start) <= 0)
      return std::nullopt;
    if (!is_lower(before.start) || is_lower(s.start)) continue;
    if (first) return std::nullopt;
    first = k;
  }
  return first;
}

class Ring {
 public:
  Ring(const Part& part, std::size_t first) : steps_(part.paths[0].steps), at_(first) {}

  bool ended() const { return taken_ == steps_.size(); }
  const Step& step() const { return steps_[at_]; }
  void advance() {
    ++taken_;
    if (++at_ == steps_.size()) at_ = 0;
  }
  bool upper() const { return !is_lower(step().start); }

 private:
  const std::vector<Step>& steps_;
  std::size_t at_, taken_ = 0;
};

/// Order of the directions of the next steps, both rings begun at their first.
int order(const Ring& p, const Ring& q) {
  if (p.ended() || q.ended()) return p.ended() ? 1 : -1;
  if (p.upper() != q.upper()) return p.upper() ? -1 : 1;
  return -cross_sign(p.step().start, q.step().start);
}

}  // namespace

std::optional<SignMap> convex_sum(const Part& a, const Part& b) {
  auto first_a = first_step(a), first_b = first_step(b);
  if (!first_a || !first_b) return std::nullopt;
  Ring p(a, *first_a), q(b, *first_b);
  Contour ring;
  ring.reserve(a.paths[0].steps.size() + b.paths[0].steps.size());
  while (!p.ended() || !q.ended()) {
    // A step of one ring starts at the sum of its start and of the vertex where the other ring stands: the start of its
    // next step.
    const Position &u = p.step().from, &v = q.step().from;
    ring.push_back({.start = {u.x + v.x, u.y + v.y}});
    int o = order(p, q);
    if (o <= 0) p.advance();
    if (o >= 0) q.advance();
  }
  SignMap map = region_of_rings(std::span(&ring, 1));
  for (Face& f : map.faces) f.mark = f.mark > 0 ? -1 : 1;
  for (Edge& e : map.edges) e.mark = 0;
  for (Vertex& v : map.vertices) v.mark = 0;
  return map;
}

}  // namespace findspace::plane
