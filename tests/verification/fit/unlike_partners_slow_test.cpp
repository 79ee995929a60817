// Two unlike metals pressed against each other: `pressed` curves joined (docs/explanation/joined.md), beside
// CalculiX with both spheres in it (bench/peers/calculix/two_spheres_calculix.py), and beside the rule worked
// out anew from the rows of the press.

#include "fit/pressed.hpp"
#include "platen/law/catalogue.hpp"
#include "press/press.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

namespace platen {
namespace {

/// Perfectly plastic, R = 1 m, as in CalculiX: stresses are in units of sigma_y of the first sphere, in Pa.
struct Metal {
  double E, sigma_y;
  auto operator<=>(const Metal&) const = default;
};

const press::Curve& pressed(const Metal& m) {
  static std::map<Metal, press::Curve> known;
  if (const auto at = known.find(m); at != known.end()) return at->second;
  press::Simple e;
  e.unload_from = {0.1, 0.2, 0.3, 0.4, 0.5};
  const auto result = press::press({{"metal", material::VonMises{m.E, 0.3, m.sigma_y}}, 1, e});
  if (result.failure) throw std::runtime_error(*result.failure);
  return known[m] = result.curve;
}

const law::PressedMaterial& law_of(const Metal& m) {
  static std::map<Metal, law::PressedMaterial> known;
  if (!known.contains(m)) known[m] = fit::fit_pressed(pressed(m), fit::fit_unloading(pressed(m))).material;
  return known[m];
}

struct Unlike {
  const char* what;
  Metal one, two;
  double R2; ///< of the second sphere, of the first one's
};

/// F/(pi R1^2 sigma_y) by the two curves joined.
double joined(const Unlike& u, double gamma) {
  const law::Law law = law::tabulate(law::prepare(law_of(u.one), 1, law_of(u.two), u.R2));
  return law::evaluate(law, {}, gamma).force / M_PI;
}

constexpr double power = 7.0 / 4; // with which an elastic and a plastic overlap add up

/// The loading rows of a press in x and F over pi R^2, with the work up to each.
struct Rows {
  std::vector<double> x, F, W;

  explicit Rows(const Metal& m) : E(m.E) {
    for (const auto& row : pressed(m).points)
      if (row.branch == press::Branch::loading && (x.empty() || row.delta_bar > x.back())) {
        const double now = row.F_bar * m.sigma_y;
        W.push_back(x.empty() ? 0 : W.back() + (now + F.back()) / 2 * (row.delta_bar - x.back()));
        x.push_back(row.delta_bar), F.push_back(now);
      }
  }
  /// At a force on this metal of this radius: of R^2 x the elastic part, P, and n.
  struct At {
    double elastic, plastic, n;
  };
  At at(double force, double R, double p = power) const {
    const double f = force / (R * R);
    const auto i = std::max<std::ptrdiff_t>(std::upper_bound(F.begin(), F.end() - 1, f) - F.begin(), 1);
    const double t = (f - F[i - 1]) / (F[i] - F[i - 1]), here = x[i - 1] + t * (x[i] - x[i - 1]);
    const double x_hertz = std::min(std::pow(0.75 * M_PI * f * (1 - 0.3 * 0.3) / E, 2.0 / 3), here);
    const double whole = W[i - 1] + (F[i - 1] + f) / 2 * (here - x[i - 1]), work = whole - 0.4 * f * x_hertz;
    const double n = f * here / whole - 1;
    return {R * R * x_hertz, R * R * std::pow(std::pow(here, p) - std::pow(x_hertz, p), 1 / p),
            work > 0 ? std::min(f * (here - x_hertz) / work - 1, n) : n};
  }
  double most() const { return F.back(); }

 private:
  double E;
};

/// The rule of docs/explanation/joined.md on these rows: F/(pi R1^2 sigma_y) by bisection of the overlap.
double by_hand(const Unlike& u, double gamma) {
  const Rows one(u.one), two(u.two);
  const double A = 1 + 1 / u.R2, L1 = std::min(1.0, 2 / A), L2 = std::min(u.R2, 2 / A);
  double low = 1e-3 * one.most(), high = std::min(one.most() * L1 * L1, two.most() * L2 * L2);
  for (int i = 0; i < 60; ++i) {
    const double force = (low + high) / 2;
    const auto a = one.at(force, L1), b = two.at(force, L2);
    const double share = std::pow(b.plastic, 4) / (std::pow(a.plastic, 4) + std::pow(b.plastic, 4));
    const double n = std::max((1 - share) * a.n + share * b.n, 1 + 1e-6),
                 q = std::clamp(n / (2 * (n - 1)), 1.0, 200.0);
    const double most = std::max(a.plastic, b.plastic),
                 part = (std::pow(a.plastic / most, q) / L1 + std::pow(b.plastic / most, q) / L2) / A;
    const double plastic = most * std::pow(part, 1 / q),
                 elastic =
                     std::pow((std::pow(a.elastic, 1.5) / L1 + std::pow(b.elastic, 1.5) / L2) / A, 2.0 / 3);
    (A * std::pow(std::pow(elastic, power) + std::pow(plastic, power), 1 / power) < gamma ? low : high) =
        force;
  }
  return low;
}

const Metal soft{100, 1}, bit_harder{100, 1.3}, twice{100, 2}, five{100, 5}, stiff{500, 1}, hard{1e4, 100};

/// Both spheres in CalculiX 2.20. Fine: --columns 36 --grading 8 for alike ones, to 0.15 for five times the
/// modulus, to 0.2 for twice radius and strength (below 0.1 --columns 54 --step 0.0075); --columns 48 --step
/// 0.03 for twice the strength and the hard one. These two agree within 1 % (at 0.06 2.7 %, at 0.6 1.3 %).
/// The others --columns 24, steps of 0.002 throughout: 1 % from the fine ones from 0.1 to 0.4, 3 to 4 %
/// below, 2.7 % too high at 0.5 and 4 % at 0.6, which is left out. The return mapping errs with the step.
const std::vector<double> gammas = {0.04, 0.06, 0.1, 0.15, 0.2, 0.3, 0.4, 0.5, 0.6};
const struct {
  Unlike pair;
  double near, half, last; ///< bounds of docs/explanation/joined.md: to gamma = 0.4, at 0.5, at 0.6
  std::vector<double> F;   ///< over pi R1^2 sigma_y, at as many gammas as were computed
} calculix[] = {
    {{"alike", soft, soft, 1},
     0.025,
     0.03,
     0.02,
     {0.0794, 0.1290, 0.2242, 0.3301, 0.4206, 0.5432, 0.6069, 0.6761, 0.7654}},
    {{"1.3 times the strength", soft, bit_harder, 1},
     0.03,
     0.03,
     0,
     {0.0813, 0.1317, 0.2257, 0.3365, 0.4264, 0.5442, 0.6160, 0.6722}},
    {{"twice the strength", soft, twice, 1},
     0.05,
     0.05,
     0.1,
     {0.0838, 0.1325, 0.2302, 0.3357, 0.4222, 0.5390, 0.6054, 0.6535, 0.6928}},
    {{"five times the strength", soft, five, 1},
     0.03,
     0.03,
     0,
     {0.0826, 0.1320, 0.2262, 0.3368, 0.4256, 0.5433, 0.6153, 0.6713}},
    {{"five times the modulus", soft, stiff, 1},
     0.03,
     0,
     0,
     {0.0954, 0.1464, 0.2476, 0.3525, 0.4390, 0.5519, 0.6240}},
    {{"a hundred times modulus and strength", soft, hard, 1},
     0.05,
     0.06,
     0.105,
     {0.0977, 0.1533, 0.2474, 0.3520, 0.4339, 0.5438, 0.6084, 0.6578, 0.7002}},
    {{"1.25 times the radius", soft, soft, 1.25},
     0.05,
     0,
     0,
     {0.0825, 0.1398, 0.2433, 0.3642, 0.4635, 0.5765, 0.6600}},
    {{"twice the radius", soft, soft, 2},
     0.035,
     0.04,
     0,
     {0.1007, 0.1576, 0.2830, 0.4118, 0.5141, 0.6242, 0.7256, 0.8205}},
    {{"twice radius and strength", soft, twice, 2},
     0.06,
     0.04,
     0,
     {0.1038, 0.1690, 0.2862, 0.4257, 0.5145, 0.6281, 0.7266, 0.8219}},
    {{"twice the radius, five times the strength", soft, five, 2},
     0.05,
     0,
     0,
     {0.1051, 0.1628, 0.2877, 0.4155, 0.5180, 0.6278, 0.7253}},
    {{"a dent: twice the radius, half the strength", twice, soft, 2},
     0.155,
     0.205,
     0,
     {0.1047, 0.1684, 0.3212, 0.4892, 0.6431, 0.9112, 1.1344, 1.3341}},
};

} // namespace

TEST(UnlikePartners, JoinedCurvesAreAsFarFromCalculiXAsThePageSays) {
  for (const auto& [pair, near, half, last, F] : calculix)
    for (std::size_t i = 0; i < F.size(); ++i) {
      const double deviation = joined(pair, gammas[i]) / F[i] - 1;
      const double of_ratio = (1 + deviation) / (joined(calculix[0].pair, gammas[i]) / calculix[0].F[i]) - 1;
      std::printf("%s, gamma %.2f: force %+.1f %%, over that of alike ones %+.1f %%\n", pair.what, gammas[i],
                  100 * deviation, 100 * of_ratio);
      const double most = gammas[i] < 0.45 ? near : gammas[i] < 0.55 ? half : last;
      EXPECT_NEAR(deviation, 0, most) << pair.what << ' ' << gammas[i];
    }
}

TEST(UnlikePartners, OfAgarwalAreAsFarFromCalculiXAsThePageSays) { // dissimilar-spheres.md
  const auto metal = [](const Metal& m) {
    return law::LawChoice{
        "agarwal",
        "",
        {{"nu", "0.3"}, {"E_Pa", std::to_string(m.E)}, {"sigma_y_Pa", std::to_string(m.sigma_y)}}};
  };
  for (const auto& [pair, near, half, last, F] : calculix) {
    const bool alike = pair.R2 == 1, dent = pair.two.sigma_y < pair.one.sigma_y;
    if (dent) continue;
    const law::Law law = law::make_law(metal(pair.one), 1, metal(pair.two), pair.R2);
    for (std::size_t i = 2; i < F.size(); ++i)
      EXPECT_NEAR(law::evaluate(law, {}, gammas[i]).force / M_PI / F[i], 1,
                  !alike             ? 0.09
                  : gammas[i] < 0.55 ? 0.07
                                     : 0.11)
          << pair.what << ' ' << gammas[i];
  }
}

/// With this power the plastic part of the overlap depends least on the modulus.
TEST(UnlikePartners, PlasticPartOfTheOverlapDependsLittleOnTheModulus) {
  const auto spread = [](double p) { // largest and mean deviation of P from its mean over the moduli
    double most = 0, sum = 0;
    int count = 0;
    for (const double f : {0.05, 0.1, 0.15, 0.2, 0.3, 0.4, 0.6, 0.8}) {
      std::vector<double> P;
      for (const double E : {50.0, 100.0, 200.0, 500.0, 1000.0})
        P.push_back(Rows({E, 1}).at(f, 1, p).plastic);
      const double mean = (P[0] + P[1] + P[2] + P[3] + P[4]) / 5;
      for (const double here : P)
        most = std::max(most, std::abs(here / mean - 1)), sum += std::abs(here / mean - 1), ++count;
    }
    std::printf("power %.2f: P within %.1f %%, in the mean %.1f\n", p, 100 * most, 100 * sum / count);
    return std::pair{most, sum / count};
  };
  const auto [most, mean] = spread(power);
  EXPECT_LE(most, 0.12);
  EXPECT_LE(mean, 0.05);
  for (const double other : {1.5, 2.0}) EXPECT_GT(spread(other).second, mean);
}

TEST(UnlikePartners, JoinedCurvesFollowTheRuleWorkedOutAnew) {
  for (const auto& [pair, near, half, last, F] : calculix)
    for (std::size_t i = 0; i < F.size(); ++i)
      EXPECT_NEAR(joined(pair, gammas[i]) / by_hand(pair, gammas[i]), 1, 0.006)
          << pair.what << ' ' << gammas[i];
}

} // namespace platen
