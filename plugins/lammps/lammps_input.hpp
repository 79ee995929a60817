#pragma once
// What the pair style and the wall read alike.

#include "core/error.hpp"
#include "dem/contacts.hpp"

#include "error.h"
#include "update.h"
#include "utils.h"

#include <cmath>
#include <cstring>

namespace LAMMPS_NS {

/// What `act` throws becomes an error of LAMMPS, on all ranks (`one`: on this one).
template <class Act>
auto platen_try(Error* error, const char* file, int line, const std::string& who, const Act& act,
                bool one = false) {
  std::string why;
  try {
    return act();
  } catch (const std::exception& problem) { why = who + ": " + problem.what(); }
  if (one) error->one(file, line, why);
  error->all(file, line, why);
}

/// A number of the input; LAMMPS reads 1e999 as infinity.
inline double platen_number(Error* error, const char* file, int line, const std::string& who,
                            const char* text, LAMMPS* lmp) {
  const double value = utils::numeric(file, line, text, false, lmp);
  if (!std::isfinite(value)) error->all(file, line, who + ": " + text + " is not finite");
  return value;
}

inline platen::dem::Units platen_units(Error* error, const Update* update, const std::string& who) {
  if (std::strcmp(update->unit_style, "si") == 0) return {};
  if (std::strcmp(update->unit_style, "cgs") == 0) return {1e-2, 1e-5};
  error->all(FLERR, who + " needs units si or cgs, not " + update->unit_style);
}

} // namespace LAMMPS_NS
