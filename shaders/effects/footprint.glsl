// Computes how far the normal turns within a pixel. Mirrors and highlights are blurred by this
// angle, so that strongly curved surfaces do not glitter (Tokuyoshi & Kaplanyan 2019). Needs
// surface_point.glsl and field_hessian().
//
// The normals of a pixel over which the normal turns by T count as facets of alpha^2 = T^2 / 48. An
// even spread over T has the variance T^2 / 12, but GGX's tails then carry lamps far beyond it: at
// 288x288 the chrome blobby was 1.32 times as bright as the mean of 16 rays per pixel, and farther
// from that mean than without any blur. With 48 it is 1.15 times as bright and nearer to the mean.
// Less blur would leave more glitter.

// Added to alpha^2 of the surface being lit.
float footprint_alpha2 = 0.0;

#ifdef HESSIAN
// `width`: of the beam along `direction`. Returns 2 where the normal has no derivative.
float turn_of_normal(SurfacePoint p, vec3 direction, float width) {
    if (p.on_ground) return 0.0;
#ifdef SECTIONS
    if (p.cap >= 0) return 0.0;
#endif
    Hessian f = field_hessian(p.position);
    mat3 h = mat3(f.xx, f.xy, f.xz, f.xy, f.yy, f.yz, f.xz, f.yz, f.zz);
    vec3 n = p.normal;
    vec3 across = cross(direction, n);
    vec3 axis = abs(n.x) < 0.5 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0);
    vec3 u = normalize(dot(across, across) > 1.0e-6 ? across : cross(axis, n));
    vec3 v = cross(n, u);
    vec3 hu = h * u, hv = h * v;
    hu -= dot(hu, n) * n;
    hv -= dot(hv, n) * n;
    // The surface cuts the beam obliquely, which makes its footprint longer along the ray.
    float slant = max(-dot(direction, n), 0.1);
    float turn = width / p.steepness * sqrt(dot(hu, hu) + dot(hv, hv) / (slant * slant));
    return turn < 2.0 ? turn : 2.0; // also for NaN
}
#else
// The formula's second derivatives are too long for a shader.
float turn_of_normal(SurfacePoint p, vec3 direction, float width) {
    return 0.0;
}
#endif
