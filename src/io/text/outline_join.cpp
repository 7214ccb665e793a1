// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Joining open chains end to end, as drawings of single lines and arcs need it: first where ends are the same grid
// point, then, where a gap is allowed, the nearest ends first. Over a gap the second end moves to the first. Where what
// stays open is taken for lines, chains that no closed outline can hold are set aside before.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <tuple>

#include "findspace/error.h"
#include "io/text/outline_shapes.h"
#include "io/text/quantity.h"
#include "plane/build/mended_rings.h"
#include "plane/contour/contour.h"

namespace findspace::io {
namespace {

using plane::Contour;
using plane::ContourEdge;
using plane::GridPoint;

/// An open chain the other way round: its end point comes first.
Chain reversed_chain(const Chain& chain) {
  Chain result{plane::reversed(chain.edges), chain.closed, {}, chain.name};
  std::rotate(result.edges.begin(), result.edges.begin() + 1, result.edges.end());
  if (chain.curves.empty()) return result;
  result.curves.resize(result.edges.size());
  const std::size_t last = chain.edges.size() - 1;
  for (std::size_t k = 0; k < last; ++k)
    if (chain.curves[k])
      result.curves[last - 1 - k] = std::make_shared<const plane::Curve>(plane::reversed(*chain.curves[k]));
  return result;
}

/// `piece` begins where `chain` ends.
void append(Chain& chain, Chain piece) {
  if (!quantity_in(chain.name) && (chain.name.empty() || quantity_in(piece.name))) chain.name = piece.name;
  if (!chain.curves.empty() || !piece.curves.empty()) {
    chain.curves.resize(chain.edges.size() - 1);
    piece.curves.resize(piece.edges.size());
    chain.curves.insert(chain.curves.end(), piece.curves.begin(), piece.curves.end());
  }
  chain.edges.pop_back();
  chain.edges.insert(chain.edges.end(), piece.edges.begin(), piece.edges.end());
}

void close_chain(Chain& chain) {
  chain.edges.pop_back();
  if (!chain.curves.empty()) chain.curves.pop_back();
  chain.closed = true;
}

/// What two chains that draw the same have in common, whatever their direction and first point.
std::vector<double> drawn_key(const Chain& chain) {
  auto key_of = [](const Chain& c) {
    std::vector<double> key{c.closed ? 1.0 : 0.0};
    const std::size_t n = c.edges.size();
    std::size_t first = 0;
    for (std::size_t k = 1; c.closed && k < n; ++k)
      if (c.edges[k].start < c.edges[first].start) first = k;
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t k = (first + i) % n;
      const ContourEdge& e = c.edges[k];
      key.insert(key.end(), {double(e.start.x), double(e.start.y)});
      if (e.arc) key.insert(key.end(), {e.ccw ? 1.0 : -1.0, e.arc->cx.to_double(), e.arc->cy.to_double()});
      if (c.curves.empty() || !c.curves[k]) continue;
      for (const plane::CurvePiece& piece : c.curves[k]->pieces)
        for (std::size_t p = 0; p < piece.x.size(); ++p)
          key.insert(key.end(), {std::round(piece.x[p].lo), std::round(piece.y[p].lo)});
    }
    return key;
  };
  Chain back = chain;
  if (chain.closed) {
    back.edges = plane::reversed(chain.edges);
    back.curves.clear();  // closed ones with curves are compared in their own direction alone
  } else {
    back = reversed_chain(chain);
  }
  if (chain.closed && !chain.curves.empty()) return key_of(chain);
  return std::min(key_of(chain), key_of(back));
}

/// Drops what is drawn twice: under the even-odd rule it would cancel out. How many were dropped.
std::size_t drop_doubled(Drawing& drawing) {
  std::set<std::vector<double>> seen;
  const std::size_t chains =
      std::erase_if(drawing.chains, [&](const Chain& c) { return !seen.insert(drawn_key(c)).second; });
  const std::size_t discs = std::erase_if(drawing.discs, [&](const Disc& d) {
    return !seen.insert({2, double(d.center.x), double(d.center.y), d.radius.to_double()}).second;
  });
  return chains + discs;
}

class Joiner {
 public:
  explicit Joiner(std::vector<Chain> chains) : chains_(std::move(chains)), used_(chains_.size(), false) {
    for (std::size_t i = 0; i < chains_.size(); ++i) {
      if (chains_[i].closed) continue;
      at_[chains_[i].edges.front().start].push_back(i);
      at_[chains_[i].edges.back().start].push_back(i);
    }
  }

  /// Where an odd number of ends meets, which belong together is open.
  void refuse_odd(double step) const {
    for (const auto& [point, chains] : at_) {
      if (chains.size() == 1 || chains.size() % 2 == 0) continue;  // by the even-odd rule it does not matter which join
      double x = double(point.x) * step, y = double(point.y) * step;
      throw Error(ErrorCode::kGeometry,
                  fmt::format("{} lines end at ({:.10g}, {:.10g}); which belong together is open", chains.size(), x, y))
          .at(x, y);
    }
  }

  std::vector<Chain> join() {
    std::vector<Chain> result;
    for (std::size_t i = 0; i < chains_.size(); ++i) {
      if (used_[i]) continue;
      used_[i] = true;
      Chain chain = std::move(chains_[i]);
      if (!chain.closed && !extend(chain)) {
        chain = reversed_chain(chain);
        extend(chain);
        chain = reversed_chain(chain);
      }
      result.push_back(std::move(chain));
    }
    return result;
  }

 private:
  /// Adds what follows the chain's last point, as far as it goes; true where it comes back to its first.
  bool extend(Chain& chain) {
    while (true) {
      GridPoint end = chain.edges.back().start;
      if (end == chain.edges.front().start) {
        close_chain(chain);
        return true;
      }
      const std::vector<std::size_t>& here = at_[end];
      auto next = std::find_if(here.begin(), here.end(), [&](std::size_t i) { return !used_[i]; });
      if (next == here.end()) return false;
      used_[*next] = true;
      Chain piece = std::move(chains_[*next]);
      if (piece.edges.front().start != end) piece = reversed_chain(piece);
      append(chain, std::move(piece));
    }
  }

  std::vector<Chain> chains_;
  std::vector<bool> used_;
  std::map<GridPoint, std::vector<std::size_t>> at_;
};

/// Takes out the open chains that no closed outline can hold: those with an end where no other ends, and what hangs on
/// these alone.
std::vector<Chain> take_hanging(std::vector<Chain>& chains) {
  struct Meeting {
    std::size_t chains = 0, sum = 0;  // how many end here, and the sum of their indices
  };
  std::map<GridPoint, Meeting> at;
  const auto ends_of = [&](std::size_t i) {
    return std::array{chains[i].edges.front().start, chains[i].edges.back().start};
  };
  for (std::size_t i = 0; i < chains.size(); ++i) {
    if (chains[i].closed) continue;
    for (const GridPoint& p : ends_of(i)) {
      ++at[p].chains;
      at[p].sum += i;
    }
  }
  std::vector<GridPoint> loose;
  for (const auto& [point, here] : at)
    if (here.chains == 1) loose.push_back(point);
  std::vector<bool> hangs(chains.size(), false);
  while (!loose.empty()) {
    const Meeting last = at[loose.back()];
    loose.pop_back();
    if (last.chains == 0) continue;  // the chain was taken from its other end
    hangs[last.sum] = true;
    for (const GridPoint& p : ends_of(last.sum)) {
      Meeting& here = at[p];
      here.sum -= last.sum;
      if (--here.chains == 1) loose.push_back(p);
    }
  }
  std::vector<Chain> hanging, kept;
  for (std::size_t i = 0; i < chains.size(); ++i) (hangs[i] ? hanging : kept).push_back(std::move(chains[i]));
  chains = std::move(kept);
  return hanging;
}

/// One end of an open chain.
struct End {
  std::size_t chain = 0;
  bool back = false;
};

/// Two ends and how far they are apart, in grid steps.
struct Gap {
  double width = 0;
  End a, b;
};

GridPoint end_place(const std::vector<Chain>& chains, const End& e) {
  const Contour& edges = chains[e.chain].edges;
  return (e.back ? edges.back() : edges.front()).start;
}

double distance(GridPoint a, GridPoint b) { return std::hypot(double(a.x - b.x), double(a.y - b.y)); }

std::vector<End> open_ends(const std::vector<Chain>& chains) {
  std::vector<End> ends;
  for (std::size_t i = 0; i < chains.size(); ++i) {
    if (chains[i].closed) continue;
    ends.push_back({i, false});
    ends.push_back({i, true});
  }
  return ends;
}

/// All pairs of ends of a width of at most `most`, the narrowest first; ends of one chain too.
std::vector<Gap> gaps_of(const std::vector<Chain>& chains, double most, ReadContext& context) {
  std::vector<std::pair<GridPoint, End>> sorted;
  for (const End& e : open_ends(chains)) sorted.emplace_back(end_place(chains, e), e);
  std::sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<Gap> gaps;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    for (std::size_t j = i + 1; j < sorted.size(); ++j) {
      context.work.charge(1, "ends that lie so near to each other");
      if (double(sorted[j].first.x - sorted[i].first.x) > most) break;
      const double width = distance(sorted[i].first, sorted[j].first);
      if (width <= most) gaps.push_back({width, sorted[i].second, sorted[j].second});
    }
  }
  std::stable_sort(gaps.begin(), gaps.end(), [](const Gap& a, const Gap& b) { return a.width < b.width; });
  return gaps;
}

bool is_large(const ContourEdge& e, GridPoint to) {
  const exact::Real turn = (e.arc->cx - exact::Real(e.start.x)) * exact::Real(to.y - e.start.y) -
                           (e.arc->cy - exact::Real(e.start.y)) * exact::Real(to.x - e.start.x);
  return turn.sign() == (e.ccw ? 1 : -1);
}

/// Moves an end; the edge there keeps its radius, a curve its other control points.
void move_end(Chain& chain, bool back, GridPoint place) {
  const std::size_t edge = back ? chain.edges.size() - 2 : 0;
  ContourEdge& e = chain.edges[edge];
  const GridPoint to = chain.edges[edge + 1].start;
  const GridPoint new_from = back ? e.start : place, new_to = back ? place : to;
  if (!chain.curves.empty() && chain.curves[edge]) {
    chain.curves[edge] = std::make_shared<const plane::Curve>(plane::with_ends(*chain.curves[edge], new_from, new_to));
  } else if (e.arc && new_from != new_to) {
    e = plane::radius_arc(new_from, new_to, e.arc->r, is_large(e, to), e.ccw);
  }
  chain.edges[edge].start = new_from;
  chain.edges[edge + 1].start = new_to;
}

/// Closes gaps by moving ends, each end once; the widest that was closed, and how many.
std::pair<Gap, std::size_t> close_gaps(std::vector<Chain>& chains, double most, ReadContext& context) {
  std::vector<std::array<bool, 2>> done(chains.size(), {false, false});
  Gap widest;
  std::size_t count = 0;
  for (const Gap& gap : gaps_of(chains, most, context)) {
    const auto [width, a, b] = gap;
    const bool short_chain = a.chain == b.chain && chains[a.chain].edges.size() == 2 && chains[a.chain].curves.empty();
    if (done[a.chain][a.back] || done[b.chain][b.back] || short_chain) continue;
    done[a.chain][a.back] = done[b.chain][b.back] = true;
    move_end(chains[b.chain], b.back, end_place(chains, a));
    widest = gap;
    ++count;
  }
  return {widest, count};
}

/// Drops open chains of segments that fit into a square of this side: CAD programs leave such lines behind.
std::size_t drop_debris(std::vector<Chain>& chains, double most) {
  return std::erase_if(chains, [&](const Chain& c) {
    if (c.closed || !c.curves.empty()) return false;
    const GridPoint from = c.edges[0].start;
    return std::all_of(c.edges.begin(), c.edges.end(), [&](const ContourEdge& e) {
      return !e.arc && std::abs(double(e.start.x - from.x)) <= most && std::abs(double(e.start.y - from.y)) <= most;
    });
  });
}

/// It runs out along a line, straight or not, and back, so that it goes round nothing.
bool runs_back(const Chain& c) {
  if (!c.curves.empty()) return false;
  exact::int128 twice = 0;  // the area between the chords
  const GridPoint from = c.edges[0].start;
  for (std::size_t k = 0; k < c.edges.size(); ++k) {
    const GridPoint p = c.edges[k].start, q = plane::end_of(c.edges, k);
    twice += exact::int128(p.x - from.x) * (q.y - from.y) - exact::int128(p.y - from.y) * (q.x - from.x);
  }
  return twice == 0 && plane::RingMender({&c.edges, 1}).winds_round_nothing();
}

/// Closed chains that run back on themselves become open ones.
void open_lines_there_and_back(std::vector<Chain>& chains) {
  for (Chain& c : chains) {
    if (!c.closed || !runs_back(c)) continue;
    c.edges.push_back(ContourEdge{.start = c.edges[0].start});
    c.closed = false;
  }
}

std::string point_text(GridPoint p, const ReadContext& context) { return context.point_text(double(p.x), double(p.y)); }

/// The chains that stay open, and the end of one that is nearest to another end.
[[noreturn]] void refuse_open(const std::vector<Chain>& chains, const ReadContext& context) {
  const std::vector<End> ends = open_ends(chains);
  const double step = context.grid.step_size();
  constexpr double kFar = double(Grid::kLimit);
  constexpr std::size_t kMany = 2000;  // ends; for more of them no gap is sought
  double least = kFar;
  if (ends.size() <= kMany) {
    for (std::size_t i = 0; i < ends.size(); ++i)
      for (std::size_t j = i + 1; j < ends.size(); ++j)
        least = std::min(least, distance(end_place(chains, ends[i]), end_place(chains, ends[j])));
  }
  const GridPoint from = end_place(chains, ends[0]), to = end_place(chains, ends[1]);
  std::string message = fmt::format(
      "{} open, {}from {} to {}", ends.size() == 2 ? "an outline is" : fmt::format("{} outlines are", ends.size() / 2),
      ends.size() == 2 ? "" : "the first ", point_text(from, context), point_text(to, context));
  if (least < kFar) message += fmt::format("; the narrowest gap is {}", context.length_text(least));
  message += "; --join closes gaps up to a width, --open-lines takes what is open for lines";
  throw Error(ErrorCode::kGeometry, message).at(double(from.x) * step, double(from.y) * step);
}

}  // namespace

void join_open_chains(Drawing& drawing, double step) {
  Joiner joiner(std::move(drawing.chains));
  joiner.refuse_odd(step);
  drawing.chains = joiner.join();
}

bool is_point(const Chain& c) {
  return c.curves.empty() && std::all_of(c.edges.begin(), c.edges.end(),
                                         [&](const ContourEdge& e) { return !e.arc && e.start == c.edges[0].start; });
}

int open_chains(const Drawing& drawing) {
  return static_cast<int>(
      std::count_if(drawing.chains.begin(), drawing.chains.end(), [](const Chain& c) { return !c.closed; }));
}

void close_outlines(Drawing& drawing, ReadContext& context, const std::string& name) {
  const double step = context.grid.step_size();
  context.repeated_points += std::int64_t(std::erase_if(drawing.chains, is_point));
  if (const std::size_t doubled = drop_doubled(drawing); doubled > 0)
    context.notes.push_back(fmt::format("{}: {} drawn twice, taken once", name,
                                        doubled == 1 ? "1 outline is" : fmt::format("{} outlines are", doubled)));
  if (context.drawing.join > 0) {
    drawing.chains = Joiner(std::move(drawing.chains)).join();
    const auto [widest, count] = close_gaps(drawing.chains, context.drawing.join, context);
    if (count > 0)
      context.notes.push_back(
          fmt::format("{}: {} closed, the widest {} at {}", name, count == 1 ? "1 gap" : fmt::format("{} gaps", count),
                      context.length_text(widest.width), point_text(end_place(drawing.chains, widest.a), context)));
  }
  std::vector<Chain> hanging;
  if (context.drawing.open_lines) hanging = Joiner(take_hanging(drawing.chains)).join();
  join_open_chains(drawing, step);
  std::move(hanging.begin(), hanging.end(), std::back_inserter(drawing.chains));
  if (const std::size_t debris = drop_debris(drawing.chains, context.drawing.join); debris > 0)
    context.notes.push_back(fmt::format("{}: {} no longer than the gaps that are closed, left out", name,
                                        debris == 1 ? "1 open line is" : fmt::format("{} open lines are", debris)));
  if (context.drawing.open_lines) open_lines_there_and_back(drawing.chains);
  const int open = open_chains(drawing);
  if (open == 0) return;
  if (!context.drawing.open_lines) refuse_open(drawing.chains, context);
  context.notes.push_back(fmt::format("{}: {} open {} read as {}, without an inside", name, open,
                                      open == 1 ? "outline is" : "outlines are",
                                      open == 1 ? "a polyline" : "polylines"));
}

}  // namespace findspace::io
