// Laws are made and evaluated by any number of threads. That nothing is shared unguarded the thread sanitizer
// sees (preset "threads"); here the numbers are asked for.
#include "random_material.hpp"

#include <functional>
#include <gtest/gtest.h>
#include <thread>

using namespace platen::law;

namespace {

constexpr int threads = 4;

void on_threads(const std::function<void(int)>& work) {
  std::vector<std::jthread> all;
  for (int t = 0; t < threads; ++t) all.emplace_back(work, t);
}

std::vector<double> forces(const Law& law, double R) {
  std::vector<double> list;
  State state;
  for (int i = 1; i <= 200; ++i) {
    const auto now = evaluate(law, state, R * (i % 50) * i / 2e4);
    state = now.state;
    list.push_back(now.force);
  }
  return list;
}

} // namespace

TEST(Threads, MakeTheSameTablesSideBySide) {
  platen::law::testing::Random random;
  for (const auto& info : laws()) {
    auto one = platen::law::testing::random_material(info, random);
    one.parameters["radius_m"] = "1e-3";
    std::vector<double> of[threads];
    on_threads([&](int t) {
      try {
        of[t] = forces(make_law(one.name, one.variant, one.parameters), 1e-3);
      } catch (const BadParameter&) {} // what is drawn may be refused, by all alike
    });
    for (int t = 1; t < threads; ++t) EXPECT_EQ(of[0], of[t]) << platen::law::testing::text_of(one);
  }
}

TEST(Threads, ShareALawThatIsMade) {
  const Law law = make_law("agarwal", "", parameter_texts("radius_m=1e-3 E_Pa=1e9 nu=0.3 sigma_y_Pa=5e6"));
  std::vector<double> of[threads];
  on_threads([&](int t) { of[t] = forces(law, 1e-3); });
  for (int t = 1; t < threads; ++t) EXPECT_EQ(of[0], of[t]);
  EXPECT_GT(*std::max_element(of[0].begin(), of[0].end()), 0);
}
