// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// docs/scene.md and docs/tour.md show scenes that are read, and the examples are read.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "io/scene/scene.h"
#include "io/text/read_text.h"

namespace findspace::io {
namespace io_scene_docs {

/// Reads all scenes of a page; how many there are.
int scenes_of(const std::string& name) {
  const std::string page = read_text(std::filesystem::path(FINDSPACE_SOURCE) / "docs" / name);
  const std::string open = "```json\n", close = "```";
  int scenes = 0;
  for (std::size_t at = page.find(open); at != std::string::npos; at = page.find(open, at)) {
    at += open.size();
    const std::size_t end = page.find(close, at);
    if (end == std::string::npos) break;
    EXPECT_NO_THROW(read_scene_text(page.substr(at, end - at), FINDSPACE_SOURCE, name)) << page.substr(at, end - at);
    at = end + close.size();
    ++scenes;
  }
  return scenes;
}

TEST(SceneDocs, EverySceneIsRead) {
  EXPECT_GE(scenes_of("scene.md"), 4);
  EXPECT_EQ(scenes_of("tour.md"), 1);
}

TEST(SceneDocs, EveryExampleIsRead) {
  for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(FINDSPACE_SOURCE) / "examples")) {
    if (entry.path().extension() == ".json") {
      EXPECT_NO_THROW(read_scene(entry.path())) << entry.path();
    }
  }
}

}  // namespace io_scene_docs
}  // namespace findspace::io
