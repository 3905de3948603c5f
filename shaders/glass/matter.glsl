// The matter of a surface of glass, and how light fades in it.
uniform vec4 glass;      // transmission, index of refraction
uniform vec4 absorption; // per formula unit

vec3 absorbed(float way) {
    return exp(-absorption.rgb * max(way, 0.0));
}
