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
//   shader    what computes it in shaders
//   sign      of its values
//   extent    of its values
//   at_0      whether it is 0 where its argument is
//   breaks    where it jumps, or has a kink or a pole
//   gaps      what it makes of an argument without a value
//   domain    where it has a value, on paper, as an expression of x
//   slope     its derivative, as an expression of the argument a and the value f (derivative.cpp)
//
// functions.h says what the words of shader, sign, extent, at_0, breaks and gaps mean.
#pragma once

// clang-format off
#define ISOMOTION_FUNCTIONS(ROW)                                                                                                         \
    /*  name   shader        sign          extent     at_0   breaks     gaps  domain             slope   */                              \
    ROW(abs,   by_intervals, not_negative, finite,    zero,  kink_at_0, kept, true,              sign(a))                                \
    ROW(sign,  built_in,     as_argument,  unit,      zero,  steps,     cut,  true,              jumps(f))                               \
    ROW(sqrt,  kernel,       not_negative, finite,    zero,  kink_at_0, kept, x >= 0,            where_rooted(a, 0.5 / f))               \
    ROW(exp,   kernel,       positive,     unbounded, other, nowhere,   kept, true,              f)                                      \
    ROW(log,   kernel,       any,          unbounded, other, pole_at_0, kept, x > 0,             1.0 / a)                                \
    ROW(sin,   kernel,       any,          unit,      zero,  nowhere,   kept, true,              cos(a))                                 \
    ROW(cos,   kernel,       any,          unit,      other, nowhere,   kept, true,              -sin(a))                                \
    ROW(tan,   kernel,       any,          unbounded, zero,  poles,     cut,  true,              1.0 + f * f)                            \
    ROW(sinh,  kernel,       any,          unbounded, zero,  nowhere,   cut,  true,              cosh(a))                                \
    ROW(cosh,  kernel,       positive,     unbounded, other, nowhere,   cut,  true,              sinh(a))                                \
    ROW(tanh,  kernel,       any,          unit,      zero,  nowhere,   cut,  true,              1.0 - f * f)                            \
    ROW(asin,  kernel,       any,          finite,    zero,  kink_at_1, cut,  std::abs(x) <= 1,  within_unit(a, 1.0 / rest_of_unit(a)))  \
    ROW(acos,  kernel,       any,          finite,    other, kink_at_1, cut,  std::abs(x) <= 1,  within_unit(a, -1.0 / rest_of_unit(a))) \
    ROW(atan,  kernel,       any,          finite,    zero,  turn,      cut,  true,              1.0 / (1.0 + a * a))                    \
    ROW(floor, built_in,     as_argument,  finite,    zero,  steps,     cut,  true,              jumps(f))
// clang-format on
