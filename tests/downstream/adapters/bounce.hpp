#pragma once
#include <cstdio>
#include <cstdlib>

/// Writes what an impact leaves of its velocity; `force(overlap, v)`: v apart [m/s]. A force that pulls
/// fails.
template <class Force> int bounce(double mass, double velocity, double dt, Force force) {
  double overlap = 0, v = -velocity;
  for (int step = 0; overlap >= 0 && step < 1000000; ++step) {
    overlap -= dt * v / 2;
    const double F = force(overlap, v);
    if (!(F >= 0)) return EXIT_FAILURE;
    v += dt * F / mass;
    overlap -= dt * v / 2;
  }
  std::printf("%.17g\n", v / velocity);
  return EXIT_SUCCESS;
}
