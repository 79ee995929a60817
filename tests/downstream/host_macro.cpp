// Every function that a DEM code's inner loop reaches, instantiated; host_macro.sh checks that each carries
// the macro. One table runs every law.
#include "platen/law/table.hpp"

using namespace platen::law;

double reach(const TableView& table, const Scale& scale, const State& state, double overlap) {
  const auto now = evaluate(table, scale, state, overlap);
  return now.force + now.dissipated_work + now.mean_pressure;
}
