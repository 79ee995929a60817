#include "calibrate/profile.hpp"

#include "calibrate/problem.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace platen::calibrate {
namespace {

class Profiler {
 public:
  Profiler(const Task& task, const Solution& best, std::size_t k)
      : workshop_(task), coordinates_{task}, best_(best), k_(k), ends_(bounds(task, k)) {
    const double noise = best.noise_errors[k], all = best.errors[k];
    shrink_ = std::isfinite(noise) && all > 0 ? std::pow(noise / all, 2) : 1;
  }

  Profile run(bool drawn) {
    Profile p;
    const double best = best_.state.theta[k_];
    p.points.push_back({coordinates_.outside(k_, best), 0});
    const auto [low, open_low] = side(-1, p);
    const auto [high, open_high] = side(1, p);
    for (const double end : {low, high})
      for (const double share : {0.4, 0.7, 1.35})
        if (drawn && end != best) between_ends(best + share * (end - best), p);
    std::ranges::sort(p.points, {}, &ProfilePoint::value);
    p.better = better_;
    p.low = coordinates_.outside(k_, low), p.open_low = open_low;
    p.high = coordinates_.outside(k_, high), p.open_high = open_high;
    return p;
  }

 private:
  struct End {
    double theta;
    bool open;
  };

  void between_ends(double theta, Profile& p) {
    if (theta < ends_[0] || theta > ends_[1]) return;
    const State found = held_at(theta, best_.state);
    if (is_law(found)) p.points.push_back({coordinates_.outside(k_, theta), deviance(found)});
  }

  bool is_law(const State& s) {
    return workshop_.law(s.theta.data(), workshop_.made_for(best_.samples.front())) != nullptr;
  }

  double deviance(const State& found) const {
    return shrink_ * std::max(0.0, 2 * (found.cost - best_.state.cost)) /
           std::max(best_.reduced_chi_squared, 1e-300);
  }

  /// The root of the deviance is nearly linear in theta: a few steps find where it is that of 95 %.
  End side(int sign, Profile& p) {
    const double best = best_.state.theta[k_], wanted = std::sqrt(deviance_95);
    const double room = sign > 0 ? ends_[1] - best : best - ends_[0];
    const double error = best_.errors[k_] / coordinates_.slope(k_, best);
    double inside = 0, root_inside = 0, outside = room, root_outside = 0;
    double step = std::clamp(std::isfinite(error) && error > 0 ? wanted * error : 0.1, 1e-6 * room, room);
    State from = best_.state; // the others start where they were
    constexpr int most = 12;
    constexpr double close = 0.02;
    for (int i = 0; i < most && room > 0; ++i) {
      const double theta = best + sign * step;
      const State found = held_at(theta, from);
      const double root = std::sqrt(deviance(found));
      const bool law = is_law(found);
      if (law) p.points.push_back({coordinates_.outside(k_, theta), root * root});
      if (law && std::abs(root - wanted) < close) return {theta, false};
      if (law && root < wanted) {
        inside = step, root_inside = root;
        from = found;
        if (step >= room * (1 - 2 * on_bound_share)) break;
        if (root_outside > 0) step = between(inside, root_inside, outside, root_outside);
        else step = std::min(step * std::clamp(root > 0 ? wanted / root : 4.0, 1.05, 4.0), outside);
      } else {
        outside = step, root_outside = law ? root : 0;
        step = law ? between(inside, root_inside, outside, root_outside) : (inside + outside) / 2;
        if (outside - inside < 1e-3 * outside) break;
      }
    }
    if (root_outside > 0) return {best + sign * between(inside, root_inside, outside, root_outside), false};
    return {best + sign * std::max(inside, 0.0), true};
  }

  static double between(double a, double root_a, double b, double root_b) {
    return a + (b - a) * std::clamp((std::sqrt(deviance_95) - root_a) / (root_b - root_a), 0.05, 0.95);
  }

  State held_at(double theta, State start) {
    start.theta[k_] = theta;
    State found = Problem(workshop_, best_.samples, std::move(start), {static_cast<int>(k_)}).solve();
    constexpr double noticed = 0.05; // of the deviance of one standard error
    const double least = better_ ? better_->cost : best_.state.cost;
    if (2 * (least - found.cost) > noticed * best_.reduced_chi_squared) better_ = found;
    return found;
  }

  Workshop workshop_;
  Coordinates coordinates_;
  const Solution& best_;
  std::size_t k_;
  std::array<double, 2> ends_;
  double shrink_ = 1;
  std::optional<State> better_;
};

} // namespace

std::string words_of(const Profile& p) {
  if (p.open_low && p.open_high) return "anything";
  if (p.open_high) return fmt::format("above {:.4g}", p.low);
  if (p.open_low) return fmt::format("below {:.4g}", p.high);
  return fmt::format("{:.4g} to {:.4g}", p.low, p.high);
}

Profile profile(const Task& task, const Solution& best, std::size_t k, bool drawn) {
  return Profiler(task, best, k).run(drawn);
}

} // namespace platen::calibrate
