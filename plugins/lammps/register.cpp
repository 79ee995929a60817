// Makes the styles known to the LAMMPS that loads this shared object (platen.lmp): by `plugin load`, or where
// LAMMPS was built without PLUGIN, by its `python` command.

#include "fix_wall_platen.h"
#include "pair_platen.h"

#include "error.h"
#include "force.h"
#include "modify.h"

#ifdef PLATEN_LAMMPS_LOADS_PLUGINS
#include "lammpsplugin.h"
#include "version.h"

#include <cstring>
#endif

using namespace LAMMPS_NS;

#ifdef PLATEN_LAMMPS_LOADS_PLUGINS

extern "C" void lammpsplugin_init(void* host, void* handle, void* register_with) {
  auto* lmp = static_cast<LAMMPS*>(host);
  if (std::strcmp(lmp->version, LAMMPS_VERSION) != 0) // classes of another version look different inside
    lmp->error->all(FLERR,
                    std::string("The Platen plug-in was built for LAMMPS " LAMMPS_VERSION ", this is ") +
                        lmp->version + ": build it anew with ./run lammps SOURCE");
  const auto add = reinterpret_cast<lammpsplugin_regfunc>(register_with);
  lammpsplugin_t plugin{};
  plugin.version = LAMMPS_VERSION;
  plugin.author = "Platen";
  plugin.handle = handle;
  plugin.style = "pair";
  plugin.name = "platen";
  plugin.info = "contact laws of plastic particles";
  plugin.creator.v1 = [](void* l) -> void* { return new PairPlaten(static_cast<LAMMPS*>(l)); };
  add(&plugin, lmp);
  plugin.style = "fix";
  plugin.name = "wall/platen";
  plugin.info = "rigid planes and cylinders with these laws";
  plugin.creator.v2 = [](void* l, int n, char** a) -> void* {
    return new FixWallPlaten(static_cast<LAMMPS*>(l), n, a);
  };
  add(&plugin, lmp);
}

#else

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

#endif
