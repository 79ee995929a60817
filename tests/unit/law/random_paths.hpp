#pragma once
// What has to hold on every path of every law, and random paths and materials to try it on (rapidcheck).

#include "platen/law/contact.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace platen::law::testing {

/// A number in [0, 1) that rapidcheck can shrink; uniform from the first case on, whatever the "size".
inline double unit() { return *rc::gen::resize(100, rc::gen::inRange(0, 1 << 30)) / double(1 << 30); }
inline double between(double low, double high) { return low + (high - low) * unit(); }
inline double log_between(double low, double high) { return low * std::pow(high / low, unit()); }

/// Overlaps of one contact: up, down, separated, and up again, in units of `scale`.
inline std::vector<double> random_path(double scale) {
  const auto steps =
      *rc::gen::container<std::vector<int>>(12, rc::gen::resize(100, rc::gen::inRange(-200'000, 1'000'000)));
  std::vector<double> path;
  const double reach = scale * log_between(1e-6, 1.0); // many paths have to stay in the first regimes
  for (int step : steps) path.push_back(step * 1e-6 * reach);
  return path;
}

template <class Law> bool same(const BasicResponse<double>& a, const BasicResponse<double>& b, const Law&) {
  return a.force == b.force && a.stiffness == b.stiffness && a.contact_radius == b.contact_radius &&
         a.dissipated_work == b.dissipated_work && a.branch == b.branch && a.in_range == b.in_range;
}

/// No NaN, no negative force or residual overlap, no energy created, the same answer again, and the same
/// answer with the sides swapped.
template <class Law> void holds_on_path(const Law& law, const Law& swapped, const std::vector<double>& path) {
  State state;
  double lost = 0;
  for (double gamma : path) {
    const Response now = evaluate(law, state, gamma);
    RC_ASSERT(std::isfinite(now.force) && std::isfinite(now.stiffness) && std::isfinite(now.contact_radius) &&
              std::isfinite(now.mean_pressure) && std::isfinite(now.dissipated_work));
    RC_ASSERT(now.force >= 0.0);
    RC_ASSERT(now.stiffness >= 0.0);
    RC_ASSERT(now.contact_radius >= 0.0);
    if (const double top = now.state.gamma_max; top > law.gamma_elastic) // residual overlap
      RC_ASSERT(law.unloading(top, law.loading(top)).gamma_0(top) >= -1e-15 * top);
    RC_ASSERT(same(now, evaluate(law, state, gamma), law));
    RC_ASSERT(same(now, evaluate(swapped, state, gamma), law));
    RC_ASSERT(now.force <= evaluate(law, State{}, gamma).force * (1 + 1e-9));
    // Separated or in touch, what is lost is lost: it depends on the largest overlap alone, and grows with
    // it.
    const double W = law.work(now.state.gamma_max);
    if (now.state.gamma_max > 0 && now.branch != Branch::separated) {
      RC_ASSERT(now.dissipated_work >= lost - 1e-9 * W);
      RC_ASSERT(now.dissipated_work <= W * (1 + 1e-12));
      lost = std::max(lost, now.dissipated_work);
    }
    state = now.state;
  }
  // Reloading joins the loading curve at the previous maximum.
  if (state.gamma_max > 0) {
    const double F = evaluate(law, State{}, state.gamma_max).force;
    RC_ASSERT(std::abs(evaluate(law, state, state.gamma_max).force - F) <= 1e-12 * F);
  }
}

/// Runs `property` on `cases` random cases and fails with rapidcheck's shrunk counterexample.
template <class Property> void for_random_cases(int cases, Property property) {
  rc::detail::TestParams params = rc::detail::configuration().testParams;
  params.maxSuccess = cases;
  rc::detail::TestMetadata metadata;
  metadata.id = ::testing::UnitTest::GetInstance()->current_test_info()->name();
  const auto result = rc::detail::checkTestable(property, metadata, params);
  if (!result.template is<rc::detail::SuccessResult>()) {
    std::ostringstream out;
    rc::detail::printResultMessage(result, out);
    FAIL() << out.str();
  }
}

#if defined(__SANITIZE_ADDRESS__) || !defined(__OPTIMIZE__)
inline constexpr int paths_per_law =
    10'000; // enough for memory and undefined behaviour, at a tenth of the time
#else
inline constexpr int paths_per_law = 100'000;
#endif

} // namespace platen::law::testing
