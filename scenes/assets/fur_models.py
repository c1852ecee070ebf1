"""Makes fox.obj, fox.png, fox_coat.png, spot.obj, spot.png and spot_coat.png: see LICENSES.md.

    python3 fur_models.py Fox.glb spot.obj     # writes beside this file

Needs numpy and Pillow. The fox is smoothed, as it has few triangles, and keeps its texture, with eyes and
nose painted over; the cow keeps its shape, and gets a coat painted by place, so that no seam of its
texture shows. White in a coat's map bears hair.
"""

import io
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


def spot_at(at, middle, radii):
    """1 inside an ellipsoid, 0 outside; mirrored in x."""
    off = (numpy.abs(at[:, :1]), at[:, 1:])
    far = numpy.linalg.norm((numpy.hstack(off) - middle) / radii, axis=1)
    return 1 - step(far, 0.82, 1.0)


def cow(at):
    """A coat of dark patches on cream; muzzle, eyes and hooves bare. sRGB."""
    color = numpy.tile([0.90, 0.86, 0.78], (len(at), 1))
    color = color + 0.03 * waves(at, 4, 30)[:, None]
    dark = step(waves(at, 21, 4.2), 0.10, 0.22)
    color = blend(color, [0.17, 0.10, 0.065], dark)
    color = blend(color, [0.83, 0.53, 0.47], spot_at(at, *MUZZLE))
    color = blend(color, [0.30, 0.13, 0.12], spot_at(at, *NOSTRIL))
    color = blend(color, [0.22, 0.19, 0.17], 1 - step(at[:, 1], 0.03, 0.07))
    color = blend(color, [0.03, 0.02, 0.02], spot_at(at, *COW_EYE))
    return blend(color, [0.95, 0.95, 0.95], spot_at(at, *COW_GLINT))


def cow_hair(at):
    """Where the cow bears hair."""
    hooves = 1 - step(at[:, 1], 0.03, 0.07)
    bare = numpy.maximum(spot_at(at, *MUZZLE), spot_at(at, *COW_EYE))
    return (1 - numpy.maximum(hooves, bare))[:, None].repeat(3, 1)


def fox_hair(at):
    """Where the fox bears hair."""
    bare = numpy.maximum(spot_at(at, *FOX_EYE), spot_at(at, *FOX_NOSE))
    return (1 - bare)[:, None].repeat(3, 1)


def fox_face(image, mesh):
    """The fox's own image, with eyes and nose over it."""
    size = image.size[0]
    face = paint(size, *mesh, lambda at: 1 - fox_hair(at))
    share = numpy.asarray(face, float)[:, :, :1] / 255
    glint = paint(size, *mesh, lambda at: spot_at(at, *FOX_GLINT)[:, None].repeat(3, 1))
    glint = numpy.asarray(glint, float)[:, :, :1] / 255
    drawn = numpy.asarray(image.convert("RGB"), float)
    drawn = drawn * (1 - share) + numpy.array([14, 11, 10]) * share
    drawn = drawn * (1 - glint) + 240 * glint
    return Image.fromarray(drawn.round().astype(numpy.uint8))


# Ellipsoids in the scene's metres, after `place`: middle (x as on one side) and half axes.
MUZZLE = ([0.0, 0.55, -0.54], [0.24, 0.14, 0.13])
NOSTRIL = ([0.07, 0.60, -0.50], [0.022, 0.02, 0.06])
COW_EYE = ([0.135, 0.765, -0.40], [0.032, 0.05, 0.10])
COW_GLINT = ([0.127, 0.785, -0.40], [0.009, 0.013, 0.10])
FOX_EYE = ([0.053, 0.530, 0.538], [0.024, 0.016, 0.019])
FOX_GLINT = ([0.050, 0.536, 0.545], [0.006, 0.005, 0.008])
FOX_NOSE = ([0.0, 0.462, 0.645], [0.026, 0.026, 0.03])


def main():
    points, uvs, triangles, uv_triangles, image = read_glb(sys.argv[1])
    points, triangles, kept = weld(points, triangles)
    mesh = (points, uvs, triangles, uv_triangles[kept])
    mesh = subdivide(*mesh)
    mesh = (place(mesh[0], 0.62), *mesh[1:])
    write_obj("fox", *mesh)
    fox_face(Image.open(io.BytesIO(image)), mesh).save(HERE / "fox.png", optimize=True)
    paint(256, *mesh, fox_hair).convert("L").save(HERE / "fox_coat.png", optimize=True)

    points, uvs, triangles, uv_triangles = read_obj(sys.argv[2])
    points = place(points, 1.0)
    write_obj("spot", points, uvs, triangles, uv_triangles)
    paint(512, points, uvs, triangles, uv_triangles, cow).save(HERE / "spot.png", optimize=True)
    coat = paint(256, points, uvs, triangles, uv_triangles, cow_hair)
    coat.convert("L").save(HERE / "spot_coat.png", optimize=True)


main()
