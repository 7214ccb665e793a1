// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/rays/piece_rays.h"

#include <algorithm>
#include <utility>

#include "plane/base/parallel.h"

namespace findspace::space {
namespace {

using exact::Real;

/// The units of parallel work.
constexpr std::size_t kBlock = 64;

template <class Each>
void in_blocks(std::size_t count, Each each) {
  plane::parallel_for((count + kBlock - 1) / kBlock, [&](std::size_t block) {
    for (std::size_t k = block * kBlock; k < std::min(count, (block + 1) * kBlock); ++k) each(k);
  });
}

}  // namespace

PieceRays::PieceRays(const std::vector<LinePiece>& pieces, std::int64_t scale, const RayGrid& grid, Of of)
    : grid_(grid), of_(of), pieces_(pieces.size()) {
  in_blocks(pieces.size(), [&](std::size_t k) { pieces_[k] = aligned(pieces[k], scale); });
  list_rows();
}

PieceRays::PieceRays(std::size_t count, const Maker& piece, std::int64_t scale, const RayGrid& grid, Of of)
    : grid_(grid), of_(of), pieces_(count) {
  in_blocks(count, [&](std::size_t k) { pieces_[k] = aligned(piece(k), scale); });
  list_rows();
}

/// Which pieces may meet the lines of each row.
void PieceRays::list_rows() {
  first_.assign(static_cast<std::size_t>(grid_.nv) + 1, 0);
  for (const Piece& p : pieces_) {
    for (int j = p.lines.first_row; j <= p.lines.last_row; ++j) ++first_[static_cast<std::size_t>(j) + 1];
  }
  for (int j = 0; j < grid_.nv; ++j) first_[static_cast<std::size_t>(j) + 1] += first_[static_cast<std::size_t>(j)];
  of_row_.resize(first_.back());
  std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
  for (std::size_t k = 0; k < pieces_.size(); ++k) {
    for (int j = pieces_[k].lines.first_row; j <= pieces_[k].lines.last_row; ++j)
      of_row_[next[static_cast<std::size_t>(j)]++] = static_cast<int>(k);
  }
}

int PieceRays::compare_ends(const End& a, const End& b, int i, int j) const {
  const double gap = a.value - b.value, blur = (a.error + b.error) * 2;
  if (a.piece < 0 || b.piece < 0) return a.value < b.value ? -1 : a.value > b.value ? 1 : 0;
  if (gap > blur) return 1;
  if (gap < -blur) return -1;
  if (a.piece == b.piece && a.which == b.which) return 0;
  return exact::compare(root(a.piece, a.which, i, j), root(b.piece, b.which, i, j));
}

RayPosition PieceRays::position(const End& e, int i, int j) const {
  RayPosition at;
  at.value = e.value;
  at.radius = e.error;
  at.roots = this;
  at.patch = e.piece;
  at.which = e.which;
  at.i = i;
  at.j = j;
  return at;
}

/// Whether a comes before b, by doubles alone.
bool PieceRays::surely_before(const End& a, const End& b) { return b.value - a.value > (a.error + b.error) * 2; }

/// Puts chains of stretches that surely overlap in their insides in the place of what lies surely inside them: then
/// most ends that are the same place need not be compared, as where the slabs of two polygons meet within the cylinder
/// about their common edge.
void PieceRays::join_sure(std::vector<Stretch>& all) {
  std::stable_sort(all.begin(), all.end(),
                   [](const Stretch& a, const Stretch& b) { return a.low.value < b.low.value; });
  std::vector<Stretch> chains;
  for (const Stretch& s : all) {
    if (!s.inside) continue;
    if (chains.empty() || !surely_before(s.low, chains.back().high) || !surely_before(chains.back().low, s.high))
      chains.push_back(s);
    else if (s.high.value > chains.back().high.value)
      chains.back().high = s.high;
  }
  std::size_t k = 0;
  std::erase_if(all, [&](const Stretch& s) {
    while (k + 1 < chains.size() && chains[k + 1].low.value <= s.low.value) ++k;
    return !chains.empty() && surely_before(chains[k].low, s.low) && surely_before(s.high, chains[k].high);
  });
  all.insert(all.end(), chains.begin(), chains.end());
}

/// Disjoint, in order: of the closed stretches, or of the inner ones of those with an inside.
std::vector<PieceRays::Stretch> PieceRays::united(std::vector<Stretch> all, bool open, int i, int j) const {
  if (all.size() > 2) join_sure(all);
  if (open) std::erase_if(all, [](const Stretch& s) { return !s.inside; });
  if (!open) {
    for (Stretch& s : all) s.low.held = s.high.held = true;
  }
  // Of those that begin together one that holds the place comes first: so it joins what ended there without it.
  std::stable_sort(all.begin(), all.end(), [&](const Stretch& a, const Stretch& b) {
    const int order = compare_ends(a.low, b.low, i, j);
    return order != 0 ? order < 0 : a.low.held && !b.low.held;
  });
  std::vector<Stretch> out;
  for (const Stretch& s : all) {
    const int gap = out.empty() ? 1 : compare_ends(s.low, out.back().high, i, j);
    if (gap > 0 || (gap == 0 && !s.low.held && !out.back().high.held)) {
      out.push_back(s);
      continue;
    }
    Stretch& last = out.back();
    const int order = compare_ends(s.high, last.high, i, j);
    if (order > 0) last.high = s.high;
    if (order == 0) last.high.held = last.high.held || s.high.held;
  }
  return out;
}

std::vector<PieceRays::Stretch> PieceRays::common(const std::vector<Stretch>& all, bool open, int i, int j) const {
  if (all.size() < pieces_.size()) return {};
  Stretch both{{-exact::kInfinity, 0, -1, 0}, {exact::kInfinity, 0, -1, 0}, true};
  for (const Stretch& s : all) {
    if (open && !s.inside) return {};
    if (compare_ends(s.low, both.low, i, j) > 0) both.low = s.low;
    if (compare_ends(s.high, both.high, i, j) < 0) both.high = s.high;
  }
  const int width = compare_ends(both.high, both.low, i, j);
  if (width < 0 || (open && width == 0)) return {};
  both.low.held = both.high.held = !open;
  return {both};
}

void PieceRays::put(const std::vector<Stretch>& stretches, int i, int j, RayRow& row) const {
  const auto in = static_cast<std::int8_t>(-1), out = static_cast<std::int8_t>(1);
  row.before.push_back(!stretches.empty() && stretches[0].low.piece < 0 ? in : out);
  for (std::size_t k = 0; k < stretches.size(); ++k) {
    const Stretch& s = stretches[k];
    // Two may meet in a place that neither holds, one may be a single place.
    const bool meets_before = k > 0 && compare_ends(s.low, stretches[k - 1].high, i, j) == 0;
    if (s.low.piece >= 0 && !meets_before) row.events.push_back({position(s.low, i, j), s.low.held ? in : out, in});
    if (s.high.piece < 0) continue;
    if (compare_ends(s.low, s.high, i, j) == 0) {
      row.events.back().after = out;
      continue;
    }
    const bool meets_next = k + 1 < stretches.size() && compare_ends(s.high, stretches[k + 1].low, i, j) == 0;
    row.events.push_back({position(s.high, i, j), s.high.held ? in : out, meets_next ? in : out});
  }
  row.first.push_back(static_cast<int>(row.events.size()));
}

std::span<const int> PieceRays::of_row(int j) const {
  const std::size_t from = first_[static_cast<std::size_t>(j)], to = first_[static_cast<std::size_t>(j) + 1];
  return std::span(of_row_).subspan(from, to - from);
}

/// What the lines of a row meet, one line after the other. Of a union without pieces that lie between places which
/// others surely hold; so those that held the line before are asked first.
class PieceRays::RowStretches {
 public:
  RowStretches(const PieceRays& rays, int j)
      : rays_(rays), j_(j), pieces_(rays.of_row(j)), asked_(pieces_.size(), -1) {}

  const std::vector<Stretch>& on(int i) {
    all_.clear();
    held_.clear();
    std::vector<std::size_t> first;
    first.swap(holding_);
    for (const std::size_t k : first) ask(k, i);
    for (std::size_t k = 0; k < pieces_.size(); ++k) ask(k, i);
    std::sort(all_.begin(), all_.end(), [](const Stretch& a, const Stretch& b) { return a.piece < b.piece; });
    return all_;
  }

 private:
  struct Held {
    double low, high;
  };

  void ask(std::size_t k, int i) {
    const Piece& p = rays_.pieces_[static_cast<std::size_t>(pieces_[k])];
    if (std::exchange(asked_[k], i) == i) return;
    const auto around = [&](const Held& h) { return h.low < p.low && p.high < h.high; };
    if (rays_.of_ == Of::kUnion && std::any_of(held_.begin(), held_.end(), around)) return;
    Stretch s;
    if (!rays_.stretch(pieces_[k], i, j_, s)) return;
    all_.push_back(s);
    if (s.inside && hold({s.low.value + 4 * s.low.error, s.high.value - 4 * s.high.error})) holding_.push_back(k);
  }

  /// False if nothing new is held.
  bool hold(Held more) {
    const auto within = [&](const Held& h) { return h.low <= more.low && more.high <= h.high; };
    if (!(more.low < more.high) || std::any_of(held_.begin(), held_.end(), within)) return false;
    std::erase_if(held_, [&](const Held& h) {
      const bool joined = h.low < more.high && more.low < h.high;
      if (joined) more = {std::min(h.low, more.low), std::max(h.high, more.high)};
      return joined;
    });
    held_.push_back(more);
    return true;
  }

  const PieceRays& rays_;
  int j_;
  std::span<const int> pieces_;
  std::vector<int> asked_;            // the last line on which each was
  std::vector<std::size_t> holding_;  // of the pieces, those that held more of the last line
  std::vector<Held> held_;            // of the line; apart from each other
  std::vector<Stretch> all_;
};

exact::Tried<RayRow> PieceRays::try_row(int j) const {
  std::array<RayRow, 2> rows;  // the open set, the closed one
  RowStretches lines(*this, j);
  for (int i = 0; i < grid_.nu; ++i) {
    const std::vector<Stretch>& all = lines.on(i);
    for (const bool open : {true, false})
      put(of_ == Of::kUnion ? united(all, open, i, j) : common(all, open, i, j), i, j, rows[open ? 0 : 1]);
  }
  return combined(rows, [](std::span<const std::int8_t> s) {
    return static_cast<std::int8_t>(s[0] < 0 ? -1 : s[1] < 0 ? 0 : 1);
  });
}

}  // namespace findspace::space
