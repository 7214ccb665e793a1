// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "common/outputs.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "findspace/error.h"
#include "findspace/team.h"
#include "findspace/text.h"

namespace findspace::app {

namespace {

void check_own_outputs(const Options& options, const std::vector<std::string>& formats) {
  for (const auto& path : options.outputs) {
    const auto is_it = [&](const std::string& word) {
      std::error_code none;  // where one of them is not there, they are not the same
      return std::filesystem::equivalent(path, word, none);
    };
    if (is_it(options.scene) || std::any_of(options.shapes.begin(), options.shapes.end(), is_it))
      throw Error(ErrorCode::kUsage, fmt::format("-o {}: this is the input itself; it would be lost", path.string()));
    if (std::find(formats.begin(), formats.end(), path.extension().string()) != formats.end()) continue;
    throw Error(ErrorCode::kUsage,
                fmt::format("-o {}: the ending must be one of {}", path.string(), fmt::join(formats, " ")));
  }
}

}  // namespace

void check_outputs(const Options& options, const std::vector<std::string>& formats) {
  if (options.team == nullptr) return check_own_outputs(options, formats);
  options.team->shared_text([&] { return check_own_outputs(options, formats), std::string(); });
}

void write_outputs(const Options& options, const Writers& writers, const Streams& streams) {
  std::vector<FileText> files;
  for (const auto& path : options.outputs) {
    const auto stream = streams.find(path.extension().string());
    if (stream != streams.end())
      files.push_back({path, {}, stream->second});
    else
      files.push_back({path, writers.at(path.extension().string())(), {}});
  }
  findspace::write_files(files);
}

}  // namespace findspace::app
