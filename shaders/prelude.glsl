#version 330 core
// `precise` keeps a driver from reassociating float arithmetic (Mesa does: (a+b)-a becomes b). It
// comes with GLSL 4.00 or this extension; where there is neither, the word must still compile.
#if __VERSION__ < 400
#extension GL_ARB_gpu_shader5 : enable
#ifndef GL_ARB_gpu_shader5
#define precise
#endif
#endif
// Operations<float>::saturation() of the CPU.
#define IM_SATURATION 1.0e30
