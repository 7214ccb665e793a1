// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "placing/packing_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "findspace/error.h"
#include "io/nesting/fault_text.h"
#include "io/text/read_text.h"

namespace findspace::app {
namespace {

using packing::Fault;

constexpr std::size_t kFaultsShown = 8;

const char* kind_name(Fault::Kind kind) {
  constexpr const char* kNames[] = {"overlap", "gap",   "condition", "outside", "angle",
                                    "zone",    "count", "sheets",    "fixed"};
  return kNames[std::size_t(kind)];
}

bool of_part(Fault::Kind kind) { return kind == Fault::Kind::kCount || kind == Fault::Kind::kFixed; }

}  // namespace

packing::Layout start_layout(const packing::Problem& problem, const std::filesystem::path& path, std::uint64_t most) {
  const std::string text = io::read_text(path, most);
  packing::Layout layout;
  if (path.extension() == ".svg") {
    io::ProblemAndLayout read = io::read_sparrow_svg(text, path.string());
    layout = std::move(read.layout);
    for (packing::Placed& item : layout.items) {
      const std::string& name = read.problem.parts[item.part].name;
      const auto same = [&](const packing::Part& part) { return part.name == name; };
      const auto found = std::find_if(problem.parts.begin(), problem.parts.end(), same);
      if (found == problem.parts.end())
        throw Error(ErrorCode::kBadValue, fmt::format("no part '{}'", name), path.string());
      item.part = std::size_t(found - problem.parts.begin());
    }
  } else {
    layout = io::read_layout(text, path.string(), problem);
  }
  std::vector<int> missing;
  for (const packing::Part& part : problem.parts) missing.push_back(part.demand);
  for (const packing::Placed& item : layout.items) --missing[item.part];
  for (const packing::LeftOut& out : layout.left_out) missing[out.part] -= out.copies;
  if (std::any_of(missing.begin(), missing.end(), [](int count) { return count != 0; }))
    throw Error(ErrorCode::kBadValue, "the layout to start with has other parts than the problem", path.string());
  return layout;
}

io::NestingOptions nesting_options(const Options& options) {
  const auto height = options.height ? std::optional(packing::Fraction::parse(*options.height)) : std::nullopt;
  return {height, packing::Fraction::parse(options.gap), packing::Fraction::parse(options.edge), reading(options)};
}

std::string better_text(const packing::SearchState& state, std::string_view size) {
  return fmt::format("{:8.2f} s  processor {:8.2f} s  {} {:.8g}  density {:.3f} %", state.seconds, state.processor,
                     size, state.length, 100 * state.density);
}

std::string progress_text(const packing::SearchState& state, std::string_view size) {
  return fmt::format("{:.0f} s  {} {:.6g}  density {:.3f} %  overlap left {:.3g}  better {:.0f} s ago", state.seconds,
                     size, state.length, 100 * state.density, state.overlap, state.since_better);
}

std::string verdict_text(const packing::Problem& problem, const packing::Layout& layout,
                         const packing::Verdict& verdict) {
  std::string text =
      fmt::format("{}  {} items, length {}, density {:.4f} %\n", verdict.feasible() ? "feasible" : "not feasible",
                  layout.items.size(), layout.length.text(), 100 * verdict.density);
  for (std::size_t i = 0; i < std::min(kFaultsShown, verdict.faults.size()); ++i)
    text += "  " + io::fault_text(problem, layout, verdict.faults[i]) + "\n";
  if (verdict.faults.size() > kFaultsShown)
    text += fmt::format("  and {} more\n", verdict.faults.size() - kFaultsShown);
  return text;
}

std::string verdict_json(const packing::Problem& problem, const packing::Layout& layout,
                         const packing::Verdict& verdict) {
  std::string faults;
  double deepest = 0;
  for (const Fault& fault : verdict.faults) {
    if (fault.kind == Fault::Kind::kOverlap) deepest = std::max(deepest, fault.depth);
    std::string items =
        fmt::format("\"{}\"", of_part(fault.kind)                  ? problem.parts[fault.first].name
                              : fault.kind == Fault::Kind::kSheets ? problem.sheets[fault.first].name
                                                                   : io::item_name(problem, layout, fault.first));
    if (fault.kind <= Fault::Kind::kCondition)
      items += fmt::format(", \"{}\"", io::item_name(problem, layout, fault.second));
    faults += fmt::format("{}\n  {{\"kind\": \"{}\", \"of\": [{}], \"depth\": {}, \"near\": [{}, {}]}}",
                          faults.empty() ? "" : ",", kind_name(fault.kind), items, fault.depth, fault.x, fault.y);
  }
  return fmt::format(
      "{{\"findspace\": 1, \"verdict\": {{\"feasible\": {}, \"items\": {}, \"length\": \"{}\", \"used\": \"{}\", "
      "\"density\": {}, \"largest_overlap\": {}, \"faults\": [{}]}}}}\n",
      verdict.feasible(), layout.items.size(), layout.length.text(), verdict.used.text(), verdict.density, deepest,
      faults);
}

}  // namespace findspace::app
