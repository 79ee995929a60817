#pragma once
// The subcommands. Each adds itself to the command line, and does its work in a callback that reports failure
// by the exceptions of core/error.hpp; main alone knows exit codes.

namespace CLI {
class App;
}

namespace platen::app {

void add_materials(CLI::App&);
void add_point(CLI::App&);
void add_press(CLI::App&);
void add_fit(CLI::App&);
void add_derive(CLI::App&);
void add_laws(CLI::App&);
void add_eval(CLI::App&);
void add_compare(CLI::App&);
void add_export(CLI::App&);
void add_study(CLI::App&);

} // namespace platen::app
