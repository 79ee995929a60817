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
[[noreturn]] void claim_all(Store store, const fs::path& pressed, int keys, std::uint64_t seed, bool mortal) {
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
  auto s = store();
  const auto runs = folder_ / "store/runs", claims = folder_ / "store/claims";
  for (const auto* name : {".key1-0", ".key2-0", ".key3-0"}) fs::create_directory(runs / name);
  const pid_t child = ::fork();
  if (child == 0) {
    (void)new Claim(*s.claim("key1"));
    std::_Exit(0);
  }
  ::waitpid(child, nullptr, 0);
  const auto living = s.claim("key2");
  write("claims/key3", "0000000001 01 another-host/pid:[1] 1 1\n");
  write("claims/key4", "some-other-host 1 1\n"); // of an older program
  EXPECT_TRUE(fs::exists(claims / "key1"));
  (void)store();
  EXPECT_FALSE(fs::exists(runs / ".key1-0"));
  EXPECT_FALSE(fs::exists(claims / "key1"));
  for (const auto* name : {".key2-0", ".key3-0"}) EXPECT_TRUE(fs::exists(runs / name)) << name;
  for (const auto* name : {"key2", "key3", "key4"}) EXPECT_TRUE(fs::exists(claims / name)) << name;
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

namespace {

const press::Case& small_case() {
  static const press::Case c = [] {
    press::Simple e;
    e.delta_bar_max = 0.001;
    e.elements = 40;
    return press::Case{{"e", material::Elastic{1e9, 0.3}, {}}, 1e-3, e};
  }();
  return c;
}

} // namespace

TEST_F(RunStore, LeavesARunThatIsThereAsItIs) {
  const auto s = store();
  const auto result = press::press(small_case());
  s.keep("key1", small_case(), result, {1, 1});
  s.keep("key1", small_case(), result, {2, 2});
  EXPECT_EQ(s.cost("key1").cpu_s, 1);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_ / "store/runs"), {}), 1);
}

TEST_F(RunStore, SeesWhatIsNotAsItWasWritten) {
  auto s = store();
  const auto key = s.key(small_case());
  const auto result = press::press(small_case());
  const auto damaged_by = [&](const std::string& name,
                              const std::function<std::string(std::string)>& change) {
    s.keep(key, small_case(), result, {1, 1});
    EXPECT_EQ(s.damage(key), "");
    const std::string file = "runs/" + key + "/" + name;
    write(file, change(text(file)));
    EXPECT_EQ(s.verified(key), Store::State::damaged) << name;
    return s.forget_damaged(key);
  };
  const auto shorter = [](std::string content) { return content.substr(0, content.size() / 2) + "\n"; };
  const auto digit = [](std::string content) {
    content[content.find_last_of("123456789")] = '0';
    return content;
  };
  for (const std::string name : {"curve.csv", "case.toml", "summary.json", "cost.txt", "sums.txt"}) {
    EXPECT_NE(damaged_by(name, shorter).find("sums.txt: does not belong to these files"), std::string::npos)
        << name;
    EXPECT_NE(damaged_by(name, digit).find("sums.txt: does not belong to these files"), std::string::npos)
        << name;
    EXPECT_EQ(s.state(key), Store::State::missing);
  }
  EXPECT_NE(damaged_by("identity.txt", digit).find("identity.txt: is that of another run"),
            std::string::npos);
  EXPECT_NE(damaged_by("curve.csv", [](auto) { return ""; }).find("curve.csv: has no end"),
            std::string::npos);
}

TEST_F(RunStore, SeesWhatIsNoRun) {
  auto s = store();
  const auto key = s.key(small_case());
  const auto run = s.run(key);
  const auto is_damaged = [&](const std::string& what) {
    EXPECT_EQ(s.verified(key), Store::State::damaged) << what;
    EXPECT_NE(s.forget_damaged(key).find(what), std::string::npos) << s.damage(key);
    EXPECT_EQ(s.verified(key), Store::State::missing) << what;
  };
  core::write_file(run, "a file\n");
  is_damaged("is no folder");
  fs::create_symlink("nowhere", run);
  is_damaged("is no folder");
  fs::create_directory(run);
  is_damaged("case.toml: is missing");
  s.keep(key, small_case(), press::press(small_case()), {1, 1});
  fs::remove(run / "curve.csv");
  fs::create_directory(run / "curve.csv");
  is_damaged("curve.csv: is no file");
}

TEST_F(RunStore, WhoseStudyCannotBeReadIsRefused) {
  (void)store();
  for (const char* content :
       {"", "a file\n", "0 s\n", "6\n", "6 s\nkeep\n", "6 s\nkept 5\n", "6 s\nkeep 5 4\n"}) {
    write("study.txt", content);
    EXPECT_THROW(Store(folder_ / "store", "s"), core::InvalidInput) << content;
  }
  write("study.txt", "6 s\nkeep 5\nkeep 4\n");
  EXPECT_EQ(Store(folder_ / "store", "s").engines().size(), 3U);
}

TEST_F(RunStore, TakesAWholeRunForADamagedOneAndLeavesOutWhatDiffers) {
  auto s = store();
  const auto key = s.key(small_case());
  auto result = press::press(small_case());
  s.keep(key, small_case(), result, {1, 1});
  const auto other = [&](const char* name) {
    for (auto& point : result.curve.points) point.force_N *= 1.02, point.F_bar *= 1.02;
    Store store(folder_ / name, "s");
    store.open_for_writing(OldRuns::ask);
    store.keep(key, small_case(), result, {2, 2});
    return store;
  };
  const auto differs = s.merge({other("other")}, OldRuns::ask);
  EXPECT_EQ(differs.copied, 0);
  ASSERT_EQ(differs.left_out.size(), 1U);
  EXPECT_NE(differs.left_out[0].find("differs by 2 % from the one that is here"), std::string::npos)
      << differs.left_out[0];
  EXPECT_EQ(s.cost(key).cpu_s, 1);

  write("runs/" + key + "/curve.csv", "half\n");
  const auto mended = s.merge({other("another")}, OldRuns::ask);
  EXPECT_EQ(mended.copied, 1);
  EXPECT_TRUE(mended.left_out.empty());
  EXPECT_EQ(s.verified(key), Store::State::done);
  EXPECT_EQ(s.cost(key).cpu_s, 2);
}

TEST_F(RunStore, OfAnOlderProgramHasNoSumsAndIsReadAllTheSame) {
  auto s = store();
  const auto key = s.key(small_case());
  s.keep(key, small_case(), press::press(small_case()), {1, 1});
  const auto folder = s.run(key);
  fs::remove(folder / "sums.txt");
  EXPECT_EQ(s.verified(key), Store::State::done);
  fs::remove(folder / "identity.txt");
  EXPECT_EQ(s.verified(key), Store::State::done);
  const std::string curve = "runs/" + key + "/curve.csv";
  write(curve, text(curve).substr(0, text(curve).rfind(',')) + "\n");
  EXPECT_EQ(s.verified(key), Store::State::damaged);
}

TEST_F(RunStore, KeepsEveryExperiment) {
  auto s = store();
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

  const auto curves = curves_sheet(cells, s, find_runs(cells, s), 0.002);
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
