// The ray of a pixel, in the bounds. Needs frame.glsl.

#ifdef BOX
// Returns the part of a ray inside the bounds, a box; (1, 0) if it is empty.
vec2 clip_to_bounds(vec3 anchor, vec3 direction) {
    // 1/0 is infinity on some drivers and NaN on others. So a ray along a face gets a slope by
    // which it leaves the slab only far outside the picture.
    vec3 slope = vec3(abs(direction.x) < 1e-12 ? 1e-12 : direction.x,
                      abs(direction.y) < 1e-12 ? 1e-12 : direction.y,
                      abs(direction.z) < 1e-12 ? 1e-12 : direction.z);
    vec3 a = (bounds_min.xyz - anchor) / slope;
    vec3 b = (bounds_max.xyz - anchor) / slope;
    vec3 enter = min(a, b), leave = max(a, b);
    float near = max(max(enter.x, enter.y), enter.z);
    float far = min(min(leave.x, leave.y), leave.z);
    return near <= far ? vec2(near, far) : vec2(1.0, 0.0);
}
#else
// Returns the part of a ray inside the bounds, a sphere; (1, 0) if it is empty.
vec2 clip_to_bounds(vec3 anchor, vec3 direction) {
    vec3 from_centre = anchor - bounds_min.xyz;
    float middle = -dot(from_centre, direction);
    // Foot of the perpendicular: its length keeps its digits where b^2 - 4ac cancels.
    vec3 foot = from_centre + middle * direction;
    float square = bounds_min.w * bounds_min.w - dot(foot, foot);
    float half_chord = sqrt(max(square, 0.0));
    return square < 0.0 ? vec2(1.0, 0.0) : vec2(middle - half_chord, middle + half_chord);
}
#endif

struct Ray {
    vec3 anchor;    // where it crosses the plane through the middle of the bounds: t = 0
    vec3 direction; // unit length
    float t_near;   // the part inside the bounds and in front of the eye; empty if t_near > t_far
    float t_far;
    float to_eye;   // distance from the anchor
};

vec3 ray_point(Ray ray, float t) {
    return ray.anchor + t * ray.direction;
}

Ray eye_ray() {
    vec2 at = (pixel_centre + picture.zw) * picture.xy - 1.0;
    vec3 across = at.x * ray_right.xyz + at.y * ray_up.xyz;
    vec3 from_eye = ray_axis.xyz + ray_axis.w * across;
    float distance_to_eye = length(from_eye);
    Ray ray;
    ray.anchor = ray_origin.xyz + across;
    ray.direction = from_eye / distance_to_eye;
    vec2 inside = clip_to_bounds(ray.anchor, ray.direction);
    ray.t_near = max(inside.x, -distance_to_eye);
    ray.t_far = inside.y;
    ray.to_eye = distance_to_eye;
    return ray;
}

// Where it begins, before it is clipped to the bounds.
float eye_begin(Ray ray) {
    return -length(ray_axis.xyz + ray_axis.w * (ray.anchor - ray_origin.xyz));
}

#ifdef EYE_RAYS
Ray pixel_ray() {
    return eye_ray();
}
#endif
