// Every function that a DEM code's inner loop reaches, instantiated; host_macro.sh checks that each carries
// the macro.
#include "platen/law/agarwal.hpp"
#include "platen/law/batch.hpp"
#include "platen/law/edmans_sinka.hpp"
#include "platen/law/hertz.hpp"
#include "platen/law/shahin.hpp"
#include "platen/law/similarity.hpp"
#include "platen/law/wang.hpp"

template <class Law> double reach(const Law& law, const platen::law::State& state, double overlap) {
  const auto now = evaluate(law, state, overlap);
  return now.force + now.dissipated_work + now.mean_pressure;
}

using namespace platen::law;
template double reach(const Hertz<double>&, const State&, double);
template double reach(const Similarity<double>&, const State&, double);
template double reach(const EdmansSinka<double>&, const State&, double);
template double reach(const Wang<double>&, const State&, double);
template double reach(const Agarwal&, const State&, double);
template double reach(const Shahin&, const State&, double);

void reach_all(const Wang<double>& law, std::span<const double> overlap, std::span<State> state,
               std::span<double> force) {
  evaluate_all(law, overlap, state, force);
}
