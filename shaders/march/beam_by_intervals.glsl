// Finds which part of their way the rays of a block of BLOCK x BLOCK pixels need to march. One
// invocation a block walks along the block's beam by interval arithmetic, from its near end and, except
// for the smallest blocks with lists, from its far end. It passes a piece of the beam whose box is
// proved free of roots, and takes the next one twice as long. It halves any other piece, until that is
// short against the block. What it passed holds no root of any of the block's rays, rounding included.
//
// `part` is of tau, empty without roots; its .zw tell where front and middle end.

uniform int beam_evaluations;
#ifdef GRID
uniform float element_budget;
#endif

void follow_beam(ivec2 block) {
    Beam way = beam_of(block);
    Part whole = parent_part(block);
    float low = whole.low, high = whole.high;
    float longest = whole.first, piece = longest;
    bool backwards = false, open = low < high;
    int evaluations = beam_evaluations;
#ifdef LISTS
    enter_list(whole.all);
    evaluations = min(evaluations, MOST_TERMS / max(array0_count, 1)); // as in beam_list.glsl
    LIST front = whole.front, middle = whole.front, all = whole.all;
    float front_end = whole.front_end, middle_end = whole.front_end;
#ifdef COPIES
    KEPT kept = new_list(block, 0), kept_in_front = new_list(block, 1);
#endif
    // Few elements matter in the front, where most rays end; the walk there is the cheaper, too.
    if (LIST_OF_ALL == 0 && open) {
        front_end = mix(low, high, FRONT);
        enter_list(front_end <= middle_end ? middle : all);
#ifdef COPIES
        // Its copies are made later: the walk goes through what it was made from.
        kept_in_front = lists_of(block, way, low, front_end).all;
        front = entered_list();
#else
        front = lists_of(block, way, low, front_end).all;
#endif
    }
#endif
    for (int k = 0; k < evaluations; ++k) {
#ifdef GRID
        // Loops must end before drivers end them; some eight neighbours are in cells of their own.
        if (grid_entered > int(0.125 * element_budget)) break;
#endif
        float end = high;
#ifdef LISTS
        if (low < middle_end) end = middle_end;
        enter_list(low < middle_end ? middle : all);
        if (low < front_end) {
            end = front_end;
            enter_list(front);
        }
        if (backwards) enter_list(all);
#endif
        float a = backwards ? max(high - piece, low) : low;
        float b = backwards ? high : min(low + piece, min(end, high));
        vec2 x, y, z;
        bool inside = box_of(way, a, b, x, y, z);
        vec2 f = field_interval(x, y, z);
#ifdef LISTS
        // What the lists of all three levels may have left out.
        vec2 rest, factor;
        rest_and_factor_interval(x, y, z, rest, factor);
        f += vec2(-3.5, 3.5) * LEFT_OUT * im_abs(rest).y;
#endif
        bool free = f.x > 0.0 || f.y < 0.0;
#ifdef SECTIONS
        vec2 cut = sections_over(x, y, z, beam.w);
        free = f.x > 0.0 || cut.x > 0.0 || f.y < 0.0 && cut.y < 0.0;
#endif
        if (!inside || free) {
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
#ifdef LISTS
    if (LIST_OF_ALL == 1 && open) {
        enter_list(all);
        Lists made = lists_of(block, way, low, high);
#ifdef COPIES
        kept = made.all;
        kept_in_front = made.front;
#else
        all = made.all;
        front = middle = made.front;
#endif
        front_end = middle_end = made.front_end;
    }
    part = vec4(low, open ? high : low, front_end, middle_end);
#ifdef COPIES
    store_masks(kept_in_front, kept);
#else
    store_lists(front, middle, all);
#endif
#else
    part = vec4(low, open ? high : low, low, low);
#endif
}
