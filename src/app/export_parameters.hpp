#pragma once

#include "app/command_line.hpp"

namespace platen::app {

/// `platen export parameters`, under the command `export`.
void add_export_parameters(Command command);

} // namespace platen::app
