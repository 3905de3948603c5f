// What a driver makes of doubles, one operation a draw: src/render/doubles.cpp. Doubles come and go
// as four whole numbers of 16 bits, lowest first.
uniform sampler2D first, second;
uniform int operation;
out vec4 result;

double joined(vec4 parts) {
    uvec4 bits = uvec4(parts);
    return packDouble2x32(uvec2(bits.x | bits.y << 16, bits.z | bits.w << 16));
}

vec4 parted(double x) {
    uvec2 bits = unpackDouble2x32(x);
    return vec4(bits.x & 0xffffu, bits.x >> 16, bits.y & 0xffffu, bits.y >> 16);
}

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    double a = joined(texelFetch(first, at, 0)), b = joined(texelFetch(second, at, 0));
    precise double r = 0.0;
    precise double sum = a + b;
    switch (operation) {
    case 0: r = sum; break;
    case 1: r = a - b; break;
    case 2: r = a * b; break;
    case 3: r = sum - a; break;
    case 4: r = min(a, b); break;
    case 5: r = max(a, b); break;
    case 6: r = a < b ? 1.0 : 0.0; break;
    case 7: r = a >= b ? 1.0 : 0.0; break;
    case 8: r = floor(a); break;
    case 9: r = abs(a); break;
    case 10: r = double(float(a)); break;
    case 11: r = literal(at.x % LITERALS); break;
    case 12: r = a / b; break;
    case 13: r = sqrt(a); break;
    }
    result = parted(r);
}
