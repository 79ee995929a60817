#pragma once

#include "app/command_line.hpp"

namespace platen::app {

/// `platen study methods`
void add_study_methods(Command study);

} // namespace platen::app
