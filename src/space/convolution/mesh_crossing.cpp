// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/convolution/mesh_crossing.h"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "plane/base/parallel.h"
#include "space/convolution/ray_overlap.h"

namespace findspace::space {
namespace {

constexpr std::size_t kFacesAtOnce = 4096;  // from here on in several threads
constexpr std::size_t kTasks = 256;         // at least, from there on: fewer than such a mesh has leaves

/// How many corners two faces share, and where the last of them is in each.
struct SharedCorners {
  int count = 0, in_f = 0, in_g = 0;
};

SharedCorners shared_corners(const RayBody& body, int f, int g) {
  const auto &p = body.faces[static_cast<std::size_t>(f)], &q = body.faces[static_cast<std::size_t>(g)];
  SharedCorners out;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      if (p[static_cast<std::size_t>(i)] == q[static_cast<std::size_t>(j)]) out = {out.count + 1, i, j};
  return out;
}

/// Whether face f, from its corner k in the plane of face g, lies on one side of that plane.
bool beside(const RayBody& body, int f, int k, int g) {
  const auto side = [&](int corner) {
    return exact::sign_volume(body.corner(g, 0), body.corner(g, 1), body.corner(g, 2), body.corner(f, corner % 3));
  };
  return side(k + 1) * side(k + 2) > 0;
}

bool cross(const RayBody& body, int f, int g) {
  const SharedCorners shared = shared_corners(body, f, g);
  if (shared.count > 1) return false;  // the faces about an edge were put in order
  if (shared.count == 1 && (beside(body, f, shared.in_f, g) || beside(body, g, shared.in_g, f))) return false;
  return faces_overlap(body, f, body, g, RayPlace{{}, {0, 1}});
}

/// Two nodes of the tree, or one twice: the pairs of faces below them.
struct NodePair {
  int p, q;
};

/// The pairs of faces whose boxes meet, each once.
class MeetingPairs {
 public:
  explicit MeetingPairs(const BoxTree& tree) : tree_(tree) {}

  /// The pairs of nodes below these, of which one at least is no leaf.
  void part(const NodePair& pair, std::vector<NodePair>& out) const {
    const auto [p, q] = pair;
    const BoxTree::Node &x = node(p), &y = node(q);
    if (p == q) {
      for (const NodePair& below : {NodePair{x.first, x.first}, {x.first + 1, x.first + 1}, {x.first, x.first + 1}})
        out.push_back(below);
    } else if (x.count == 0 && (y.count > 0 || extent(x) >= extent(y))) {
      out.insert(out.end(), {{x.first, q}, {x.first + 1, q}});
    } else {
      out.insert(out.end(), {{p, y.first}, {p, y.first + 1}});
    }
  }
  bool apart(const NodePair& pair) const { return !node(pair.p).box.meets(node(pair.q).box); }
  bool leaves(const NodePair& pair) const { return node(pair.p).count > 0 && node(pair.q).count > 0; }

  template <class Visit>
  void each(const NodePair& leaves, Visit visit) const {
    const BoxTree::Node &x = node(leaves.p), &y = node(leaves.q);
    for (int i = x.first; i < x.first + x.count; ++i) {
      for (int j = leaves.p == leaves.q ? i + 1 : y.first; j < y.first + y.count; ++j)
        if (tree_.box(i).meets(tree_.box(j))) visit(std::minmax({tree_.face(i), tree_.face(j)}));
    }
  }

 private:
  const BoxTree::Node& node(int k) const { return tree_.nodes()[static_cast<std::size_t>(k)]; }
  static std::int64_t extent(const BoxTree::Node& n) { return n.box.high.x - n.box.low.x; }

  const BoxTree& tree_;
};

using FacePair = std::pair<int, int>;
constexpr FacePair kNoFaces{std::numeric_limits<int>::max(), 0};

struct Found {
  FacePair least_crossing = kNoFaces;
  bool inner_walls = false;
};

/// Of the pairs below.
Found find(const RayBody& body, const MeetingPairs& pairs, const NodePair& of) {
  Found found;
  std::vector<NodePair> stack{of};
  while (!stack.empty()) {
    const NodePair top = stack.back();
    stack.pop_back();
    if (pairs.apart(top)) continue;
    if (!pairs.leaves(top)) {
      pairs.part(top, stack);
      continue;
    }
    pairs.each(top, [&](const FacePair& faces) {
      const auto [f, g] = faces;
      if (faces < found.least_crossing && cross(body, f, g)) found.least_crossing = faces;
      found.inner_walls = found.inner_walls || faces_back_to_back(body, f, g);
    });
  }
  return found;
}

}  // namespace

SelfContact self_contact(const RaySheet& sheet) {
  const RayBody& body = sheet.body;
  const MeetingPairs pairs(sheet.tree);
  std::vector<NodePair> parted{{0, 0}}, next;
  while (parted.size() < kTasks && body.faces.size() >= kFacesAtOnce) {
    next.clear();
    for (const NodePair& pair : parted) {
      if (pairs.leaves(pair))
        next.push_back(pair);
      else if (!pairs.apart(pair))
        pairs.part(pair, next);
    }
    parted.swap(next);
  }
  std::vector<Found> found(parted.size());
  plane::at_once(parted.size(), body.faces.size(), kFacesAtOnce,
                 [&](std::size_t k) { found[k] = find(body, pairs, parted[k]); });
  SelfContact out;
  FacePair first = kNoFaces;
  for (const Found& part : found) {
    first = std::min(first, part.least_crossing);
    out.inner_walls = out.inner_walls || part.inner_walls;
  }
  if (first != kNoFaces) out.crossing = {first.first, first.second};
  return out;
}

}  // namespace findspace::space
