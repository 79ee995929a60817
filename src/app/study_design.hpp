#pragma once
// `platen study design`: the runs of a study before any is pressed.

namespace CLI {
class App;
}

namespace platen::app {

void add_study_design(CLI::App& study);

} // namespace platen::app
