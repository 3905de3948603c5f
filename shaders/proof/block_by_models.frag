// Proves a block of BLOCK x BLOCK rays of a polynomial F at once, as far as that goes, by models of
// F over pieces of their beam: as block.frag, but that the piece with the roots comes first, where
// all rays hit, and that of another one the beginning is settled as far as its quadratic keeps off
// 0, less the error of the model.

// From where on in tau F may be 0, and to where it is monotone; its least slope there, in tau, or 0
// if it is not, or -1 where no ray hits, proved.
layout(location = 0) out vec4 block_proof;

uniform int block_pieces; // at most

// The rays through the middles of a block's pixels, in the plane of the anchors.
struct Across {
    vec3 middle, right, up; // from the middle to the outer pixels
};

Across across_block(ivec2 block) {
    vec2 half_size = 0.5 * float(BLOCK - 1) * picture.xy;
    vec2 at = (vec2(block * BLOCK) + picture.zw + 0.5) * picture.xy - 1.0 + half_size;
    return Across(at.x * ray_right.xyz + at.y * ray_up.xyz, half_size.x * ray_right.xyz,
                  half_size.y * ray_up.xyz);
}

Model coordinate_of(float origin, float axis, float across, float right, float up, float middle,
                    float half_piece) {
    precise float widens = 1.0 + ray_axis.w * middle;
    precise float c = origin + middle * axis + widens * across;
    precise vec3 l =
        vec3(widens * right, widens * up, half_piece * (axis + ray_axis.w * across));
    vec3 o = half_piece * ray_axis.w * vec3(0.0, right, up);
    float off = beam.w + 4.0 * IM_ROUNDING * (abs(c) + abs(l.x) + abs(l.y) + abs(l.z));
    return md_model(c, l, vec3(0.0), o, md_up(off));
}

Model model_of_piece(Across way, float middle, float half_piece) {
    vec3 o = ray_origin.xyz, a = ray_axis.xyz, m = way.middle, r = way.right, u = way.up;
    return field_model(coordinate_of(o.x, a.x, m.x, r.x, u.x, middle, half_piece),
                       coordinate_of(o.y, a.y, m.y, r.y, u.y, middle, half_piece),
                       coordinate_of(o.z, a.z, m.z, r.z, u.z, middle, half_piece));
}

// Where in tau the rays end.
struct Ends {
    int hits, misses;
    float first, last; // of hits
    float nearest_eye;
};

Ends ends_of(ivec2 block) {
    Ends ends = Ends(0, 0, IM_SATURATION, -IM_SATURATION, IM_SATURATION);
    for (int k = 0; k < RAYS; ++k) {
        ivec2 pixel = block * BLOCK + ivec2(k % BLOCK, k / BLOCK);
        Ending ended = load_ending(pixel);
        vec2 at = (vec2(pixel) + 0.5 + picture.zw) * picture.xy - 1.0;
        vec3 across = at.x * ray_right.xyz + at.y * ray_up.xyz;
        float to_eye = length(ray_axis.xyz + ray_axis.w * across);
        float t = ended.t / to_eye;
        ends.hits += int(ended.hit);
        ends.misses += int(ended.miss);
        ends.first = ended.hit ? min(ends.first, t) : ends.first;
        ends.last = ended.hit ? max(ends.last, t) : ends.last;
        ends.nearest_eye = min(ends.nearest_eye, to_eye);
    }
    return ends;
}

void main() {
    ivec2 block = ivec2(pixel_centre);
    Beam boxes = beam_of(block);
    Across way = across_block(block);
    Part whole = parent_part(block);
    Ends ends = ends_of(block);
    bool all_hit = ends.hits == RAYS, all_miss = ends.misses == RAYS;
    float margin = 2.0 * tube.z / ends.nearest_eye;
    float around = 2.0 * tube.w / ends.nearest_eye + margin;
    float low = whole.low - margin, high = all_hit ? ends.last + around : whole.high + margin;
    // The piece with the roots.
    float beside = around + 2.0 * beam.z + 0.25 * (ends.last - ends.first);
    float first = all_hit ? ends.first - beside : high, last = ends.last + beside;

    float settled = low, piece = first - low, slope = 0.0;
    bool open = low < high && ends.hits + ends.misses > 0, roots = open && all_hit;
    for (int k = 0; k < block_pieces && open; ++k) {
        float from = roots ? first : settled, to = roots ? last : min(settled + piece, first);
        float middle = 0.5 * (from + to);
        float half_piece = (roots ? 0.5 / 0.84 : 0.500001) * (to - from) +
                           IM_DRIVER_ERROR * abs(middle);
        Model f = model_of_piece(way, middle, half_piece);
        float size = md_size(f), rounding = 8.0 * IM_ROUNDING * size;
        // The beginning, in y.
        bool below = f.c - f.l.z + f.d.z < 0.0;
        float upright = below ? -1.0 : 1.0;
        float c = upright * f.c, l = upright * f.l.z, d = upright * f.d.z;
        vec2 bend = min(upright * f.d.xy, 0.0);
        float aside = abs(f.l.x) + abs(f.l.y) + md_sum(f.o) - bend.x - bend.y + f.error;
        precise float g0 = c - l + d - 1.000001 * aside;
        precise float g1 = l - 2.0 * d;
        float reach = first_reach(g0, g1, d, 64.0 * IM_ROUNDING * size);
        if (roots) {
            float bends = 1.7 * abs(f.d.z) + abs(f.o.y) + abs(f.o.z);
            precise float least =
                abs(f.l.z) - 1.000001 * (bends + SLOPE_OF_REST * f.error) - rounding;
            slope = least > 0.0 ? 0.999999 * least / half_piece : 0.0;
            first = slope > 0.0 ? max(first, low) : ends.first - margin;
            piece = first - low;
            roots = false;
        } else {
            vec2 x, y, z;
            box_around(boxes, from, to, x, y, z);
            bool is_free = reach >= 2.0 || !meets_bounds(x, y, z);
            float part = is_free ? 1.0 : reach > 0.05 ? 0.499 * reach : 0.0;
            settled = is_free ? to : settled + part * (to - from) - IM_DRIVER_ERROR * abs(middle);
            piece = (is_free ? 2.0 : part > 0.0 ? max(part, 0.2) : 0.3) * (to - from);
        }
        open = settled < first && piece > 0.25 * beam.z;
    }
    bool settles = settled >= first;
    bool missed = all_miss && settles;
    block_proof = vec4(max(settled, low), high, missed ? -1.0 : settles ? slope : 0.0, 0.0);
}
