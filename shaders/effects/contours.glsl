// Contours: lines where a function of the point is a multiple of `every`, the same number of pixels
// wide at any distance. The function's gradient gives its change over a pixel. The function is
// taken as linear within a pixel, and the part of the pixel that lies on lines is coloured.
uniform vec4 contours; // every, from, width in pixels
uniform vec4 contour_color;

// Length of the part of [0, x] within `around` of integers; |x| is at most 0.5 and half a pixel.
float part_on_lines(float x, float around) {
    float whole = floor(x + 0.5);
    return 2.0 * around * whole + clamp(x - whole, -around, around);
}

// Changes of the function over the tangent plane, from a pixel to the next and to the one above.
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
    // Crowded lines get thinner, so that never more than half of the surface is line.
    float around = min(0.5 * contours.z * pixel, 0.25);
    float off = x - floor(x + 0.5);
    float part = (part_on_lines(off + 0.5 * pixel, around) -
                  part_on_lines(off - 0.5 * pixel, around)) / pixel;
    // No line is drawn where rounding changes the function as much as a pixel does, or where it is
    // not a number.
    bool is_known = pixel > 1.0e-6 * max(abs(x), 1.0e-6) && !im_is_nan(part);
    return is_known ? clamp(part, 0.0, 1.0) : 0.0;
}
