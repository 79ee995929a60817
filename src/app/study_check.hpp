#pragma once
// `platen study check`: runs of a data pool pressed again.

namespace CLI {
class App;
}

namespace platen::app {

void add_study_check(CLI::App& study);

} // namespace platen::app
