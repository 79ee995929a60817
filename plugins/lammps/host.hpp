#pragma once
// What differs between the LAMMPS of Debian 12 (29 Sep 2021, without PLUGIN) and the current one, which loads
// plug-ins itself.

#include "neighbor.h"
#include "pair.h"
#include "utils.h"

#if __has_include("lammpsplugin.h")
#define PLATEN_LAMMPS_LOADS_PLUGINS
#include "fix_neigh_history.h"
#else
#include "debian/lammps_private.h"
#endif

namespace LAMMPS_NS {

/// A half list by radius, with the mark of pairs that touch.
inline void request_history(Neighbor* neighbor, Pair* pair, [[maybe_unused]] int instance) {
#ifdef PLATEN_LAMMPS_LOADS_PLUGINS
  neighbor->add_request(pair, NeighConst::REQ_SIZE | NeighConst::REQ_HISTORY);
#else
  const int request = neighbor->request(pair, instance);
  neighbor->requests[request]->size = 1;
  neighbor->requests[request]->history = 1;
#endif
}

} // namespace LAMMPS_NS
