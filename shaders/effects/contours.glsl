// Lines where a number of the place is a multiple of `every`, as wide as so many pixels at any
// distance: the slopes of the number tell what a step of a pixel over the surface makes of it. Of
// each pixel the part is coloured that lies on lines, the number being taken for linear in it.
uniform vec4 contours; // every, from, width in pixels
uniform vec4 contour_color;

// How much of [0, x] lies within `around` of whole numbers, |x| < 0.5 and a half more.
float part_on_lines(float x, float around) {
    float whole = floor(x + 0.5);
    return 2.0 * around * whole + clamp(x - whole, -around, around);
}

// How the number changes over the tangent plane from a pixel to the next, and to the one above.
vec2 change_over_pixel(vec3 slope, vec3 position, vec3 normal) {
    vec3 forward = cross(normalize(ray_up.xyz), normalize(ray_right.xyz));
    vec3 from_plane = position - ray_origin.xyz;
    float depth = dot(from_plane, forward) / dot(ray_axis.xyz, forward);
    float scale = max(abs(1.0 + ray_axis.w * depth), 1.0e-6);
    vec3 to = normalize(ray_axis.w > 0.0 ? from_plane + ray_axis.xyz : ray_axis.xyz);
    float facing = dot(normal, to);
    facing = facing < 0.0 ? min(facing, -1.0e-4) : max(facing, 1.0e-4);
    vec3 right = scale * picture.x * ray_right.xyz, up = scale * picture.y * ray_up.xyz;
    return vec2(dot(slope, right - to * (dot(normal, right) / facing)),
                dot(slope, up - to * (dot(normal, up) / facing)));
}

float on_contours(vec3 position, vec3 normal) {
    vec4 number = contour_value(position);
    vec2 change = change_over_pixel(number.yzw, position, normal);
    float x = (number.x - contours.y) / contours.x;
    float pixel = length(change) / contours.x;
    // Lines that come too close are thinner: never more than half is line.
    float around = min(0.5 * contours.z * pixel, 0.25);
    float off = x - floor(x + 0.5);
    float part = (part_on_lines(off + 0.5 * pixel, around) -
                  part_on_lines(off - 0.5 * pixel, around)) / pixel;
    // Where rounding moves the number by as much as a pixel does, there is no line to be seen; nor
    // where it is no number.
    bool is_known = pixel > 1.0e-6 * max(abs(x), 1.0e-6) && !im_is_nan(part);
    return is_known ? clamp(part, 0.0, 1.0) : 0.0;
}

vec3 surface_color(Hit hit) {
    return mix(color_below(hit), contour_color.rgb, on_contours(hit.position, hit.normal));
}
