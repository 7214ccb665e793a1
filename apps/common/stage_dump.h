// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// FINDSPACE_DUMP=DIR: the geometry of every stage of an answer as a file, numbered in the order of the computation: SVG
// in the plane, OBJ in space, in grid steps or in steps that divide them. The same files for any number of threads.
// Keywords: debug dump.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "common/reporter.h"
#include "findspace/error.h"
#include "plane/base/stage_observer.h"

namespace findspace::app {

class StageDump : public plane::StageObserver {
 public:
  /// Null where the variable is not set. Throws Error(kFile) where it names no folder that can be written to.
  static std::unique_ptr<StageDump> from_environment();

  void cells(std::string_view stage, const std::string& title, const plane::CellComplex& cells) override;
  void drawing(std::string_view stage, const std::string& title, const plane::StageDrawing& drawing) override;
  /// Says how many files there are. Throws the first error that writing gave.
  void finish(Reporter& reporter) const;

 private:
  explicit StageDump(std::filesystem::path folder) : folder_(std::move(folder)) {}
  /// The file of the next stage; nothing where there are enough.
  std::optional<std::filesystem::path> next(std::string_view stage, const char* ending);
  /// A stage may end while an exception passes, so errors are kept.
  void write(const std::filesystem::path& path, const std::string& text);

  std::filesystem::path folder_;
  int stages_ = 0;
  std::optional<Error> failed_;
};

}  // namespace findspace::app
