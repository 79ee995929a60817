/* The contact laws for programs that are not C++20: a small compiled interface over include/platen/law.
 *
 * A law is made once from texts and is then read-only: any number of threads may evaluate it. What a contact remembers
 * is a block of platen_law_state_size(law) bytes that the caller keeps, all zero when two bodies first touch. It may be
 * copied and saved as bytes; keep platen_law_state_version(law) beside it, and ask it before use. Link platen::law_c,
 * or -lplaten_law. No function here throws or prints. */
#ifndef PLATEN_LAW_H
#define PLATEN_LAW_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct platen_law platen_law;

enum { PLATEN_SEPARATED = 0, PLATEN_LOADING = 1, PLATEN_UNLOADING = 2, PLATEN_RELOADING = 3 };

typedef struct platen_law_response {
  double force_N;
  double stiffness_N_per_m;
  double contact_radius_m;
  double mean_pressure_Pa;
  double dissipated_work_J;
  int branch;
  int in_range; /* 0: outside what the law was made for; the values continue monotonically */
} platen_law_response;

/* `law` and `variant` as `platen laws` lists them, "" is the law's default variant; `parameters` as
 * "radius_m=1e-3 E_Pa=1e9 nu=0.3 ...". NULL where something is wrong: then `message` says what. */
platen_law* platen_law_new(const char* law, const char* variant, const char* parameters, char* message,
                           size_t message_size);
void platen_law_free(platen_law*);

/* What a contact remembers. */
size_t platen_law_state_size(const platen_law*);      /* bytes, a multiple of 8 */
unsigned platen_law_state_version(const platen_law*); /* of what the bytes mean */
/* The numbers in it: name and unit of number i, NULL past the last. */
const char* platen_law_state_name(const platen_law*, size_t i);

/* Overlap: approach of the two centres, against a plane that of the centre [m]. Advances `state`. An overlap that is no
 * number, or bytes that no law left there, give a response that is none, and the state stays. */
platen_law_response platen_law_evaluate(const platen_law*, void* state, double overlap_m);

/* The same but for rounding over n contacts, several at once, whose states lie one after the other;
 * `stiffness_N_per_m` may be NULL. */
void platen_law_evaluate_all(const platen_law*, size_t n, const double* overlap_m, void* states, double* force_N,
                             double* stiffness_N_per_m);

#ifdef __cplusplus
}
#endif
#endif
