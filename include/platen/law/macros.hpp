#pragma once
// What a host program may set before it includes a law.
//
// PLATEN_FUNCTION marks every function that a DEM code may call in its inner loop. A GPU code sets it, e.g.
//   #define PLATEN_FUNCTION __host__ __device__ inline
// before the first include of platen/law. Functions that validate and tabulate (`prepare`, `make`) throw or
// loop over std functions, and stay on the host.
//
// PLATEN_HOT and PLATEN_RARE add to it what the compiler cannot know: which functions lie on the path of
// every contact, so that an unused part of a response costs nothing, and which hardly ever run.

#ifndef PLATEN_FUNCTION
#define PLATEN_FUNCTION inline
#endif

#if defined(__GNUC__) && !defined(__CUDACC__) && !defined(__HIP__)
#define PLATEN_HOT __attribute__((always_inline)) PLATEN_FUNCTION
#define PLATEN_RARE __attribute__((noinline, cold)) PLATEN_FUNCTION
#else
#define PLATEN_HOT PLATEN_FUNCTION
#define PLATEN_RARE PLATEN_FUNCTION
#endif
