// Compiles a function once more for processors that have each of the targets. glibc chooses the
// version while the program is linked. That is before a sanitizer is ready, so sanitized builds
// don't use it.
#pragma once

#include <cstdint> // defines __GLIBC__

#if defined(__x86_64__) && defined(__gnu_linux__) && defined(__GLIBC__) && defined(__GNUC__) &&    \
    !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define ISOMOTION_CLONES(...) __attribute__((target_clones(__VA_ARGS__, "default")))
#else
#define ISOMOTION_CLONES(...)
#endif

// Before a loop over lanes: results of one lane are no operands of another.
#if defined(__GNUC__) && !defined(__clang__)
#define ISOMOTION_LANES_APART _Pragma("GCC ivdep") _Pragma("GCC unroll 1")
#else
#define ISOMOTION_LANES_APART
#endif
