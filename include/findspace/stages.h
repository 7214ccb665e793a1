// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The geometry of each stage of an answer as files, for whoever wants to see how it comes about: convex parts, sums,
// sign maps, overlays, cells of searches (docs/architecture.md, "Debugging"). Guarantee: answers are the same, and the
// files are for any number of threads, because work is not spread over threads meanwhile. Keywords: debug dump, trace.
#pragma once

#include <memory>
#include <string>

namespace findspace {

/// While it lives, the stages of what this thread is asked are written into a folder, numbered in the order of the
/// computation: SVG in the plane, OBJ in space, in grid steps or in steps that divide them.
class StageFiles {
 public:
  /// Error(kFile) where there is no such folder, or it cannot be written to. Messages call it by the name.
  explicit StageFiles(const std::string& folder, const std::string& name = "stages");
  ~StageFiles();
  StageFiles(const StageFiles&) = delete;
  StageFiles& operator=(const StageFiles&) = delete;

  /// As it was given.
  const std::string& folder() const;
  /// How many there have been; the first 999 have files.
  int stages() const;
  int files() const;
  /// Throws the first error that writing gave: a stage may end while an exception passes.
  void finish() const;

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

}  // namespace findspace
