// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "planning/planar/pair_system.h"

#include <algorithm>
#include <array>
#include <utility>

#include "plane/complex/overlay.h"
#include "plane/offset/plain_sum.h"
#include "plane/query/moved.h"
#include "plane/query/topology.h"
#include "plane/sum/minkowski.h"
#include "plane/walk/unite.h"
#include "planning/order/convex_cells.h"
#include "planning/planar/cell_search.h"

namespace findspace::planning {

using exact::RealPoint;
using plane::CellComplex;
using plane::Region;

namespace {

constexpr std::size_t kMostPoints = 256;  // positions of a body that are branched on
constexpr int kRounds = 3;                // of the filter, where it does not end by itself

using Pair = std::pair<std::size_t, std::size_t>;

Region both(const Region& a, const Region& b) {
  std::array<const Region*, 2> operands{&a, &b};
  return plane::intersect(operands);
}

Region either(const Region& a, const Region& b) {
  std::array<const Region*, 2> operands{&a, &b};
  return plane::unite(operands);
}

/// The points of a set of finitely many points.
std::optional<std::vector<RealPoint>> as_points(const Region& r) {
  if (!r.edges.empty() || r.faces[0].mark > 0 || r.vertices.size() > kMostPoints) return std::nullopt;
  std::vector<RealPoint> out;
  for (const plane::Vertex& v : r.vertices) out.push_back(r.geometry.exact(v.point));
  return out;
}

class Projector {
 public:
  Projector(PairSystem system, const Limit& limit) : s_(std::move(system)), limit_(limit) {}

  Projections run() {
    std::erase_if(s_.between, [](const auto& b) { return plane::is_whole(b.second); });
    out_.positions = s_.own;
    if (nothing()) return empty();
    find_components();
    for (const auto& members : components_) {
      if (!solve(members)) return empty();
    }
    if (!out_.exact) {
      // Something undecided: of the other components nothing is certain either.
      for (Region& r : out_.positions)
        if (undecided_empty_) r = CellComplex::uniform(0);
    }
    return std::move(out_);
  }

 private:
  std::size_t size() const { return s_.own.size(); }

  bool nothing() const {
    return std::any_of(out_.positions.begin(), out_.positions.end(), plane::is_empty) ||
           std::any_of(s_.between.begin(), s_.between.end(), [](const auto& b) { return plane::is_empty(b.second); });
  }

  Projections empty() const {
    Projections none;
    none.positions.assign(size(), CellComplex::uniform(0));
    return none;
  }

  void find_components() {
    std::vector<std::size_t> mark(size());
    for (std::size_t i = 0; i < size(); ++i) mark[i] = i;
    for (bool changed = true; changed;) {
      changed = false;
      for (const auto& [pair, region] : s_.between) {
        const std::size_t low = std::min(mark[pair.first], mark[pair.second]);
        changed = changed || mark[pair.first] != low || mark[pair.second] != low;
        mark[pair.first] = mark[pair.second] = low;
      }
    }
    for (std::size_t root = 0; root < size(); ++root) {
      std::vector<std::size_t> members;
      for (std::size_t i = 0; i < size(); ++i)
        if (mark[i] == root) members.push_back(i);
      if (!members.empty()) components_.push_back(std::move(members));
    }
  }

  std::vector<Pair> edges_of(const std::vector<std::size_t>& members) const {
    std::vector<Pair> out;
    for (const auto& [pair, region] : s_.between)
      if (std::find(members.begin(), members.end(), pair.first) != members.end()) out.push_back(pair);
    return out;
  }

  /// P_to <- P_to and what the pair leaves to it over all of P_from. False: it is empty.
  bool narrow(std::size_t from, std::size_t to, bool* changed = nullptr) {
    const Region& n = s_.between.at(std::minmax(from, to));
    // p_i - p_j in N for i < j: p_i in P_j (+) N, p_j in P_i (+) -N.
    const Region reach = plane::plain_sum(out_.positions[from], to < from ? n : plane::mirrored(n));
    Region now = both(out_.positions[to], reach);
    if (changed != nullptr) {
      std::array<const Region*, 2> difference{&out_.positions[to], &now};
      *changed = *changed || !plane::is_empty(plane::subtract(difference));
    }
    out_.positions[to] = std::move(now);
    return !plane::is_empty(out_.positions[to]);
  }

  /// False: no placement.
  bool solve(const std::vector<std::size_t>& members) {
    const std::vector<Pair> edges = edges_of(members);
    if (edges.size() + 1 == members.size()) return solve_tree(members);
    for (int round = 0; round < kRounds; ++round) {
      if (branch_if_finite(members)) return finite_found_;
      bool changed = false;
      for (const Pair& e : edges)
        if (!narrow(e.first, e.second, &changed) || !narrow(e.second, e.first, &changed)) return false;
      if (!changed) break;
    }
    if (branch_if_finite(members)) return finite_found_;
    return search(members);
  }

  /// From the leaves to the root and back.
  bool solve_tree(const std::vector<std::size_t>& members) {
    std::vector<Pair> order;  // (child, parent), parents first
    std::vector<std::size_t> reached{members[0]};
    for (std::size_t k = 0; k < reached.size(); ++k)
      for (std::size_t i : members)
        if (std::find(reached.begin(), reached.end(), i) == reached.end() &&
            s_.between.count(std::minmax(i, reached[k])) != 0) {
          order.push_back({i, reached[k]});
          reached.push_back(i);
        }
    for (auto e = order.rbegin(); e != order.rend(); ++e)
      if (!narrow(e->first, e->second)) return false;
    for (const Pair& e : order)
      if (!narrow(e.second, e.first)) return false;
    return true;
  }

  /// The system of some bodies, numbered anew; their sets as narrowed so far.
  PairSystem part(const std::vector<std::size_t>& members) const {
    PairSystem out;
    for (std::size_t i : members) out.own.push_back(out_.positions[i]);
    for (std::size_t a = 0; a < members.size(); ++a)
      for (std::size_t b = a + 1; b < members.size(); ++b)
        if (auto n = s_.between.find({members[a], members[b]}); n != s_.between.end())
          out.between.emplace(Pair{a, b}, n->second);
    return out;
  }

  /// Where a body has finitely many positions: the union over them of what is left of the others.
  bool branch_if_finite(const std::vector<std::size_t>& members) {
    std::optional<std::vector<RealPoint>> points;
    std::size_t chosen = 0;
    for (std::size_t i : members)
      if (auto p = as_points(out_.positions[i]); p && (!points || p->size() < points->size())) {
        points = std::move(p);
        chosen = i;
      }
    if (!points) return false;
    std::vector<std::size_t> others;
    std::copy_if(members.begin(), members.end(), std::back_inserter(others),
                 [&](std::size_t i) { return i != chosen; });
    std::vector<Region> sums(members.size(), CellComplex::uniform(0));
    finite_found_ = false;
    bool unknown = false;
    for (const RealPoint& q : *points) {
      PairSystem rest = part(others);
      for (std::size_t k = 0; k < others.size(); ++k)
        if (auto n = s_.between.find(std::minmax(chosen, others[k])); n != s_.between.end())
          rest.own[k] = both(rest.own[k], left_by(n->second, q, chosen < others[k]));
      Projections found = project(std::move(rest), limit_);
      if (!found.exact) {
        out_.exact = false;
        out_.reason = found.reason;
        unknown = true;
      }
      if (plane::is_empty(found.positions[0])) continue;
      finite_found_ = true;
      for (std::size_t m = 0, k = 0; m < members.size(); ++m)
        sums[m] = either(sums[m], members[m] == chosen ? convex_region(std::span(&q, 1), true) : found.positions[k++]);
    }
    for (std::size_t m = 0; m < members.size(); ++m) out_.positions[members[m]] = std::move(sums[m]);
    undecided_empty_ = undecided_empty_ || (unknown && !finite_found_);
    finite_found_ = finite_found_ || unknown;
    return true;
  }

  bool search(const std::vector<std::size_t>& members) {
    const auto give_up = [&](const std::string& reason) {
      out_.exact = false;
      out_.reason = reason;
      undecided_empty_ = true;
      return true;
    };
    // The sets as given: the narrowed ones have more cells and no other solutions.
    PairSystem system = part(members);
    for (std::size_t k = 0; k < members.size(); ++k) {
      system.own[k] = s_.own[members[k]];
      if (!plane::is_bounded(system.own[k]))
        return give_up("a shape that no condition bounds is joined with others in a ring of conditions");
      if (!is_straight(system.own[k])) return give_up(kArcs);
    }
    for (auto& [pair, region] : system.between) {
      if (is_straight(region)) continue;
      // Only differences of possible positions matter; often no arc is among them.
      region = both(region, plane::plain_sum(system.own[pair.first], plane::mirrored(system.own[pair.second])));
      if (!is_straight(region)) return give_up(kArcs);
    }
    Projections found = search_cells(system, limit_);
    if (!found.exact) {
      out_.exact = false;
      out_.reason = found.reason;
    }
    const bool none = plane::is_empty(found.positions[0]);
    undecided_empty_ = undecided_empty_ || (none && !found.exact);
    for (std::size_t k = 0; k < members.size(); ++k) out_.positions[members[k]] = std::move(found.positions[k]);
    return !none || !found.exact;
  }

  static constexpr const char* kArcs =
      "a ring of conditions with circular boundaries on three or more shapes is not decided exactly";

  PairSystem s_;
  const Limit& limit_;
  std::vector<std::vector<std::size_t>> components_;
  Projections out_;
  bool finite_found_ = false, undecided_empty_ = false;
};

}  // namespace

Region left_by(const Region& between, const RealPoint& q, bool first) {
  // First: q - p in N, p in q - N. Else p - q in N, p in q + N.
  return plane::moved(first ? plane::mirrored(between) : between, q);
}

Projections project(PairSystem system, const Limit& limit) { return Projector(std::move(system), limit).run(); }

}  // namespace findspace::planning
