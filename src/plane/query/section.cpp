// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/query/section.h"

#include <algorithm>

#include "plane/query/locate.h"

namespace findspace::plane {
namespace {

using exact::Real;

/// Parameters count in vectors `direction`, so that those of grid points are rational.
class LineMeetings {
 public:
  LineMeetings(const CellComplex& s, const RealVector& through, const RealVector& direction)
      : s_(s), through_(through), direction_(direction), square_(dot(direction, direction)) {}

  std::vector<Real> parameters() {
    for (const Vertex& v : s_.vertices) {
      ends_.push_back(s_.geometry.exact(v.point));
      side_.push_back(offset_from_line(ends_.back()).sign());
      if (side_.back() == 0) found_.push_back(parameter(ends_.back()));
    }
    for (Index e = 0; e < s_.edges.size(); ++e) s_.is_arc(e) ? meet_circle(e) : meet_line(e);
    std::sort(found_.begin(), found_.end());
    found_.erase(std::unique(found_.begin(), found_.end()), found_.end());
    return std::move(found_);
  }

  RealVector at(const Real& t) const { return through_ + t * direction_; }

 private:
  Real offset_from_line(const RealVector& p) const { return cross(direction_, p - through_); }
  Real parameter(const RealVector& p) const { return dot(direction_, p - through_) / square_; }

  void meet_line(Index e) {
    // Where the ends lie strictly on different sides; touching ends are vertices, which have been seen.
    if (side_[s_.edges[e].v0] * side_[s_.edges[e].v1] >= 0) return;
    const exact::SupportingCurve& k = s_.supporting_curve(e);
    const RealVector normal{Real(k.a), Real(k.b)};
    found_.push_back((k.offset() - dot(normal, through_)) / dot(normal, direction_));
  }

  void meet_circle(Index e) {
    const exact::SupportingCurve& k = s_.supporting_curve(e);
    const RealVector center{k.center_x(), k.center_y()};
    const Real height = offset_from_line(center), rest = k.w() * k.w() * square_ - height * height;
    if (rest.sign() < 0) return;
    const Real middle = parameter(center), half = sqrt(rest) / square_;
    add_if_on_arc(e, middle - half);
    if (rest.sign() > 0) add_if_on_arc(e, middle + half);
  }

  void add_if_on_arc(Index e, const Real& t) {
    const RealVector p = at(t);
    const bool half = (p.y - s_.supporting_curve(e).center_y()).sign() * s_.edges[e].half >= 0;
    if (half && p.x >= ends_[s_.edges[e].v0].x && p.x <= ends_[s_.edges[e].v1].x) found_.push_back(t);
  }

  const CellComplex& s_;
  const RealVector through_, direction_;
  const Real square_;
  std::vector<RealVector> ends_;  // by vertex, and on which side of the line they are
  std::vector<int> side_;
  std::vector<Real> found_;
};

}  // namespace

Section section(const CellComplex& complex, const RealVector& through, const RealVector& direction) {
  LineMeetings line(complex, through, direction);
  const std::vector<Real> found = line.parameters();
  Locator locator(complex);
  Section out;
  out.before = complex.faces[0].mark;
  for (std::size_t k = 0; k < found.size(); ++k) {
    const bool last = k + 1 == found.size();
    const Mark after = last ? out.before : locator.mark(line.at((found[k] + found[k + 1]) / Real(2)));
    out.stops.push_back({found[k], locator.mark(line.at(found[k])), after});
  }
  return out;
}

Section Section::between(const Real& first, const Real& last) const {
  Section out;
  Mark now = before;
  auto k = stops.begin();
  for (; k != stops.end() && k->t < first; ++k) now = k->after;
  const bool on_stop = k != stops.end() && k->t == first;
  out.before = now;
  out.stops.push_back(on_stop ? *k++ : Stop{first, now, now});
  for (; k != stops.end() && k->t < last; ++k) out.stops.push_back(*k);
  now = out.stops.back().after;
  out.stops.push_back(k != stops.end() && k->t == last ? *k : Stop{last, now, now});
  return out;
}

Section Section::constant(const Real& first, const Real& last, Mark mark) {
  return {mark, {{first, mark, mark}, {last, mark, mark}}};
}

Section section_of_path(const CellComplex& complex, const RealVector& p, std::span<const RealVector> path,
                        std::span<const Real> times) {
  Section out;
  for (std::size_t k = 0; k + 1 < path.size(); ++k) {
    const RealVector from = p + path[k], leg = path[k + 1] - path[k];
    const Real duration = times[k + 1] - times[k];
    Section part;
    if (leg == RealVector{}) {
      part = Section::constant(Real(0), Real(1), mark_of(complex, locate(complex, from)));
    } else {
      part = section(complex, from, leg).between(Real(0), Real(1));
    }
    if (!out.stops.empty()) out.stops.pop_back();  // the next leg begins there
    for (const Section::Stop& s : part.stops) out.stops.push_back({times[k] + s.t * duration, s.at, s.after});
  }
  return out;
}

Section overlay_sections(std::span<const Section> sections, const std::function<Mark(std::span<const Mark>)>& rule) {
  std::vector<std::size_t> next(sections.size(), 0);
  std::vector<Mark> now, here(sections.size());
  for (const Section& s : sections) now.push_back(s.before);
  Section out{rule(now), {}};
  for (;;) {
    const Real* least = nullptr;
    for (std::size_t k = 0; k < sections.size(); ++k) {
      if (next[k] == sections[k].stops.size()) continue;
      const Real& t = sections[k].stops[next[k]].t;
      if (least == nullptr || t < *least) least = &t;
    }
    if (least == nullptr) return out;
    const Real t = *least;
    here = now;
    for (std::size_t k = 0; k < sections.size(); ++k) {
      if (next[k] == sections[k].stops.size() || !(sections[k].stops[next[k]].t == t)) continue;
      here[k] = sections[k].stops[next[k]].at;
      now[k] = sections[k].stops[next[k]++].after;
    }
    out.stops.push_back({t, rule(here), rule(now)});
  }
}

}  // namespace findspace::plane
