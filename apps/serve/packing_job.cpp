// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "serve/packing_job.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "exact/margins/packing.h"
#include "findspace/error.h"
#include "io/write/json_text.h"
#include "packing/compaction/finish.h"
#include "packing/proof/lower_bound.h"
#include "packing/proof/verify.h"
#include "packing/search/arrangement.h"
#include "packing/search/refined_search.h"

namespace findspace::app {
namespace {

packing::Fraction fraction(const std::string& text) { return packing::Fraction::parse(text); }

packing::Problem read(const std::string& problem, const std::string& file, const PackingOptions& asked) {
  io::NestingOptions read{std::nullopt, fraction(asked.gap), fraction(asked.edge), asked.read, asked.folder};
  if (asked.height) read.height = fraction(*asked.height);
  packing::Problem result = io::read_nesting(problem, file, read);
  if (result.on_sheets() || result.box)
    throw Error(ErrorCode::kUnsupported, "the page shows strips; sheets and boxes are packed by 'findspace pack'",
                file);
  if (!result.fixed.empty())
    throw Error(ErrorCode::kUnsupported, "the page moves all parts; fixed ones are packed around by 'findspace pack'",
                file);
  return result;
}

/// The layout with its overlaps taken out, in a strip as much longer as that needs.
std::optional<packing::Layout> separated(const packing::Problem& problem, const packing::Layout& layout) {
  constexpr std::array<double, 7> kLonger{1, 1.02, 1.05, 1.1, 1.25, 1.5, 2};
  const packing::FieldTable table(problem);
  const packing::Row row(problem, table, {});
  const double length = (layout.length - problem.edge - problem.edge).to_double();
  for (const double longer : kLonger) {
    std::vector<packing::Pose> poses = packing::poses_of(problem, table, row, layout);
    const packing::Arrangement strip(table, row, poses, length * longer);
    for (packing::Pose& pose : poses) pose.at = strip.inside(pose.variant, pose.at);
    packing::LinearMoves moves(table, row);
    double reached = length * longer;
    if (!moves.separate(poses, reached, length * longer)) continue;
    if (auto made = packing::finished(problem, table, row, poses, moves.shorten(poses, reached))) return made;
  }
  return std::nullopt;
}

/// The layout with what overlaps an item set behind the end of the strip, then shortened.
std::optional<packing::Layout> set_aside(const packing::Problem& problem, const packing::Layout& layout,
                                         std::size_t item) {
  const packing::FieldTable table(problem);
  const packing::Row row(problem, table, {});
  double length = (layout.length - problem.edge - problem.edge).to_double();
  std::vector<packing::Pose> poses = packing::poses_of(problem, table, row, layout);
  const packing::Arrangement strip(table, row, poses, length);
  poses[item].at = strip.inside(poses[item].variant, poses[item].at);
  const double touching = table.height() * margin::kNoOverlap;
  for (std::size_t k = 0; k < poses.size(); ++k) {
    if (k == item || table.depth(poses[k], poses[item]) <= touching) continue;
    const packing::Variant& variant = table.variants()[poses[k].variant];
    poses[k].at = {length + table.gap() - variant.low.x, -variant.low.y};
    length = poses[k].at.x + variant.high.x;
  }
  packing::LinearMoves moves(table, row);
  return packing::finished(problem, table, row, poses, moves.shorten(poses, length));
}

}  // namespace

PackingJob::PackingJob(const std::string& problem, const std::string& file, const PackingOptions& asked)
    : problem_(read(problem, file, asked)), bound_(packing::lower_bound(problem_)) {}

PackingJob::~PackingJob() { stop(); }

void PackingJob::stop() {
  stop_ = true;
  if (thread_.joinable()) thread_.join();
}

void PackingJob::keep(const packing::Layout& layout, const packing::SearchState& state) {
  const bool proven = packing::verify(problem_, layout).feasible();
  const std::lock_guard lock(guard_);
  best_ = layout;
  state_ = state;
  facts_.seconds = state.seconds;
  facts_.density = state.density;
  facts_.lower_bound = bound_;
  facts_.proven = proven;
  ++number_;
}

void PackingJob::search(packing::SearchOptions options, std::optional<packing::Layout> start) {
  const packing::SearchEvents events{[&](const auto& layout, const auto& state) { keep(layout, state); },
                                     [&](const auto& state) {
                                       const std::lock_guard lock(guard_);
                                       state_ = state;
                                     }};
  if (start) options.start = &*start;
  try {
    packing::search_refined(problem_, options, events, stop_);
  } catch (const std::exception& e) {
    const std::lock_guard lock(guard_);
    failure_ = e.what();
  }
  running_ = false;
}

void PackingJob::start(const PackingStart& start) {
  stop();
  std::optional<packing::Layout> from = best_;
  if (start.layout) from = io::read_layout(*start.layout, "layout", problem_);
  packing::SearchOptions options;
  options.seed = start.seed;
  options.threads = start.threads > 0 ? start.threads : std::max(1u, std::thread::hardware_concurrency());
  options.seconds = start.seconds;
  facts_.seed = options.seed;
  facts_.threads = options.threads;
  failure_.clear();
  stop_ = false;
  running_ = true;
  thread_ = std::thread([this, options, from] { search(options, from); });
}

void PackingJob::begin_with(const packing::Layout& layout) {
  if (!packing::verify(problem_, layout).feasible())
    throw Error(ErrorCode::kGeometry, "the layout to begin with is not feasible; verify says why");
  packing::SearchState state;
  state.length = layout.length.to_double();
  state.density = packing::area(problem_) / (state.length * problem_.height.to_double());
  keep(layout, state);
}

void PackingJob::repair(std::size_t item, std::array<double, 2> at) {
  stop();
  if (!best_) throw Error(ErrorCode::kBadValue, "there is no layout yet");
  if (item >= best_->items.size())
    throw Error(ErrorCode::kBadValue, fmt::format("the layout has items 0 to {}", best_->items.size() - 1));
  packing::Layout moved = *best_;
  const double steps = double(problem_.steps());
  moved.items[item].x = packing::Fraction(packing::int128(std::llround(at[0] * steps)), problem_.steps());
  moved.items[item].y = packing::Fraction(packing::int128(std::llround(at[1] * steps)), problem_.steps());
  auto made = separated(problem_, moved);
  if (!made) made = set_aside(problem_, moved, item);
  if (!made) throw Error(ErrorCode::kGeometry, "the other parts cannot make room there");
  packing::SearchState state = state_;
  state.length = made->length.to_double();
  state.density = packing::area(problem_) / (state.length * problem_.height.to_double());
  state.overlap = 0;
  keep(*made, state);
}

std::string PackingJob::problem_json(bool drawing) const {
  std::size_t k = 0;
  const std::string parts = io::list(problem_.parts, [&](const packing::Part& p) {
    const std::size_t part = k++;
    return fmt::format(R"({{"name": {}, "demand": {}{}}})", io::json_string(p.name), p.demand,
                       drawing ? ", \"drawing\": " + io::json_string(io::outline_path(problem_, part)) : "");
  });
  return fmt::format(R"({{"name": {}, "height": {}, "lower_bound": {}, "items": {}, "parts": {}}})",
                     io::json_string(problem_.name), io::json_number(problem_.height.to_double()),
                     io::json_number(bound_.to_double()), problem_.items(), parts);
}

std::string PackingJob::state_json(std::uint64_t since) const {
  const std::lock_guard lock(guard_);
  std::string out = fmt::format(R"({{"running": {}, "number": {}, "seconds": {:.3f}, "length": {}, "density": {})",
                                io::truth(running_), number_, state_.seconds, io::json_number(state_.length),
                                io::json_number(state_.density));
  if (!failure_.empty()) out += ", \"failure\": " + io::json_string(failure_);
  if (best_ && number_ > since) {
    const std::string layout = io::layout_json(problem_, *best_, facts_);
    const std::size_t from = layout.find("\"layout\"");
    out += ", " + layout.substr(from, layout.rfind('}') - from);
  }
  return out + "}";
}

}  // namespace findspace::app
