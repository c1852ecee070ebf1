"""Makes fox.obj, fox.png, spot.obj, spot.png and spot_coat.png: see LICENSES.md.

    python3 fur_models.py Fox.glb spot.obj     # writes beside this file

Needs numpy and Pillow. The fox is smoothed, as it has few triangles, and its texture kept; the cow
keeps its shape, and gets a coat painted by place, so that no seam of its texture shows.
"""

import json
import struct
import sys
from pathlib import Path

import numpy
from PIL import Image

HERE = Path(__file__).parent


def read_glb(path):
    """Positions, texture coordinates (v down) and triangles of the first primitive, and its image."""
    data = Path(path).read_bytes()
    (length,) = struct.unpack("<I", data[12:16])
    head = json.loads(data[20 : 20 + length])
    body = data[28 + length :]

    def view(index):
        v = head["bufferViews"][index]
        start = v.get("byteOffset", 0)
        return body[start : start + v["byteLength"]], v.get("byteStride")

    def floats(index, width):
        a = head["accessors"][index]
        raw, stride = view(a["bufferView"])
        stride = stride or width * 4
        start = a.get("byteOffset", 0)
        return numpy.array(
            [struct.unpack_from(f"<{width}f", raw, start + i * stride) for i in range(a["count"])]
        )

    attributes = head["meshes"][0]["primitives"][0]["attributes"]
    image, _ = view(head["images"][0]["bufferView"])
    points = floats(attributes["POSITION"], 3)
    triangles = numpy.arange(len(points)).reshape(-1, 3)
    return points, floats(attributes["TEXCOORD_0"], 2), triangles, triangles, image


def read_obj(path):
    """As `read_glb`, with indices of positions and of texture coordinates apart."""
    points, uvs, corners, uv_corners = [], [], [], []
    for line in Path(path).read_text().splitlines():
        word, *rest = line.split() or [""]
        if word == "v":
            points.append([float(x) for x in rest[:3]])
        elif word == "vt":
            uvs.append([float(rest[0]), 1.0 - float(rest[1])])
        elif word == "f":
            parts = [corner.split("/") for corner in rest]
            corners.append([int(p[0]) - 1 for p in parts])
            uv_corners.append([int(p[1]) - 1 for p in parts])
    return tuple(map(numpy.array, (points, uvs, corners, uv_corners)))


def weld(points, triangles):
    """One index for each place."""
    places, index = numpy.unique(points.round(4), axis=0, return_inverse=True)
    triangles = index.reshape(-1)[triangles]
    kept = [t for t in range(len(triangles)) if len(set(triangles[t])) == 3]
    return places, triangles[kept], kept


def subdivide(points, uvs, triangles, uv_triangles):
    """One step of Loop's subdivision; texture coordinates stay linear in each triangle."""
    sides = {}
    for t in triangles:
        for i in range(3):
            a, b, c = t[i], t[(i + 1) % 3], t[(i + 2) % 3]
            sides.setdefault((min(a, b), max(a, b)), []).append(c)
    near = [set() for _ in points]
    rim = [set() for _ in points]
    for (a, b), across in sides.items():
        near[a].add(b), near[b].add(a)
        if len(across) != 2:
            rim[a].add(b), rim[b].add(a)
    moved = numpy.empty_like(points)
    for i, p in enumerate(points):
        if len(rim[i]) == 2:
            moved[i] = 0.75 * p + 0.125 * sum(points[j] for j in rim[i])
        elif rim[i] or not near[i]:
            moved[i] = p
        else:
            n = len(near[i])
            beta = (0.625 - (0.375 + 0.25 * numpy.cos(2 * numpy.pi / n)) ** 2) / n
            moved[i] = (1 - n * beta) * p + beta * sum(points[j] for j in near[i])
    new, middle = list(moved), {}
    for (a, b), across in sides.items():
        middle[a, b] = len(new)
        half = (points[a] + points[b]) / 2
        if len(across) == 2:
            half = 0.75 * half + 0.125 * (points[across[0]] + points[across[1]])
        new.append(half)
    new_uvs, uv_middle, out, uv_out = list(uvs), {}, [], []

    def between(table, key, make):
        if key not in table:
            table[key] = len(new_uvs)
            new_uvs.append(make())
        return table[key]

    for t, u in zip(triangles, uv_triangles):
        m, mu = [], []
        for i in range(3):
            a, b = t[i], t[(i + 1) % 3]
            m.append(middle[min(a, b), max(a, b)])
            x, y = u[i], u[(i + 1) % 3]
            key = (min(x, y), max(x, y))
            mu.append(between(uv_middle, key, lambda: (uvs[x] + uvs[y]) / 2))
        for index, mid, into in ((t, m, out), (u, mu, uv_out)):
            into += [
                [index[0], mid[0], mid[2]],
                [mid[0], index[1], mid[1]],
                [mid[2], mid[1], index[2]],
                [mid[0], mid[1], mid[2]],
            ]
    return tuple(map(numpy.array, (new, new_uvs, out, uv_out)))


def normals(points, triangles):
    """Smooth normals, weighted by area."""
    total = numpy.zeros_like(points)
    a, b, c = (points[triangles[:, i]] for i in range(3))
    face = numpy.cross(b - a, c - a)
    for i in range(3):
        numpy.add.at(total, triangles[:, i], face)
    return total / numpy.linalg.norm(total, axis=1, keepdims=True).clip(1e-9)


def place(points, height):
    """Stands on y = 0, centred, `height` high."""
    low, high = points.min(0), points.max(0)
    scale = height / (high[1] - low[1])
    middle = (low + high) / 2
    return (points - [middle[0], low[1], middle[2]]) * scale


def write_obj(name, points, uvs, triangles, uv_triangles):
    lines = [f"# Made by fur_models.py: see LICENSES.md\no {name}"]
    lines += ["v %.4f %.4f %.4f" % tuple(p) for p in points]
    lines += ["vt %.4f %.4f" % (u, 1 - v) for u, v in uvs]
    lines += ["vn %.2f %.2f %.2f" % tuple(n) for n in normals(points, triangles)]
    for t, u in zip(triangles + 1, uv_triangles + 1):
        lines.append("f " + " ".join(f"{a}/{b}/{a}" for a, b in zip(t, u)))
    (HERE / f"{name}.obj").write_text("\n".join(lines) + "\n")


def paint(size, points, uvs, triangles, uv_triangles, color):
    """An image whose texels have `color(places)`, grown past the seams by a few texels."""
    image = numpy.zeros((size, size, 3))
    done = numpy.zeros((size, size), bool)
    for t, u in zip(triangles, uv_triangles):
        corners = uvs[u] * size - 0.5
        low = numpy.floor(corners.min(0)).astype(int)
        high = numpy.ceil(corners.max(0)).astype(int) + 1
        x, y = numpy.meshgrid(range(low[0], high[0]), range(low[1], high[1]))
        (ax, ay), (bx, by), (cx, cy) = corners
        area = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay)
        if abs(area) < 1e-9:
            continue
        wb = ((x - ax) * (cy - ay) - (cx - ax) * (y - ay)) / area
        wc = ((bx - ax) * (y - ay) - (x - ax) * (by - ay)) / area
        inside = (wb >= -0.02) & (wc >= -0.02) & (wb + wc <= 1.02)
        wb, wc = wb[inside][:, None], wc[inside][:, None]
        p, q, r = points[t]
        at = p * (1 - wb - wc) + q * wb + r * wc
        rows, columns = y[inside] % size, x[inside] % size
        image[rows, columns] = color(at)
        done[rows, columns] = True
    for _ in range(8):
        for shift in ((0, 1), (0, -1), (1, 0), (-1, 0)):
            from_image = numpy.roll(image, shift, (0, 1))
            from_done = numpy.roll(done, shift, (0, 1))
            new = from_done & ~done
            image[new] = from_image[new]
            done |= new
    image[~done] = image[done].mean(0)
    return Image.fromarray((image.clip(0, 1) * 255).round().astype(numpy.uint8))


def waves(at, seed, frequency):
    """Smooth noise of place, about -1 to 1."""
    random = numpy.random.default_rng(seed)
    total = numpy.zeros(len(at))
    for octave in range(3):
        for _ in range(7):
            way = random.normal(size=3)
            way *= frequency * 1.9**octave / numpy.linalg.norm(way)
            total += 0.55**octave * numpy.sin(at @ way + random.uniform(0, 6.3))
    return total / 3.2


def step(x, low, high):
    t = ((x - low) / (high - low)).clip(0, 1)
    return t * t * (3 - 2 * t)


def blend(under, over, share):
    return under + (numpy.array(over) - under) * share[:, None]


def cow(at):
    """A coat of dark patches on cream; muzzle, udder and hooves bare. sRGB."""
    color = numpy.tile([0.90, 0.86, 0.78], (len(at), 1))
    color = color + 0.03 * waves(at, 4, 30)[:, None]
    dark = step(waves(at, 21, 4.2), 0.10, 0.22)
    color = blend(color, [0.17, 0.10, 0.065], dark)
    return blend(color, [0.83, 0.53, 0.47], bare(at))


def bare(at):
    """The share of skin that shows: muzzle and hooves."""
    muzzle = numpy.linalg.norm((at - MUZZLE) / [0.24, 0.14, 0.13], axis=1)
    hooves = at[:, 1]
    return numpy.maximum(1 - step(muzzle, 0.75, 1.0), 1 - step(hooves, 0.03, 0.07))


# In the scene's metres, after `place`.
MUZZLE = numpy.array([0.0, 0.55, -0.54])


def main():
    points, uvs, triangles, uv_triangles, image = read_glb(sys.argv[1])
    points, triangles, kept = weld(points, triangles)
    mesh = (points, uvs, triangles, uv_triangles[kept])
    mesh = subdivide(*mesh)
    write_obj("fox", place(mesh[0], 0.62), *mesh[1:])
    (HERE / "fox.png").write_bytes(image)

    points, uvs, triangles, uv_triangles = read_obj(sys.argv[2])
    points = place(points, 1.0)
    write_obj("spot", points, uvs, triangles, uv_triangles)
    paint(512, points, uvs, triangles, uv_triangles, cow).save(HERE / "spot.png", optimize=True)
    coat = paint(256, points, uvs, triangles, uv_triangles, lambda p: 1 - bare(p)[:, None].repeat(3, 1))
    coat.convert("L").save(HERE / "spot_coat.png", optimize=True)


main()
