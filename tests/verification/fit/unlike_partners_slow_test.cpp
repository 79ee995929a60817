// Two unlike metals pressed against each other: `pressed` curves joined (docs/explanation/joined.md), beside
// CalculiX with both spheres in it (bench/peers/calculix/two_spheres_calculix.py), and beside the rule worked
// out anew from the rows of the press.

#include "fit/pressed.hpp"
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

law::PressedMaterial law_of(const Metal& m) {
  return fit::fit_pressed(pressed(m), fit::fit_unloading(pressed(m))).material;
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

/// The loading rows of a press in x and F over pi R^2, with the work up to each.
struct Rows {
  std::vector<double> x, F, W;

  explicit Rows(const Metal& m) {
    for (const auto& row : pressed(m).points)
      if (row.branch == press::Branch::loading && (x.empty() || row.delta_bar > x.back())) {
        const double now = row.F_bar * m.sigma_y;
        W.push_back(x.empty() ? 0 : W.back() + (now + F.back()) / 2 * (row.delta_bar - x.back()));
        x.push_back(row.delta_bar), F.push_back(now);
      }
  }
  struct At {
    double x, n;
  };
  At at(double force) const {
    const auto i = static_cast<std::size_t>(std::upper_bound(F.begin(), F.end() - 1, force) - F.begin());
    const double t = (force - F[i - 1]) / (F[i] - F[i - 1]), here = x[i - 1] + t * (x[i] - x[i - 1]);
    const double work = W[i - 1] + (F[i - 1] + force) / 2 * (here - x[i - 1]);
    return {here, std::max(force * here / work - 1, 1 + 1e-6)}; // flatter than a line: the softer one alone
  }
  double most() const { return F.back(); }
};

/// The rule of docs/explanation/joined.md on these rows: F/(pi R1^2 sigma_y) by bisection of the overlap.
double by_hand(const Unlike& u, double gamma) {
  const Rows one(u.one), two(u.two);
  const double A = 1 + 1 / u.R2, B = 1 + 1 / std::pow(u.R2, 3), R_e = std::sqrt(A / B);
  double low = 1e-3 * one.most(), high = std::min(one.most(), two.most());
  for (int i = 0; i < 60; ++i) {
    const double force = (low + high) / 2;
    const auto a = one.at(force), b = two.at(force);
    const double share = std::pow(b.x, 4) / (std::pow(a.x, 4) + std::pow(b.x, 4));
    const double n = (1 - share) * a.n + share * b.n, q = std::clamp(n / (2 * (n - 1)), 1.0, 200.0);
    const double x = std::pow((std::pow(a.x, q) + std::pow(b.x, q)) / (A * R_e), 1 / q);
    (x * A * R_e * R_e < gamma ? low : high) = force;
  }
  return low * R_e * R_e;
}

} // namespace

TEST(UnlikePartners, Explore) {
  const Metal soft{100, 1}, twice{100, 2}, five{100, 5}, stiff{500, 1};
  for (const auto& u : {Unlike{"like", soft, soft, 1},
                        {"s12", soft, twice, 1},
                        {"s15", soft, five, 1},
                        {"r12", soft, soft, 2},
                        {"r12s12", soft, twice, 2},
                        {"r12s15", soft, five, 2},
                        {"r12s21", twice, soft, 2},
                        {"r12s51", five, soft, 2},
                        {"e15", soft, stiff, 1}}) {
    const law::Law law = law::tabulate(law::prepare(law_of(u.one), 1, law_of(u.two), u.R2));
    for (const double gamma : {0.04, 0.06, 0.1, 0.15, 0.2, 0.3, 0.4, 0.5, 0.6}) {
      const auto now = law::evaluate(law, {}, gamma);
      std::printf("%s,%g,%.5f,%d\n", u.what, gamma, now.force / M_PI, now.in_range);
      std::printf("hand %s %g %.5f %+.2f %%\n", u.what, gamma, by_hand(u, gamma),
                  100 * (joined(u, gamma) / by_hand(u, gamma) - 1));
    }
  }
}

} // namespace platen
