// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "common/stage_dump.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>

#include "io/draw/draw_stage.h"
#include "io/mesh/write_mesh.h"
#include "io/write/write_file.h"

namespace findspace::app {
namespace {

constexpr const char* kVariable = "FINDSPACE_DUMP";
constexpr int kMostFiles = 999;  // three digits; maps on lines by values have a search an end

}  // namespace

std::unique_ptr<StageDump> StageDump::from_environment() {
  const char* folder = std::getenv(kVariable);  // NOLINT(concurrency-mt-unsafe)
  if (folder == nullptr || *folder == '\0') return nullptr;
  std::error_code none;
  if (!std::filesystem::is_directory(folder, none))
    throw Error(ErrorCode::kFile, fmt::format("there is no folder '{}'", folder), kVariable);
  if (access(folder, W_OK | X_OK) != 0)
    throw Error(ErrorCode::kFile,
                fmt::format("'{}' cannot be written to: {}", folder, std::generic_category().message(errno)),
                kVariable);
  return std::unique_ptr<StageDump>(new StageDump(folder));
}

std::optional<std::filesystem::path> StageDump::next(std::string_view stage, const char* ending) {
  if (++stages_ > kMostFiles || failed_) return std::nullopt;
  return folder_ / fmt::format("{:03}-{}{}", stages_, stage, ending);
}

void StageDump::write(const std::filesystem::path& path, const std::string& text) {
  try {
    io::write_files({{path, text, {}}});
  } catch (const Error& e) {
    failed_ = e;
  }
}

void StageDump::cells(std::string_view stage, const std::string& title, const plane::CellComplex& cells) {
  if (const auto path = next(stage, ".svg")) write(*path, io::stage_svg(title, cells));
}

void StageDump::drawing(std::string_view stage, const std::string& title, const plane::StageDrawing& drawing) {
  const auto path = next(stage, drawing.planar ? ".svg" : ".obj");
  if (!path) return;
  if (drawing.planar) return write(*path, io::stage_svg(title, drawing));
  write(*path, io::obj_text({drawing.corners, drawing.faces, {}}, title));
}

void StageDump::finish(Reporter& reporter) const {
  if (failed_) throw *failed_;
  const int written = std::min(stages_, kMostFiles);
  const std::string more = stages_ > written ? fmt::format("; {} more stages have no file", stages_ - written) : "";
  reporter.note(
      fmt::format("{}: {} file{} in {}{}", kVariable, written, written == 1 ? "" : "s", folder_.string(), more));
}

}  // namespace findspace::app
