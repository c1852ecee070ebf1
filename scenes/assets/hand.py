"""Makes hand.obj: see LICENSES.md.

    python3 hand.py     # writes beside this file

Needs numpy. A hand whose fingers point down, in a sleeve: capsules and a rounded box, melted together
and meshed by surface nets. Metres; the longest finger ends at the origin's height, the palm looks
towards +z.
"""

from pathlib import Path

import numpy

CELL = 0.0048
SKIN = (0.56, 0.30, 0.19)
SLEEVE = (0.09, 0.16, 0.27)
# Height of the cuff's edge.
CUFF = 0.212


def capsule(p, a, b, ra, rb):
    """Distance to a capsule whose radius goes from ra to rb."""
    a, b = numpy.array(a), numpy.array(b)
    way = b - a
    t = numpy.clip(((p - a) @ way) / (way @ way), 0.0, 1.0)
    return numpy.linalg.norm(p - a - t[..., None] * way, axis=-1) - (ra + (rb - ra) * t)


def box(p, middle, half, radius):
    q = numpy.abs(p - numpy.array(middle)) - (numpy.array(half) - radius)
    outside = numpy.linalg.norm(numpy.maximum(q, 0.0), axis=-1)
    return outside + numpy.minimum(q.max(axis=-1), 0.0) - radius


def melt(a, b, k):
    h = numpy.clip(0.5 + 0.5 * (b - a) / k, 0.0, 1.0)
    return b + (a - b) * h - k * h * (1.0 - h)


def finger(p, base, length, spread, radius, bend):
    """Three bones, each bent a little more towards the palm."""
    at, angle, distance = numpy.array(base, float), 0.0, None
    for share, ra, rb in ((0.45, 1.08, 1.0), (0.31, 1.0, 0.9), (0.24, 0.9, 0.74)):
        angle += bend
        flat = numpy.cos(angle)
        way = numpy.array([numpy.sin(spread) * flat, -numpy.cos(spread) * flat, numpy.sin(angle)])
        to = at + way * length * share
        bone = capsule(p, at, to, radius * ra, radius * rb)
        distance = bone if distance is None else melt(distance, bone, 0.004)
        at = to
    return distance


def hand(p):
    palm = box(p, (0.0, 0.127, 0.0), (0.041, 0.047, 0.0135), 0.0125)
    heel = capsule(p, (0.0, 0.15, 0.0), (0.0, 0.2, -0.006), 0.029, 0.024)
    palm = melt(palm, heel, 0.02)
    fingers = (
        ((-0.032, 0.088, 0.0), 0.080, -0.34, 0.0088),
        ((-0.0105, 0.083, 0.0), 0.087, -0.10, 0.0092),
        ((0.0115, 0.084, 0.0), 0.081, 0.14, 0.0088),
        ((0.032, 0.091, 0.0), 0.066, 0.40, 0.0076),
    )
    whole = palm
    for base, length, spread, radius in fingers:
        whole = melt(whole, finger(p, base, length, spread, radius, 0.14), 0.007)
    thumb = capsule(p, (-0.032, 0.145, 0.006), (-0.063, 0.108, 0.020), 0.0135, 0.0105)
    thumb = melt(thumb, capsule(p, (-0.063, 0.108, 0.020), (-0.078, 0.068, 0.030), 0.0105, 0.0080), 0.005)
    whole = melt(whole, thumb, 0.014)
    arm = capsule(p, (0.0, CUFF + 0.018, -0.010), (0.0, 0.54, -0.15), 0.036, 0.05)
    # A cuff is an edge, not a melt.
    return numpy.minimum(whole, arm)


def surface_nets(field, low, cell):
    """A vertex in each cell that the surface crosses, a quad about each edge that it crosses."""
    inside = field < 0.0
    corners = [(i, j, k) for i in (0, 1) for j in (0, 1) for k in (0, 1)]
    size = numpy.array(field.shape) - 1
    part = lambda a, c: a[c[0] : c[0] + size[0], c[1] : c[1] + size[1], c[2] : c[2] + size[2]]
    count = sum(part(inside, c).astype(int) for c in corners)
    cells = numpy.argwhere((count > 0) & (count < 8))
    number = -numpy.ones(size, int)
    number[tuple(cells.T)] = numpy.arange(len(cells))
    total, hits = numpy.zeros((len(cells), 3)), numpy.zeros(len(cells))
    for a in corners:
        for axis in range(3):
            if a[axis]:
                continue
            b = tuple(c + (i == axis) for i, c in enumerate(a))
            va, vb = field[tuple((cells + a).T)], field[tuple((cells + b).T)]
            crossed = (va < 0) != (vb < 0)
            t = numpy.where(crossed, va / numpy.where(va == vb, 1.0, va - vb), 0.0)
            point = numpy.array(a) + t[:, None] * (numpy.array(b) - numpy.array(a))
            total += point * crossed[:, None]
            hits += crossed
    vertices = low + (cells + total / hits[:, None]) * cell
    faces = []
    for axis in range(3):
        step = numpy.eye(3, dtype=int)[axis]
        u, v = numpy.eye(3, dtype=int)[(axis + 1) % 3], numpy.eye(3, dtype=int)[(axis + 2) % 3]
        end = tuple(slice(0, n) for n in numpy.array(field.shape) - step)
        start = tuple(slice(s, None) for s in step)
        for here in numpy.argwhere(inside[end] != inside[start]):
            if (here - u - v < 0).any() or (here >= size).any():
                continue
            quad = [number[tuple(here - d)] for d in (0 * u, u, u + v, v)]
            if not inside[tuple(here)]:
                quad.reverse()
            faces += [(quad[0], quad[1], quad[2]), (quad[0], quad[2], quad[3])]
    return vertices, faces


def main():
    low, high = numpy.array([-0.11, -0.02, -0.23]), numpy.array([0.09, 0.61, 0.085])
    axes = [numpy.arange(a, b, CELL) for a, b in zip(low, high)]
    grid = numpy.stack(numpy.meshgrid(*axes, indexing="ij"), axis=-1)
    vertices, faces = surface_nets(hand(grid), low, CELL)
    lowest = vertices[:, 1].min()
    lines = ["# Ours; see LICENSES.md"]
    for x, y, z in vertices:
        r, g, b = SLEEVE if y > CUFF - 0.015 else SKIN
        lines.append(f"v {x:.4f} {y - lowest:.4f} {z:.4f} {r} {g} {b}")
    lines += ["f " + " ".join(str(i + 1) for i in face) for face in faces]
    Path(__file__).with_name("hand.obj").write_text("\n".join(lines) + "\n")
    print(f"{len(vertices)} vertices, {len(faces)} triangles")


if __name__ == "__main__":
    main()
