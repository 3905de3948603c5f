"""Reads PNG files of 8 bits a sample, RGB or RGBA, without a library."""
import struct
import zlib


class Picture:
    """Rows from the top, pixels of four bytes."""

    def __init__(self, width, height, rows):
        self.width, self.height, self.rows = width, height, rows

    def at(self, x, y):
        return tuple(self.rows[y][4 * x:4 * x + 4])


def read(data):
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    at, packed = 8, b""
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + length]
        if kind == b"IHDR":
            width, height, bits, colour = struct.unpack(">IIBB", body[:10])
            assert bits == 8 and colour in (2, 6)
        elif kind == b"IDAT":
            packed += body
        at += 12 + length
    return _unfiltered(zlib.decompress(packed), width, height, 4 if colour == 6 else 3)


def _unfiltered(raw, width, height, size):
    line = width * size
    before, rows = bytearray(line), []
    for y in range(height):
        begin = y * (line + 1)
        kind = raw[begin]
        row = bytearray(raw[begin + 1:begin + 1 + line])
        for k in range(line):
            left = row[k - size] if k >= size else 0
            up = before[k]
            corner = before[k - size] if k >= size else 0
            if kind == 1:
                row[k] = (row[k] + left) & 255
            elif kind == 2:
                row[k] = (row[k] + up) & 255
            elif kind == 3:
                row[k] = (row[k] + (left + up) // 2) & 255
            elif kind == 4:
                row[k] = (row[k] + _paeth(left, up, corner)) & 255
        before = row
        if size == 4:
            rows.append(bytes(row))
        else:
            rows.append(b"".join(bytes(row[k:k + 3]) + b"\xff" for k in range(0, line, 3)))
    return Picture(width, height, rows)


def _paeth(left, up, corner):
    guess = left + up - corner
    apart = [abs(guess - left), abs(guess - up), abs(guess - corner)]
    return (left, up, corner)[apart.index(min(apart))]


def differences(a, b, edge=24):
    """How many pixels of two pictures of one size differ by more than 3 of 255, and how many of those
    stand off edges: no neighbour in either picture differs by more than `edge`, and no fainter edge
    has moved by less than a pixel, so that each picture's colour stands beside it in the other."""
    assert (a.width, a.height) == (b.width, b.height)
    everywhere = off_edges = 0
    for y in range(a.height):
        if a.rows[y] == b.rows[y]:
            continue
        for x in range(a.width):
            if _apart(a.at(x, y), b.at(x, y)) <= 3:
                continue
            everywhere += 1
            off_edges += not (any(_is_edge(p, x, y, edge) for p in (a, b))
                              or _stands_near(b, a.at(x, y), x, y) and _stands_near(a, b.at(x, y), x, y))
    return everywhere, off_edges


def _apart(p, q):
    return max(abs(m - n) for m, n in zip(p, q))


def _around(picture, x, y):
    """The colours of a pixel and its neighbours."""
    return [picture.at(u, v) for v in range(max(y - 1, 0), min(y + 2, picture.height))
            for u in range(max(x - 1, 0), min(x + 2, picture.width))]


def _is_edge(picture, x, y, edge):
    here = picture.at(x, y)
    return any(_apart(here, colour) > edge for colour in _around(picture, x, y))


def _stands_near(picture, colour, x, y):
    return any(_apart(colour, other) <= 3 for other in _around(picture, x, y))
