// Curvatures of the surface, as in src/formula/curvature.h. They are computed in a frame of the
// tangent plane, which avoids the differences of large terms in formulas by coordinates. Needs
// state.glsl and field_hessian().
#ifdef CURVATURE
vec3 surface_gradient(RayState s, vec3 position);

// Mean and Gaussian curvature; NaN where the gradient vanishes.
vec2 curvatures(Hit hit) {
#ifdef SECTIONS
    if (hit.cap >= 0) return section_curvatures(hit.cap);
#endif
    vec3 g = surface_gradient(load_state(), hit.position);
    // Neither depends on the scale of F, which may be near the limits of float's range.
    float scale = max(max(abs(g.x), abs(g.y)), abs(g.z));
    if (!(scale > 0.0)) return vec2(IM_NAN);
    g /= scale;
    float size = length(g);
    vec3 n = g / size;
    vec3 a = abs(n);
    // The axis farthest from n.
    vec3 axis = a.x <= a.y && a.x <= a.z ? vec3(1.0, 0.0, 0.0)
                : a.y <= a.z             ? vec3(0.0, 1.0, 0.0)
                                         : vec3(0.0, 0.0, 1.0);
    vec3 u = normalize(cross(n, axis));
    vec3 v = cross(n, u);
    Hessian f = field_hessian(hit.position);
    mat3 h = mat3(f.xx, f.xy, f.xz, f.xy, f.yy, f.yz, f.xz, f.yz, f.zz) / scale;
    vec3 hu = h * u / size;
    vec3 hv = h * v / size;
    float uv = dot(u, hv);
    return vec2(0.5 * (dot(u, hu) + dot(v, hv)), dot(u, hu) * dot(v, hv) - uv * uv);
}
#else
// For expressions that name none.
vec2 curvatures(Hit hit) {
    return vec2(0.0);
}
#endif
