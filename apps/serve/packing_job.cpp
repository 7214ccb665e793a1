// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "serve/packing_job.h"

#include <findspace/error.h>
#include <fmt/format.h>

#include "io/write/json_text.h"

namespace findspace::app {
namespace {

Packing read(const std::string& problem, const PackReading& asked) {
  Packing result = Packing::json(problem, asked);
  const PackProblem& read = result.problem();
  if (!read.sheets.empty() || read.box)
    throw Error(ErrorCode::kUnsupported, "the page shows strips; sheets and boxes are packed by 'findspace pack'",
                asked.name);
  if (!read.fixed.empty())
    throw Error(ErrorCode::kUnsupported, "the page moves all parts; fixed ones are packed around by 'findspace pack'",
                asked.name);
  return result;
}

}  // namespace

PackingJob::PackingJob(const std::string& problem, const PackReading& asked) : packing_(read(problem, asked)) {}

PackingJob::~PackingJob() { stop(); }

void PackingJob::stop() {
  stop_.request();
  if (thread_.joinable()) thread_.join();
}

void PackingJob::keep(const PackLayout& layout, const PackProgress& state) {
  const std::lock_guard lock(guard_);
  best_ = layout;
  state_ = state;
  ++number_;
}

void PackingJob::search(const findspace::Options& options, std::optional<PackLayout> start) {
  PackSearch<PackLayout> search;
  search.start = std::move(start);
  search.better = [&](const PackLayout& layout, const PackProgress& state) { keep(layout, state); };
  search.progress = [&](const PackProgress& state) {
    const std::lock_guard lock(guard_);
    state_ = state;
  };
  try {
    packing_.search(options, search);
  } catch (const std::exception& e) {
    const std::lock_guard lock(guard_);
    failure_ = e.what();
  }
  running_ = false;
}

void PackingJob::start(const PackingStart& start) {
  stop();
  std::optional<PackLayout> from = best_;
  if (start.layout) from = packing_.layout(*start.layout);
  findspace::Options options;
  options.seed = start.seed;
  options.threads = start.threads;
  options.seconds = start.seconds;
  options.cancel = stop_;
  failure_.clear();
  stop_.reset();
  running_ = true;
  thread_ = std::thread([this, options, from] { search(options, from); });
}

void PackingJob::begin_with(const PackLayout& layout) {
  if (!packing_.verdict(layout).feasible())
    throw Error(ErrorCode::kGeometry, "the layout to begin with is not feasible; verify says why");
  PackProgress state;
  state.length = layout.length.value();
  state.density = layout.density;
  keep(layout, state);
}

void PackingJob::repair(std::size_t item, std::array<double, 2> at) {
  stop();
  if (!best_) throw Error(ErrorCode::kBadValue, "there is no layout yet");
  std::optional<PackLayout> made = packing_.moved(*best_, item, at);
  if (!made) throw Error(ErrorCode::kGeometry, "the other parts cannot make room there");
  made->seconds = best_->seconds;
  made->seed = best_->seed;
  made->threads = best_->threads;
  PackProgress state = state_;
  state.length = made->length.value();
  state.density = made->density;
  state.overlap = 0;
  keep(*made, state);
}

std::string PackingJob::problem_json(bool drawing) const {
  const PackProblem& problem = packing_.problem();
  std::size_t k = 0;
  const std::string parts = io::list(problem.parts, [&](const PackPart& p) {
    const std::size_t part = k++;
    return fmt::format(R"({{"name": {}, "demand": {}{}}})", io::json_string(p.name), p.count,
                       drawing ? ", \"drawing\": " + io::json_string(packing_.outline(part)) : "");
  });
  return fmt::format(R"({{"name": {}, "height": {}, "lower_bound": {}, "items": {}, "parts": {}}})",
                     io::json_string(problem.name), io::json_number(problem.height.value()),
                     io::json_number(packing_.lower_bound().value()), packing_.copies(), parts);
}

std::string PackingJob::state_json(std::uint64_t since) const {
  const std::lock_guard lock(guard_);
  std::string out = fmt::format(R"({{"running": {}, "number": {}, "seconds": {:.3f}, "length": {}, "density": {})",
                                io::truth(running_), number_, state_.seconds, io::json_number(state_.length),
                                io::json_number(state_.density));
  if (!failure_.empty()) out += ", \"failure\": " + io::json_string(failure_);
  if (best_ && number_ > since) {
    const std::string layout = packing_.json(*best_);
    const std::size_t from = layout.find("\"layout\"");
    out += ", " + layout.substr(from, layout.rfind('}') - from);
  }
  return out + "}";
}

}  // namespace findspace::app
