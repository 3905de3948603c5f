// Has the processor round upwards, in this thread, for as long as an object lasts.
#pragma once

#include <cfenv>

#if defined(__x86_64__)
#include <xmmintrin.h>
#endif

// Whether a compiler computes at run time, and with the signs that are written, what depends on how
// the processor rounds. Loops over such arithmetic vectorise with GCC alone.
#if defined(__GNUC__) && !defined(__clang__) && defined(__ROUNDING_MATH__)
#define ISOMOTION_MAY_ROUND_UPWARDS 1
#else
#define ISOMOTION_MAY_ROUND_UPWARDS 0
#endif

namespace isomotion::formula {

class RoundingUpwards {
public:
    RoundingUpwards()
        : before_(mode())
        , upwards_(upwards(before_)) {
        set(upwards_);
    }
    ~RoundingUpwards() { set(before_); }
    RoundingUpwards(const RoundingUpwards&) = delete;
    RoundingUpwards& operator=(const RoundingUpwards&) = delete;

    // For functions whose error bounds ask for the nearest double, and afterwards.
    void pause() { set(before_); }
    void resume() { set(upwards_); }

private:
    // The C library sets what x87 does, too, which takes longer than adding up two blocks.
#if defined(__x86_64__)
    using Mode = unsigned;
    static Mode mode() { return _mm_getcsr(); }
    static Mode upwards(Mode before) { return (before & ~_MM_ROUND_MASK) | _MM_ROUND_UP; }
    static void put(Mode mode) { _mm_setcsr(mode); }
#else
    using Mode = int;
    static Mode mode() { return std::fegetround(); }
    static Mode upwards(Mode) { return FE_UPWARD; }
    static void put(Mode mode) { std::fesetround(mode); }
#endif
    // No load of an operand moves up over this, and no store of a result down.
    static void set(Mode mode) {
        asm volatile("" ::: "memory");
        put(mode);
        asm volatile("" ::: "memory");
    }

    Mode before_, upwards_;
};

// Whether the processor does as it is told. Emulators may not: valgrind always rounds to the
// nearest.
inline bool can_round_upwards() {
    static const bool can = [] {
        volatile double one = 1, little = 0x1p-60, sum = 0;
        {
            const RoundingUpwards upwards;
            sum = one + little;
        }
        return sum > 1;
    }();
    return can;
}

} // namespace isomotion::formula
