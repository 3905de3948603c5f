#version 300 es
// The mean of pictures on the screen: light becomes sRGB. A picture of another size than the screen
// (ENLARGED) is filtered, as float textures need not be by the card.
precision highp float;
precision highp sampler2D;
uniform sampler2D sum;
uniform float count;   // of pictures
uniform vec2 picture_size;
uniform vec2 screen_size;

layout(location = 0) out vec4 color;

// Beyond the picture the nearest texel counts.
vec4 texel(ivec2 at) {
    vec4 light = textureLod(sum, (vec2(at) + 0.5) / picture_size, 0.0) / count;
    // min() and max() make a number of NaN.
    return min(max(light, 0.0), 65504.0);
}

#ifdef ENLARGED
vec4 light_at(vec2 place) {
    vec2 at = place * picture_size / screen_size - 0.5;
    ivec2 low = ivec2(floor(at));
    vec2 part = at - floor(at);
    vec4 below = mix(texel(low), texel(low + ivec2(1, 0)), part.x);
    vec4 above = mix(texel(low + ivec2(0, 1)), texel(low + ivec2(1, 1)), part.x);
    return mix(below, above, part.y);
}
#else
vec4 light_at(vec2 place) { return texel(ivec2(place)); }
#endif

vec3 srgb(vec3 light) {
    light = clamp(light, 0.0, 1.0);
    return mix(1.055 * pow(light, vec3(1.0 / 2.4)) - 0.055, 12.92 * light,
               lessThanEqual(light, vec3(0.0031308)));
}

void main() {
    vec4 light = light_at(gl_FragCoord.xy);
    float coverage = min(light.a, 1.0);
    // Colours are multiplied by coverage; the screen wants that of their codes.
    color = vec4(coverage > 0.0 ? srgb(light.rgb / coverage) * coverage : vec3(0.0), coverage);
}
