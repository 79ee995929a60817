#include "core/parallel.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

using platen::core::in_parallel;

namespace {

TEST(InParallel, DoesEachOnce) {
  for (const std::size_t n : {0, 1, 7, 1000, 4001}) {
    std::vector<int> done(n);
    in_parallel(n, [&](std::size_t i) { ++done[i]; });
    EXPECT_EQ(done, std::vector<int>(n, 1));
  }
}

TEST(InParallel, ThrowsWhatTheFirstThrew) {
  for (const std::size_t n : {10, 4000}) {
    try {
      in_parallel(n, [&](std::size_t i) {
        if (i >= n / 4) throw std::runtime_error(std::to_string(i));
      });
      ADD_FAILURE() << "nothing was thrown";
    } catch (const std::runtime_error& e) { EXPECT_EQ(e.what(), std::to_string(n / 4)); }
  }
}

} // namespace
