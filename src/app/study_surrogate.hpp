#pragma once

#include "app/command_line.hpp"

namespace platen::app {

/// `platen study surrogate`
void add_study_surrogate(Command study);

} // namespace platen::app
