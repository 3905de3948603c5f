#version 330 core
// The differences between GLSL versions: desktops have 3.30 and later, browsers ES 3.00, with
// another first line.
//
// `precise` keeps a driver from reassociating float arithmetic (Mesa does: (a+b)-a becomes b). It
// needs GLSL 4.00 or this extension; without both, the word must still compile.
#ifdef GL_ES
precision highp float;
precision highp int;
precision highp sampler2D;
precision highp usampler2D;
precision highp usampler2DArray;
#define precise
#elif __VERSION__ < 400
#extension GL_ARB_gpu_shader5 : enable
#ifndef GL_ARB_gpu_shader5
#define precise
#endif
#endif
// Long arrays of vec4s or of unsigned integers, and their element `at`. In browsers they are rows
// of a texture.
#ifdef GL_ES
#define IM_BUFFER sampler2D
#define IM_BUFFER_OF_UINTS usampler2D
#define IM_BUFFER_AT(buffer, at) texelFetch(buffer, ivec2((at) & 1023, (at) >> 10), 0)
#else
#define IM_BUFFER samplerBuffer
#define IM_BUFFER_OF_UINTS usamplerBuffer
#define IM_BUFFER_AT(buffer, at) texelFetch(buffer, at)
#endif
// The texel `at` of a texture of floats whose size is of no more than 2^14 texels across. Software
// renderers work out a level for each pixel of a fetch and take half as long to sample.
#define IM_TEXEL(floats, at) textureLod(floats, (vec2(at) + 0.5) / vec2(textureSize(floats, 0)), 0.0)
// Equals Operations<float>::saturation() on the CPU.
#define IM_SATURATION 1.0e30
// `condition ? then : otherwise` for a number and for two. It computes both, so use it for cheap
// ones. Mesa makes branches of `?:`, and its compiler's memory grows with branches times variables:
// a formula of 40 powers took 5.4 GB and 33 s with `?:`, 0.8 GB and 8 s with this.
#define IM_SELECT(condition, then, otherwise) mix(otherwise, then, condition)
#define IM_SELECT2(condition, then, otherwise) mix(otherwise, then, bvec2(condition))
