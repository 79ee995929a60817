// In place of the toolchain's exponential, which takes twice the time: the one with which the program
// computes many at once, of one number, to a relative 5e-16.

#include "platen/lanes.hpp"

#include <cmath>
#include <limits>

extern "C" double exp(double x) {
  using namespace platen::core::detail;
  if (!(x > -708)) return std::isnan(x) ? x : x < -745.2 ? 0 : exp(x + 64) * 0x1.969d47321e4ccp-93; // e^-64
  if (x > 709) return x > 709.79 ? std::numeric_limits<double>::infinity() : exp(x - 1) * 0x1.5bf0a8b145769p1;
  return exp_within(x);
}
