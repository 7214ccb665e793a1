// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Any bytes are a packing problem, in the plane or in space, or an Error; after a zero byte follows a layout of it. A
// layout that is read is written and read again as the same text. What begins with '<' is a drawing of sparrow. No file
// is opened.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "findspace/error.h"
#include "io/nesting/read_nesting.h"
#include "io/nesting/read_solids.h"
#include "io/nesting/write_layout.h"
#include "io/nesting/write_solids.h"

namespace {

using namespace findspace;

void require(bool law) {
  if (!law) std::abort();
}

template <class Problem, class Read>
void read_and_written(const Problem& problem, const std::string& layout, Read read) {
  const std::string once = io::layout_json(problem, read(layout), {});
  require(io::layout_json(problem, read(once), {}) == once);
}

void in_space(const std::string& problem, const std::string& layout) {
  ReadOptions closed;
  closed.files = false;
  const packing::SolidProblem solids = io::read_solids(problem, "fuzz.json", {}, closed).problem;
  read_and_written(solids, layout,
                   [&](const std::string& text) { return io::read_solid_layout(text, "fuzz", solids); });
}

void in_plane(const std::string& problem, const std::string& layout) {
  io::NestingOptions closed;
  closed.read.files = false;
  const packing::Problem parts = io::read_nesting(problem, "fuzz.json", closed);
  read_and_written(parts, layout, [&](const std::string& text) { return io::read_layout(text, "fuzz", parts); });
}

void read(const std::string& problem, const std::string& layout) {
  if (problem.starts_with('<')) {
    io::read_sparrow_svg(problem, "fuzz.svg");
  } else if (io::is_solid_problem(problem, "fuzz.json")) {
    in_space(problem, layout);
  } else {
    in_plane(problem, layout);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  const std::size_t end = std::min(bytes.find('\0'), size);
  try {
    read(bytes.substr(0, end), bytes.substr(std::min(end + 1, size)));
  } catch (const Error& error) {
    require(!error.message().empty());
  }
  return 0;
}
