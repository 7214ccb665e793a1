// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Files within limits and pieces of JSON, through the public headers.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <limits>
#include <vector>

#include "findspace/error.h"
#include "findspace/text.h"

namespace io_public_text {

using namespace findspace;
namespace fs = std::filesystem;

ErrorCode code_of(const std::string& path, std::uint64_t most, const std::string& root = {}) {
  try {
    read_text(path, most, root);
  } catch (const Error& e) {
    return e.code();
  }
  return ErrorCode::kUsage;
}

TEST(PublicText, FilesAreReadWithinLimits) {
  const fs::path folder = fs::temp_directory_path() / "findspace_public_text";
  fs::create_directories(folder / "inner");
  const std::string path = (folder / "some.txt").string();
  std::ofstream(path) << "twelve bytes";
  EXPECT_EQ(read_text(path), "twelve bytes");
  EXPECT_EQ(read_text(path, 12, folder.string()), "twelve bytes");
  EXPECT_EQ(read_text(path, std::numeric_limits<std::uint64_t>::max()), "twelve bytes");
  EXPECT_EQ(code_of(path, 11), ErrorCode::kLimit);
  EXPECT_EQ(code_of(path, 12, (folder / "inner").string()), ErrorCode::kFile);
  EXPECT_EQ(code_of(folder.string(), 12), ErrorCode::kFile);
  EXPECT_EQ(code_of(path + ".none", 12), ErrorCode::kFile);
  fs::remove_all(folder);
}

TEST(PublicText, PiecesOfJson) {
  EXPECT_EQ(json_number(0.1), "0.1");
  EXPECT_EQ(json_number(-0.0), "0");
  EXPECT_EQ(json_number(-std::numeric_limits<double>::infinity()), "\"-inf\"");
  EXPECT_EQ(json_number(std::numeric_limits<double>::quiet_NaN()), "null");
  EXPECT_EQ(json_string("a\"\\\n"), "\"a\\\"\\\\\\u000a\"");
  const std::vector<double> numbers{1, 2.5};
  EXPECT_EQ(json_list(numbers, json_number), "[1, 2.5]");
  EXPECT_EQ(json_list(std::vector<double>{}, json_number, true), "[]");
  EXPECT_EQ(json_list(numbers, json_number, true), "[\n      1,\n      2.5]");
}

}  // namespace io_public_text
