// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Random calls of the public interface from eight threads: no crash, the same answers, and memory that does not grow
// once it is warm. FINDSPACE_SOAK_SECONDS says for how long (default: 10).

#include <gtest/gtest.h>
#include <malloc.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <random>
#include <thread>

#include "findspace/findspace.h"

namespace io_public_soak {

using namespace findspace;
using namespace findspace::words;
using Clock = std::chrono::steady_clock;

double soak_seconds() {
  const char* given = std::getenv("FINDSPACE_SOAK_SECONDS");
  return given != nullptr ? std::atof(given) : 10;
}

/// Of this process, in MiB, after what is free has been given back.
double memory_in_use() {
  malloc_trim(0);
  std::ifstream file("/proc/self/statm");
  double whole = 0, resident = 0;
  file >> whole >> resident;
  return resident * double(sysconf(_SC_PAGESIZE)) / (1 << 20);
}

/// One thread's calls.
class Caller {
 public:
  Caller(unsigned seed, const World& shared) : random_(seed), shared_(shared) {}

  void call() {
    switch (number(0, 11)) {
      case 0:
        return solve();
      case 1:
        return ask_many();
      case 2:
        return combine();
      case 3:
        return mistake();
      case 4:
        return put_down();
      case 5:
        return move();
      case 6:
        return in_space();
      case 7:
        return change();
      case 8:
        return signs();
      case 9:
        return turn();
      case 10:
        return search();
      default:
        return cancel();
    }
  }

 private:
  int number(int least, int most) { return least + int(random_() % unsigned(most - least + 1)); }
  Shape shape() {
    const int x = number(-9, 9), y = number(-9, 9);
    if (number(0, 2) == 0) return Shape::disc({x, y}, number(1, 4));
    const Position ring[] = {
        {double(x), double(y)}, {double(x + number(1, 6)), double(y)}, {double(x), y + 0.1 * number(1, 60)}};
    return number(0, 1) ? Shape::polygon(ring) : Shape::box({x, y}, {x + number(1, 6), y + number(1, 6)});
  }
  World world() {
    return World(
        {{"peg", Shape::disc({0, 0}, 1)}, {"table", Shape::box({-14, -14}, {14, 14})}, {"a", shape()}, {"b", shape()}},
        "peg");
  }
  void solve() {
    const World w = world();
    const Formula f = inside("peg", "table") && (gap("peg", "a") >= number(0, 2) || reach("peg", "b") <= number(4, 12));
    const Region region = w.solve(f);
    const Point p{number(-14, 14), number(-14, 14)};
    EXPECT_EQ(region.contains(p), w.holds(f, p));
    EXPECT_EQ(w.check(f, p).holds, w.holds(f, p));
    EXPECT_TRUE(Shape::json(region.exact_json()).region() == region);
  }
  void ask_many() {
    const Query query = shared_.query("gap(peg, wall) >= 1 and inside(peg, table)");
    std::vector<Position> at(2000);
    for (Position& p : at) p = {number(-400, 400) / 20.0, number(-400, 400) / 20.0};
    const std::unique_ptr<bool[]> out(new bool[at.size()]);
    query.holds(at, {out.get(), at.size()});
    for (std::size_t k = 0; k < at.size(); k += 500)
      EXPECT_EQ(out[k], shared_.holds(Formula(query.text()), Point{at[k][0], at[k][1]}));
    std::vector<double> values(50);
    shared_.query("gap(peg, wall)").values(std::span(at).first(50), values);
  }
  void combine() {
    const Shape a = shape(), b = shape();
    const Region joined = Shape::unite({a, b}).region(), both = Shape::intersect({a, b}).region();
    EXPECT_NEAR(*joined.area() + *both.area(), *a.region().area() + *b.region().area(), 1e-9);
    Shape::offset(a, "0.5").region().flattened(0.01, Region::Towards::kOutside);
    joined.geojson(0.01);
  }
  void mistake() {
    EXPECT_THROW(Shape::polygon(Ring{{0, 0}, {4, 4}, {4, 0}, {0, 4}}), Error);
    EXPECT_THROW(shared_.solve("gap(peg, wal) >= 1"), Error);
    EXPECT_THROW(Shape::json("{\"disc\": 1}"), Error);
  }
  void put_down() {
    const Demands demands{
        {Body({"a"}, {0, 90}, 2), "b"}, inside("self", "table"), clear("self", "other"), {}, {"y", "x"}};
    const Placement found = place({{"table", Shape::box({0, 0}, {40, 40})}, {"a", shape()}, {"b", shape()}}, demands);
    EXPECT_TRUE(found.complete());
    found.svg();
  }
  void move() {
    Motion motion;
    motion.paths["a"] = {{0, {-5, 0}}, {1, {number(0, 5), 5}}};
    const World moving = world().with(motion);
    moving.instants("gap(peg, a) <= 1", {number(-5, 5), 0});
    EXPECT_LE(*moving.distance("inf gap(peg, a)", {0, 0}).value, *moving.distance("sup gap(peg, a)", {0, 0}).value);
  }
  void in_space() {
    const World rooms({{"room", Shape::box({0, 0, 0}, {9, 9, 9})},
                       {"ball", Shape::ball({4, 4, 4}, number(1, 2))},
                       {"crate", Shape::box({0, 0, 0}, {number(1, 3), 1, 2})}},
                      "crate");
    rooms.holds("clear(crate, ball)", Point3{number(0, 8), 1, 1});
    EXPECT_EQ(rooms.solve_space("inside(crate, room)").components(), 1u);
    rooms.on_line("clear(crate, ball)", {1, 1, 0}, {0, 0, 1});
  }
  void change() {
    World mine = shared_;
    mine.set("a", shape());
    mine.move("wall", Point{number(-3, 3), 0});
    EXPECT_EQ(mine.query("clear(peg, wall) and clear(peg, a)").holds(Point{0, 0}),
              mine.holds("clear(peg, wall)", Point{0, 0}) && mine.holds("clear(peg, a)", Point{0, 0}));
  }
  /// Rarely: the least work of a packing takes a tenth of a second.
  void search() {
    const int which = number(0, 39);
    if (which == 0) pack_parts();
    if (which == 1) pack_solids();
  }
  void pack_parts() {
    PackProblem problem;
    problem.height = 12;
    problem.parts = {PackPart::of("a", shape(), 2), PackPart::of("b", shape())};
    const auto found = pack(problem, {.threads = 1, .seed = random_(), .work = 0.01});
    EXPECT_TRUE(found && layout_faults(problem, *found).empty());
  }
  void pack_solids() {
    SolidPackProblem problem;
    problem.containers = {{"crate", 4, 4, 4, 3}};
    problem.parts = {{"box", Shape::box(Point3{0, 0, 0}, Point3{number(1, 3), 2, 1}), 3, Orientation::upright()},
                     {"ball", Shape::ball({0, 0, 0}, 1), 2}};
    const auto found = pack(problem, {.threads = 1, .seed = random_(), .work = 0.01});
    EXPECT_TRUE(found && layout_faults(problem, *found).empty());
  }
  void signs() {
    const SignMap map = shared_.sign_map("gap(peg, wall)", number(0, 3));
    const Region near = map.where(true, true, false);
    for (const Position& p : near.sample(20, {.threads = 1, .seed = random_()})) EXPECT_LE(map.sign({p[0], p[1]}), 0);
  }
  void turn() {
    const World w = world();
    const PoseMap poses = w.poses("clear(peg, a) and inside(peg, table)", {0, number(1, 80)});
    EXPECT_EQ(poses.slices.size(), 2u);
    const Phi phi(shape(), shape());
    EXPECT_EQ(phi.at(Point{number(-9, 9), 30}).state, Phi::State::kApart);
    EXPECT_THROW(Shape::file("no such file.svg"), Error);
  }
  void cancel() {
    Options options;
    options.cancel.request();
    EXPECT_THROW(shared_.with(options).solve("gap(peg, wall) >= 1"), Stopped);
  }

  std::mt19937 random_;
  const World& shared_;
};

TEST(Soak, EightThreadsWithoutGrowthOfMemory) {
  constexpr unsigned kThreads = 8;
  const World shared({{"peg", Shape::disc({0, 0}, 1)},
                      {"table", Shape::box({-20, -20}, {20, 20})},
                      {"wall", Shape::offset(Shape::polyline(std::vector<Point>{{-9, 0}, {0, 5}, {9, 1}}), 1)}},
                     "peg");
  const double seconds = soak_seconds();
  const Clock::time_point begun = Clock::now();
  const auto gone = [&] { return std::chrono::duration<double>(Clock::now() - begun).count(); };
  std::atomic<long> calls{0};
  std::vector<std::thread> threads;
  for (unsigned t = 0; t < kThreads; ++t)
    threads.emplace_back([&, t] {
      Caller caller(t + 1, shared);
      for (; gone() < seconds; ++calls) caller.call();
    });
  double warm = 0, most = 0;  // in the second fifth of the time, and afterwards
  while (gone() < seconds) {
    std::this_thread::sleep_for(std::chrono::duration<double>(seconds / 100));
    double& seen = gone() < 0.4 * seconds ? warm : most;
    seen = std::max(seen, memory_in_use());
  }
  for (std::thread& thread : threads) thread.join();
  std::printf("%ld calls in %.0f s, at most %.1f MiB while warming up, %.1f MiB afterwards\n", calls.load(), gone(),
              warm, most);
  EXPECT_GT(calls.load(), 100);
  EXPECT_LT(most, 1.1 * warm + 16);
}

}  // namespace io_public_soak
