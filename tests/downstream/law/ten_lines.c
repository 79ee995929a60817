#include <platen_law.h>
#include <stdio.h>
int main(void) {
  char why[200] = "";
  platen_law* law = platen_law_new("edmans-sinka", "", "radius_m=1e-3 sigma_ref_Pa=8.61e6 E_Pa=4.417e8 nu=0.1472 k=4.2 delta_t=0.09 a=3.5", why, sizeof why);
  double state[2] = {0, 0}; /* platen_law_state_size(law) bytes */
  if (!law) return puts(why), 1;
  platen_law_response now = platen_law_evaluate(law, state, 4e-4);
  printf("%.6f %d\n", now.force_N, now.branch);
  platen_law_free(law);
  return 0;
}
