#pragma once
// `platen study check`: runs of a data pool pressed again.

#include "app/command_line.hpp"

namespace platen::app {

void add_study_check(Command study);

} // namespace platen::app
