// Where the rays of a block of BLOCK x BLOCK pixels may start: one fragment a block marches its beam
// by interval arithmetic. A piece of the beam whose box is proved free of roots is passed, and the
// next is twice as long; another is halved, until it is as short as the block is wide. What is
// passed holds no root of any of the block's rays, rounding included.
//
// Depths are tau: the ray that crosses the plane of the anchors at `across` (from ray_origin) is
// there at ray_origin + tau ray_axis + (1 + w tau) across, w = 1, or 0 for parallel rays.

layout(location = 0) out vec4 start; // tau; NO_ROOT where all of the block's rays miss

uniform int beam_evaluations;

vec2 hull(float a, float b) {
    return vec2(min(a, b), max(a, b));
}

vec2 within(vec2 x, float least, float most) {
    return vec2(max(x.x, least), min(x.y, most));
}

// [a, b] times an interval, 0 <= a <= b.
vec2 scaled(float a, float b, vec2 x) {
    return vec2(min(a * x.x, b * x.x), max(a * x.y, b * x.y));
}

void main() {
    vec2 first = (floor(gl_FragCoord.xy) * float(BLOCK) + picture.zw + 0.5) * picture.xy - 1.0;
    vec2 half_size = 0.5 * float(BLOCK - 1) * picture.xy;
    vec2 middle = first + half_size;
    vec3 across = middle.x * ray_right.xyz + middle.y * ray_up.xyz;
    vec3 reach = abs(half_size.x * ray_right.xyz) + abs(half_size.y * ray_up.xyz);
    vec3 low = across - reach, high = across + reach;
    float w = ray_axis.w;

    float tau = beam.x, piece = 0.125 * (beam.y - beam.x);
    for (int k = 0; k < beam_evaluations; ++k) {
        float next = min(tau + piece, beam.y);
        float near = max(1.0 + w * tau, 0.0), far = max(1.0 + w * next, 0.0);
        vec2 x = ray_origin.x + hull(tau * ray_axis.x, next * ray_axis.x) + scaled(near, far, vec2(low.x, high.x));
        vec2 y = ray_origin.y + hull(tau * ray_axis.y, next * ray_axis.y) + scaled(near, far, vec2(low.y, high.y));
        vec2 z = ray_origin.z + hull(tau * ray_axis.z, next * ray_axis.z) + scaled(near, far, vec2(low.z, high.z));
        vec2 rounding = vec2(-beam.w, beam.w);
        x += rounding;
        y += rounding;
        z += rounding;
        bool free = !meets_bounds(x, y, z);
        x = within(x, bounds_low().x, bounds_high().x);
        y = within(y, bounds_low().y, bounds_high().y);
        z = within(z, bounds_low().z, bounds_high().z);
        vec2 f = field_interval(x, y, z);
        free = free || f.x > 0.0 || f.y < 0.0;
        if (free) {
            tau = next;
            piece *= 2.0;
        } else {
            piece *= 0.5;
        }
        if (tau >= beam.y || piece < beam.z) break;
    }
    start = vec4(tau >= beam.y ? NO_ROOT : tau, 0.0, 0.0, 0.0);
}
