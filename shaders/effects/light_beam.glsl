// Marches shadow rays by beams of the light. Each distant light that casts shadows has a picture of
// the bounds. Its blocks hold the depths at which the light's rays may first meet the surface
// (march/beam_by_intervals.glsl). A shadow ray starts there and runs with the light to its point. If the point
// is hidden, the ray meets the occluder first; if it is lit, little of the ray is left.
//
// The pictures lie one above the other in the texture.
uniform sampler2D light_beam_texture;
#ifdef LISTS
uniform sampler2D light_beam_lists_texture;
uniform sampler2D light_beam_all_texture;
#endif
// Four vectors for each light. The first two lead right and up across its picture, in pixels from
// the middle. Their w are half of the picture's pixels, and the distance from the origin up to
// which the pictures are valid. The third gives depth tau; its w is the unit. The last is the
// origin of these three; its w is the rounding that a depth may have.
uniform vec4 light_views[4 * LIGHTS];

// Marches the ray towards the light, over all elements.
void come_to_light() {
#ifdef LISTS
    vec2 all = vec2(float(array_counts[0].x), 0.0);
    beam_lists = BeamLists(all, all, all, 0.0, 0.0);
    enter_list(all);
#endif
}

// Reverses the ray from a point to light k, unless the point is too far away for the picture.
void come_from_light(inout Ray ray, int k) {
    vec4 right = light_views[4 * k], up = light_views[4 * k + 1];
    vec4 depth = light_views[4 * k + 2], origin = light_views[4 * k + 3];
    vec3 place = ray.anchor - origin.xyz;
    if (dot(place, place) > up.w * up.w) {
        come_to_light();
        return;
    }
    vec2 at = vec2(dot(right.xyz, place), dot(up.xyz, place)) + right.w;
    ivec2 pixel = clamp(ivec2(floor(at)), ivec2(0), ivec2(2.0 * right.w) - 1);
    pixel.y += k * int(2.0 * right.w);
    ivec2 texel = beam_texel(pixel / BLOCK, SQUARE_BITS);
    vec4 part = IM_TEXEL(light_beam_texture, texel);
    float here = dot(depth.xyz, place);
    vec4 t = (part - here) * depth.w + vec4(-origin.w, origin.w, -origin.w, -origin.w);
    ray = Ray(ray.anchor, -ray.direction, -ray.t_far, -ray.t_near, 0.0);
    ray.t_near = max(ray.t_near, t.x);
    ray.t_far = part.x < part.y ? min(ray.t_far, t.y) : ray.t_near - 1.0;
#ifdef LISTS
    vec4 lists = IM_TEXEL(light_beam_lists_texture, texel);
    vec2 all = IM_TEXEL(light_beam_all_texture, texel).xy;
    beam_lists = BeamLists(lists.xy, lists.zw, all, t.z, t.w);
    enter_list(all);
#endif
}
