// The ray of a pixel. Needs frame.glsl, clip_box.glsl or clip_sphere.glsl.

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

Ray pixel_ray() {
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
