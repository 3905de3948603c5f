// What questions about a driver's arithmetic are asked with: src/render/arithmetic.cpp.
uniform float zero, one, a, c, large, smallest;
uniform uint nan_bits, tiny_bits;
out vec4 answers;

float fused(float x, float y, float z) {
#if __VERSION__ >= 400 || defined(GL_ARB_gpu_shader5)
    return fma(x, y, z);
#else
    return 0.0;
#endif
}
float precise_product() { precise float y = a * a - c; return y; }
float precise_sum() { precise float y = (large + one) - large; return y; }
