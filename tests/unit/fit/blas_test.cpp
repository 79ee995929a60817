// Which kernels the solver computes with in a program that has Ceres in it as well.

#include "fe/dissection.hpp"
#include "fit/edmans_sinka.hpp"

#include <dlfcn.h>
#include <gtest/gtest.h>

using namespace platen;

// Ceres brings ATLAS with it, which the solver would take were it found first: presses would be 1.2 to 1.7
// times as long.
TEST(Dissection, ComputesWithOpenBlasBesideCeres) {
  const std::vector<std::vector<int>> element = {{0, 1}};
  fe::Dissection solver(2, element, std::vector<fe::Vector3>{{}}); // or the linker would leave it out
  EXPECT_THROW(fit::fit_edmans_sinka(press::Curve{}), std::exception);
  void* const openblas = dlopen("libopenblas.so.0", RTLD_LAZY | RTLD_NOLOAD);
  ASSERT_NE(openblas, nullptr);
  EXPECT_EQ(dlsym(RTLD_DEFAULT, "dgemm_"), dlsym(openblas, "dgemm_"));
  EXPECT_EQ(dlsym(RTLD_DEFAULT, "sgemm_"), dlsym(openblas, "sgemm_"));
}
