// The functions of one argument, one row each. All code that handles these functions is generated
// from the rows.
//
// Besides its row a function needs only a definition for each number type: in Operations<T>
// (operations.h, interval/interval_operations.h) and for balls (arb/ball_program.cpp). A function
// with a kernel also needs it in shaders/math/ and shaders/interval/ (shader/shader_files.cpp
// lists their files). A missing definition does not compile. A function that is composed of others
// needs none of this: it is a row of functions.cpp, like smoothmin.
//
//   name      of the function, of its Op, of Operations<T>::name and of the kernel im_name
//   shader    what computes it in shaders: see Shader in functions.h
//   sign      the sign of its values: see Sign there
//   domain    where it has a value, on paper, as an expression of x
//   slope     its derivative, as an expression of the argument a and the value f (derivative.cpp)
#pragma once

// clang-format off
#define ISOMOTION_FUNCTIONS(ROW)                                                                  \
    /*  name   shader        sign          domain             slope */                            \
    ROW(abs,   by_intervals, not_negative, true,              sign(a))                            \
    ROW(sign,  built_in,     as_argument,  true,              jumps(f))                           \
    ROW(sqrt,  kernel,       not_negative, x >= 0,            where_rooted(a, 0.5 / f))           \
    ROW(exp,   kernel,       not_negative, true,              f)                                  \
    ROW(log,   kernel,       any,          x > 0,             1.0 / a)                            \
    ROW(sin,   kernel,       any,          true,              cos(a))                             \
    ROW(cos,   kernel,       any,          true,              -sin(a))                            \
    ROW(tan,   kernel,       any,          true,              1.0 + f * f)                        \
    ROW(sinh,  kernel,       any,          true,              cosh(a))                            \
    ROW(cosh,  kernel,       not_negative, true,              sinh(a))                            \
    ROW(tanh,  kernel,       any,          true,              1.0 - f * f)                        \
    ROW(asin,  kernel,       any,          std::abs(x) <= 1,  within_unit(a, 1.0 / rest_of_unit(a)))  \
    ROW(acos,  kernel,       any,          std::abs(x) <= 1,  within_unit(a, -1.0 / rest_of_unit(a))) \
    ROW(atan,  kernel,       any,          true,              1.0 / (1.0 + a * a))                \
    ROW(floor, built_in,     as_argument,  true,              jumps(f))
// clang-format on
