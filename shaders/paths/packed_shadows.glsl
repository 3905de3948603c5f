// What shadow rays took at the end of a path, in one float: rays that stay undecided, and evaluations.
// Only the paper's methods may take MOST_OF_SHADOWS for 8 lights and 8 surfaces; more are not counted.
const float MOST_OF_SHADOWS = 131072.0;

// `ended`: texel of their states, see effects/shadow.glsl.
float packed_shadows(vec4 ended) {
    return min(ended.z, MOST_OF_SHADOWS - 1.0) + MOST_OF_SHADOWS * ended.w;
}

// Evaluations, and rays undecided.
vec2 unpacked_shadows(float both) {
    float undecided = floor(both / MOST_OF_SHADOWS);
    return vec2(both - MOST_OF_SHADOWS * undecided, undecided);
}
