#include "study/claims.hpp"

#include "core/file.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <thread>

using namespace platen;
using namespace platen::study;
using namespace std::chrono_literals;
namespace fs = std::filesystem;

namespace {

class ClaimFiles : public testing::Test {
 protected:
  ClaimFiles() : folder_(fs::temp_directory_path() / ("platen-claims-test-" + std::to_string(::getpid()))) {
    fs::create_directories(folder_);
  }
  ~ClaimFiles() override { fs::remove_all(folder_); }
  /// As by a worker whose processes cannot be looked up from here.
  void claim_elsewhere(int beat) const {
    core::write_file(folder_ / "key", "000000000" + std::to_string(beat) + " 0123 another/pid:[1] 1 1\n");
  }
  fs::path folder_;
};

} // namespace

TEST_F(ClaimFiles, GoWithTheirOwner) {
  Claims claims(folder_), others(folder_);
  {
    const auto mine = claims.take("key");
    ASSERT_TRUE(mine);
    EXPECT_FALSE(others.take("key"));
    EXPECT_EQ(others.count(), 1);
  }
  EXPECT_EQ(others.count(), 0);
  EXPECT_TRUE(others.take("key"));
}

TEST_F(ClaimFiles, CountOnWhileTheirOwnerLives) {
  const auto mine = Claims(folder_, {5ms, 1s}).take("key");
  const std::string before = core::read_file(folder_ / "key");
  for (int i = 0; i < 400 && core::read_file(folder_ / "key") == before; ++i)
    std::this_thread::sleep_for(5ms);
  EXPECT_NE(core::read_file(folder_ / "key"), before);
}

TEST_F(ClaimFiles, FromElsewhereAreBelievedWhileTheyCountAndNotByTheirDate) {
  Claims claims(folder_, {1s, 100ms});
  for (int beat = 0; beat < 8; ++beat) {
    claim_elsewhere(beat);
    fs::last_write_time(folder_ / "key",
                        fs::file_time_type::clock::now() - 24h); // a clock that is a day behind
    EXPECT_FALSE(claims.take("key")) << beat;
    std::this_thread::sleep_for(30ms);
  }
  std::this_thread::sleep_for(150ms);
  EXPECT_TRUE(claims.take("key"));
}

TEST_F(ClaimFiles, WithoutContentAreTakenOverAfterTheSilence) {
  core::write_file(folder_ / "key", "");
  Claims claims(folder_, {1s, 50ms});
  EXPECT_FALSE(claims.take("key"));
  std::this_thread::sleep_for(100ms);
  EXPECT_TRUE(claims.take("key"));
}

TEST_F(ClaimFiles, AreTakenOverThoughWhoBeganToTakeThemOverDied) {
  claim_elsewhere(1);
  core::write_file(folder_ / ".key", "");
  Claims claims(folder_, {1s, 30ms});
  bool taken = false;
  for (int i = 0; i < 100 && !taken; ++i) {
    taken = claims.take("key").has_value();
    std::this_thread::sleep_for(10ms);
  }
  EXPECT_TRUE(taken);
}

TEST_F(ClaimFiles, ThatWereTakenOverAreLeftToTheirNewOwner) {
  {
    const auto mine = Claims(folder_).take("key");
    claim_elsewhere(1);
  }
  EXPECT_TRUE(fs::exists(folder_ / "key"));
}
