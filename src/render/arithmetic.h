// What a driver's float arithmetic is, measured by small shaders in the current context.
//
// Shaders of isomotion take as little as they can on trust of it; what they don't is why
// shaders/math/ has functions of its own, and why they say `precise`.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace isomotion::render {

// An answer to a question of yes or no, such as whether denormals are kept.
struct Behaviour {
    std::string_view what;
    std::string found;
    bool is_ieee = true; // what IEEE 754 asks for, or a shader's text says
};

// The largest error over a sweep of arguments, against double. Infinite where a number came out as
// NaN.
struct FunctionError {
    std::string_view function;
    double low = 0, high = 0; // of the first argument
    // In spacings of floats about the value; of sin, cos, asin, acos and atan about 1, where they
    // are 1.2e-7.
    double of_driver = 0, of_kernel = 0; // the driver's function; that of shaders/math/
    double driver_at = 0;                // the argument where the driver is worst
};

// Throw gpu::CompileError, and std::runtime_error where shaders/ is not to be found.
std::vector<Behaviour> behaviours();
std::vector<FunctionError> function_errors();

} // namespace isomotion::render
