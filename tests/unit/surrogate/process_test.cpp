#include "surrogate/process.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace platen::surrogate {
namespace {

/// Places in the square that fill it evenly (Roberts's additive recurrence).
Inputs places(std::size_t count) {
  Inputs inputs{2, {}};
  for (std::size_t i = 0; i < count; ++i)
    for (const double step : {0.7548776662466927, 0.5698402909980532})
      inputs.values.push_back(std::fmod(0.5 + step * static_cast<double>(i), 1.0));
  return inputs;
}

std::vector<double> values_of(const Inputs& inputs, double (*f)(double, double)) {
  std::vector<double> values;
  for (std::size_t i = 0; i < inputs.size(); ++i) values.push_back(f(inputs.row(i)[0], inputs.row(i)[1]));
  return values;
}

double variance_at(const Process& p, const Inputs& inputs, std::span<const double> at) {
  return variances({&p, 1}, inputs, at)[0];
}

double wavy(double x, double y) { return std::sin(3 * x) * std::cos(2 * y) - 0.2; }

TEST(Process, GoesThroughItsValues) {
  const Inputs inputs = places(40);
  const auto values = values_of(inputs, wavy);
  const Process p = fit_process(inputs, values);
  for (std::size_t i = 0; i < inputs.size(); ++i)
    EXPECT_NEAR(means({&p, 1}, inputs, inputs.row(i))[0], values[i], 1e-4);
}

TEST(Process, SaysASmoothFunctionBetweenThem) {
  const Inputs inputs = places(40);
  const Process p = fit_process(inputs, values_of(inputs, wavy));
  for (double x = 0.1; x < 0.95; x += 0.2)
    for (double y = 0.1; y < 0.95; y += 0.2) {
      const std::vector<double> at = {x, y};
      EXPECT_NEAR(means({&p, 1}, inputs, at)[0], wavy(x, y), 5e-3) << x << " " << y;
    }
}

TEST(Process, ContinuesAPlaneBeyondItsInputs) {
  const auto plane = [](double x, double y) { return 2 * x - y; };
  const Inputs inputs = places(30);
  const Process p = fit_process(inputs, values_of(inputs, plane));
  const std::vector<double> at = {1.3, -0.2};
  EXPECT_NEAR(means({&p, 1}, inputs, at)[0], plane(1.3, -0.2), 0.05);
}

// Of more inputs than are asked: the nearest are others at every place, most of the same at places near by,
// none of them far away.
TEST(Process, RemembersWhatItSaidBefore) {
  for (const std::size_t count : {230, 400}) {
    const Inputs inputs = places(count);
    auto values = values_of(inputs, wavy);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] += i % 2 ? 0.003 : -0.003;
    Process p = fit_process(places(120), values_of(places(120), wavy));
    p.nugget = 1e-4;
    pass_through(p, inputs, values);
    Process known = p;
    remember(known, inputs);
    for (double x = -0.2; x < 1.3; x += 0.25)
      for (double y = -0.2; y < 1.3; y += x < 0.4 ? 0.15 : 0.01) {
        const std::vector<double> at = {x, y};
        const double variance = variance_at(p, inputs, at);
        EXPECT_GT(variance, 0);
        EXPECT_NEAR(variance_at(known, inputs, at), variance, 1e-7 * variance) << x << " " << y;
      }
  }
}

// The closed form against what it stands for: each value taken away, the process made of the others.
TEST(Process, LeavesOutInClosedForm) {
  const Inputs inputs = places(25);
  auto values = values_of(inputs, wavy);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] += i % 2 ? 0.01 : -0.01; // a nugget
  const Process p = fit_process(inputs, values);
  const LeftOut out = left_out(p, inputs, values);
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    Inputs others = inputs;
    auto other_values = values;
    others.values.erase(others.values.begin() + static_cast<std::ptrdiff_t>(2 * i),
                        others.values.begin() + static_cast<std::ptrdiff_t>(2 * i + 2));
    other_values.erase(other_values.begin() + static_cast<std::ptrdiff_t>(i));
    Process without = p;
    pass_through(without, others, other_values);
    EXPECT_NEAR(means({&without, 1}, others, inputs.row(i))[0], out.mean[i], 1e-9);
    without.variance = p.variance; // of all values, as the closed form has it
    const double variance = variance_at(without, others, inputs.row(i)) + p.nugget * p.variance;
    EXPECT_NEAR(variance, out.variance[i], 1e-6 * out.variance[i]);
  }
}

TEST(Process, KnowsMostAtItsInputsAndLittleFarAway) {
  const Inputs inputs = places(30);
  const Process p = fit_process(inputs, values_of(inputs, wavy));
  const std::vector<double> far = {5, 5};
  const double here = variance_at(p, inputs, inputs.row(3));
  EXPECT_LT(here, 1e-4 * p.variance);
  EXPECT_GT(variance_at(p, inputs, far), 100 * here);
}

TEST(Process, IsTheSameEachTime) {
  const Inputs inputs = places(20);
  const auto values = values_of(inputs, wavy);
  EXPECT_EQ(fit_process(inputs, values).weights, fit_process(inputs, values).weights);
}

} // namespace
} // namespace platen::surrogate
