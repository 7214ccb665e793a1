// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/convolution/mesh_crossing.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <limits>
#include <string_view>
#include <utility>
#include <vector>

#include "plane/base/allowed_work.h"
#include "plane/base/parallel.h"
#include "space/convolution/ray_overlap.h"
#include "space/mesh/parting_plane.h"

namespace findspace::space {
namespace {

constexpr std::size_t kFacesAtOnce = 4096;  // from here on in several threads
constexpr int kFacesOfBlock = 64;           // faces that are looked at with those of another block
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

bool cross(const RayBody& body, int f, int g, const SharedCorners& shared) {
  if (shared.count > 1) return false;  // the faces about an edge were put in order
  if (shared.count == 1 && (beside(body, f, shared.in_f, g) || beside(body, g, shared.in_g, f))) return false;
  return faces_overlap(body, f, body, g, RayPlace{{}, {0, 1}});
}

/// Faces that have a corner, and the box about their other corners as seen from it.
class Fan {
 public:
  Fan() = default;
  /// A face from its corner k.
  Fan(const RayBody& body, int face, int k) : corner_(body.faces[static_cast<std::size_t>(face)][std::size_t(k)]) {
    const Point one = body.corner(face, (k + 1) % 3) - body.corner(face, k),
                two = body.corner(face, (k + 2) % 3) - body.corner(face, k);
    low_ = {std::min(one.x, two.x), std::min(one.y, two.y), std::min(one.z, two.z)};
    high_ = {std::max(one.x, two.x), std::max(one.y, two.y), std::max(one.z, two.z)};
  }
  static constexpr int kNone = -1;
  int corner() const { return corner_; }

  /// Of two fans of one corner.
  static Fan united(const Fan& f, const Fan& g) {
    Fan out = f;
    for (std::size_t k = 0; k < 3; ++k) {
      out.low_[k] = std::min(f.low_[k], g.low_[k]);
      out.high_[k] = std::max(f.high_[k], g.high_[k]);
    }
    return out;
  }

  /// Whether the faces of two fans surely meet in one corner alone: a plane through it parts the boxes.
  static bool apart(const Fan& f, const Fan& g) {
    if (f.corner_ == kNone || f.corner_ != g.corner_) return false;
    for (std::size_t i = 0; i < 3; ++i) {
      if ((f.low_[i] > 0 && g.high_[i] <= 0) || (g.low_[i] > 0 && f.high_[i] <= 0)) return true;
      if ((f.high_[i] < 0 && g.low_[i] >= 0) || (g.high_[i] < 0 && f.low_[i] >= 0)) return true;
      for (const std::size_t j : {(i + 1) % 3, (i + 2) % 3})
        if (less_steep(f, g, i, j) || less_steep(g, f, i, j)) return true;
    }
    return false;
  }

 private:
  /// Whether coordinate j grows less with coordinate i, away from 0, wherever f is than wherever g is.
  static bool less_steep(const Fan& f, const Fan& g, std::size_t i, std::size_t j) {
    const bool above = f.low_[i] > 0 && g.low_[i] > 0;
    if (!above && !(f.high_[i] < 0 && g.high_[i] < 0)) return false;
    const auto near = [&](const Fan& x) { return above ? x.low_[i] : -x.high_[i]; };
    const auto far = [&](const Fan& x) { return above ? x.high_[i] : -x.low_[i]; };
    const std::int64_t most = f.high_[j], least = g.low_[j];
    return int128(most) * (least >= 0 ? far(g) : near(g)) < int128(least) * (most >= 0 ? near(f) : far(f));
  }

  int corner_ = kNone;
  std::array<std::int64_t, 3> low_{}, high_{};
};

/// The box about points, and for each of its sides the box about those of them that lie in it.
class ContactBoxes {
 public:
  explicit ContactBoxes(const Point& p) : all_{{p.x, p.y, p.z}, {p.x, p.y, p.z}} { in_.fill(all_); }
  ContactBoxes(const RayBody& body, int face) : ContactBoxes(body.corner(face, 0)) {
    unite(ContactBoxes(body.corner(face, 1)));
    unite(ContactBoxes(body.corner(face, 2)));
  }

  void unite(const ContactBoxes& other) {
    for (std::size_t k = 0; k < 3; ++k) {
      unite_side(k, other, other.all_.low[k] < all_.low[k], other.all_.low[k] == all_.low[k]);
      unite_side(k + 3, other, other.all_.high[k] > all_.high[k], other.all_.high[k] == all_.high[k]);
    }
    all_.unite(other.all_);
  }

  /// Whether triangles with their corners in these boxes surely do not meet. In boxes that touch what lies in the
  /// common side can meet.
  static bool apart(const ContactBoxes& f, const ContactBoxes& g) {
    if (!f.all_.meets(g.all_)) return true;
    for (std::size_t k = 0; k < 3; ++k) {
      if (f.all_.high[k] == g.all_.low[k] && !f.in_[k + 3].meets(g.in_[k])) return true;
      if (g.all_.high[k] == f.all_.low[k] && !g.in_[k + 3].meets(f.in_[k])) return true;
    }
    return false;
  }

 private:
  struct Box {
    std::array<std::int64_t, 3> low, high;
    void unite(const Box& other) {
      for (std::size_t k = 0; k < 3; ++k) {
        low[k] = std::min(low[k], other.low[k]);
        high[k] = std::max(high[k], other.high[k]);
      }
    }
    bool meets(const Box& other) const {
      for (std::size_t k = 0; k < 3; ++k)
        if (high[k] < other.low[k] || other.high[k] < low[k]) return false;
      return true;
    }
  };

  void unite_side(std::size_t side, const ContactBoxes& other, bool farther, bool same) {
    if (farther) in_[side] = other.in_[side];
    if (same) in_[side].unite(other.in_[side]);
  }

  Box all_;
  std::array<Box, 6> in_;  // the sides of low x, y, z, then those of high
};

/// The fans that fill nodes of the tree: many faces about one corner meet there, box by box.
class Fans {
 public:
  explicit Fans(const RaySheet& sheet) : about_(sheet.body.points.size()) {
    const RayBody& body = sheet.body;
    for (const auto& face : body.faces)
      for (const int corner : face) ++about_[static_cast<std::size_t>(corner)];
    if (std::none_of(about_.begin(), about_.end(), [](int faces) { return faces >= kMany; })) return;
    const std::vector<BoxTree::Node>& nodes = sheet.tree.nodes();
    groups_.resize(nodes.size());
    for (std::size_t k = nodes.size(); k-- > 0;)  // those below stand behind
      groups_[k] = nodes[k].count == 0 ? groups_below(nodes[k].first) : groups_of_faces(sheet, nodes[k]);
  }

  /// Whether the faces of two nodes surely meet in one corner alone, if at all.
  bool apart(int p, int q) const {
    if (groups_.empty()) return false;
    const Groups &of_p = groups_[static_cast<std::size_t>(p)], &of_q = groups_[static_cast<std::size_t>(q)];
    if (of_p.empty() || of_q.empty()) return false;
    for (const Group& f : of_p)
      for (const Group& g : of_q)
        if (!Fan::apart(f.fan, g.fan) && !ContactBoxes::apart(f.sides, g.sides)) return false;
    return true;
  }

 private:
  static constexpr int kMany = 32;             // faces about a corner
  static constexpr std::size_t kMostFans = 3;  // kept apart in a node

  /// Faces of one fan.
  struct Group {
    Fan fan;
    ContactBoxes sides;
  };
  /// Of all faces of a node; empty where some have no fan, or they have too many.
  using Groups = std::vector<Group>;

  Groups groups_below(int first) const {
    Groups out = groups_[static_cast<std::size_t>(first)];
    const Groups& beside = groups_[static_cast<std::size_t>(first) + 1];
    if (out.empty() || beside.empty()) return {};
    for (const Group& group : beside) add(out, group);
    return out.size() > kMostFans ? Groups() : out;
  }

  Groups groups_of_faces(const RaySheet& sheet, const BoxTree::Node& node) const {
    Groups out;
    for (int i = 0; i < node.count; ++i) {
      const int face = sheet.tree.face(node.first + i);
      const Fan fan = of_face(sheet.body, face);
      if (fan.corner() == Fan::kNone) return {};
      add(out, {fan, ContactBoxes(sheet.body, face)});
    }
    return out.size() > kMostFans ? Groups() : out;
  }

  static void add(Groups& groups, const Group& more) {
    const auto same = std::find_if(groups.begin(), groups.end(),
                                   [&](const Group& group) { return group.fan.corner() == more.fan.corner(); });
    if (same == groups.end()) return groups.push_back(more);
    same->fan = Fan::united(same->fan, more.fan);
    same->sides.unite(more.sides);
  }

  /// From the corner that most faces have.
  Fan of_face(const RayBody& body, int face) const {
    const auto& corners = body.faces[static_cast<std::size_t>(face)];
    int most = 0;
    for (int k = 1; k < 3; ++k)
      if (faces_about(corners[std::size_t(k)]) > faces_about(corners[std::size_t(most)])) most = k;
    return faces_about(corners[std::size_t(most)]) < kMany ? Fan() : Fan(body, face, most);
  }
  int faces_about(int corner) const { return about_[static_cast<std::size_t>(corner)]; }

  std::vector<int> about_;
  std::vector<Groups> groups_;  // of each node; none where no corner has many faces
};

/// Two nodes of the tree, or one twice: the pairs of faces below them.
struct NodePair {
  int p, q;
};

/// The pairs of faces whose boxes meet, each once.
class MeetingPairs {
 public:
  explicit MeetingPairs(const RaySheet& sheet) : tree_(sheet.tree), fans_(sheet), below_(tree_.nodes().size()) {
    for (std::size_t k = below_.size(); k-- > 0;) {  // those below stand behind
      const BoxTree::Node& x = tree_.nodes()[k];
      below_[k] = x.count > 0 ? x.count : faces_below(x.first) + faces_below(x.first + 1);
    }
  }

  /// The pairs of nodes below these, of which one at least is no leaf.
  void part(const NodePair& pair, std::vector<NodePair>& out) const {
    const auto [p, q] = pair;
    const BoxTree::Node &x = node(p), &y = node(q);
    if (p == q) {
      for (const NodePair& below : {NodePair{x.first, x.first}, {x.first + 1, x.first + 1}, {x.first, x.first + 1}})
        out.push_back(below);
    } else if (x.count == 0 && (y.count > 0 || larger(p, q))) {
      out.insert(out.end(), {{x.first, q}, {x.first + 1, q}});
    } else {
      out.insert(out.end(), {{p, y.first}, {p, y.first + 1}});
    }
  }
  bool apart(const NodePair& pair) const {
    return !node(pair.p).box.meets(node(pair.q).box) || fans_.apart(pair.p, pair.q);
  }
  bool leaves(const NodePair& pair) const { return node(pair.p).count > 0 && node(pair.q).count > 0; }
  int faces_below(int k) const { return below_[static_cast<std::size_t>(k)]; }
  /// The corners of the faces below a node, each once.
  void corners_below(int k, const RayBody& body, std::vector<int>& numbers, std::vector<Point>& out) const {
    numbers.clear();
    int first = k;
    while (node(first).count == 0) first = node(first).first;
    for (int i = node(first).first; i < node(first).first + faces_below(k); ++i)
      for (const int corner : body.faces[static_cast<std::size_t>(tree_.face(i))]) numbers.push_back(corner);
    std::sort(numbers.begin(), numbers.end());
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
    out.clear();
    for (const int corner : numbers) out.push_back(body.points[static_cast<std::size_t>(corner)]);
  }

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
  /// By their faces until both are blocks, so that these are of like size; then by extent.
  bool larger(int p, int q) const {
    const int of_p = faces_below(p), of_q = faces_below(q);
    return std::max(of_p, of_q) > kFacesOfBlock ? of_p >= of_q : extent(node(p)) >= extent(node(q));
  }
  static std::int64_t extent(const BoxTree::Node& n) { return n.box.high.x - n.box.low.x; }

  const BoxTree& tree_;
  Fans fans_;
  std::vector<int> below_;  // faces below each node
};

using FacePair = std::pair<int, int>;
constexpr FacePair kNoFaces{std::numeric_limits<int>::max(), 0};

struct Found {
  FacePair least_crossing = kNoFaces;
  bool inner_walls = false;
};

/// Counts the pairs of faces that are looked at, of all tasks.
class PairWork {
 public:
  explicit PairWork(std::size_t faces) : free_(kFreeOfFace * faces) {}
  void charge(std::uint64_t pairs) {
    const std::uint64_t all = counted_.fetch_add(pairs, std::memory_order_relaxed) + pairs;
    if (all > free_) plane::WorkBudget(work_).charge(all - free_, "a mesh with so many faces near each other");
  }

 private:
  static constexpr std::uint64_t kFreeOfFace = 32;  // more than an even mesh needs

  const std::uint64_t free_;
  const plane::WorkBudget work_ = plane::allowed_work();
  std::atomic<std::uint64_t> counted_{0};
};

/// Looks at the pairs of faces below pairs of nodes.
class PairSearch {
 public:
  PairSearch(const RayBody& body, const MeetingPairs& pairs, PairWork& work)
      : body_(body), pairs_(pairs), work_(work) {}

  Found run(const NodePair& of) {
    stack_.push_back(of);
    while (!stack_.empty()) {
      const NodePair top = stack_.back();
      stack_.pop_back();
      if (pairs_.apart(top)) continue;
      if (pairs_.leaves(top) ||
          (pairs_.faces_below(top.p) <= kFacesOfBlock && pairs_.faces_below(top.q) <= kFacesOfBlock))
        look_at_block(top);
      else
        pairs_.part(top, stack_);
    }
    return found_;
  }

 private:
  static constexpr std::size_t kMany = 256;       // pairs of two blocks whose boxes meet: then a plane may part them
  static constexpr std::size_t kBoxesAPair = 64;  // pairs of boxes that cost as much as one of faces

  void look_at_block(const NodePair& of) {
    met_.clear();
    const std::size_t begin = stack_.size();
    stack_.push_back(of);
    while (stack_.size() > begin) {
      const NodePair top = stack_.back();
      stack_.pop_back();
      if (pairs_.apart(top)) continue;
      if (pairs_.leaves(top))
        pairs_.each(top, [&](const FacePair& faces) { met_.push_back(faces); });
      else
        pairs_.part(top, stack_);
    }
    work_.charge(met_.size() / kBoxesAPair);
    if (met_.size() >= kMany && of.p != of.q && parted(of)) return;
    work_.charge(met_.size());
    for (const FacePair& faces : met_) look_at(faces);
  }

  bool parted(const NodePair& of) {
    pairs_.corners_below(of.p, body_, numbers_, of_p_);
    pairs_.corners_below(of.q, body_, numbers_, of_q_);
    return plane_parts(of_p_, of_q_);
  }

  void look_at(const FacePair& faces) {
    const auto [f, g] = faces;
    const SharedCorners shared = shared_corners(body_, f, g);
    if (shared.count == 1 && Fan::apart({body_, f, shared.in_f}, {body_, g, shared.in_g})) return;
    if (faces < found_.least_crossing && cross(body_, f, g, shared)) found_.least_crossing = faces;
    found_.inner_walls = found_.inner_walls || faces_back_to_back(body_, f, g);
  }

  const RayBody& body_;
  const MeetingPairs& pairs_;
  PairWork& work_;
  Found found_;
  std::vector<NodePair> stack_;
  std::vector<FacePair> met_;
  std::vector<int> numbers_;
  std::vector<Point> of_p_, of_q_;
};

}  // namespace

SelfContact self_contact(const RaySheet& sheet) {
  const RayBody& body = sheet.body;
  const MeetingPairs pairs(sheet);
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
  PairWork work(body.faces.size());
  plane::at_once(parted.size(), body.faces.size(), kFacesAtOnce,
                 [&](std::size_t k) { found[k] = PairSearch(body, pairs, work).run(parted[k]); });
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
