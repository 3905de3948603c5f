// Measures a driver's float arithmetic by small shaders in the current context.
//
// Shaders of isomotion rely on as little of it as they can. Where they can't rely on it,
// shaders/math/ has functions of its own and shaders use `precise`.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace isomotion::render {

// The answer to a yes-or-no question, such as whether denormals are kept.
struct Behaviour {
    std::string_view what;
    std::string found;
    bool is_ieee = true; // as required by IEEE 754 or by the shader's text
};

// The largest error over a sweep of arguments, compared with double. Infinite if some result was
// NaN.
struct FunctionError {
    std::string_view function;
    double low = 0, high = 0; // of the first argument
    // In spacings of floats at the value; for sin, cos, asin, acos and atan at 1, where they are
    // 1.2e-7.
    double of_driver = 0, of_kernel = 0; // of the driver's function; of the kernel in shaders/math/
    double driver_at = 0;                // the argument with the driver's largest error
};

// Throw gpu::CompileError, and std::runtime_error if shaders/ is not found.
std::vector<Behaviour> behaviours();
std::vector<FunctionError> function_errors();

} // namespace isomotion::render
