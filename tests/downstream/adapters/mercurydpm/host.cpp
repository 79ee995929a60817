// MercuryDPM, as far as the adapter sees it: reads lines "R1 R2 overlap" of one contact (R2 above 1e6: a
// wall), writes its force.
#include "PlatenNormalSpecies.h"

#include <cstdio>
#include <cstdlib>
#include <sstream>

int main() {
  PlatenNormalSpecies species;
  species.setRestitution(0.5);
  BaseParticle one, two;
  BaseInteractable wall;
  PlatenInteraction pair(&one, &two, 0), on_wall(&one, &wall, 0);
  double R1, R2, overlap;
  while (std::scanf("%lf %lf %lf", &R1, &R2, &overlap) == 3) {
    one.radius = R1, two.radius = R2;
    PlatenInteraction& contact = R2 < 1e6 ? pair : on_wall;
    std::stringstream file; // as at a restart
    contact.write(file);
    PlatenInteraction again(contact);
    again.read(file);
    if (again.getOverlapMax() > contact.getOverlapMax() * (1 + 1e-5)) return EXIT_FAILURE;
    contact.species = &species;
    contact.overlap = overlap;
    contact.normal = Vec3D(1, 0, 0);
    contact.computeNormalForce();
    std::printf("%.17g\n", contact.force.X);
  }
}
