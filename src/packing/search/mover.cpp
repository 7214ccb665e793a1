// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "packing/search/mover.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace findspace::packing {
namespace {

constexpr int kSpread = 40, kAbout = 20;  // positions at random
constexpr int kMostProjections = 8;
constexpr std::size_t kMostLines = 4;
constexpr double kGrow = 1.1, kShrink = 0.5;
constexpr double kFar = std::numeric_limits<double>::infinity();

}  // namespace

std::size_t Mover::random_variant(std::size_t item) {
  const std::size_t part = a_.table().variants()[a_.pose(item).variant].part;
  const auto& variants = a_.table().variants_of(part);
  return variants[variants.size() == 1 ? 0 : random_.below(variants.size())];
}

/// Keeps the best few.
void Mover::offer(std::size_t item, const Pose& pose) {
  const double bound = count_ < kKept ? kFar : kept_[count_ - 1].cost;
  const double cost = a_.cost(item, pose, bound);
  if (!(cost < bound)) return;
  std::size_t k = count_ < kKept ? count_++ : count_ - 1;
  for (; k > 0 && cost < kept_[k - 1].cost; --k) kept_[k] = kept_[k - 1];
  kept_[k] = {pose, cost};
}

void Mover::sample(std::size_t item, const Candidate& here) {
  kept_[0] = here;
  count_ = 1;
  const Pose now = here.pose;
  for (int k = 0; k < kSpread; ++k) {
    const std::size_t v = random_variant(item);
    offer(item, {v, a_.random_position(v, random_)});
  }
  const Variant& shape = a_.table().variants()[now.variant];
  const Vec middle = now.at + 0.5 * (shape.low + shape.high);
  for (int k = 0; k < kAbout; ++k) {
    const std::size_t v = random_variant(item);
    const Variant& w = a_.table().variants()[v];
    const double reach = 0.25 * (w.high.x - w.low.x + w.high.y - w.low.y);
    const Vec off{random_.between(-reach, reach), random_.between(-reach, reach)};
    offer(item, {v, a_.inside(v, middle - 0.5 * (w.low + w.high) + off)});
  }
}

bool Mover::try_at(std::size_t item, Candidate& c, Vec at) {
  const Pose pose{c.pose.variant, a_.inside(c.pose.variant, at)};
  const double cost = a_.cost(item, pose, c.cost);
  if (!(cost < c.cost)) return false;
  c = {pose, cost};
  return true;
}

bool Mover::project_once(std::size_t item, Candidate& c) {
  struct Line {
    Vec at, way;
    double cost;
  };
  std::array<Line, kMostLines> lines;
  std::size_t count = 0;
  const Vec from = c.pose.at;
  for (const std::uint32_t j : a_.near(item, c.pose)) {
    const Arrangement::Exit exit = a_.exit(c.pose, j);
    if (exit.depth <= 0) continue;
    const Line line{from + exit.move, exit.line, exit.depth * a_.weight(item, j)};
    if (count == kMostLines && line.cost <= lines[count - 1].cost) continue;
    std::size_t k = count < kMostLines ? count++ : count - 1;
    for (; k > 0 && line.cost > lines[k - 1].cost; --k) lines[k] = lines[k - 1];
    lines[k] = line;
  }
  bool better = false;
  for (std::size_t k = 0; k < count; ++k) {
    better |= try_at(item, c, lines[k].at);
    for (std::size_t l = 0; l < k; ++l) {
      const double turn = cross(lines[k].way, lines[l].way);
      if (turn == 0) continue;
      const double along = cross(lines[l].at - lines[k].at, lines[l].way) / turn;
      better |= try_at(item, c, lines[k].at + along * lines[k].way);
    }
  }
  return better;
}

void Mover::project(std::size_t item, Candidate& c) {
  for (int k = 0; k < kMostProjections && c.cost > 0 && project_once(item, c); ++k) {
  }
}

void Mover::descend(std::size_t item, Candidate& c, double step) {
  const double least = step / 256;
  double step_x = step, step_y = step;
  while (c.cost > 0 && (step_x > least || step_y > least)) {
    const int axes = int(random_.below(4));
    const double dx = axes == 1 ? 0 : step_x, dy = axes == 0 ? 0 : axes == 3 ? -step_y : step_y;
    const Vec at = c.pose.at;
    const bool better = try_at(item, c, {at.x + dx, at.y + dy}) || try_at(item, c, {at.x - dx, at.y - dy});
    const double factor = better ? kGrow : axes < 2 ? kShrink : std::sqrt(kShrink);
    if (axes != 1) step_x *= factor;
    if (axes != 0) step_y *= factor;
  }
}

void Mover::improve(std::size_t item) {
  const Candidate now{a_.pose(item), a_.cost(item, a_.pose(item), kFar)};
  if (now.cost <= 0) return;
  sample(item, now);
  const Variant& v = a_.table().variants()[now.pose.variant];
  const double size = std::min(v.high.x - v.low.x, v.high.y - v.low.y);
  Candidate best = now;
  for (std::size_t k = 0; k < count_; ++k) {
    project(item, kept_[k]);
    if (kept_[k].cost < best.cost) best = kept_[k];
  }
  if (best.cost > 0) {
    Candidate c = best;
    descend(item, c, 0.05 * size);
    project(item, c);
    if (c.cost < best.cost) best = c;
  }
  if (best.cost < now.cost) a_.move(item, best.pose);
}

}  // namespace findspace::packing
