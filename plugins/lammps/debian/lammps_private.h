#pragma once
// The beginnings of two classes of LAMMPS 29 Sep 2021 whose headers Debian's liblammps-dev leaves out. Only members
// that the plug-in reads or sets are named; the plug-in refuses to load into another version (register.cpp).

#include "fix.h"

namespace LAMMPS_NS {

class NeighRequest : protected Pointers {
 public:
  int index;
  void* requestor;
  int requestor_instance, id;
  int pair, fix, compute, command, neigh; // who asks
  int half, full;
  int occasional, newton, ghost;
  int size, history; // by particle radius; with the mark of pairs that touch
};

class FixNeighHistory : public Fix {
 public:
  int nlocal_neigh, nall_neigh, use_bit_flag;
  int** firstflag;
  double** firstvalue;
  class Pair* pair;
};

} // namespace LAMMPS_NS
