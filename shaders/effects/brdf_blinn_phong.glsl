// A white highlight on a matt surface: Blinn-Phong, normalised. Needs math/pow.glsl and what that
// needs. See brdf_lambert.glsl for what the two functions are.
//
// The highlight pi * brdf = specular * N * (n.h)^shininess has N such that a white one (specular 1)
// reflects all light to a viewer straight above, and less to any other:
// N = (s + 2)(s + 4) / (8 (s + 2^(-s/2))). What the highlight may take, the matt part leaves: never
// more light comes back than came, and light and viewer may change places.

uniform vec4 gloss; // shininess s >= 0, specular 0..1

vec3 reflected(vec3 albedo, vec3 normal, vec3 to_viewer, vec3 to_light) {
    float cosine = dot(normal, to_light);
    if (!(cosine > 0.0)) return vec3(0.0);
    float shininess = max(gloss.x, 0.0);
    float specular = clamp(gloss.y, 0.0, 1.0);
    // The half vector keeps its length: (n.h)^2 is a quotient of squares, and 0 for no half vector.
    vec3 between = to_viewer + to_light;
    float along = max(dot(normal, between), 0.0);
    float square = min(along * along / max(dot(between, between), 1.0e-12), 1.0);
    float normalisation = (shininess + 2.0) * (shininess + 4.0) /
                          (8.0 * (shininess + im_exp(-0.346573590 * shininess)));
    float highlight = specular * normalisation * im_pow(square, 0.5 * shininess);
    return (clamp(albedo, 0.0, 1.0) * (1.0 - specular) + highlight) * cosine;
}

// Schlick's Fresnel term, from `specular` straight on to 1 along the surface. A material of
// specular below 2 % has no such rim: at 0 it is matt from every side.
vec3 mirror_weight(vec3 albedo, vec3 normal, vec3 to_viewer) {
    float specular = clamp(gloss.y, 0.0, 1.0);
    float off = 1.0 - clamp(dot(normal, to_viewer), 0.0, 1.0);
    float off2 = off * off;
    return vec3(mix(specular, min(50.0 * specular, 1.0), off2 * off2 * off));
}
