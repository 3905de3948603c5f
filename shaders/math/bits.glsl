// Floats as bit patterns. Needs no other file.

#define IM_NAN uintBitsToFloat(0x7fc00000u)
#define IM_SMALLEST 1.17549435e-38 // hardware may flush smaller ones to 0: kernels treat them as 0
#define IM_LARGEST 3.402823466e38

// Tests bits: compilers that assume finite arithmetic remove `x != x`, and some drivers isnan().
bool im_is_nan(float x) {
    return (floatBitsToUint(x) & 0x7fffffffu) > 0x7f800000u;
}

// Clears the last 12 bits of x's mantissa: products of two such numbers are exact.
float im_leading(float x) {
    return uintBitsToFloat(floatBitsToUint(x) & 0xfffff000u);
}
