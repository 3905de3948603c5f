"""A formula and a view as a scene of POV-Ray's isosurface, and how it is run.

POV-Ray's functions know no `^`, no named parts and no sums: constants are folded, whole powers of
short terms written as products (its pow is slow), other powers as pow(). The camera is
orthographic, given by its axes, and the surface is cut by the ball that contains it.
"""
import math
import re

TOKEN = re.compile(r"\s*(?:(\d+\.?\d*(?:[eE][-+]?\d+)?|\.\d+(?:[eE][-+]?\d+)?)|([A-Za-z_]\w*)|(.))")
FUNCTIONS = {"sqrt": math.sqrt, "exp": math.exp, "log": math.log, "sin": math.sin,
             "cos": math.cos, "tan": math.tan, "abs": abs, "min": min, "max": max}
POVRAY_NAMES = {"log": "ln"}
SHORT = 3       # nodes of a term that may be written several times
LONGEST = 8     # factors of a power written as a product


class Formula:
    """Parses into ("number", v), ("name", n), (operator, a, b), ("call", f, a...): constants are
    numbers when it is done. Names but x, y, z are looked up in `constants`."""

    def __init__(self, text, constants):
        self.tokens = [next(t for t in m.groups() if t) for m in TOKEN.finditer(text.strip())]
        self.constants = {"pi": math.pi, **constants}
        self.at = 0

    def parse(self):
        tree = self.sum()
        if self.at < len(self.tokens):
            raise ValueError(f"not understood from '{self.tokens[self.at]}' on")
        return tree

    def take(self, *wanted):
        if self.at < len(self.tokens) and self.tokens[self.at] in wanted:
            self.at += 1
            return self.tokens[self.at - 1]
        return None

    def expect(self, token):
        if not self.take(token):
            raise ValueError(f"'{token}' is missing")

    def sum(self):
        tree = self.product()
        while sign := self.take("+", "-"):
            tree = fold(sign, tree, self.product())
        return tree

    def product(self):
        tree = self.signed()
        while sign := self.take("*", "/"):
            tree = fold(sign, tree, self.signed())
        return tree

    def signed(self):
        if self.take("-"):
            return fold("*", ("number", -1.0), self.signed())
        if self.take("+"):
            return self.signed()
        return self.power()

    def power(self):
        base = self.atom()
        return fold("^", base, self.signed()) if self.take("^") else base

    def atom(self):
        if self.at == len(self.tokens):
            raise ValueError("ends too early")
        token = self.tokens[self.at]
        self.at += 1
        if token[0].isdigit() or token[0] == ".":
            return "number", float(token)
        if token == "(":
            tree = self.sum()
            self.expect(")")
            return tree
        if token in ("x", "y", "z"):
            return "name", token
        if token in self.constants:
            return "number", float(self.constants[token])
        if token in FUNCTIONS:
            self.expect("(")
            arguments = [self.sum()]
            while self.take(","):
                arguments.append(self.sum())
            self.expect(")")
            if all(a[0] == "number" for a in arguments):
                return "number", float(FUNCTIONS[token](*(a[1] for a in arguments)))
            return ("call", token, *arguments)
        raise ValueError(f"unknown: {token}")


def fold(sign, a, b):
    if a[0] == b[0] == "number":
        p, q = a[1], b[1]
        return "number", {"+": lambda: p + q, "-": lambda: p - q, "*": lambda: p * q,
                          "/": lambda: p / q, "^": lambda: p**q}[sign]()
    zero, one = ("number", 0.0), ("number", 1.0)
    if sign == "*":
        if zero in (a, b):
            return zero
        if one in (a, b):
            return b if a == one else a
    if b == zero and sign in "+-" or b == one and sign in "/^":
        return a
    if a == zero and sign == "+":
        return b
    if b == zero and sign == "^":
        return one
    return sign, a, b


def nodes(tree):
    return 1 + sum(nodes(part) for part in tree[1:] if isinstance(part, tuple))


def written(tree):
    kind = tree[0]
    if kind == "number":
        return f"{tree[1]:.17g}" if tree[1] >= 0 else f"({tree[1]:.17g})"
    if kind == "name":
        return tree[1]
    if kind == "call":
        return f"{POVRAY_NAMES.get(tree[1], tree[1])}({', '.join(map(written, tree[2:]))})"
    if kind == "^":
        base, exponent = tree[1], tree[2]
        whole = exponent[0] == "number" and exponent[1] == int(exponent[1])
        if whole and 2 <= exponent[1] <= LONGEST and nodes(base) <= SHORT:
            return "(" + "*".join([written(base)] * int(exponent[1])) + ")"
        return f"pow({written(base)}, {written(exponent)})"
    return f"({written(tree[1])} {kind} {written(tree[2])})"


def function(formula, constants):
    """The formula as the body of a POV-Ray function of x, y, z."""
    return written(Formula(formula, constants).parse())


def sum_of(term, constants, elements):
    """The body for the sum of `term` over elements, each a dictionary of names to numbers."""
    return "\n  + ".join(function(term, {**constants, **element}) for element in elements)


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def vector(v, scale=1.0):
    return "<" + ", ".join(f"{scale * c:.17g}" for c in v) + ">"


def scene(body, radius, back, up, height, accuracy, max_gradient):
    """`back` leads from the origin to the viewer, at right angles to `up`; both of unit length. The
    picture is square and `height` high. `open`: no cap where the ball cuts."""
    right = cross(up, back)
    return f"""#version 3.7;
global_settings {{ assumed_gamma 1.0 }}
background {{ rgb <1, 0, 1> }}
camera {{
  orthographic
  location {vector(back, 3 * radius)}
  direction {vector(back, -1)}
  right {vector(right, height)}
  up {vector(up, height)}
}}
light_source {{ {vector(back, 100 * radius)} rgb 1 shadowless }}
isosurface {{
  function {{ {body} }}
  contained_by {{ sphere {{ <0, 0, 0>, {radius:.17g} }} }}
  accuracy {accuracy:.17g}
  max_gradient {max_gradient:.17g}
  open
  pigment {{ rgb <0.1, 0.7, 0.2> }}
  finish {{ ambient 0.2 diffuse 0.6 }}
}}
"""


def command(pov, size, picture):
    return ["povray", f"+I{pov}", f"+O{picture}", f"+W{size}", f"+H{size}", "+FN8", "-D", "-A"]
