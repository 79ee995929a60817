// Makes the styles known to the LAMMPS that loads this shared object (platen.lmp).

#include "fix_wall_platen.h"
#include "pair_platen.h"

#include "error.h"
#include "force.h"
#include "modify.h"

using namespace LAMMPS_NS;

extern "C" void platen_register(void* handle) {
  auto* lmp = static_cast<LAMMPS*>(handle);
  if (lmp->num_ver != PLATEN_LAMMPS_VERSION)
    lmp->error->all(FLERR, "The Platen plug-in was built for LAMMPS " +
                               std::to_string(PLATEN_LAMMPS_VERSION) + ", this is " +
                               std::to_string(lmp->num_ver) + ": build it anew with ./run lammps");
  (*lmp->force->pair_map)["platen"] = [](LAMMPS* l) -> Pair* { return new PairPlaten(l); };
  (*lmp->modify->fix_map)["wall/platen"] = [](LAMMPS* l, int n, char** a) -> Fix* {
    return new FixWallPlaten(l, n, a);
  };
}
