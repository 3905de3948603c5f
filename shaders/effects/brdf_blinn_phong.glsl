// Blinn-Phong, normalised: a white highlight on a matt surface. Needs math/pow.glsl and the files
// that it needs. brdf_lambert.glsl describes the two functions.
//
// The highlight is pi * brdf = specular * N * (n.h)^shininess, with
// N = (s + 2)(s + 4) / (8 (s + 2^(-s/2))). So a white highlight (specular 1) reflects all light to
// a viewer straight above, and less to any other. The matt part gets the light that the highlight
// leaves. So no more light comes back than came, and light and viewer may be exchanged.

uniform vec4 gloss; // shininess s >= 0, specular 0..1

vec3 reflected(vec3 albedo, vec3 normal, vec3 to_viewer, vec3 to_light) {
    float cosine = dot(normal, to_light);
    if (!(cosine > 0.0)) return vec3(0.0);
    float shininess = max(gloss.x, 0.0);
    float specular = clamp(gloss.y, 0.0, 1.0);
    // The half vector is not normalised: (n.h)^2 is a quotient of squares, 0 for a zero vector.
    vec3 between = to_viewer + to_light;
    float along = max(dot(normal, between), 0.0);
    float square = min(along * along / max(dot(between, between), 1.0e-12), 1.0);
    float normalisation = (shininess + 2.0) * (shininess + 4.0) /
                          (8.0 * (shininess + im_exp(-0.346573590 * shininess)));
    float highlight = specular * normalisation * im_pow(square, 0.5 * shininess);
    return (clamp(albedo, 0.0, 1.0) * (1.0 - specular) + highlight) * cosine;
}

// Schlick's Fresnel term, from `specular` straight on to 1 at grazing angles. Below 2 % of specular
// the rim fades; at 0 the material is matt from every side.
vec3 mirror_weight(vec3 albedo, vec3 normal, vec3 to_viewer) {
    float specular = clamp(gloss.y, 0.0, 1.0);
    float off = 1.0 - clamp(dot(normal, to_viewer), 0.0, 1.0);
    float off2 = off * off;
    return vec3(mix(specular, min(50.0 * specular, 1.0), off2 * off2 * off));
}
