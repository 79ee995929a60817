// A million random finite increments, up to 20 %, from random admissible states, for each kind of model: how
// many are refused, how many needed the bracket, and that none gives NaN.

#include "random_states.hpp"

#include <gtest/gtest.h>

#include <cstdio>

using namespace platen::material;
using namespace platen::material::testing;

namespace {

constexpr long increments = 1000000;
constexpr double refused_share_max = 1e-3;

struct Counts {
  long tried = 0, plastic = 0, bracketed = 0, refused = 0, unstable = 0, not_finite = 0;
  void take(const PointUpdate& u) {
    ++tried;
    plastic += u.zone != Zone::elastic;
    bracketed += u.status == Status::bracketed;
    refused += u.status == Status::refused;
    unstable += u.status == Status::unstable;
    if (is_refused(u.status)) return;
    double sum = u.phi + u.dv + u.dw;
    for (int A = 0; A < 3; ++A) sum += u.sigma[A] + u.eps[A] + u.D[A][0] + u.D[A][1] + u.D[A][2];
    not_finite += !std::isfinite(sum);
  }
  void say(const char* name) const {
    std::printf("%-16s %ld increments: %ld plastic, %ld bracketed, %ld refused, %ld unstable\n", name, tried,
                plastic, bracketed, refused, unstable);
    EXPECT_EQ(not_finite, 0) << name;
    EXPECT_LE(static_cast<double>(refused + unstable), refused_share_max * static_cast<double>(tried))
        << name;
  }
};

template <class M> Counts count(const std::vector<M>& materials, unsigned seed) {
  std::mt19937 generator(seed);
  Counts counts;
  for (const M& m : materials)
    for (long i = 0; i < increments / std::ssize(materials) + 1; ++i) {
      const Trial t = random_trial(m, generator, 0.2);
      counts.take(update_one(m, t.eps, t.phi));
    }
  return counts;
}

} // namespace

TEST(MillionIncrements, OfVonMisesWithEveryHardening) { count(metals(), 41).say("von-mises"); }
TEST(MillionIncrements, OfVmdcInItsParameterSpace) { count(corner_materials(), 42).say("vmdc"); }
TEST(MillionIncrements, OfDruckerPrager) { count(rocks(), 43).say("drucker-prager"); }
TEST(MillionIncrements, OfDpcInTheSameParameterSpace) { count(caps(), 44).say("dpc"); }
TEST(MillionIncrements, OfDpcWithItsPublishedFlow) { count(caps(true), 46).say("dpc-published"); }

TEST(MillionIncrements, OfMohrCoulomb) {
  std::mt19937 generator(45);
  std::uniform_real_distribution<double> sign(-1, 1), unit(0, 1);
  Counts counts;
  for (const MohrCoulomb& m :
       {MohrCoulomb{3125, 0.38, 27.8, 1, 27.8, 0.3125}, MohrCoulomb{3125, 0.38, 27.8, 1, 5, 0.3125},
        MohrCoulomb{100, 0.2, 40, 1, 0, 1}, MohrCoulomb{100, 0.3, 0, 1, 0, 0.5}})
    for (long i = 0; i < increments / 4; ++i) {
      std::array<double, 3> eps;
      const double size = 0.2 * std::pow(10, -3 * unit(generator));
      for (double& e : eps) e = 5 / m.E * sign(generator) + size * sign(generator);
      counts.take(update_one(m, eps, 0));
    }
  counts.say("mohr-coulomb");
}
