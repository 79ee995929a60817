#include "study/store.hpp"

#include "core/error.hpp"
#include "core/file.hpp"
#include "press/press.hpp"
#include "study/random.hpp"
#include "study/table.hpp"
#include "study/work.hpp"

#include <gtest/gtest.h>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <thread>

using namespace platen;
using namespace platen::study;
namespace fs = std::filesystem;

namespace {

class RunStore : public testing::Test {
 protected:
  RunStore() : folder_(fs::temp_directory_path() / ("platen-store-test-" + std::to_string(::getpid()))) {
    fs::remove_all(folder_);
  }
  ~RunStore() override { fs::remove_all(folder_); }

  Store store() const {
    Store s(folder_ / "store", "s");
    s.open_for_writing(OldRuns::ask);
    return s;
  }
  std::string text(const std::string& name) const { return core::read_file(folder_ / "store" / name); }
  void write(const std::string& name, const std::string& content) const {
    core::write_file(folder_ / "store" / name, content);
  }

  fs::path folder_;
};

std::string key(int i) { return "key" + std::to_string(i); }

/// Goes through all keys as a worker does; each "press" is a file that must not be there before. Dies at
/// random with the claim in its hands.
[[noreturn]] void claim_all(const Store& store, const fs::path& pressed, int keys, std::uint64_t seed,
                            bool mortal) {
  Random random(seed);
  for (int left = keys; left > 0;) {
    left = 0;
    for (int i = 0; i < keys; ++i) {
      if (store.state(key(i)) != Store::State::missing) continue;
      ++left;
      const auto claim = store.claim(key(i));
      if (!claim) continue;
      const fs::path mark = pressed / key(i);
      const int file = ::open(mark.c_str(), O_CREAT | O_EXCL | O_WRONLY, 0644);
      if (file < 0) std::_Exit(1); // somebody else presses it
      ::close(file);
      if (random.uniform() < 0.3) std::this_thread::sleep_for(std::chrono::microseconds(200));
      ::unlink(mark.c_str());
      if (mortal && random.uniform() < 0.2) std::_Exit(2);
      fs::create_directory(store.run(key(i)));
    }
  }
  std::_Exit(0);
}

} // namespace

TEST_F(RunStore, NeverGivesOneRunToTwoWorkers) {
  const auto s = store();
  const fs::path pressed = folder_ / "pressed";
  fs::create_directories(pressed);
  constexpr int keys = 200;
  std::vector<pid_t> workers;
  for (int i = 0; i < 8; ++i) {
    const pid_t child = ::fork();
    if (child == 0) claim_all(s, pressed, keys, static_cast<std::uint64_t>(i), i < 4);
    workers.push_back(child);
  }
  int dead = 0;
  for (const pid_t worker : workers) {
    int status = 0;
    ::waitpid(worker, &status, 0);
    ASSERT_TRUE(WIFEXITED(status));
    EXPECT_NE(WEXITSTATUS(status), 1) << "two workers pressed the same run";
    dead += WEXITSTATUS(status) == 2;
  }
  EXPECT_GT(dead, 0) << "nobody died: the test does not test what it says";
  for (int i = 0; i < keys; ++i) EXPECT_TRUE(s.state(key(i)) == Store::State::done);
}

TEST_F(RunStore, SweepsWhatTheDeadLeft) {
  (void)store();
  std::array<char, 256> host{};
  ::gethostname(host.data(), host.size() - 1);
  const auto runs = folder_ / "store/runs", claims = folder_ / "store/claims";
  const std::string dead = std::string(".key1-") + host.data() + "-999999999";
  const std::string live = std::string(".key2-") + host.data() + "-" + std::to_string(::getpid());
  for (const auto& name :
       {dead, live, std::string(".key3-some-other-host-1"), std::string(".key4-another-1")})
    fs::create_directory(runs / name);
  const auto long_ago = fs::file_time_type::clock::now() - std::chrono::hours(1);
  fs::last_write_time(runs / ".key4-another-1", long_ago);
  write("claims/key1", std::string(host.data()) + " 999999999 1\n");
  write("claims/key3", "some-other-host 1 1\n");
  (void)store();
  EXPECT_FALSE(fs::exists(runs / dead));
  EXPECT_TRUE(fs::exists(runs / live));
  EXPECT_TRUE(fs::exists(runs / ".key3-some-other-host-1"));
  EXPECT_FALSE(fs::exists(runs / ".key4-another-1"));
  EXPECT_FALSE(fs::exists(claims / "key1"));
  EXPECT_TRUE(fs::exists(claims / "key3"));
}

TEST_F(RunStore, OfAnotherEngineIsKeptOrRecomputed) {
  const press::Case c;
  (void)store();
  write("study.txt", "1 s\n");
  const std::string older = key_of(c, 1);
  fs::create_directory(folder_ / "store/runs" / older);
  Store s(folder_ / "store", "s");
  EXPECT_EQ(s.key(c), older);
  EXPECT_THROW(s.open_for_writing(OldRuns::ask), core::InvalidInput);
  s.open_for_writing(OldRuns::keep);
  EXPECT_EQ(s.key(c), older);
  EXPECT_EQ(store().key(c), older) << "the decision is remembered";
  s.open_for_writing(OldRuns::recompute);
  EXPECT_EQ(s.key(c), key_of(c));
  EXPECT_EQ(store().key(c), key_of(c));
}

TEST_F(RunStore, OfAnotherStudyIsRefused) {
  (void)store();
  EXPECT_THROW(Store(folder_ / "store", "other"), core::InvalidInput);
}

TEST_F(RunStore, WritesWhatTheFirstVersionRead) {
  (void)store();
  EXPECT_EQ(text("study.txt"), std::to_string(core::engine) + " s\n");
}

TEST_F(RunStore, LeavesARunThatIsThereAsItIs) {
  const auto s = store();
  press::Simple e;
  e.delta_bar_max = 0.001;
  e.elements = 40;
  const press::Case c{{"e", material::Elastic{1e9, 0.3}, {}}, 1e-3, e};
  const auto result = press::press(c);
  s.keep("key1", c, result, {1, 1});
  s.keep("key1", c, result, {2, 2});
  EXPECT_EQ(s.cost("key1").cpu_s, 1);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_ / "store/runs"), {}), 1);
}

TEST_F(RunStore, KeepsEveryExperiment) {
  const auto s = store();
  const auto pressed = [&](const std::string& mesh, const std::string& experiments) {
    core::write_file(
        folder_ / "study.toml",
        "platen = 1\nname = \"s\"\n[case]\nplaten = 1\nexperiment = \"simple\"\nradius_m = 1e-2\n"
        "material = \"von-mises-100\"\n[case.path]\ndelta_bar_max = 0.004\n[case.mesh]\n" +
            mesh + "\n[design]\nkind = \"factorial\"\n[factors]\nexperiment = { values = [" + experiments +
            "] }\n");
    auto study = read_study((folder_ / "study.toml").string());
    work(study, s);
    return study;
  };
  const auto summary = [&](const Study& study, std::size_t run) {
    return text("runs/" + s.key(study.runs[run].press_case) + "/summary.json");
  };
  const auto local = pressed("edges = 8", "\"local\"");
  EXPECT_NE(summary(local, 0).find("\"yield_at_edge\""), std::string::npos);
  const auto cells = pressed("elements = 200", "\"simple\", \"die\", \"hydrostatic\"");
  EXPECT_EQ(tally(cells, s).done, 3);
  EXPECT_EQ(summary(cells, 0).find("\"cell_filling\""), std::string::npos);
  EXPECT_NE(summary(cells, 1).find("\"cell_filling\""), std::string::npos);
  EXPECT_NE(summary(cells, 2).find("\"cell_filling\""), std::string::npos);

  const auto curves = curves_sheet(cells, s, 0.002);
  EXPECT_EQ(curves.columns.back(), "a_bar_x"); // of the die
  int walls = 0, no_walls = 0;
  for (const auto& row : curves.rows) {
    const bool die = std::get<std::int64_t>(row[0]) == 2;
    EXPECT_EQ(std::holds_alternative<double>(row.back()), die);
    ++(die ? walls : no_walls);
  }
  EXPECT_GT(walls, 0);
  EXPECT_GT(no_walls, 0);
}
