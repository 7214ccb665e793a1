// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "placing/packing_report.h"

#include <findspace/error.h>
#include <findspace/text.h>
#include <fmt/format.h>

#include <algorithm>

#include "common/stop_on_interrupt.h"
#include "findspace/team.h"

namespace findspace::app {
namespace {

constexpr std::size_t kFaultsShown = 8;

const char* kind_name(PackFault::Kind kind) {
  constexpr const char* kNames[] = {"overlap", "gap",   "condition", "outside",    "angle",
                                    "zone",    "count", "sheets",    "containers", "fixed"};
  return kNames[std::size_t(kind)];
}

}  // namespace

PackReading pack_reading(const Options& options, const std::string& name) {
  PackReading result{name, {}, reading(options), options.gap, options.edge};
  if (options.height) result.height = *options.height;
  return result;
}

findspace::Options search_options(const Options& options) {
  findspace::Options result;
  result.threads = options.threads;
  result.seconds = options.time_limit;
  result.cancel = StopOnInterrupt::wanted();
  result.seed = options.seed;
  result.work = options.work;
  return result;
}

PackPeers* peers_of(const Options& options) {
  return options.team != nullptr && options.team->count() > 1 ? options.team : nullptr;
}

PackLayout start_layout(const Packing& packing, const std::filesystem::path& path, std::uint64_t most) {
  const std::string text = read_text(path, most);
  PackLayout layout =
      path.extension() == ".svg" ? Packing::sparrow(text, path.string()).second : packing.layout(text, path.string());
  try {
    packing.check_start(layout);
  } catch (const Error& e) {
    throw e.within(path.string());
  }
  return layout;
}

SolidPackLayout start_layout(const SolidPacking& packing, const std::filesystem::path& path, std::uint64_t most) {
  SolidPackLayout layout = packing.layout(read_text(path, most), path.string());
  const PackVerdict verdict = packing.verdict(layout);
  if (verdict.feasible()) return layout;
  throw Error(ErrorCode::kBadValue, "the layout to start with is not feasible: " + verdict.faults[0].text,
              path.string());
}

std::string better_text(const PackProgress& state, std::string_view size) {
  return fmt::format("{:8.2f} s  processor {:8.2f} s  {} {:.8g}  density {:.3f} %", state.seconds, state.processor,
                     size, state.length, 100 * state.density);
}

std::string progress_text(const PackProgress& state, std::string_view size) {
  return fmt::format("{:.0f} s  {} {:.6g}  density {:.3f} %  overlap left {:.3g}  better {:.0f} s ago", state.seconds,
                     size, state.length, 100 * state.density, state.overlap, state.since_better);
}

std::string verdict_text(std::size_t items, const LayoutSize& size, const PackVerdict& verdict) {
  std::string text =
      fmt::format("{}  {} item{}, {} {}, density {:.4f} %\n", verdict.feasible() ? "feasible" : "not feasible", items,
                  items == 1 ? "" : "s", size.word, size.value.text(), 100 * verdict.density);
  for (std::size_t i = 0; i < std::min(kFaultsShown, verdict.faults.size()); ++i)
    text += "  " + verdict.faults[i].text + "\n";
  if (verdict.faults.size() > kFaultsShown)
    text += fmt::format("  and {} more\n", verdict.faults.size() - kFaultsShown);
  return text;
}

std::string verdict_json(std::size_t items, const LayoutSize& size, const PackVerdict& verdict) {
  std::string faults;
  double deepest = 0;
  for (const PackFault& fault : verdict.faults) {
    if (fault.kind == PackFault::Kind::kOverlap) deepest = std::max(deepest, fault.depth);
    faults += fmt::format(R"({}
  {{"kind": "{}", "of": {}, "depth": {}, "near": [{}], "text": {}}})",
                          faults.empty() ? "" : ",", kind_name(fault.kind), json_list(fault.of, json_string),
                          fault.depth, fmt::join(fault.near, ", "), json_string(fault.text));
  }
  return fmt::format(
      "{{\"findspace\": 1, \"verdict\": {{\"feasible\": {}, \"items\": {}, \"{}\": \"{}\", \"used\": \"{}\", "
      "\"density\": {}, \"largest_overlap\": {}, \"faults\": [{}]}}}}\n",
      verdict.feasible(), items, size.word, size.value.text(), verdict.used.text(), verdict.density, deepest, faults);
}

}  // namespace findspace::app
