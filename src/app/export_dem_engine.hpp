#pragma once

#include "app/command_line.hpp"

namespace platen::app {

/// `platen export dem-engine`, under the command `export`.
void add_export_dem_engine(Command command);

} // namespace platen::app
