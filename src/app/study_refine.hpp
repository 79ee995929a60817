#pragma once

#include "app/command_line.hpp"

namespace platen::app {

/// `platen study refine`
void add_study_refine(Command study);

} // namespace platen::app
