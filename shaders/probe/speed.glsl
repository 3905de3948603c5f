// How much arithmetic a driver does: CHAINS (1 to 8) chains of multiply-adds, UNROLLED of each in a round,
// beside which the loop is cheap (a power of two from 4 on). FUSED writes them as fma().
//
// Chains tend to 1, whatever the number of rounds, so that no number is denormal or infinite. Each begins
// elsewhere, so that they can't be merged.
uniform vec4 factor, term;
uniform int rounds;

#if FUSED
#define NEXT(v) v = fma(v, factor, term);
#else
#define NEXT(v) v = v * factor + term;
#endif
#if CHAINS > 4
#define ONCE NEXT(a) NEXT(b) NEXT(c) NEXT(d) NEXT(e) NEXT(f) NEXT(g) NEXT(h)
#elif CHAINS > 3
#define ONCE NEXT(a) NEXT(b) NEXT(c) NEXT(d)
#elif CHAINS > 2
#define ONCE NEXT(a) NEXT(b) NEXT(c)
#elif CHAINS > 1
#define ONCE NEXT(a) NEXT(b)
#else
#define ONCE NEXT(a)
#endif
#define FOUR(x) x x x x
#if UNROLLED == 32
#define ROUND FOUR(FOUR(ONCE)) FOUR(FOUR(ONCE))
#elif UNROLLED == 16
#define ROUND FOUR(FOUR(ONCE))
#endif

vec4 chains(vec4 place) {
    vec4 a = place * 1e-3 + 0.5, b = a + 1.0, c = a + 2.0, d = a + 3.0;
    vec4 e = a + 4.0, f = a + 5.0, g = a + 6.0, h = a + 7.0;
    for (int k = 0; k < rounds; ++k) {
        ROUND
    }
    return a + b + c + d + e + f + g + h;
}

#ifdef COMPUTE
layout(rgba32f, binding = 0) writeonly uniform image2D stored;

void main() { imageStore(stored, ivec2(gl_GlobalInvocationID.xy), chains(pixel_centre.xyxy)); }
#else
out vec4 color;

void main() { color = chains(pixel_centre.xyxy); }
#endif
