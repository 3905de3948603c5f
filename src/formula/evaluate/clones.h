// A function compiled once more for processors that have `target`. Which one runs is chosen while
// the program is linked, by glibc: before a sanitiser is ready, so not with one.
#pragma once

#include <cstdint> // defines __GLIBC__

#if defined(__x86_64__) && defined(__gnu_linux__) && defined(__GLIBC__) && defined(__GNUC__) &&    \
    !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define ISOMOTION_CLONES(target) __attribute__((target_clones(target, "default")))
#else
#define ISOMOTION_CLONES(target)
#endif
