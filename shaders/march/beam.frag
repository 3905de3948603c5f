// Which part of their way the rays of a block of BLOCK x BLOCK pixels need to march: one fragment a
// block walks along the block's beam by interval arithmetic, from its near end and, but for the
// smallest blocks with lists, from its far one. A piece of the beam
// whose box is proved free of roots is passed, and the next is twice as long; another is halved,
// until it is short against the block. What was passed holds no root of any of the block's rays,
// rounding included.

layout(location = 0) out vec4 part; // of tau, empty without roots; where its front ends
#ifdef LISTS
layout(location = 1) out vec4 lists; // of the front and of all: elements, the first
#endif

uniform int beam_evaluations;

void main() {
    ivec2 block = beam_block(ivec2(pixel_centre), SQUARE_BITS);
    Beam way = beam_of(block);
    vec4 whole = parent_part(block);
    float low = whole.x, high = whole.y;
    float longest = whole.z, piece = longest;
    bool backwards = false, open = low < high;
    float front_end = mix(low, high, FRONT);
    int evaluations = beam_evaluations;
#ifdef LISTS
    evaluations = min(evaluations, MOST_TERMS / max(array0_count, 1)); // as in beam_list.glsl
    vec2 all = vec2(float(array0_count), float(array0_first)), front = all;
    // Few elements matter in the front, where most rays end; the walk there is the cheaper, too.
    if (FRONT < 1.0 && open) front = list_of(block, way, low, front_end);
#endif
    for (int k = 0; k < evaluations; ++k) {
        bool in_front = low < front_end;
#ifdef LISTS
        if (FRONT < 1.0) enter_list(in_front ? front : all);
#endif
        float a = backwards ? max(high - piece, low) : low;
        float b = backwards ? high : min(low + piece, in_front ? front_end : high);
        vec2 x, y, z;
        bool inside = box_of(way, a, b, x, y, z);
        vec2 f = field_interval(x, y, z);
#ifdef LISTS
        // What the lists of all three levels may have left out.
        vec2 rest, factor;
        rest_and_factor_interval(x, y, z, rest, factor);
        f += vec2(-3.5, 3.5) * LEFT_OUT * im_abs(rest).y;
#endif
        if (!inside || f.x > 0.0 || f.y < 0.0) {
            if (backwards) high = a; else low = b;
            piece *= 2.0;
        } else {
            piece *= 0.5;
        }
        open = open && low < high;
        if (piece < beam.z) {
            if (backwards || BOTH_ENDS == 0) break;
            backwards = true;
            piece = longest;
        }
        if (!open) break;
    }
    part = vec4(low, open ? high : low, front_end, 0.0);
#ifdef LISTS
    if (FRONT == 1.0 && open) front = all = list_of(block, way, low, high);
    lists = vec4(front, all);
#endif
}
