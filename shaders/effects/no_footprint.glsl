// Replaces footprint.glsl if the formula's second derivatives are too long for a shader.
float footprint_alpha2 = 0.0;

float turn_of_normal(SurfacePoint p, vec3 direction, float width) {
    return 0.0;
}
