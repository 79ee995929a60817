#pragma once
// The subcommands. Each adds itself to the command line, and does its work in a callback that reports failure
// by the exceptions of core/error.hpp; main alone knows exit codes.

#include "app/command_line.hpp"

namespace platen::app {

void add_materials(Command);
void add_point(Command);
void add_press(Command);
void add_fit(Command);
void add_derive(Command);
void add_laws(Command);
void add_eval(Command);
void add_compare(Command);
void add_export(Command);
void add_study(Command);
void add_import(Command);
void add_calibrate(Command);
void add_convert(Command);
void add_compaction(Command);
void add_predict(Command);
void add_reproduce(Command);
void add_manual(Command, const Program&);
void add_completion(Command, const Program&);

} // namespace platen::app
