#include "surrogate/natural_neighbours.hpp"

#include "core/error.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace platen::surrogate {
namespace {

/// Places in the cube that fill it evenly (Roberts's additive recurrence), on no grid.
Inputs scattered(std::size_t dimensions, std::size_t count, double from = 0, double to = 1) {
  double g = 2; // g^(d+1) = g + 1
  for (int i = 0; i < 60; ++i) g = std::pow(1 + g, 1.0 / static_cast<double>(dimensions + 1));
  Inputs places{dimensions, {}};
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t k = 0; k < dimensions; ++k)
      places.values.push_back(
          from +
          (to - from) *
              std::fmod(0.5 + static_cast<double>(i + 1) * std::pow(g, -static_cast<double>(k + 1)), 1.0));
  return places;
}

/// 3 x 3 x 3 x 6 as in Table 1 of Wang et al., or the last of these numbers.
Inputs grid(std::size_t dimensions) {
  const std::vector<std::vector<double>> levels = {
      {0, 0.5, 1}, {0, 0.5, 1}, {0, 0.5, 1}, {0, 5. / 45, 15. / 45, 25. / 45, 35. / 45, 1}};
  Inputs sites{dimensions, {}};
  std::vector<std::size_t> at(dimensions, 0);
  const auto levels_of = [&](std::size_t k) { return levels[4 - dimensions + k]; };
  for (;;) {
    for (std::size_t k = 0; k < dimensions; ++k) sites.values.push_back(levels_of(k)[at[k]]);
    std::size_t k = 0;
    while (k < dimensions && ++at[k] == levels_of(k).size()) at[k++] = 0;
    if (k == dimensions) return sites;
  }
}

/// On a grid, and not.
std::vector<Inputs> kinds(std::size_t dimensions) { return {grid(dimensions), scattered(dimensions, 162)}; }

double interpolated(const NaturalNeighbours& n, const std::vector<double>& values,
                    std::span<const double> at) {
  const auto shares = n.shares(at);
  if (shares.empty()) return std::nan("");
  double sum = 0;
  for (const auto& [site, share] : shares) sum += share * values[site];
  return sum;
}

std::vector<double> values_of(const Inputs& inputs, double (*f)(std::span<const double>)) {
  std::vector<double> values;
  for (std::size_t i = 0; i < inputs.size(); ++i) values.push_back(f(inputs.row(i)));
  return values;
}

double linear(std::span<const double> x) {
  double sum = 0.7;
  for (std::size_t k = 0; k < x.size(); ++k) sum += (static_cast<double>(k) - 1.3) * x[k];
  return sum;
}
double wavy(std::span<const double> x) {
  double product = 1;
  for (std::size_t k = 0; k < x.size(); ++k) product *= std::sin(5 * x[k] + static_cast<double>(k));
  return product;
}

TEST(NaturalNeighbours, AreExactAtTheSites) {
  for (std::size_t d = 1; d <= 4; ++d)
    for (const Inputs& sites : kinds(d)) {
      const NaturalNeighbours n(sites);
      const auto values = values_of(sites, wavy);
      for (std::size_t i = 0; i < sites.size(); ++i) {
        EXPECT_EQ(interpolated(n, values, sites.row(i)), values[i]);
        // and beside them, towards the inside
        std::vector<double> beside(sites.row(i).begin(), sites.row(i).end());
        for (double& x : beside) x += 1e-7 * (0.5 - x);
        const double value = interpolated(n, values, beside);
        if (!std::isnan(value)) { EXPECT_NEAR(value, values[i], 1e-5); }
      }
    }
}

TEST(NaturalNeighbours, MeetLinearFunctions) {
  for (std::size_t d = 2; d <= 4; ++d)
    for (const Inputs& sites : kinds(d)) {
      const NaturalNeighbours n(sites);
      const auto values = values_of(sites, linear);
      int inside = 0;
      // Anywhere, in planes of the grid and on its hull.
      for (const auto& places :
           {scattered(d, 200), scattered(d, 100, 0, 1e-6), scattered(d, 100, 0.5 - 1e-8, 0.5 + 1e-8)})
        for (std::size_t i = 0; i < places.size(); ++i) {
          std::vector<double> at(places.row(i).begin(), places.row(i).end());
          if (i % 3 == 1) at[i % d] = 0.5;
          if (i % 3 == 2) at[i % d] = std::round(at[i % d]);
          const double value = interpolated(n, values, at);
          if (std::isnan(value)) continue;
          ++inside;
          EXPECT_NEAR(value, linear(at), 1e-10);
          for (const auto& [site, share] : n.shares(at)) EXPECT_GT(share, -1e-12);
        }
      EXPECT_GT(inside, 100);
    }
}

// In steps of a millionth along lines: through sites, along planes of the grid, across anything.
TEST(NaturalNeighbours, AreContinuous) {
  for (std::size_t d = 2; d <= 4; ++d)
    for (const Inputs& sites : kinds(d)) {
      const NaturalNeighbours n(sites);
      const auto values = values_of(sites, wavy);
      for (int line = 0; line < 8; ++line)
        for (double middle = 0.3; middle < 0.75; middle += 0.1) {
          double before = std::nan("");
          for (int step = -5; step <= 5; ++step) {
            const double t = middle + 1e-6 * step;
            std::vector<double> at(d, t);
            if (line < 4) at[static_cast<std::size_t>(line) % d] = 0.5;
            if (line > 5) at[0] = 1 - t;
            const double value = interpolated(n, values, at);
            if (!std::isnan(before) && !std::isnan(value)) { EXPECT_NEAR(value, before, 2e-4); }
            before = value;
          }
        }
      // and from the inside to the hull of the grid
      for (double h = 1e-3; h > 1e-13; h /= 10) {
        std::vector<double> at(d, 0.3), on = at;
        at[0] = h, on[0] = 0;
        const double value = interpolated(n, values, at), there = interpolated(n, values, on);
        if (!std::isnan(there)) { EXPECT_NEAR(value, there, 20 * h + 1e-9) << d << " " << h; }
      }
    }
}

// What they are: the places that are nearer to the new site than to any other, counted on a raster.
TEST(NaturalNeighbours, TakeTheirPartOfEachVoronoiCell) {
  for (std::size_t d = 2; d <= 3; ++d)
    for (const Inputs& sites : kinds(d)) {
      const NaturalNeighbours n(sites);
      const std::vector<double> at = {0.4, 0.57, 0.45};
      const auto distance2 = [&](std::span<const double> x, const std::vector<double>& y) {
        double sum = 0;
        for (std::size_t k = 0; k < d; ++k) sum += (x[k] - y[k]) * (x[k] - y[k]);
        return sum;
      };
      std::vector<double> counted(sites.size());
      double all = 0;
      const int raster = d == 2 ? 800 : 100;
      const int count = d == 2 ? raster * raster : raster * raster * raster;
      for (int i = 0; i < count; ++i) {
        std::vector<double> x(d);
        int rest = i;
        for (double& one : x) one = (0.5 + rest % raster) / raster, rest /= raster;
        std::size_t nearest = 0;
        double least = 9;
        for (std::size_t s = 0; s < sites.size(); ++s)
          if (const double r = distance2(sites.row(s), x); r < least) least = r, nearest = s;
        if (distance2({at.data(), d}, x) < least) counted[nearest] += 1, all += 1;
      }
      std::vector<double> shares(sites.size());
      for (const auto& [site, share] : n.shares({at.data(), d})) shares[site] = share;
      for (std::size_t s = 0; s < sites.size(); ++s)
        EXPECT_NEAR(shares[s], counted[s] / all, 0.016) << d; // of a raster
    }
}

TEST(NaturalNeighbours, InOneDimensionAreTheTwoBeside) {
  const NaturalNeighbours n(Inputs{1, {1, 0, 0.4}});
  const std::vector<double> at = {0.55};
  const auto shares = n.shares(at);
  ASSERT_EQ(shares.size(), 2U);
  EXPECT_NEAR(shares[0].share, 0.25, 1e-14); // of the site at 1
  EXPECT_NEAR(shares[1].share, 0.75, 1e-14); // of that at 0.4
}

TEST(NaturalNeighbours, SayNothingOutsideOfTheHull) {
  for (std::size_t d = 1; d <= 4; ++d) {
    const NaturalNeighbours n(grid(d));
    for (const double x : {-0.01, 1.01, -1e-9}) {
      std::vector<double> at(d, 0.3);
      at[d - 1] = x;
      EXPECT_TRUE(n.shares(at).empty());
    }
  }
}

// How long that takes: bench/surrogate_bench.cpp.
TEST(NaturalNeighbours, AnswerWhereverTheyAreAsked) {
  const NaturalNeighbours n(grid(4));
  const Inputs places = scattered(4, 1000);
  for (std::size_t i = 0; i < places.size(); ++i) EXPECT_FALSE(n.shares(places.row(i)).empty());
}

TEST(NaturalNeighbours, RefuseSitesThatFillNothing) {
  EXPECT_THROW(NaturalNeighbours(Inputs{5, std::vector<double>(50)}), core::InvalidInput);
  EXPECT_THROW(NaturalNeighbours(Inputs{2, {0, 0, 1, 1}}), core::InvalidInput);
  EXPECT_THROW(NaturalNeighbours(Inputs{2, {0, 0, 1, 1, 0.5, 0.5}}), core::InvalidInput);   // on a line
  EXPECT_THROW(NaturalNeighbours(Inputs{2, {0, 0, 1, 1, 1, 0, 0, 0}}), core::InvalidInput); // one twice
}

} // namespace
} // namespace platen::surrogate
