#pragma once
// Debian's baseline knows SSE2 alone. A function marked with this is compiled for newer processors too, and
// the right version is taken when the program starts. They differ by rounding: newer ones multiply and add at
// once.

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) &&     \
    !defined(__SANITIZE_THREAD__) && !defined(PLATEN_PLAIN)
#define PLATEN_VECTOR_CLONES [[gnu::target_clones("default", "arch=x86-64-v3", "arch=x86-64-v4")]]
#else
#define PLATEN_VECTOR_CLONES
#endif
