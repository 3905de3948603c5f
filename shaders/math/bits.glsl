// Floats as bit patterns. Needs no other file.

#define IM_NAN uintBitsToFloat(0x7fc00000u)
#define IM_SMALLEST 1.17549435e-38 // below it hardware may flush to 0: the kernels treat it as 0
#define IM_LARGEST 3.402823466e38

// By bits: compilers that assume finite arithmetic remove `x != x` and some drivers isnan().
bool im_is_nan(float x) {
    return (floatBitsToUint(x) & 0x7fffffffu) > 0x7f800000u;
}

// x with the last 12 bits of its mantissa cleared: a product of two such is exact.
float im_leading(float x) {
    return uintBitsToFloat(floatBitsToUint(x) & 0xfffff000u);
}
