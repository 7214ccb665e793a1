// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/surface/surface_gap.h"

#include <algorithm>

#include "exact/margins/space.h"
#include "plane/base/subdivide.h"
#include "space/polytope/near_features.h"

namespace findspace::space {

using exact::Real;
using Pair = SurfaceGaps::Pair;
using Sheet = SurfaceSet::Sheet;
using DoubleTriple = near::Triple<double>;

namespace {

/// Between a box of A and one of B moved by p.
double box_gap(const GridBox& a, const GridBox& b, const Vector& p) {
  const auto gap = [](std::int64_t low_a, std::int64_t high_a, std::int64_t low_b, std::int64_t high_b, double by) {
    const double below = static_cast<double>(low_b - high_a) + by, above = static_cast<double>(low_a - high_b) - by;
    return std::max({below, above, 0.0});
  };
  const double x = gap(a.low.x, a.high.x, b.low.x, b.high.x, p.x), y = gap(a.low.y, a.high.y, b.low.y, b.high.y, p.y),
               z = gap(a.low.z, a.high.z, b.low.z, b.high.z, p.z);
  return std::sqrt(x * x + y * y + z * z);
}

/// Best first over pairs of boxes.
class Search {
 public:
  /// `size` of the coordinates, `longest` of the edges: what a distance may be off.
  Search(const Vector& p, double size, double longest)
      : p_(p), slack_(margin::kFaceDistance * size + margin::kFaceProjection * longest) {}

  void sheets(const Sheet& a, int i, const Sheet& b, int j) {
    run(a.tree, b.tree, p_, [&](int f, int g) { faces(a, i, f, b, j, g); });
  }

  /// The centre of a ball, as seen by the sheet, and its radius.
  void point(const Sheet& sheet, const Vector& at, const Pair& pair, double radius) {
    radius_ = radius;
    const auto gap = [&](const GridBox& box) { return box_gap(box, {}, at); };
    sheet.tree.nearest_first(
        gap, [&](double least) { return worth(least); },
        [&](int k) {
          Pair found = pair;
          (pair.kind == Pair::Kind::kBallOfB ? found.a : found.b) = sheet.tree.face(k);
          offer(found, squared_distance(sheet, sheet.tree.face(k), at));
          return true;
        });
    radius_ = 0;
  }

  void points(const Vector& way, const Pair& pair, double radius) {
    radius_ = radius;
    offer(pair, dot(way, way));
    radius_ = 0;
  }

  SurfaceGaps::Near found() {
    SurfaceGaps::Near out{std::move(pairs_), best_, slack_};
    std::erase_if(out.pairs, [&](const Pair& pair) { return pair.nearly > best_ + slack_; });
    const auto same = [](const Pair& x, const Pair& y) {
      return std::tie(x.kind, x.sheet_a, x.sheet_b, x.a, x.b) == std::tie(y.kind, y.sheet_a, y.sheet_b, y.a, y.b);
    };
    std::sort(out.pairs.begin(), out.pairs.end());
    out.pairs.erase(std::unique(out.pairs.begin(), out.pairs.end(), same), out.pairs.end());
    std::stable_sort(out.pairs.begin(), out.pairs.end(),
                     [](const Pair& x, const Pair& y) { return x.nearly < y.nearly; });
    return out;
  }

 private:
  struct Task {
    double gap;
    int a, b;
    bool operator<(const Task& other) const { return gap > other.gap; }
  };

  bool worth(double gap) const { return gap - radius_ <= best_ + slack_; }

  template <class Visit>
  void run(const BoxTree& a, const BoxTree& b, const Vector& p, Visit visit) {
    plane::Subdivision<Task> queue;
    const auto push = [&](int i, int j) {
      const double gap = box_gap(a.nodes()[std::size_t(i)].box, b.nodes()[std::size_t(j)].box, p);
      if (worth(gap)) queue.push({gap, i, j});
    };
    push(0, 0);
    const auto look = [&](const Task& top) {
      const BoxTree::Node &x = a.nodes()[std::size_t(top.a)], &y = b.nodes()[std::size_t(top.b)];
      if (x.count > 0 && y.count > 0) {
        for (int k = x.first; k < x.first + x.count; ++k)
          for (int m = y.first; m < y.first + y.count; ++m)
            if (worth(box_gap(a.box(k), b.box(m), p))) visit(a.face(k), b.face(m));
      } else if (y.count > 0 || (x.count == 0 && width(x.box) >= width(y.box))) {
        push(x.first, top.b);
        push(x.first + 1, top.b);
      } else {
        push(top.a, y.first);
        push(top.a, y.first + 1);
      }
    };
    queue.run([&](const Task& top) { return !worth(top.gap); }, look);
  }

  static std::int64_t width(const GridBox& b) {
    return std::max({b.high.x - b.low.x, b.high.y - b.low.y, b.high.z - b.low.z});
  }

  void faces(const Sheet& a, int i, int f, const Sheet& b, int j, int g) {
    std::array<DoubleTriple, 3> s, t;
    for (std::size_t k = 0; k < 3; ++k) {
      s[k] = near::triple(exact::approx(a.body.corner(f, static_cast<int>(k))));
      t[k] = near::triple(plus(exact::approx(b.body.corner(g, static_cast<int>(k))), p_));
    }
    const auto from = [](const std::array<DoubleTriple, 3>& c, const DoubleTriple& x) {
      return near::squared_of_triangle(near::minus(c[0], x), near::minus(c[1], x), near::minus(c[2], x));
    };
    const auto &of_a = a.body.faces[std::size_t(f)], &of_b = b.body.faces[std::size_t(g)];
    for (std::size_t k = 0; k < 3; ++k) {
      offer({Pair::Kind::kCornerOfA, i, j, of_a[k], g}, from(t, s[k]));
      offer({Pair::Kind::kCornerOfB, i, j, f, of_b[k]}, from(s, t[k]));
      for (std::size_t m = 0; m < 3; ++m) {
        offer({Pair::Kind::kEdges, i, j, a.body.face_edges[std::size_t(f)][k], b.body.face_edges[std::size_t(g)][m]},
              near::squared_between(s[k], near::minus(s[(k + 1) % 3], s[k]), t[m], near::minus(t[(m + 1) % 3], t[m])));
      }
    }
  }

  void offer(Pair pair, double squared) {
    pair.nearly = std::sqrt(squared) - radius_;
    if (!(pair.nearly <= best_ + slack_)) return;
    best_ = std::min(best_, pair.nearly);
    pairs_.push_back(pair);
    if (pairs_.size() < kept_) return;
    std::erase_if(pairs_, [&](const Pair& other) { return other.nearly > best_ + slack_; });
    kept_ = std::max(kKept, 2 * pairs_.size());
  }

  static constexpr std::size_t kKept = 4096;
  Vector p_;
  double slack_, radius_ = 0, best_ = exact::kInfinity;
  std::size_t kept_ = kKept;
  std::vector<Pair> pairs_;
};

RealVector nearest_of_face(const Sheet& sheet, int face, const RealVector& x) {
  const auto corner = [&](int k) { return minus(real(sheet.body.corner(face, k)), x); };
  return near::nearest_of_triangle<Real>(corner(0), corner(1), corner(2));
}

double farthest_out(const SurfaceSet& set) {
  double size = 0;
  for (const auto& sheet : set.sheets()) {
    for (const Point& c : {sheet->body.low, sheet->body.high}) size = std::max(size, size_of(exact::approx(c)));
  }
  for (const auto& ball : set.balls())
    size = std::max(size, size_of(exact::approx(ball.center)) + ball.radius.to_double());
  return size;
}

}  // namespace

double squared_distance(const Sheet& sheet, int face, const Vector& x) {
  const auto corner = [&](int k) { return near::triple(exact::approx(sheet.body.corner(face, k)) - x); };
  return near::squared_of_triangle(corner(0), corner(1), corner(2));
}

RealVector way_to(const Sheet& sheet, const RealVector& x) {
  const Vector at = space::rounded(x);
  Search search({}, size_of(exact::approx(sheet.body.low)) + size_of(exact::approx(sheet.body.high)) + size_of(at),
                sheet.longest);
  search.point(sheet, at, {Pair::Kind::kBallOfB}, 0);
  std::optional<RealVector> best;
  for (const Pair& pair : search.found().pairs) {
    RealVector next = nearest_of_face(sheet, pair.a, x);
    if (!best || dot(next, next) < dot(*best, *best)) best = std::move(next);
  }
  return *best;
}

Vector nearest_place(const Sheet& sheet, int face, const Vector& x) {
  const auto corner = [&](int k) { return near::triple(exact::approx(sheet.body.corner(face, k)) - x); };
  const DoubleTriple way = near::nearest_of_triangle(corner(0), corner(1), corner(2));
  return plus(x, Vector{way[0], way[1], way[2]});
}

SurfaceGaps::SurfaceGaps(std::shared_ptr<const SurfaceSet> a, std::shared_ptr<const SurfaceSet> b)
    : a_(std::move(a)), b_(std::move(b)), overlaps_(a_->sheets().size() * b_->sheets().size()) {
  for (const SurfaceSet* set : {a_.get(), b_.get()}) {
    for (const auto& sheet : set->sheets()) longest_ = std::max(longest_, sheet->longest);
  }
}

SurfaceGaps::Near SurfaceGaps::near(const Vector& p) const {
  Search search(p, farthest_out(*a_) + farthest_out(*b_) + size_of(p), longest_);
  const int of_a = static_cast<int>(a_->sheets().size()), of_b = static_cast<int>(b_->sheets().size());
  for (int i = 0; i < of_a; ++i) {
    const Sheet& sheet = *a_->sheets()[std::size_t(i)];
    for (int j = 0; j < of_b; ++j) search.sheets(sheet, i, *b_->sheets()[std::size_t(j)], j);
    for (int j = 0; j < static_cast<int>(b_->balls().size()); ++j) {
      const SurfaceSet::Ball& ball = b_->balls()[std::size_t(j)];
      search.point(sheet, plus(exact::approx(ball.center), p), {Pair::Kind::kBallOfB, i, j}, ball.radius.to_double());
    }
  }
  for (int i = 0; i < static_cast<int>(a_->balls().size()); ++i) {
    const SurfaceSet::Ball& ball = a_->balls()[std::size_t(i)];
    const Vector center = exact::approx(ball.center) - p;
    for (int j = 0; j < of_b; ++j)
      search.point(*b_->sheets()[std::size_t(j)], center, {Pair::Kind::kBallOfA, i, j}, ball.radius.to_double());
    for (int j = 0; j < static_cast<int>(b_->balls().size()); ++j) {
      const SurfaceSet::Ball& other = b_->balls()[std::size_t(j)];
      search.points(center - exact::approx(other.center), {Pair::Kind::kBalls, i, j},
                    (ball.radius + other.radius).to_double());
    }
  }
  return search.found();
}

RealVector SurfaceGaps::way(const Pair& pair, const RealVector& p) const {
  const auto sheet_a = [&]() -> const Sheet& { return *a_->sheets()[std::size_t(pair.sheet_a)]; };
  const auto sheet_b = [&]() -> const Sheet& { return *b_->sheets()[std::size_t(pair.sheet_b)]; };
  const auto ball_a = [&] { return real(a_->balls()[std::size_t(pair.sheet_a)].center); };
  const auto ball_b = [&] { return real(b_->balls()[std::size_t(pair.sheet_b)].center); };
  switch (pair.kind) {
    case Pair::Kind::kCornerOfB:
      return nearest_of_face(sheet_a(), pair.a, plus(real(sheet_b().body.points[std::size_t(pair.b)]), p));
    case Pair::Kind::kCornerOfA:
      return negated(nearest_of_face(sheet_b(), pair.b, minus(real(sheet_a().body.points[std::size_t(pair.a)]), p)));
    case Pair::Kind::kBallOfB:
      return nearest_of_face(sheet_a(), pair.a, plus(ball_b(), p));
    case Pair::Kind::kBallOfA:
      return negated(nearest_of_face(sheet_b(), pair.b, minus(ball_a(), p)));
    case Pair::Kind::kBalls:
      return minus(ball_a(), plus(ball_b(), p));
    case Pair::Kind::kEdges:
      break;
  }
  const auto ends = [](const Sheet& sheet, int edge) {
    const RayEdge& e = sheet.body.edges[std::size_t(edge)];
    return std::array{real(sheet.body.points[std::size_t(e.from)]), real(sheet.body.points[std::size_t(e.to)])};
  };
  const auto s = ends(sheet_a(), pair.a), t = ends(sheet_b(), pair.b);
  const RealVector from = plus(t[0], p);
  const auto found = near::way_between(s[0], minus(s[1], s[0]), from, minus(t[1], t[0]));
  return found ? *found : minus(s[0], from);  // then a corner is nearer
}

Real SurfaceGaps::radius(const Pair& pair) const {
  const bool of_a = pair.kind == Pair::Kind::kBallOfA || pair.kind == Pair::Kind::kBalls,
             of_b = pair.kind == Pair::Kind::kBallOfB || pair.kind == Pair::Kind::kBalls;
  return (of_a ? a_->balls()[std::size_t(pair.sheet_a)].radius : Real()) +
         (of_b ? b_->balls()[std::size_t(pair.sheet_b)].radius : Real());
}

SurfaceGap SurfaceGaps::gap(const RealVector& p, const Near& near) const {
  std::optional<SurfaceGap> best;
  std::optional<Real> square;  // of the way, where there is no radius
  for (const Pair& pair : near.pairs) {
    SurfaceGap next{way(pair, p), radius(pair), {}};
    const Real length = dot(next.way, next.way);
    if (best && square && next.radius.sign() == 0 && *square <= length) continue;
    next.value = sqrt(length) - next.radius;
    if (best && best->value <= next.value) continue;
    square = next.radius.sign() == 0 ? std::optional(length) : std::nullopt;
    best = std::move(next);
  }
  return *best;
}

}  // namespace findspace::space
