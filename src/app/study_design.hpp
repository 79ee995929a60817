#pragma once
// `platen study design`: the runs of a study before any is pressed.

#include "app/command_line.hpp"

namespace platen::app {

void add_study_design(Command study);

} // namespace platen::app
