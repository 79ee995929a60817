#pragma once

namespace CLI {
class App;
}

namespace platen::app {

/// `platen export lammps`, under the command `export`.
void add_export_lammps(CLI::App& command);

} // namespace platen::app
