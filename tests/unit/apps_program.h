// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Runs the program in a folder of its own. Keywords: fixture, exit status, streams.
#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>

namespace apps_program {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr const char* kScene = R"json({"findspace": 1, "unit": "mm", "shapes": {
  "A": {"box": {"min": [0, 0], "max": [10, 6]}}, "B": {"box": {"min": [-1, -1], "max": [1, 1]}}},
  "moving": "B", "where": "inside(B, A)"})json";

class Program : public testing::Test {
 protected:
  struct Result {
    int status = -1;
    std::string out, err;
  };

  Program() { fs::create_directories(folder_); }
  ~Program() override { fs::remove_all(folder_); }

  /// The arguments as a shell takes them, in a folder with scene.json.
  Result run(const std::string& arguments, const std::string& scene = kScene) const {
    std::ofstream(folder_ / "scene.json") << scene;
    const std::string command =
        "cd '" + folder_.string() + "' && '" FINDSPACE_PROGRAM "' " + arguments + " > out.txt 2> err.txt";
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read("out.txt"), read("err.txt")};
  }
  std::string read(const char* name) const {
    std::ifstream file(folder_ / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  bool exists(const char* name) const { return fs::exists(folder_ / name); }

  static std::string scene_where(const std::string& formula) {
    std::string scene = kScene;
    return scene.replace(scene.find("inside(B, A)"), 12, formula);
  }

  fs::path folder_ = fs::temp_directory_path() / ("findspace_program_" + std::to_string(getpid()));
};

inline bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace apps_program
