// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "findspace/error.h"
#include "findspace/text.h"
#include "io/text/spool.h"

namespace findspace::io {
namespace io_write_file {

namespace fs = std::filesystem;

class WriteFile : public testing::Test {
 protected:
  WriteFile() { fs::create_directories(folder_); }
  ~WriteFile() override { fs::remove_all(folder_); }
  static std::string read(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  std::size_t entries() const { return std::size_t(std::distance(fs::directory_iterator(folder_), {})); }

  fs::path folder_ = fs::temp_directory_path() / ("findspace_write_file_" + std::to_string(getpid()));
};

TEST_F(WriteFile, WritesAndReplaces) {
  write_files({{folder_ / "a", "first"}});
  write_files({{folder_ / "a", std::string("second\0", 7)}});
  EXPECT_EQ(read(folder_ / "a").size(), 7u);
  write_files({{folder_ / "a", ""}});
  EXPECT_EQ(read(folder_ / "a"), "");
  EXPECT_EQ(entries(), 1u);
}

TEST_F(WriteFile, MissingFolderAndFolderAsTarget) {
  EXPECT_THROW(write_files({{folder_ / "none" / "a", "x"}}), Error);
  fs::create_directory(folder_ / "b");
  EXPECT_THROW(write_files({{folder_ / "b", "x"}}), Error);
  EXPECT_EQ(entries(), 1u);
}

TEST_F(WriteFile, AllOrNone) {
  write_files({{folder_ / "a", "old"}});
  const std::vector<FileText> last_fails[] = {
      {{folder_ / "a", "new"}, {folder_ / "c", "new"}, {folder_ / "none" / "b", "x"}},
      {{folder_ / "a", "new"}, {folder_ / "c", "new"}, {folder_, "x"}},
      {{folder_ / "a", "new"}, {folder_ / "c", "new"}, {"/dev/full", "x"}}};
  for (const auto& files : last_fails) {
    EXPECT_THROW(write_files(files), Error);
    EXPECT_EQ(read(folder_ / "a"), "old");
    EXPECT_EQ(entries(), 1u);
  }
  write_files({{folder_ / "a", "new"}, {folder_ / "c", "too"}});
  EXPECT_EQ(read(folder_ / "a") + read(folder_ / "c"), "newtoo");
}

TEST_F(WriteFile, LinksStayLinks) {
  write_files({{folder_ / "a", "old"}});
  fs::create_symlink("a", folder_ / "link");
  write_files({{folder_ / "link", "new"}});
  EXPECT_TRUE(fs::is_symlink(folder_ / "link"));
  EXPECT_EQ(read(folder_ / "a"), "new");
}

TEST_F(WriteFile, DevicesAreWrittenTo) {
  write_files({{"/dev/null", "x"}});
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  EXPECT_THROW(write_files({{"/dev/full", "x"}}), Error);
}

TEST_F(WriteFile, TakesTextPieceByPiece) {
  Spool spool;
  EXPECT_TRUE(spool.empty());
  std::string all;
  for (int k = 0; k < 50000; ++k) {
    const std::string part = std::to_string(k) + " ";
    spool.append(part);
    all += part;
  }
  write_files({{folder_ / "a", {}, [&](const TextSink& sink) {
                  spool.copy_to(sink);
                  spool.copy_to(sink);
                }}});
  EXPECT_EQ(read(folder_ / "a"), all + all);
  const auto fails = [&](const TextSink& sink) {
    sink("half");
    throw Error(ErrorCode::kFile, "no more");
  };
  EXPECT_THROW(write_files({{folder_ / "b", "x"}, {folder_ / "a", {}, fails}}), Error);
  EXPECT_EQ(read(folder_ / "a"), all + all);
  EXPECT_EQ(entries(), 1u);
}

}  // namespace io_write_file
}  // namespace findspace::io
