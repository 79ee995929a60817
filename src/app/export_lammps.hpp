#pragma once

#include "app/command_line.hpp"

namespace platen::app {

/// `platen export lammps`, under the command `export`.
void add_export_lammps(Command command);

} // namespace platen::app
