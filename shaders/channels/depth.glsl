// Channel Z: distance from the eye along the camera's axis in world units; infinite without a hit.
layout(location = DEPTH_LOCATION) out vec4 depth_out;

void write_depth(Ray ray, Hit hit, int verdict) {
    float z = depth.w + hit.t * dot(depth.xyz, ray.direction);
    depth_out = vec4(on_surface(verdict) ? z : uintBitsToFloat(0x7f800000u), 0.0, 0.0, 0.0);
}
