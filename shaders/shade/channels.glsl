// The channels that a picture is asked for, each an attachment: src/shader/channel.h.

#ifdef DEPTH_LOCATION
// Z: distance from the eye along the camera's axis in world units; infinite without a hit.
layout(location = DEPTH_LOCATION) out vec4 depth_out;
#endif
#ifdef NORMAL_LOCATION
// N: unit normal in world coordinates, towards the viewer; 0 where nothing is hit.
layout(location = NORMAL_LOCATION) out vec4 normal_out;
#endif
#ifdef POSITION_LOCATION
// P: point in world coordinates; 0 where nothing is hit.
layout(location = POSITION_LOCATION) out vec4 position_out;
#endif
#ifdef CAP_LOCATION
// cap: number of the section whose cap is seen, from 1 on; 0 elsewhere.
layout(location = CAP_LOCATION) out vec4 cap_out;
#endif
#ifdef SURFACE_LOCATION
// surface: number of the surface that is seen, from 1 on; 0 elsewhere.
layout(location = SURFACE_LOCATION) out vec4 surface_out;
#endif
#ifdef ENDING_LOCATION
// ending, for proofs: t of a hit, on the first one's ray where there are several surfaces; or a code of
// verdict.glsl for a miss or an unknown end.
layout(location = ENDING_LOCATION) out float ending_out;
#endif

void write_channels(Ray ray, Hit hit, int verdict) {
#ifdef DEPTH_LOCATION
    float z = depth.w + hit.t * dot(depth.xyz, ray.direction);
    depth_out = vec4(on_surface(verdict) ? z : uintBitsToFloat(0x7f800000u), 0.0, 0.0, 0.0);
#endif
#ifdef NORMAL_LOCATION
    vec3 n = normalize(mat3(to_world) * hit.normal);
    normal_out = on_surface(verdict) ? vec4(n, 0.0) : vec4(0.0);
#endif
#ifdef POSITION_LOCATION
    position_out = on_surface(verdict) ? vec4((to_world * vec4(hit.position, 1.0)).xyz, 0.0) : vec4(0.0);
#endif
#ifdef CAP_LOCATION
#ifdef SECTIONS
    cap_out = vec4(on_surface(verdict) ? float(hit.cap + 1) : 0.0, 0.0, 0.0, 0.0);
#else
    cap_out = vec4(0.0);
#endif
#endif
#ifdef SURFACE_LOCATION
#ifdef SURFACE
    const float number = float(SURFACE + 1);
#else
    const float number = 1.0;
#endif
    surface_out = vec4(on_surface(verdict) ? number : 0.0, 0.0, 0.0, 0.0);
#endif
#ifdef ENDING_LOCATION
#ifndef SURFACE
    float t = hit.t;
#elif defined(DRAWS_AT_ONCE)
    float t = shared_way(ray, hit.t);
#else
    float t = IM_TEXEL(surface_texture_3, ivec2(pixel_centre)).x;
#endif
    ending_out = on_surface(verdict) ? t : verdict == VERDICT_MISS ? ENDS_NOWHERE : ENDS_UNKNOWN;
#endif
}
