// What shadow rays took at the end of a path, in one float: evaluations, which are fewer than
// MOST_OF_SHADOWS for 8 lights and 8 surfaces, and rays that stay undecided.
const float MOST_OF_SHADOWS = 131072.0;

// `ended`: texel of their states, see effects/hidden_lights.glsl.
float packed_shadows(vec4 ended) {
    return ended.z + MOST_OF_SHADOWS * ended.w;
}

// Evaluations, and rays undecided.
vec2 unpacked_shadows(float both) {
    float undecided = floor(both / MOST_OF_SHADOWS);
    return vec2(both - MOST_OF_SHADOWS * undecided, undecided);
}
