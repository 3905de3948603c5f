// The operations of one argument and of two, one row each. All code that handles these operations
// is generated from the rows.
//
// Besides its row an operation needs only a definition for each number type: in Operations<T>
// (operations.h, interval/interval_operations.h) and for balls (arb/ball_program.cpp). One with a
// kernel also needs it in shaders/math/ and shaders/interval/ (shader/shader_files.cpp lists their
// files). A missing definition does not compile. Functions of one argument can be called by
// formulas; those of two, and functions that are composed of others, like smoothmin, are called
// by rows of functions.cpp.
//
//   name      of the function, of its Op, of Operations<T>::name and of the kernel im_name
//   naming    of a function of one argument: whether a scene may have a parameter of its name
//   shader    what computes it in shaders
//   sign      what is known of the sign of the operation's values
//   extent    how large they may be
//   at_0      whether the function is 0 where its argument is
//   breaks    where it jumps, or has a kink or a pole
//   gaps      what it makes of an argument without a value
//   domain    where it has a value, on paper, as an expression of x
//   slope     its derivative, as an expression of the argument a and the value f (derivative.cpp);
//             of two arguments a and b, whose derivatives are da and db
//
// functions.h says what the words of naming, shader, sign, extent, at_0, breaks and gaps mean.
#pragma once

// clang-format off
#define ISOMOTION_FUNCTIONS(ROW)                                                                                                                                   \
    /*  name   naming    shader        sign          extent     at_0   breaks       gaps  domain            slope   */                                             \
    ROW(abs,   reserved, by_intervals, not_negative, finite,    zero,  kink_at_0,   kept, true,             sign(a))                                               \
    ROW(sign,  reserved, built_in,     as_argument,  unit,      zero,  steps,       cut,  true,             jumps(f))                                              \
    ROW(sqrt,  reserved, kernel,       not_negative, finite,    zero,  kink_at_0,   kept, x >= 0,           where_rooted(a, 0.5 / f))                              \
    ROW(exp,   reserved, kernel,       positive,     unbounded, other, nowhere,     kept, true,             f)                                                     \
    ROW(log,   reserved, kernel,       any,          unbounded, other, pole_at_0,   kept, x > 0,            1.0 / a)                                               \
    ROW(sin,   reserved, kernel,       any,          unit,      zero,  nowhere,     kept, true,             cos(a))                                                \
    ROW(cos,   reserved, kernel,       any,          unit,      other, nowhere,     kept, true,             -sin(a))                                               \
    ROW(tan,   reserved, kernel,       any,          unbounded, zero,  poles,       cut,  true,             1.0 + f * f)                                           \
    ROW(sinh,  reserved, kernel,       any,          unbounded, zero,  nowhere,     cut,  true,             cosh(a))                                               \
    ROW(cosh,  reserved, kernel,       positive,     unbounded, other, nowhere,     cut,  true,             sinh(a))                                               \
    ROW(tanh,  reserved, kernel,       any,          unit,      zero,  nowhere,     cut,  true,             1.0 - f * f)                                           \
    ROW(asin,  reserved, kernel,       any,          finite,    zero,  kink_at_1,   cut,  std::abs(x) <= 1, within_unit(a, 1.0 / rest_of_unit(a)))                 \
    ROW(acos,  reserved, kernel,       any,          finite,    other, kink_at_1,   cut,  std::abs(x) <= 1, within_unit(a, -1.0 / rest_of_unit(a)))                \
    ROW(atan,  reserved, kernel,       any,          finite,    zero,  turn,        cut,  true,             1.0 / (1.0 + a * a))                                   \
    ROW(floor, reserved, built_in,     as_argument,  finite,    zero,  steps,       cut,  true,             jumps(f))                                              \
    ROW(asinh, free,     kernel,       as_argument,  finite,    zero,  nowhere,     cut,  true,             1.0 / sqrt(1.0 + a * a))                               \
    ROW(acosh, free,     kernel,       not_negative, finite,    zero,  begins_at_1, cut,  x >= 1,           above_1(a, 1.0 / sqrt((a - a.number(1)) * (1.0 + a)))) \
    ROW(erf,   free,     kernel,       as_argument,  unit,      zero,  nowhere,     cut,  true,             1.0 / sqrt(atan(a.number(1))) * exp(-(a * a)))         \
    ROW(cbrt,  free,     kernel,       as_argument,  finite,    zero,  kink_at_0,   cut,  true,             1.0 / (3.0 * (f * f)))

// atan2(a, b) is the angle of the point (b, a), above -pi and up to pi. angle(a, b) is the same up
// to whole turns: as a number it is atan2, but its enclosures go on across the cut, beyond pi.
#define ISOMOTION_OPERATIONS_OF_TWO(ROW)                                                                                         \
    /*  name      shader    sign         extent     breaks           gaps  slope   */                                            \
    ROW(add,      built_in, of_both,     finite,    nowhere,         kept, da + db)                                              \
    ROW(subtract, built_in, any,         finite,    nowhere,         kept, da - db)                                              \
    ROW(multiply, built_in, of_both,     finite,    nowhere,         kept, da * b + a * db)                                      \
    ROW(divide,   kernel,   of_both,     unbounded, pole_at_b_0,     kept, quotient_slope(a, b, f, da, db))                      \
    ROW(min,      built_in, of_both,     finite,    kink_where_same, cut,  where_less(Op::min, a, b, da, db))                    \
    ROW(max,      built_in, of_either,   finite,    kink_where_same, cut,  where_less(Op::max, a, b, db, da))                    \
    ROW(power,    kernel,   as_argument, unbounded, base_at_0,       cut,  power_slope(a, b, f, da, db))                         \
    ROW(atan2,    kernel,   as_argument, finite,    cut,             cut,  (b * da - a * db) / (a * a + b * b) + jumps(f))       \
    ROW(angle,    kernel,   any,         finite,    axis,            cut,  (b * da - a * db) / (a * a + b * b) + jumps(f))
// clang-format on
