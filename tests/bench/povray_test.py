#!/usr/bin/env python3
"""The text that is written for POV-Ray, without POV-Ray: read back as Python it has the value of the
formula."""
import math
import random
import unittest

import povray


def value(body, x, y, z):
    names = {"pow": pow, "ln": math.log, **{n: getattr(math, n) for n in ("exp", "sin", "cos")},
             "abs": abs, "min": min, "max": max, "sqrt": math.sqrt}
    return eval(body.replace("\n", " "), {"__builtins__": {}}, {**names, "x": x, "y": y, "z": z})


class Written(unittest.TestCase):
    def check(self, formula, expected, constants={}):
        body = povray.function(formula, constants)
        self.assertNotIn("^", body)
        source = random.Random(1)
        for _ in range(50):
            p = [source.uniform(-2, 2) for _ in range(3)]
            self.assertAlmostEqual(value(body, *p), expected(*p), delta=1e-9, msg=body)

    def test_a_minus_binds_looser_than_a_power(self):
        self.check("-x^2 - -y^2", lambda x, y, z: -x**2 + y**2)

    def test_powers_group_to_the_right(self):
        self.check("x^2^3", lambda x, y, z: x**8)

    def test_differences_group_to_the_left(self):
        self.check("x - y - z/2/4", lambda x, y, z: x - y - z / 8)

    def test_constants_are_folded(self):
        self.assertEqual(povray.function("a*(1 + sqrt(4))*x + 0*y", {"a": 2}), "(6 * x)")

    def test_long_terms_are_written_once(self):
        self.assertEqual(povray.function("(x*y + z)^2", {}).count("z"), 1)

    def test_functions(self):
        self.check("exp(-abs(x)) + log(2 + y^2) + max(x, y)*cos(k*z)",
                   lambda x, y, z: math.exp(-abs(x)) + math.log(2 + y * y)
                   + max(x, y) * math.cos(3 * z), {"k": 3})

    def test_sums_are_written_out(self):
        body = povray.sum_of("exp(-a*((x-c)^2 + y^2))", {"a": 2}, [{"c": 0.5}, {"c": -1}])
        self.assertAlmostEqual(value(body, 0.3, 0.2, 0),
                               math.exp(-2 * (0.04 + 0.04)) + math.exp(-2 * (1.69 + 0.04)))

    def test_mistakes(self):
        for formula in ("x +", "x y", "(x", "q*x"):
            with self.assertRaises(ValueError, msg=formula):
                povray.function(formula, {})

    def test_the_camera_is_not_mirrored(self):
        text = povray.scene("x", 1, [0, 0, 1], [0, 1, 0], 2, 1e-3, 1)
        self.assertIn("right <2, 0, 0>", text)
        self.assertIn("direction <0, 0, -1>", text)


if __name__ == "__main__":
    unittest.main()
