// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Files of stages.

#include <findspace/error.h>
#include <findspace/stages.h>
#include <findspace/text.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <optional>
#include <string_view>
#include <system_error>

#include "io/draw/draw_stage.h"
#include "io/mesh/write_mesh.h"
#include "plane/base/stage_observer.h"

namespace findspace {
namespace {

constexpr int kMostFiles = 999;  // three digits; maps on lines by values have a search an end

}  // namespace

class StageWriter : public plane::StageObserver {
 public:
  StageWriter(std::filesystem::path folder, const std::string& name) : folder_(std::move(folder)) {
    std::error_code none;
    if (!std::filesystem::is_directory(folder_, none))
      throw Error(ErrorCode::kFile, fmt::format("there is no folder '{}'", folder_.string()), name);
    if (access(folder_.c_str(), W_OK | X_OK) != 0)
      throw Error(
          ErrorCode::kFile,
          fmt::format("'{}' cannot be written to: {}", folder_.string(), std::generic_category().message(errno)), name);
  }

  void cells(std::string_view stage, const std::string& title, const plane::CellComplex& cells) override {
    if (const auto path = next(stage, ".svg")) write(*path, io::stage_svg(title, cells));
  }
  void drawing(std::string_view stage, const std::string& title, const plane::StageDrawing& drawing) override {
    const auto path = next(stage, drawing.planar ? ".svg" : ".obj");
    if (!path) return;
    if (drawing.planar) return write(*path, io::stage_svg(title, drawing));
    write(*path, io::obj_text({drawing.corners, drawing.faces, {}}, title));
  }

  int stages() const { return stages_; }
  const std::optional<Error>& failed() const { return failed_; }

 private:
  /// The file of the next stage; nothing where there are enough.
  std::optional<std::string> next(std::string_view stage, const char* ending) {
    if (++stages_ > kMostFiles || failed_) return std::nullopt;
    return (folder_ / fmt::format("{:03}-{}{}", stages_, stage, ending)).string();
  }
  void write(const std::string& path, const std::string& text) {
    try {
      write_files({{path, text}});
    } catch (const Error& e) {
      failed_ = e;
    }
  }

  std::filesystem::path folder_;
  int stages_ = 0;
  std::optional<Error> failed_;
};

struct StageFiles::Data {
  std::string folder;
  StageWriter writer;
  plane::ObserveStages observed{&writer};

  Data(const std::string& where, const std::string& name) : folder(where), writer(where, name) {}
};

StageFiles::StageFiles(const std::string& folder, const std::string& name)
    : data_(std::make_unique<Data>(folder, name)) {}
StageFiles::~StageFiles() = default;
const std::string& StageFiles::folder() const { return data_->folder; }
int StageFiles::stages() const { return data_->writer.stages(); }
int StageFiles::files() const { return std::min(stages(), kMostFiles); }
void StageFiles::finish() const {
  if (const auto& failed = data_->writer.failed()) throw *failed;
}

}  // namespace findspace
