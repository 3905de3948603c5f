// Refraction, after Born and Wolf, Principles of Optics, 1.5. Needs surface_point.glsl.

#ifndef FOLLOWS_PATHS
// The matter of a surface of glass, and how light fades in it.
uniform vec4 glass;      // transmission, index of refraction
uniform vec4 absorption; // per formula unit

vec3 absorbed(float way) {
    return exp(-absorption.rgb * max(way, 0.0));
}
#endif

// The split of light from `direction` at the surface.
struct Refraction {
    float reflected; // the part of unpolarised light; 1: total reflection
    vec3 direction;  // of the refracted rest
};

// `index`: of refraction within the surface, relative to that outside.
Refraction refraction_at(SurfacePoint p, vec3 direction, float index) {
    float eta = p.inside ? index : 1.0 / index;
    float c = clamp(-dot(p.normal, direction), 0.0, 1.0);
    float square = (1.0 - eta * eta) + (eta * c) * (eta * c);
    if (square <= 0.0) return Refraction(1.0, vec3(0.0));
    float beyond = sqrt(square);
    float across = (eta * c - beyond) / max(eta * c + beyond, 1.0e-30);
    float along = (eta * beyond - c) / max(eta * beyond + c, 1.0e-30);
    return Refraction(0.5 * (across * across + along * along),
                      normalize(eta * direction + (eta * c - beyond) * p.normal));
}
