// Where a pixel's ray ended, for the proofs of one surface among several: on it, or on another one, up to
// which it has to miss this one. See render/picture_proofs.h.
layout(location = 0) out vec4 ending; // as shade/channels.glsl; t up to which there is something to prove

uniform sampler2D way_to_end;      // of all surfaces: shade/channels.glsl on the first one's ray
uniform sampler2D surface_of_end;  // shade/channels.glsl
uniform float beyond;              // to prove behind another surface, where its root may be

void main() {
    ivec2 at = ivec2(pixel_centre);
    float way = IM_TEXEL(way_to_end, at).x;
    Ray ray = pixel_ray();
#if SURFACE == 0
    float t = way; // to the bit, whatever a driver makes of a quotient by 1
#else
    float t = (way - surface_way.y * ray.to_eye) / surface_way.x;
#endif
    bool hits = abs(way) < ENDS_NOWHERE;
    bool is_own = int(IM_TEXEL(surface_of_end, at).x) == SURFACE + 1;
    ending = vec4(!hits ? way : is_own ? t : ENDS_NOWHERE, hits && !is_own ? t + beyond : ENDS_NOWHERE, 0.0,
                  0.0);
}
