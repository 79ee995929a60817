// MercuryDPM, as far as the adapter sees it: reads lines "R1 R2 overlap" of one contact (R2 above 1e6: a
// wall), writes its force. With an argument: what an impact returns.
#include "PlatenNormalSpecies.h"

#include "../bounce.hpp"

#include <cstdio>
#include <cstdlib>
#include <sstream>

int main(int argc, char**) {
  PlatenNormalSpecies species;
  species.setRestitution(0.5);
  BaseParticle one, two;
  BaseInteractable wall;
  PlatenInteraction pair(&one, &two, 0), on_wall(&one, &wall, 0);
  const auto force = [&](double R1, double R2, double overlap, double v) {
    one.radius = R1, two.radius = R2, one.velocity = Vec3D(v, 0, 0);
    PlatenInteraction& contact = R2 < 1e6 ? pair : on_wall;
    std::stringstream file; // as at a restart
    contact.write(file);
    PlatenInteraction again(contact);
    again.read(file);
    if (again.getOverlapMax() > contact.getOverlapMax() * (1 + 1e-5)) std::exit(EXIT_FAILURE);
    contact.species = &species;
    contact.overlap = overlap;
    contact.normal = Vec3D(1, 0, 0);
    contact.computeNormalForce();
    return contact.force.X;
  };
  if (argc > 1)
    return bounce(1e-6, 1, 1e-9, [&](double overlap, double v) { return force(1e-3, 1e-3, overlap, v); });
  double R1, R2, overlap;
  while (std::scanf("%lf %lf %lf", &R1, &R2, &overlap) == 3)
    std::printf("%.17g\n", force(R1, R2, overlap, 0));
}
