// Proves a block of BLOCK x BLOCK rays at once, as far as possible, over boxes around all of them.
//
// From where the rays' parts begin, F stays away from 0 in a piece by its natural bound, or because
// its value at the beginning is too far from 0 for its slope. If all rays hit and F is monotone
// along all of them from there to behind the last root, each ray only has to prove that its root is
// close to where it was found: begin.frag. The proofs of other single rays begin where this one
// ends.

// The tau from which on F may be 0: .x + (.y u + .z v), with u and v from -1 to 1 across the block.
// .w is the least slope of F in tau if F is monotone from there to behind the last root, by the
// margin that begin.frag assumes; otherwise 0; or an outcome: rounding.glsl.
layout(location = 0) out vec4 block_proof;

uniform int block_pieces; // limit on the pieces

void main() {
    ivec2 block = ivec2(pixel_centre);
    Beam way = beam_of(block);
    Part whole = parent_part(block);
    bool has_way = whole.low < whole.high; // else larger beams proved that no ray hits

    // Finds where the rays end, in tau.
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

    // Directions of the rays, per tau.
    vec3 one = ray_axis.xyz + ray_axis.w * way.low, other = ray_axis.xyz + ray_axis.w * way.high;
    float rounding = tube.y * length(max(abs(one), abs(other)));
    vec3 least = min(one, other) - rounding, most = max(one, other) + rounding;
    vec2 dx = vec2(least.x, most.x), dy = vec2(least.y, most.y), dz = vec2(least.z, most.z);

    vec2 x, y, z;
    float settled = low, piece = 0.0, longest = 0.25 * (high - low);
    float value = 0.0; // F at `settled` is at least this far from 0, with this sign; 0: unknown
    bool open = has_way && low < high && hits + misses > 0;
    bool below = false, monotone = false, at_roots = false;
    float slope = 0.0;
    int k = 0;
    do { // as in prove.glsl
        if (!open) break;
        float end = at_roots ? high : min(settled + piece, high);
        // Takes the whole box: where one ray enters the bounds, another's value is already known.
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
            // A shorter piece would not make the box smaller.
            bool stuck = piece < beam.z || k == block_pieces - 2;
            at_roots = stuck && all_hit;
            open = settled < high && (!stuck || all_hit);
        }
        open = open && HAS_ELEMENTS_LEFT;
        ++k;
    } while (open && k < block_pieces);
    bool missed = all_miss && (!has_way || settled >= high);
    block_proof = vec4(settled, 0.0, 0.0, missed ? BLOCK_MISSES : monotone ? slope : 0.0);
}
