#pragma once
// What a host program may set before it includes a law.
//
// PLATEN_FUNCTION marks every function that a DEM code may call in its inner loop. A GPU code sets it, e.g.
//   #define PLATEN_FUNCTION __host__ __device__ inline
// before the first include of platen/law. Functions that validate (`prepare`) throw and stay on the host.

#ifndef PLATEN_FUNCTION
#define PLATEN_FUNCTION inline
#endif
