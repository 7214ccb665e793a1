// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// docs/scene.md shows scenes that are read, and the examples are read.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "io/read_text.h"
#include "io/scene.h"

namespace findspace::io {
namespace {

TEST(SceneDocs, EverySceneIsRead) {
  std::string page = read_text(std::filesystem::path(FINDSPACE_SOURCE) / "docs/scene.md");
  const std::string open = "```json\n", close = "```";
  int scenes = 0;
  for (std::size_t at = page.find(open); at != std::string::npos; at = page.find(open, at)) {
    at += open.size();
    std::size_t end = page.find(close, at);
    ASSERT_NE(end, std::string::npos);
    EXPECT_NO_THROW(read_scene_text(page.substr(at, end - at), FINDSPACE_SOURCE, "scene.md"))
        << page.substr(at, end - at);
    at = end + close.size();
    ++scenes;
  }
  EXPECT_GE(scenes, 4);
}

TEST(SceneDocs, EveryExampleIsRead) {
  for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(FINDSPACE_SOURCE) / "examples")) {
    if (entry.path().extension() == ".json") {
      EXPECT_NO_THROW(read_scene(entry.path())) << entry.path();
    }
  }
}

}  // namespace
}  // namespace findspace::io
