// The matter of all surfaces. At a place that lies in several, the matter with the least rank counts and
// the others are not there: Schmidt and Budge, Simple Nested Dielectrics in Ray Traced Images, 2002.
// Needs path.glsl.
uniform vec4 matters[2 * SURFACES]; // of each: index of refraction, rank; absorption per unit of this formula

float rank_of(int matter) {
    return matter == NO_MATTER ? 1.0e9 : matters[2 * matter].y;
}

float index_of(int matter) {
    return matter == NO_MATTER ? 1.0 : matters[2 * matter].x;
}

vec3 absorbed_in(int matter, float way) {
    if (matter == NO_MATTER) return vec3(1.0);
    return exp(-matters[2 * matter + 1].rgb * max(way, 0.0));
}
