// Shadow rays by beams of the light's own: each light far away that casts shadows has a picture of
// the bounds, whose blocks tell where its rays may first meet the surface (march/beam.frag). A ray
// comes from there, with the light, to the place that it may fall on: what is hidden is so by what
// the ray meets first, and what is lit has little of it left.
//
// The pictures lie one above the other in the texture.
uniform sampler2D light_beam_texture;
#ifdef LISTS
uniform sampler2D light_beam_lists_texture;
uniform sampler2D light_beam_all_texture;
#endif
// Four vectors for each light. The first two lead across its picture and up it, in pixels from the
// middle; their w are half of the pixels, and how far from the last vector's place the pictures are
// right. The third gives depth tau; its w is the unit. The last is the place without any of these
// three; its w is what rounding may add to a depth.
uniform vec4 light_views[4 * LIGHTS];

// As it is, to a light: through all elements.
void come_to_light() {
#ifdef LISTS
    vec2 all = vec2(float(array_counts[0].x), 0.0);
    beam_lists = BeamLists(all, all, all, 0.0, 0.0);
    enter_list(all);
#endif
}

// Turns the ray from a place to light k round, unless it is far away.
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
    vec4 part = texelFetch(light_beam_texture, texel, 0);
    float here = dot(depth.xyz, place);
    vec4 t = (part - here) * depth.w + vec4(-origin.w, origin.w, -origin.w, -origin.w);
    ray = Ray(ray.anchor, -ray.direction, -ray.t_far, -ray.t_near, 0.0);
    ray.t_near = max(ray.t_near, t.x);
    ray.t_far = part.x < part.y ? min(ray.t_far, t.y) : ray.t_near - 1.0;
#ifdef LISTS
    vec4 lists = texelFetch(light_beam_lists_texture, texel, 0);
    vec2 all = texelFetch(light_beam_all_texture, texel, 0).xy;
    beam_lists = BeamLists(lists.xy, lists.zw, all, t.z, t.w);
    enter_list(all);
#endif
}
