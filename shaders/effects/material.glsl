// How a material reflects light: reflected() and mirror_weight(), for each model.
//
// Directions are unit vectors away from the surface. Colours of lights are irradiance / pi, so
// `reflected` is pi * brdf * cosine: the light to the viewer, in units of the light's colour. It is
// finite and not negative for any directions, and 0 for a light below the horizon. `mirror_weight`
// is the share of a mirror's image that the material shows, 0..1.

#if defined(GGX)
// Microfacet materials, from plastic to metal.
//
// The highlight is Cook and Torrance's, with GGX at alpha = roughness^2, Smith's height-correlated
// masking (Heitz 2014) and Schlick's Fresnel term. Light that facets pass on to other facets comes
// back as a second lobe, and the matt part gets what both lobes leave (Kulla & Conty 2017). So no
// material loses much light or makes any, and light and viewer may be exchanged. A metal's
// highlight has the colour of its albedo. Reflectances above 1 count as 1.

uniform vec4 gloss; // roughness, metallic, specular (reflectance straight on); each 0..1

// With less roughness, the highlight of a point light is smaller than a pixel.
const float least_roughness = 0.045;

// Reflection by facets: Schlick's term from `straight` on to `along` the surface; `back` is the
// share of the light lost at the first facet that returns after further ones.
struct Specular {
    vec3 straight, along, back;
};

float roughness() {
    float rough = clamp(gloss.x, least_roughness, 1.0);
#ifdef FOOTPRINT
    float square = rough * rough;
    rough = sqrt(sqrt(min(square * square + footprint_alpha2, 1.0)));
#endif
    return rough;
}

float alpha() {
    return roughness() * roughness();
}

float metallic() {
    return clamp(gloss.y, 0.0, 1.0);
}

// The highlight's parts of light from (or to) one direction: x, the part that facets of reflectance
// 1 do not return at once; y, the part with the weight (1 - v.h)^5. Least squares fits to numerical
// integrals, biased to the side that makes no light: x is at most 0.0015 above and 0.016 below, y
// at most 0.002 below and 0.02 above.
vec2 lost_and_rim(float cosine) {
    float r = roughness();
    vec4 p = vec4(1.0, r, r * r, r * r * r);
    float x = cosine / (cosine + alpha()); // in x all narrow lobes are alike
    float lost = dot(vec4(8.02535, -50.0926, 90.7582, -5.00699), p);
    lost = lost * x + dot(vec4(-22.082, 137.518, -305.388, 134.611), p);
    lost = lost * x + dot(vec4(16.839, -105.294, 239.821, -118.79), p);
    lost = lost * x + dot(vec4(-3.96104, 26.9899, -58.6064, 26.3452), p);
    lost = lost * x + dot(vec4(0.502939, -2.1117, 3.39547, 1.65056), p);
    lost *= x * (1.0 - x);
    float rim = dot(vec4(-0.426372, 3.38154, 7.97865, -11.4049), p);
    rim = rim * x + dot(vec4(1.34057, -7.68646, 0.281895, 10.6851), p);
    rim = rim * x + dot(vec4(-1.10394, 8.82225, -15.8297, 7.61745), p);
    rim = rim * x + dot(vec4(1.20228, -3.76992, 4.40469, -1.78444), p);
    float off = 1.0 - cosine;
    float off2 = off * off;
    rim *= off2 * off2 * off;
    rim += cosine * cosine * off2 * dot(vec3(1.35372, -0.785764, -0.614851), p.yzw);
    return clamp(vec2(lost, rim), 0.0, 1.0);
}

// Their means over all directions, weighted by the cosine. The fit of the first is too high, by 1 %
// and more the smaller it is, so that less light comes back than was lost.
vec2 mean_lost_and_rim() {
    float r = roughness();
    float lost = 3.52232;
    lost = lost * r - 6.2589;
    lost = lost * r + 0.627395;
    lost = lost * r + 2.81021;
    lost = lost * r - 0.112021;
    lost = lost * r + 0.00176403;
    float rim = -0.304607;
    rim = rim * r + 0.698527;
    rim = rim * r - 0.5187;
    rim = rim * r + 0.0814528;
    rim = rim * r + 0.0486051;
    return vec2(max(lost * r * r, 1.0e-7), rim);
}

// Reflection by facets with a reflectance of 0..1 straight on. No real material has less than 2 %:
// a smaller reflectance also fades the rim, and 0 gives no highlight. Each further facet reflects
// the mean of Schlick's term and loses the mean of the lost part.
Specular specular_of(vec3 straight, float mean_lost) {
    vec3 along = vec3(min(50.0 * max(max(straight.r, straight.g), straight.b), 1.0));
    vec3 mean = mix(straight, along, 1.0 / 21.0);
    return Specular(straight, along, mean * mean * (1.0 - mean_lost) / (1.0 - mean * mean_lost));
}

// The colourless coat over the matt part.
Specular coat_of(float mean_lost) {
    return specular_of(vec3(clamp(gloss.z, 0.0, 1.0)), mean_lost);
}

// Mixes metal and coat: a half metal is one half of each.
Specular highlight_of(vec3 albedo, Specular coat, float mean_lost) {
    Specular metal = specular_of(albedo, mean_lost);
    float part = metallic();
    return Specular(mix(coat.straight, metal.straight, part), mix(coat.along, metal.along, part),
                    mix(coat.back, metal.back, part));
}

// The highlight's share of the light from one direction.
vec3 share(Specular s, vec2 lost_rim) {
    return s.straight * max(1.0 - lost_rim.x - lost_rim.y, 0.0) + s.along * lost_rim.y +
           s.back * lost_rim.x;
}

// pi D F G / (4 (n.l) (n.v)). The half vector is not normalised. 1 - (n.h)^2 is computed by a cross
// product, since the difference would have no digits left inside the highlight.
vec3 single_scattering(Specular s, vec3 normal, vec3 to_viewer, vec3 to_light, float nv, float nl) {
    vec3 between = to_viewer + to_light;
    vec3 across = cross(normal, between);
    float along = max(dot(normal, between), 0.0);
    float sine2 = dot(across, across);
    float cosine2 = along * along;
    float a2 = alpha() * alpha();
    float q = (cosine2 + sine2) / max(cosine2 * a2 + sine2, 1.0e-20);
    float masking =
        0.5 / (nl * sqrt(nv * nv * (1.0 - a2) + a2) + nv * sqrt(nl * nl * (1.0 - a2) + a2));
    float vh = min(0.5 * length(between), 1.0); // of two unit vectors
    float off = 1.0 - vh;
    float off2 = off * off;
    return mix(s.straight, s.along, off2 * off2 * off) * (a2 * q * q * masking);
}

vec3 reflected(vec3 albedo, vec3 normal, vec3 to_viewer, vec3 to_light) {
    float nl = min(dot(normal, to_light), 1.0);
    if (!(nl > 0.0)) return vec3(0.0);
    float nv = clamp(dot(normal, to_viewer), 1.0e-4, 1.0);
    albedo = clamp(albedo, 0.0, 1.0);
    vec2 mean = mean_lost_and_rim();
    vec2 at_light = lost_and_rim(nl), at_viewer = lost_and_rim(nv);
    Specular coat = coat_of(mean.x);
    Specular highlight = highlight_of(albedo, coat, mean.x);
    vec3 all = single_scattering(highlight, normal, to_viewer, to_light, nv, nl);
    all += highlight.back * (at_light.x * at_viewer.x / mean.x);
    vec3 matt = max(1.0 - share(coat, at_light), 0.0) * max(1.0 - share(coat, at_viewer), 0.0) /
                max(1.0 - share(coat, mean), 1.0e-3);
    all += (1.0 - metallic()) * albedo * matt;
    return all * nl;
}

// The highlight's share of ambient light: Schlick's term for a mirror, with a weaker rim where the
// surface is rough.
vec3 mirror_weight(vec3 albedo, vec3 normal, vec3 to_viewer) {
    float mean_lost = mean_lost_and_rim().x;
    Specular highlight = highlight_of(clamp(albedo, 0.0, 1.0), coat_of(mean_lost), mean_lost);
    float nv = clamp(dot(normal, to_viewer), 0.0, 1.0);
    return clamp(share(highlight, lost_and_rim(nv)), 0.0, 1.0);
}
#elif defined(BLINN_PHONG)
// Blinn-Phong, normalised: a white highlight on a matt surface. Needs math/pow.glsl and the files
// that it needs.
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
#else
// A matt surface, which reflects equally to every side.
vec3 reflected(vec3 albedo, vec3 normal, vec3 to_viewer, vec3 to_light) {
    return albedo * max(dot(normal, to_light), 0.0);
}

// The share that a clear coat mirrors (Schlick).
vec3 mirror_weight(vec3 albedo, vec3 normal, vec3 to_viewer) {
    float c = 1.0 - clamp(dot(normal, to_viewer), 0.0, 1.0);
    return vec3(0.04 + 0.96 * c * c * c * c * c);
}
#endif
