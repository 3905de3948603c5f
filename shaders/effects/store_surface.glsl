// Stores the end of a pixel's ray, and the evaluations that it took. Needs surface_point.glsl.
const int MOST_STORED_EVALUATIONS = (1 << 19) - 1; // above five bits of a float's 24

layout(location = 0) out vec4 surface_0;
layout(location = 1) out vec4 surface_1;
layout(location = 2) out vec4 surface_2;

void store_surface(SurfacePoint p, int evaluations) {
    int code = p.verdict + (p.inside ? 8 : 0) + (p.on_ground ? 16 : 0) +
               (min(evaluations, MOST_STORED_EVALUATIONS) << 5);
    surface_0 = vec4(p.position, p.offset);
    surface_1 = vec4(p.normal, float(code));
    surface_2 = vec4(p.steepness, p.t, p.pixel, 0.0);
#ifdef SECTIONS
    surface_2.w = float(p.cap + 1);
#endif
}
