#include <cstdio>
#include <platen/law/edmans_sinka.hpp>
#include <platen/law/tabulate.hpp>
int main() {
  platen::law::EdmansSinkaMaterial mcc;
  mcc.sigma_ref = 8.61e6, mcc.E = 4.417e8, mcc.nu = 0.1472, mcc.k = 4.2, mcc.delta_t = 0.09, mcc.a = 3.5;
  const auto law = platen::law::tabulate(platen::law::prepare(mcc, 1e-3));
  platen::law::State state;
  auto now = evaluate(law, state, 4e-4);
  std::printf("%.6f %d\n", now.force, int(now.branch));
}
