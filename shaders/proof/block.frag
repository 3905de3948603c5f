// Proves a block of BLOCK x BLOCK rays at once, as far as that goes, over boxes around all of them.
//
// From where the rays' ways begin on, F keeps off 0 in a piece by its natural bound, or as its value
// at the beginning is too far from 0 for its slope. Where all rays hit and F is monotone along all
// of them from there to behind the last root, what is left to each ray is whether its root is close
// to where it was found: begin.frag. The proofs of other single rays begin where this one ends.

// From where on in tau F may be 0: with u and v from -1 to 1 across the block, .x + (.y u + .z v). In
// .w the least slope in tau of F, which is monotone from there to behind the last root by as much as
// begin.frag takes for granted, or 0 if it is not; or -1 where no ray hits, proved.
layout(location = 0) out vec4 block_proof;

uniform int block_pieces; // at most

void main() {
    ivec2 block = ivec2(pixel_centre);
    Beam way = beam_of(block);
    Part whole = parent_part(block);

    // Where in tau they end.
    int hits = 0, misses = 0;
    float first = IM_SATURATION, last = -IM_SATURATION, nearest_eye = IM_SATURATION;
    for (int k = 0; k < RAYS; ++k) {
        ivec2 pixel = block * BLOCK + ivec2(k % BLOCK, k / BLOCK);
        Ending ended = load_ending(pixel);
        vec2 at = (vec2(pixel) + 0.5 + picture.zw) * picture.xy - 1.0;
        vec3 across = at.x * ray_right.xyz + at.y * ray_up.xyz;
        float to_eye = length(ray_axis.xyz + ray_axis.w * across);
        hits += int(ended.hit);
        misses += int(ended.miss);
        first = ended.hit ? min(first, ended.t / to_eye) : first;
        last = ended.hit ? max(last, ended.t / to_eye) : last;
        nearest_eye = min(nearest_eye, to_eye);
    }
    bool all_hit = hits == RAYS, all_miss = misses == RAYS;
    float margin = 2.0 * tube.z / nearest_eye;
    float around = 2.0 * tube.w / nearest_eye + margin;
    float low = whole.low - margin, high = all_hit ? last + around : whole.high + margin;

#ifdef LISTS
    choose_list_of_block(way, block, all_hit ? first - around : whole.low,
                         all_hit ? high : whole.high, all_hit ? last : mix(whole.low, whole.high, 0.5));
#endif

    // Directions of the rays in tau.
    vec3 one = ray_axis.xyz + ray_axis.w * way.low, other = ray_axis.xyz + ray_axis.w * way.high;
    float rounding = tube.y * length(max(abs(one), abs(other)));
    vec3 least = min(one, other) - rounding, most = max(one, other) + rounding;
    vec2 dx = vec2(least.x, most.x), dy = vec2(least.y, most.y), dz = vec2(least.z, most.z);

    vec2 x, y, z;
    float settled = low, piece = 0.0, longest = 0.25 * (high - low);
    float value = 0.0; // F at `settled` is at least so far from 0, on this side; 0: unknown
    bool below = false, open = low < high && hits + misses > 0, monotone = false, at_roots = false;
    float slope = 0.0;
    for (int k = 0; k < block_pieces && open; ++k) {
        float end = at_roots ? high : min(settled + piece, high);
        // All of it: where one ray enters the bounds, another's value is already told.
        box_around(way, settled, end, x, y, z);
        bool inside = meets_bounds(x, y, z);
        vec4 f = field_directional_interval(x, y, z, dx, dy, dz);
        float h = (end - settled) * 1.000002;
        float fall = max(below ? f.w : -f.z, 0.0);
        precise float kept = value - fall * h * 1.000002;
        bool natural = f.x > 0.0 || f.y < 0.0;
        bool is_free = !inside || natural || kept > 0.0;
        slope = max(f.z, -f.w);
        monotone = at_roots && inside && slope > 0.0;
        open = !at_roots;
        if (!at_roots) {
            below = natural ? f.y < 0.0 : below;
            value = !is_free ? value : !inside ? 0.0 : natural ? max(f.x, -f.y) : KEPT_BY_SLOPES;
            settled = is_free ? end : settled;
            piece = k == 0 ? longest : is_free ? 2.0 * h : 0.4 * h;
            // No shorter piece could bring the box in.
            bool stuck = piece < beam.z || k == block_pieces - 2;
            at_roots = stuck && all_hit;
            open = settled < high && (!stuck || all_hit);
        }
        open = open && HAS_ELEMENTS_LEFT;
    }
    bool missed = all_miss && settled >= high;
    block_proof = vec4(settled, 0.0, 0.0, missed ? -1.0 : monotone ? slope : 0.0);
}
