#pragma once

#include "app/command_line.hpp"

namespace platen::app {

/// `platen study sobol`
void add_study_sobol(Command study);

} // namespace platen::app
