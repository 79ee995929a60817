/* A library to be preloaded, whose allocations are counted and fail: NO_MEMORY_AT=N the Nth; NO_MEMORY_COUNT=FILE how many there
 * were, written at the end. Counted from main on, on all threads: before it the system says itself that it cannot load. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

extern void* __libc_malloc(size_t);
extern void* __libc_calloc(size_t, size_t);
extern void* __libc_realloc(void*, size_t);
extern void* __libc_memalign(size_t, size_t);

static atomic_long calls;
static long at = -1; /* until it is known */

typedef int Main(int, char**, char**);
static Main* real_main;

static int counted_main(int count, char** words, char** environment) {
  const char* text = getenv("NO_MEMORY_AT");
  at = text ? atol(text) : 0;
  return real_main(count, words, environment);
}

int __libc_start_main(Main* program, int count, char** words, void (*init)(void), void (*fini)(void), void (*rtld_fini)(void),
                      void* stack_end) {
  int (*real)(Main*, int, char**, void (*)(void), void (*)(void), void (*)(void), void*) = dlsym(RTLD_NEXT, "__libc_start_main");
  real_main = program;
  return real(counted_main, count, words, init, fini, rtld_fini, stack_end);
}

__attribute__((destructor)) static void end(void) {
  const char* name = getenv("NO_MEMORY_COUNT");
  const long counted = atomic_load(&calls);
  at = -1;
  if (!name) return;
  FILE* file = fopen(name, "w");
  if (!file) return;
  fprintf(file, "%ld\n", counted);
  fclose(file);
}

static int fails(void) {
  if (at < 0 || atomic_fetch_add(&calls, 1) + 1 != at) return 0;
  errno = ENOMEM;
  return 1;
}

void* malloc(size_t size) { return fails() ? NULL : __libc_malloc(size); }
void* calloc(size_t count, size_t size) { return fails() ? NULL : __libc_calloc(count, size); }
void* realloc(void* old, size_t size) { return fails() ? NULL : __libc_realloc(old, size); }
void* memalign(size_t alignment, size_t size) { return fails() ? NULL : __libc_memalign(alignment, size); }
void* aligned_alloc(size_t alignment, size_t size) { return memalign(alignment, size); }
int posix_memalign(void** result, size_t alignment, size_t size) {
  void* memory = memalign(alignment, size);
  if (!memory) return ENOMEM;
  *result = memory;
  return 0;
}
