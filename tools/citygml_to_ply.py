#!/usr/bin/env python3
"""Converts CityGML 2.0 buildings to one coloured triangle mesh for `hybridfusion simulate --world`.

    tools/citygml_to_ply.py building1.xml building2.xml ... mesh.ply

Coordinates become metres relative to the middle of all buildings, z up. Every polygon takes the
diffuse colour of its X3DMaterial, or the mean colour of its texture image; faces are labelled as
buildings (1). Ground surfaces are left out: the simulator brings its own ground.
Needs python3-numpy and, for texture images, python3-pil.
"""

import sys
import xml.etree.ElementTree as ET
from pathlib import Path

import numpy as np

GML = "{http://www.opengis.net/gml}"
APP = "{http://www.opengis.net/citygml/appearance/2.0}"
BLDG = "{http://www.opengis.net/citygml/building/2.0}"
XLINK_HREF = "{http://www.w3.org/1999/xlink}href"
DEFAULT_COLOR = (200, 190, 175)
BUILDING_LABEL = 1


def mean_color(image: Path):
    from PIL import Image

    with Image.open(image) as picture:
        return tuple(np.asarray(picture.convert("RGB").resize((32, 32))).reshape(-1, 3).mean(0))


def polygon_colors(root, folder: Path):
    """Colour of each polygon id."""
    colors = {}
    for material in root.iter(APP + "X3DMaterial"):
        diffuse = material.findtext(APP + "diffuseColor")
        if diffuse is None:
            continue
        color = tuple(255.0 * float(c) for c in diffuse.split())
        for target in material.iter(APP + "target"):
            colors[target.text.strip().lstrip("#")] = color
    for texture in root.iter(APP + "ParameterizedTexture"):
        image = folder / texture.findtext(APP + "imageURI", "").replace("\\", "/")
        if not image.is_file():
            continue
        color = mean_color(image)
        for target in texture.iter(APP + "target"):
            colors[target.get("uri", "").lstrip("#")] = color
    return colors


def ring_points(ring):
    """Corners of a linear ring without the repeated last one, n x 3."""
    values = [float(v) for e in ring.iter(GML + "posList") for v in e.text.split()]
    if not values:
        values = [float(v) for e in ring.iter(GML + "pos") for v in e.text.split()]
    points = np.array(values).reshape(-1, 3)
    if len(points) > 1 and np.allclose(points[0], points[-1]):
        points = points[:-1]
    return points


def normal_of(points):
    """Newell's normal; its length is twice the area."""
    following = np.roll(points, -1, axis=0)
    return np.cross(points, following).sum(axis=0)


def cross2(a, b, c):
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def with_hole(outer, hole, plane):
    """One ring that runs through the hole by a bridge from its rightmost corner (Eberly 2002)."""
    start = max(range(len(hole)), key=lambda i: plane[hole[i]][0])
    h = plane[hole[start]]
    order = sorted(range(len(outer)), key=lambda i: np.hypot(*(plane[outer[i]] - h)))
    ring = [plane[i] for i in outer]

    def clear(i):
        a, b = h, ring[i]
        for j in range(len(ring)):
            c, d = ring[j], ring[(j + 1) % len(ring)]
            if any(np.array_equal(p, q) for p in (a, b) for q in (c, d)):
                continue
            if cross2(a, b, c) * cross2(a, b, d) < 0 and cross2(c, d, a) * cross2(c, d, b) < 0:
                return False
        return True

    at = next((i for i in order if clear(i)), order[0])
    loop = hole[start:] + hole[: start + 1]
    return outer[: at + 1] + loop + outer[at:]


def ears(ring, plane):
    """Triangles of a simple counter-clockwise ring by ear clipping."""
    ring = list(ring)
    triangles = []
    while len(ring) > 3:
        for k in range(len(ring)):
            i, j, l = ring[k - 1], ring[k], ring[(k + 1) % len(ring)]
            a, b, c = plane[i], plane[j], plane[l]
            if cross2(a, b, c) <= 0:
                continue
            inside = (
                cross2(a, b, plane[m]) > 0 and cross2(b, c, plane[m]) > 0 and cross2(c, a, plane[m]) > 0
                for m in ring
                if m not in (i, j, l)
            )
            if not any(inside):
                triangles.append((i, j, l))
                del ring[k]
                break
        else:
            # Only flat corners are left: they add no area.
            del ring[0]
    if len(ring) == 3:
        triangles.append(tuple(ring))
    return triangles


def triangulate(outer, holes):
    """(points n x 3, triangles) of a planar polygon with holes."""
    normal = normal_of(outer)
    length = np.linalg.norm(normal)
    if length < 1e-6:
        return np.empty((0, 3)), []
    normal /= length
    side = np.cross(normal, np.eye(3)[np.argmin(np.abs(normal))])
    side /= np.linalg.norm(side)
    axes = np.stack([side, np.cross(normal, side)])
    points = np.concatenate([outer] + holes)
    plane = (points - outer[0]) @ axes.T
    ring = list(range(len(outer)))
    loops, first = [], len(outer)
    for hole in holes:
        loop = list(range(first, first + len(hole)))
        first += len(hole)
        if normal_of(hole) @ normal > 0:
            loop.reverse()
        loops.append(loop)
    for loop in sorted(loops, key=lambda l: -max(plane[i][0] for i in l)):
        ring = with_hole(ring, loop, plane)
    return points, ears(ring, plane)


def read_buildings(path: Path):
    """Yields (points, triangles, color) of every polygon above the ground."""
    root = ET.parse(path).getroot()
    colors = polygon_colors(root, path.parent)
    ground = {p for g in root.iter(BLDG + "GroundSurface") for p in g.iter(GML + "Polygon")}
    for polygon in root.iter(GML + "Polygon"):
        exterior = polygon.find(GML + "exterior")
        if polygon in ground or exterior is None:
            continue
        holes = [ring_points(h) for h in polygon.findall(GML + "interior")]
        points, triangles = triangulate(ring_points(exterior), [h for h in holes if len(h) > 2])
        if triangles:
            yield points, triangles, colors.get(polygon.get(GML + "id"), DEFAULT_COLOR)


def write_ply(path: Path, points, colors, triangles):
    vertex = np.zeros(len(points), dtype=[("p", "<f4", 3), ("c", "u1", 3)])
    vertex["p"], vertex["c"] = points, np.clip(colors, 0, 255)
    face = np.zeros(len(triangles), dtype=[("n", "u1"), ("v", "<i4", 3), ("l", "u1")])
    face["n"], face["v"], face["l"] = 3, triangles, BUILDING_LABEL
    header = (
        "ply\nformat binary_little_endian 1.0\n"
        f"element vertex {len(points)}\nproperty float x\nproperty float y\nproperty float z\n"
        "property uchar red\nproperty uchar green\nproperty uchar blue\n"
        f"element face {len(triangles)}\nproperty list uchar int vertex_indices\n"
        "property uchar label\nend_header\n"
    )
    with open(path, "xb") as out:
        out.write(header.encode() + vertex.tobytes() + face.tobytes())


def main(arguments):
    if len(arguments) < 2 or not arguments[-1].endswith(".ply"):
        sys.exit(__doc__)
    points, colors, triangles, count = [], [], [], 0
    for name in arguments[:-1]:
        for corner, faces, color in read_buildings(Path(name)):
            points.append(corner)
            colors.append(np.tile(color, (len(corner), 1)))
            triangles.append(np.array(faces) + count)
            count += len(corner)
    if not points:
        sys.exit("no polygons above the ground in these files")
    points = np.concatenate(points)
    low, high = points.min(0), points.max(0)
    middle = 0.5 * (low + high)
    write_ply(
        Path(arguments[-1]),
        points - [middle[0], middle[1], low[2]],
        np.concatenate(colors),
        np.concatenate(triangles),
    )
    print(
        f"{arguments[-1]}: {len(np.concatenate(triangles))} triangles, "
        f"{high[0] - low[0]:.1f} x {high[1] - low[1]:.1f} x {high[2] - low[2]:.1f} m"
    )


if __name__ == "__main__":
    main(sys.argv[1:])
