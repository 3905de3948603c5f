// Lights glass by effects/material.glsl. Transmitted light is taken from the matt part only; the
// highlight, also of metal, is the same as without glass.

// The matt part of reflected().
vec3 matt_part(vec3 albedo, vec3 normal, vec3 to_viewer, vec3 to_light) {
    float nl = min(dot(normal, to_light), 1.0);
    float nv = clamp(dot(normal, to_viewer), 1.0e-4, 1.0);
    vec2 mean = mean_lost_and_rim();
    Specular coat = coat_of(mean.x);
    vec3 matt = max(1.0 - share(coat, lost_and_rim(nl)), 0.0) *
                max(1.0 - share(coat, lost_and_rim(nv)), 0.0) /
                max(1.0 - share(coat, mean), 1.0e-3);
    return (1.0 - metallic()) * clamp(albedo, 0.0, 1.0) * matt * max(nl, 0.0);
}

vec3 reflected_by_glass(vec3 albedo, vec3 normal, vec3 to_viewer, vec3 to_light) {
    // Without metal the highlight has no colour.
    if (metallic() == 0.0)
        return reflected(clamp(albedo, 0.0, 1.0) * opaque_part(), normal, to_viewer, to_light);
    vec3 matt = matt_part(albedo, normal, to_viewer, to_light);
    return max(reflected(albedo, normal, to_viewer, to_light) - (1.0 - opaque_part()) * matt, 0.0);
}
