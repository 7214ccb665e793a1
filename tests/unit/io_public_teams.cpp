// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What surrounds questions in the public headers: a team of processes (here of threads), the store of results, the
// files of stages, and JSON as it is read.
#include <findspace/findspace.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <condition_variable>
#include <deque>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <mutex>
#include <thread>

namespace findspace {
namespace io_public_teams {

namespace fs = std::filesystem;

/// A folder that is gone afterwards.
struct Folder {
  fs::path path = fs::temp_directory_path() / ("findspace_teams_" + std::to_string(getpid()));
  Folder() { fs::create_directories(path); }
  ~Folder() { fs::remove_all(path); }
  std::size_t entries() const { return std::size_t(std::distance(fs::directory_iterator(path), {})); }
};

/// What the threads of a team share.
struct Hall {
  explicit Hall(std::size_t n) : boxes(n) {}
  std::mutex guard{};
  std::condition_variable changed{};
  std::vector<std::deque<Team::Message>> boxes;
  std::size_t here = 0, meetings = 0;
  std::string board{};
  std::size_t sent = 0;
};

class ThreadTeam : public Team {
 public:
  ThreadTeam(Hall& hall, std::size_t number) : hall_(hall), number_(number) {}
  std::size_t number() const override { return number_; }
  std::size_t count() const override { return hall_.boxes.size(); }
  void meet() {
    std::unique_lock lock(hall_.guard);
    const std::size_t meeting = hall_.meetings;
    if (++hall_.here == count()) {
      hall_.here = 0;
      ++hall_.meetings;
      hall_.changed.notify_all();
    }
    hall_.changed.wait(lock, [&] { return hall_.meetings != meeting; });
  }
  void broadcast(std::string& bytes, std::size_t from) override {
    if (number_ == from) hall_.board = bytes;
    meet();
    bytes = hall_.board;
    meet();
  }
  bool any(bool own) override { return own; }
  std::string best_of(std::span<const double>, std::string own) override { return own; }
  void send(std::size_t to, int kind, std::string bytes) override {
    const std::lock_guard lock(hall_.guard);
    hall_.boxes[to].push_back({number_, kind, std::move(bytes)});
    ++hall_.sent;
    hall_.changed.notify_all();
  }
  std::optional<Message> receive(bool wait) override {
    std::unique_lock lock(hall_.guard);
    auto& box = hall_.boxes[number_];
    if (wait) hall_.changed.wait(lock, [&] { return !box.empty(); });
    if (box.empty()) return std::nullopt;
    Message out = std::move(box.front());
    box.pop_front();
    return out;
  }

 private:
  Hall& hall_;
  std::size_t number_;
};

/// What each of them answers to ask(path), where only the leader has the file; its answer is that of all.
template <class Ask>
std::vector<std::string> answers(std::size_t processes, const std::string& path, std::size_t& sent, const Ask& ask) {
  Hall hall(processes);
  std::vector<std::string> out(processes);
  std::vector<std::thread> threads;
  for (std::size_t k = 0; k < processes; ++k)
    threads.emplace_back([&, k] {
      ThreadTeam team(hall, k);
      {
        const TeamScope scope(&team);
        try {
          out[k] = ask(k == 0 ? path : path + " is read by the leader");
        } catch (const Error& e) {
          out[k] = e.what();
        }
      }
      team.finish();
    });
  for (std::thread& t : threads) t.join();
  sent = hall.sent;
  return out;
}

constexpr const char* kRock = R"json({"findspace": 1, "shapes": {"rock": {"polytope": [[0, 0, 0], [9, 0, 0], [0, 9, 0],
    [0, 0, 9]]}, "ball": {"ball": {"center": [0, 0, 0], "radius": 2}}}, "moving": "ball",
    "where": "clear(ball, rock) and gap(ball, rock) <= 1"})json";

MapQuestion on_lines() {
  MapQuestion out;
  out.lines = MapLines{24};
  return out;
}

TEST(PublicTeam, AnswersAsOneProcessDoes) {
  const Folder folder;
  const std::string path = (folder.path / "scene.json").string();
  write_files({{path, kRock}});
  const auto ask = [](const std::string& file) {
    const Answer answer = Scene::file(file).map(on_lines());
    return answer.json() + answer.file(".obj").text;
  };
  std::size_t sent = 0;
  const std::string alone = answers(1, path, sent, ask)[0];
  EXPECT_NE(alone.find("\"lines\""), std::string::npos);
  EXPECT_EQ(sent, 0u);
  for (const std::size_t processes : {2, 3}) {
    const std::vector<std::string> found = answers(processes, path, sent, ask);
    EXPECT_EQ(found[0], alone);
    EXPECT_GE(sent, 4 * (processes - 1));  // each asks for rows, and is let go
    EXPECT_EQ(found[1].find("\"lines\""), std::string::npos);
  }
  fs::remove(path);
  const std::vector<std::string> missing = answers(2, path, sent, ask);
  EXPECT_NE(missing[0].find(path + ": "), std::string::npos) << missing[0];
  EXPECT_EQ(missing[1], missing[0]);  // the leader's, with its path
}

TEST(PublicTeam, AnswersOneQuestionAfterAnother) {
  const Folder folder;
  const std::string path = (folder.path / "scene.json").string();
  write_files({{path, kRock}});
  const auto ask = [](const std::string& file) {
    const Scene scene = Scene::file(file);
    const Answer first = scene.map(on_lines()), turned = scene.rotated(Rotation::read("1,1,1:120")).map(on_lines());
    const Answer again = Scene::file(file).map(on_lines());  // read meanwhile
    return first.file(".obj").text + turned.json() + turned.file(".obj").text + again.json();
  };
  std::size_t sent = 0;
  const std::string alone = answers(1, path, sent, ask)[0];
  for (const std::size_t processes : {2, 3}) EXPECT_EQ(answers(processes, path, sent, ask)[0], alone);
}

TEST(PublicTeam, ALeaderMayEndFirst) {
  const Folder folder;
  const std::string path = (folder.path / "scene.json").string();
  write_files({{path, kRock}});
  std::size_t sent = 0;
  const std::vector<std::string> found = answers(2, path, sent, [&](const std::string& file) {
    Scene::file(file).map(on_lines());
    if (file == path) throw Error(ErrorCode::kFile, "the leader cannot write");
    return Scene::file(file).map(on_lines()).json();
  });
  EXPECT_NE(found[0].find("cannot write"), std::string::npos);
  EXPECT_NE(found[1].find("has ended"), std::string::npos) << found[1];
}

TEST(ResultStore, KeepsResults) {
  const Folder folder;
  EXPECT_THROW(ResultStore("/dev/null/folder"), Error);
  const ResultStore store(folder.path.string(), 1 << 20);
  EXPECT_EQ(store.limit(), 1u << 20);
  const auto solved = [] {
    const Shape disc = Shape::unite({Shape::disc({0, 0}, 1), Shape::box({1, 0}, {2, 3})});
    const World world({{"A", Shape::subtract({Shape::box({0, 0}, {20, 20}), disc})}, {"B", disc}}, "B");
    return world.solve("inside(B, A)").json();
  };
  const std::string alone = solved();
  std::uintmax_t size = 0;
  for (int k = 0; k < 2; ++k) {
    const StoreScope scope(store);
    EXPECT_EQ(solved(), alone);
    std::uintmax_t now = 0;
    for (const auto& entry : fs::directory_iterator(folder.path))
      if (entry.path().extension() != ".sqlite-shm") now += entry.file_size();
    EXPECT_TRUE(k != 0 || now > 0);
    EXPECT_TRUE(k != 1 || now == size);  // found, not made again
    size = now;
  }
}

TEST(StageFiles, AreWrittenWhileItLives) {
  const Folder folder;
  EXPECT_THROW(StageFiles((folder.path / "none").string()), Error);
  const auto solve = [] {
    return World({{"A", Shape::box({0, 0}, {9, 9})}, {"B", Shape::disc({0, 0}, 1)}}, "B").solve("inside(B, A)").json();
  };
  const std::string alone = solve();
  EXPECT_EQ(folder.entries(), 0u);
  {
    const StageFiles files(folder.path.string());
    EXPECT_EQ(solve(), alone);
    files.finish();
    EXPECT_GT(files.files(), 1);
    EXPECT_EQ(files.files(), files.stages());
    EXPECT_EQ(folder.entries(), std::size_t(files.files()));
  }
  const std::size_t before = folder.entries();
  solve();
  EXPECT_EQ(folder.entries(), before);
}

TEST(ReadJson, ForgetsNothing) {
  const JsonValue value = read_json("{\"a\": [1.10, true], // why\n  \"b\": null}");
  ASSERT_TRUE(value.is(JsonValue::Kind::kObject));
  EXPECT_EQ(value.keys, (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(value.find("a")->items[0].text, "1.10");
  EXPECT_TRUE(value.find("a")->items[1].boolean);
  EXPECT_STREQ(value.find("a")->kind_name(), "a list");
  EXPECT_EQ(value.find("b")->line, 2);
  EXPECT_EQ(value.find("c"), nullptr);
  try {
    read_json("[1,\n 2", "numbers");
    ADD_FAILURE();
  } catch (const Error& e) {
    EXPECT_EQ(e.place().substr(0, 9), "numbers:2");
  }
  EXPECT_THROW(read_json("[1, 2, 3]", "numbers", 3), Error);
}

TEST(DrawingEndings, SayWhatIsRead) {
  EXPECT_EQ(drawing_endings(2), (std::vector<std::string>{".svg", ".dxf", ".wkt", ".geojson"}));
  EXPECT_EQ(drawing_endings(3).size(), 11u);
}

}  // namespace io_public_teams
}  // namespace findspace
