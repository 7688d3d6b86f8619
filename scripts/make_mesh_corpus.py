#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The ESM authors
# SPDX-License-Identifier: MIT
"""Writes the mesh corpus: small files of every format, dialect, topology, scale and accident, and what is in them.

  make_mesh_corpus.py FOLDER     writes the files and FOLDER/expected.json

expected.json maps each name to the counts that `esm inspect --json` must find, or to {"refused": "a part of the
message"}. Counts come from the model that a file was written from, never from a reader. Standard library only.
"""
import base64
import json
import math
import pathlib
import random
import struct
import sys
import zlib


class Model:
    """Points; faces, segments and tetrahedra over them."""

    def __init__(self, points, faces=(), segments=(), tetrahedra=()):
        self.points = [tuple(float(x) for x in p) for p in points]
        self.faces = [tuple(f) for f in faces]
        self.segments = [tuple(s) for s in segments]
        self.tetrahedra = [tuple(t) for t in tetrahedra]

    def soup(self):
        """The same faces, each with points of its own, as STL has them; unused points are lost."""
        points, faces = [], []
        for face in self.faces:
            faces.append(tuple(range(len(points), len(points) + len(face))))
            points += [self.points[i] for i in face]
        return Model(points, faces)

    def expected(self):
        """What inspect must say after an exact weld."""
        place = {}
        for point in self.points:
            place.setdefault(tuple(x + 0.0 for x in point), len(place))
        of = [place[tuple(x + 0.0 for x in point)] for point in self.points]
        users, triangles, duplicates, degenerate, seen, diagonals = {}, 0, 0, 0, set(), 0
        for face in self.faces:
            corners = [of[i] for i in face]
            triangles += len(face) - 2
            diagonals += len(face) - 3
            key = tuple(sorted(corners))
            duplicates += key in seen
            seen.add(key)
            degenerate += len(set(corners)) < len(corners)
            edges = {frozenset((corners[i - 1], corners[i])) for i in range(len(corners))}
            for edge in edges:
                if len(edge) == 2:
                    users[edge] = users.get(edge, 0) + 1
        lines = set(users)
        for segment in self.segments:
            lines.add(frozenset(of[i] for i in segment))
        for tetrahedron in self.tetrahedra:
            lines |= {frozenset((of[a], of[b])) for a in tetrahedron for b in tetrahedron}
        lines = {line for line in lines if len(line) == 2}
        used = {i for line in lines for i in line}
        parent = {i: i for i in used}

        def root(i):
            while parent[i] != i:
                i = parent[i]
            return i
        for a, b in (tuple(line) for line in lines):
            parent[root(a)] = root(b)
        where = list(place)
        ends = [where[i] for i in used]
        answer = {"nodes": len(used), "springs": len(lines) + diagonals, "triangles": triangles,
                  "segments": len(self.segments), "components": len({root(i) for i in used}),
                  "isolated_vertices": len(place) - len(used),
                  "boundary_edges": sum(n == 1 for n in users.values()),
                  "nonmanifold_edges": sum(n > 2 for n in users.values()), "duplicate_faces": duplicates,
                  "degenerate_faces": degenerate, "finite": True,
                  "bbox_min": [min(p[k] for p in ends) for k in range(3)],
                  "bbox_max": [max(p[k] for p in ends) for k in range(3)]}
        if diagonals == 0:
            answer["sum_rest_length"] = sum(math.dist(where[a], where[b]) for a, b in (tuple(line) for line in lines))
        return answer


# === Models. Coordinates are multiples of 1/16, so that float32 holds them too, unless said otherwise.

def grid(n, step=1.0, x0=0.0, y0=0.0):
    points = [(x0 + i * step, y0 + j * step, 0.0) for i in range(n) for j in range(n)]
    faces = []
    for i in range(n - 1):
        for j in range(n - 1):
            a, b, c, d = i * n + j, (i + 1) * n + j, (i + 1) * n + j + 1, i * n + j + 1
            faces += [(a, b, c), (a, c, d)]
    return Model(points, faces)


def ring(around, along, closed):
    """A tube, or a torus if closed; coordinates rounded to 1/16."""
    points, faces = [], []
    for i in range(along):
        for j in range(around):
            u, v = 2 * math.pi * i / along, 2 * math.pi * j / around
            r = 20 + 6 * math.cos(v)
            p = (r * math.cos(u), r * math.sin(u), 6 * math.sin(v)) if closed else (6 * math.cos(v), 6 * math.sin(v), 3 * i)
            points.append(tuple(round(16 * x) / 16 for x in p))
    for i in range(along if closed else along - 1):
        for j in range(around):
            i1, j1 = (i + 1) % along, (j + 1) % around
            a, b, c, d = i * around + j, i1 * around + j, i1 * around + j1, i * around + j1
            faces += [(a, b, c), (a, c, d)]
    return Model(points, faces)


TETRA = Model([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], [(0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2)])
OCTA = Model([(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)],
             [(0, 2, 4), (2, 1, 4), (1, 3, 4), (3, 0, 4), (2, 0, 5), (1, 2, 5), (3, 1, 5), (0, 3, 5)])


def joined(*models):
    points, faces, segments = [], [], []
    for model in models:
        n = len(points)
        points += model.points
        faces += [tuple(i + n for i in f) for f in model.faces]
        segments += [tuple(i + n for i in s) for s in model.segments]
    return Model(points, faces, segments)


def moved(model, scale, shift):
    return Model([tuple(scale * x + d for x, d in zip(p, shift)) for p in model.points], model.faces, model.segments)


SURFACES = {
    "triangle": Model([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(0, 1, 2)]), "tetra": TETRA, "octa": OCTA, "grid": grid(5),
    "tube": ring(8, 6, False), "torus": ring(8, 12, True), "parts": joined(TETRA, moved(OCTA, 2, (8, 0, 0))),
    "fins": Model([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1)], [(0, 1, 2), (1, 0, 3), (0, 1, 4)]),
    "twice": Model([(0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0)], [(0, 1, 2), (2, 1, 3), (1, 2, 0)]),
    "needle": Model([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(0, 1, 2), (0, 0, 1)]),
    "unwelded": Model(grid(3).points + grid(3).points, grid(3).faces[:4] + [tuple(i + 9 for i in f) for f in grid(3).faces[4:]]),
    "small": moved(grid(4), 2.0 ** -40, (0, 0, 0)), "large": moved(grid(4), 2.0 ** 40, (0, 0, 0)),
}
INDEXED = {  # formats with shared points only
    "isolated": Model(OCTA.points + [(9, 9, 9)], OCTA.faces),
    "polygons": Model([(0, 0, 0), (2, 0, 0), (2, 1, 0), (0, 1, 0), (3, 0, 0), (4, 1, 0), (3, 2, 0)], [(0, 1, 2, 3), (1, 4, 5, 6, 2)]),
}
PRECISE = {"far": grid(5, 0.01, 5e6, 5e6)}  # 1 cm far from the origin: float32 would lose it
LINES = {"polyline": Model([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 1)], [], [(0, 1), (1, 2), (2, 3)]),
         "mixed": Model(OCTA.points + [(0, 0, 3)], OCTA.faces, [(4, 6)])}
SOLIDS = {"solid": Model([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 1)], [], [], [(0, 1, 2, 3), (1, 2, 3, 4)]),
          "solid_mixed": Model([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (2, 0, 0)], [(0, 2, 1)], [(1, 4)], [(0, 1, 2, 3)])}


# === Writers: model -> bytes

def words(values):
    return " ".join(repr(float(x)) for x in values)


def obj(model):
    return ("".join(f"v {words(p)}\n" for p in model.points) +
            "".join("f " + " ".join(str(i + 1) for i in f) + "\n" for f in model.faces) +
            "".join(f"l {a + 1} {b + 1}\n" for a, b in model.segments)).encode()


def stl_binary(model, header=b"corpus", tail=b""):
    facets = b"".join(struct.pack("<12fH", 0, 0, 1, *(x for i in f for x in model.points[i]), 0) for f in model.faces)
    return header.ljust(80, b" ") + struct.pack("<I", len(model.faces)) + facets + tail


def stl_ascii(model, name="corpus"):
    text = f"solid {name}\n"
    for face in model.faces:
        text += "facet normal 0 0 1\n outer loop\n"
        text += "".join(f"  vertex {words(model.points[i])}\n" for i in face) + " endloop\nendfacet\n"
    return (text + f"endsolid {name}\n").encode()


def ply(model, order=None, scalar="double"):
    head = f"ply\nformat {'ascii' if not order else 'binary_little_endian' if order == '<' else 'binary_big_endian'} 1.0\n"
    head += f"comment corpus\nelement vertex {len(model.points)}\n" + "".join(f"property {scalar} {k}\n" for k in "xyz")
    head += f"element face {len(model.faces)}\nproperty list uchar int vertex_indices\n"
    if model.segments:
        head += f"element edge {len(model.segments)}\nproperty int vertex1\nproperty int vertex2\n"
    head += "end_header\n"
    if not order:
        return (head + "".join(words(p) + "\n" for p in model.points) +
                "".join(f"{len(f)} {' '.join(map(str, f))}\n" for f in model.faces) +
                "".join(f"{a} {b}\n" for a, b in model.segments)).encode()
    code = "3d" if scalar == "double" else "3f"
    return (head.encode() + b"".join(struct.pack(order + code, *p) for p in model.points) +
            b"".join(struct.pack(f"{order}B{len(f)}i", len(f), *f) for f in model.faces) +
            b"".join(struct.pack(order + "2i", *s) for s in model.segments))


def off(model):
    return (f"OFF\n{len(model.points)} {len(model.faces)} 0\n" + "".join(words(p) + "\n" for p in model.points) +
            "".join(f"{len(f)} {' '.join(map(str, f))}\n" for f in model.faces)).encode()


def dxf(model, eol="\n"):
    def group(code, value):
        return f"{code:>3}{eol}{value}{eol}"

    def point(number, p):
        return "".join(group(10 * (k + 1) + number, repr(x)) for k, x in enumerate(p))
    text = group(0, "SECTION") + group(2, "ENTITIES")
    for face in model.faces:
        corners = list(face) + [face[-1]] * (4 - len(face))
        text += group(0, "3DFACE") + "".join(point(k, model.points[i]) for k, i in enumerate(corners))
    for a, b in model.segments:
        text += group(0, "LINE") + point(0, model.points[a]) + point(1, model.points[b])
    return (text + group(0, "ENDSEC") + group(0, "EOF")).encode()


def cells(model):
    """(VTK type, Gmsh type, nodes) of each cell."""
    return ([(5, 2, f) for f in model.faces] + [(3, 1, s) for s in model.segments] +
            [(10, 4, t) for t in model.tetrahedra])


def vtk(model, binary=False):
    all_cells = cells(model)
    points = [x for p in model.points for x in p]
    numbers = [x for _, _, nodes in all_cells for x in (len(nodes), *nodes)]
    types = [t for t, _, _ in all_cells]

    def body(values, code):
        return struct.pack(f">{len(values)}{code}", *values) if binary else " ".join(map(repr, values)).encode()
    return (f"# vtk DataFile Version 3.0\ncorpus\n{'BINARY' if binary else 'ASCII'}\nDATASET UNSTRUCTURED_GRID\n"
            f"POINTS {len(model.points)} double\n".encode() + body(points, "d") +
            f"\nCELLS {len(all_cells)} {len(numbers)}\n".encode() + body(numbers, "i") +
            f"\nCELL_TYPES {len(all_cells)}\n".encode() + body(types, "i") + b"\n")


def vtu(model, how):
    all_cells = cells(model)
    ends, total = [], 0
    for _, _, nodes in all_cells:
        total += len(nodes)
        ends.append(total)
    arrays = [("Points", "Float64", "d", [x for p in model.points for x in p]),
              ("connectivity", "Int64", "q", [i for _, _, nodes in all_cells for i in nodes]),
              ("offsets", "Int64", "q", ends), ("types", "UInt8", "B", [t for t, _, _ in all_cells])]
    appended, texts = b"", []
    for name, kind, code, values in arrays:
        raw = struct.pack(f"<{len(values)}{code}", *values)
        extra, content = "", ""
        if how == "ascii":
            content = " ".join(map(repr, values))
        elif how == "base64":
            content = base64.b64encode(struct.pack("<Q", len(raw)) + raw).decode()
        elif how == "zlib":
            blocks = [raw[i:i + 64] for i in range(0, len(raw), 64)]
            packed = [zlib.compress(b) for b in blocks]
            last = len(raw) % 64
            head = struct.pack(f"<{3 + len(packed)}Q", len(packed), 64, last, *(len(p) for p in packed))
            content = base64.b64encode(head).decode() + base64.b64encode(b"".join(packed)).decode()
        else:
            extra = f' offset="{len(appended)}"'
            appended += struct.pack("<Q", len(raw)) + raw
        form = {"ascii": "ascii", "raw": "appended"}.get(how, "binary")
        components = ' NumberOfComponents="3"' if name == "Points" else ""
        texts.append(f'<DataArray type="{kind}" Name="{name}"{components} format="{form}"{extra}>{content}</DataArray>')
    compressor = ' compressor="vtkZLibDataCompressor"' if how == "zlib" else ""
    return (f'<?xml version="1.0"?>\n<VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian" '
            f'header_type="UInt64"{compressor}>\n<UnstructuredGrid><Piece NumberOfPoints="{len(model.points)}" '
            f'NumberOfCells="{len(all_cells)}">\n<Points>{texts[0]}</Points>\n<Cells>{"".join(texts[1:])}</Cells>\n'
            f'</Piece></UnstructuredGrid>\n').encode() + (
                b'<AppendedData encoding="raw">_' + appended + b"</AppendedData>" if how == "raw" else b"") + b"</VTKFile>\n"


def msh(model, version, binary=False):
    all_cells = cells(model)
    tag = [3 * i + 5 for i in range(len(model.points))]  # tags need not be 1, 2, 3
    head = f"$MeshFormat\n{version} {int(binary)} 8\n".encode() + (struct.pack("<i", 1) + b"\n" if binary else b"")
    n, c = len(tag), len(all_cells)
    if version == "1":  # no line of its version, the count of nodes before them
        nodes = "".join(f"{t} {words(p)}\n" for t, p in zip(tag, model.points))
        elements = "".join(f"{i + 1} {g} 1 1 {len(nodes_)} {' '.join(str(tag[k]) for k in nodes_)}\n"
                           for i, (_, g, nodes_) in enumerate(all_cells))
        return f"$NOD\n{n}\n{nodes}$ENDNOD\n$ELM\n{c}\n{elements}$ENDELM\n".encode()
    if version == "2.2" and not binary:
        nodes = f"{n}\n" + "".join(f"{t} {words(p)}\n" for t, p in zip(tag, model.points))
        elements = f"{c}\n" + "".join(f"{i + 1} {g} 2 1 1 {' '.join(str(tag[k]) for k in nodes_)}\n"
                                      for i, (_, g, nodes_) in enumerate(all_cells))
        parts = nodes.encode(), elements.encode()
    elif version == "2.2":
        parts = (f"{n}\n".encode() + b"".join(struct.pack("<i3d", t, *p) for t, p in zip(tag, model.points)),
                 f"{c}\n".encode() + b"".join(struct.pack(f"<6i{len(nodes_)}i", g, 1, 2, i + 1, 1, 1, *(tag[k] for k in nodes_))
                                              for i, (_, g, nodes_) in enumerate(all_cells)))
    elif not binary:
        nodes = f"1 {n} {tag[0]} {tag[-1]}\n3 1 0 {n}\n" + "".join(f"{t}\n" for t in tag) + "".join(words(p) + "\n" for p in model.points)
        elements = f"{c} {c} 1 {c}\n" + "".join(f"2 1 {g} 1\n{i + 1} {' '.join(str(tag[k]) for k in nodes_)}\n"
                                                for i, (_, g, nodes_) in enumerate(all_cells))
        parts = nodes.encode(), elements.encode()
    else:
        parts = (struct.pack(f"<4Q3iQ{n}Q", 1, n, tag[0], tag[-1], 3, 1, 0, n, *tag) +
                 b"".join(struct.pack("<3d", *p) for p in model.points),
                 struct.pack("<4Q", c, c, 1, c) + b"".join(
                     struct.pack(f"<3iQQ{len(nodes_)}Q", 2, 1, g, 1, i + 1, *(tag[k] for k in nodes_))
                     for i, (_, g, nodes_) in enumerate(all_cells)))
    return head + b"$EndMeshFormat\n$Nodes\n" + parts[0] + b"\n$EndNodes\n$Elements\n" + parts[1] + b"\n$EndElements\n"


# === The corpus: name -> (bytes, what to expect)

def formats(files):
    everywhere = {"obj": obj, "ascii.ply": ply, "little.ply": lambda m: ply(m, "<"), "big.ply": lambda m: ply(m, ">")}
    for name, model in {**SURFACES, **INDEXED, **PRECISE, **LINES}.items():
        for ending, write in everywhere.items():
            files[f"{name}.{ending}"] = write(model), model.expected()
    for name, model in {**SURFACES, **INDEXED, **PRECISE}.items():
        files[f"{name}.off"] = off(model), model.expected()
    for name, model in SURFACES.items():
        files[f"{name}.binary.stl"] = stl_binary(model), model.soup().expected()
        files[f"{name}.ascii.stl"] = stl_ascii(model), model.soup().expected()
    for name in ("tetra", "octa", "grid", "parts"):
        files[f"{name}.dxf"] = dxf(SURFACES[name]), SURFACES[name].soup().expected()
    files["far.dxf"] = dxf(PRECISE["far"]), PRECISE["far"].expected()
    files["polyline.dxf"] = dxf(LINES["polyline"]), LINES["polyline"].expected()
    files["windows.dxf"] = dxf(LINES["mixed"], "\r\n"), LINES["mixed"].expected()
    for name, model in {"octa": OCTA, "far": PRECISE["far"], **LINES, **SOLIDS}.items():
        for ending, write in {"ascii.vtk": vtk, "binary.vtk": lambda m: vtk(m, True), "ascii.vtu": lambda m: vtu(m, "ascii"),
                              "base64.vtu": lambda m: vtu(m, "base64"), "zlib.vtu": lambda m: vtu(m, "zlib"),
                              "raw.vtu": lambda m: vtu(m, "raw"), "v1.msh": lambda m: msh(m, "1"), "v2.msh": lambda m: msh(m, "2.2"),
                              "v2b.msh": lambda m: msh(m, "2.2", True), "v4.msh": lambda m: msh(m, "4.1"),
                              "v4b.msh": lambda m: msh(m, "4.1", True)}.items():
            files[f"{name}.{ending}"] = write(model), model.expected()


def dialects(files):
    text, octa = obj(OCTA).decode(), OCTA.expected()
    n = len(OCTA.points)
    for name, changed in {
            "bom": "\ufeff" + text, "crlf": text.replace("\n", "\r\n"), "cr": text.replace("\n", "\r"),
            "comments": text.replace("\n", " # said at the end\n"), "tabs": text.replace(" ", "\t"),
            "plus": text.replace(" 1.0", " +1.0"), "short_numbers": text.replace("0.0", ".0").replace("1.0", "1."),
            "exponents": text.replace("1.0", "10.0e-01"), "no_last_end": text.rstrip("\n"),
            "normals": "vn 0 0 1\nvt 0 0\n" + "".join(line + "\n" if line[0] == "v" else
                       "f " + " ".join(f"{w}/1/1" for w in line.split()[1:]) + "\n" for line in text.splitlines()),
            "negative": "".join(line + "\n" if line[0] == "v" else "f " + " ".join(str(int(w) - 1 - n) for w in line.split()[1:]) +
                                "\n" for line in text.splitlines()),
            "continued": text.replace("f 1 ", "f 1 \\\n "), "groups": "o a\ng b c\ns off\nusemtl x\n" + text}.items():
        files[f"dialect_{name}.obj"] = changed.encode(), octa
    lines = Model([(0, 0, 0), (1, 0, 0), (1, 1, 0)], [], [(0, 1), (1, 2)])
    files["dialect_two_corner_faces.obj"] = b"v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2\nf 2 3\n", lines.expected()
    files["dialect_long_l.obj"] = b"v 0 0 0\nv 1 0 0\nv 1 1 0\nl 1 2 3\n", lines.expected()
    soup = OCTA.soup().expected()
    binary_stl, ascii_stl = stl_binary(OCTA), stl_ascii(OCTA).decode()
    files["dialect_upper.stl"] = ascii_stl.upper().replace("\n", "\r\n").encode(), soup
    files["dialect_two_solids.stl"] = stl_ascii(TETRA) + stl_ascii(moved(OCTA, 2, (8, 0, 0))), SURFACES["parts"].soup().expected()
    files["dialect_solid_binary.stl"] = stl_binary(OCTA, b"solid says nothing"), soup
    files["dialect_trailing.stl"] = stl_binary(OCTA, tail=b"written by a friendly program"), soup
    files["dialect_count_all_ones.stl"] = binary_stl[:80] + b"\xff\xff\xff\xff" + binary_stl[84:], soup
    files["dialect_count_wraps.stl"] = binary_stl[:80] + struct.pack("<I", 85899346) + binary_stl[84:], soup
    files["dialect_count_zero.stl"] = binary_stl[:80] + bytes(4) + binary_stl[84:], soup
    files["dialect_no_endsolid.stl"] = ascii_stl.rsplit("endsolid", 1)[0].encode(), soup
    files["dialect_two_words.stl"] = ascii_stl.replace("endsolid", "end solid").encode(), soup
    files["dialect_float.ply"] = ply(OCTA, "<", "float"), octa
    files["dialect_crlf.ply"] = ply(OCTA).replace(b"\n", b"\r\n"), octa
    files["dialect_comments.off"] = off(OCTA).replace(b"OFF\n", b"# a comment\nOFF # and one\n"), octa
    files["dialect_one_line.off"] = off(OCTA).replace(b"OFF\n", b"OFF "), octa


def names(files):
    data, expected = obj(OCTA), OCTA.expected()
    for name in ("with blanks in it.obj", "Gebärmutter größer.obj", "子宮.obj", "-dash.obj", "--json.obj", "no_ending", "UPPER.OBJ",
                 "two.dots.obj", "quote's \"here\".obj", "per%cent.obj", "x" * 240 + ".obj", "wrong.stl", ".hidden.obj",
                 "line\nbreak.obj", "sub/folder/deep.obj"):
        files[name] = data, expected


def invalid(files):
    def refuse(name, data, message=""):
        files["bad_" + name] = data if isinstance(data, bytes) else data.encode(), {"refused": message}
    text = obj(OCTA).decode()
    noise = random.Random(1999)
    refuse("empty.obj", b"", "empty")
    refuse("blanks.stl", b" \n\t\n", "nothing but blanks")
    refuse("zeros.stl", bytes(5000), "nothing but blanks")
    refuse("comments.obj", "# nothing here\n")
    refuse("points.obj", "v 0 0 0\nv 1 0 0\n", "no face")
    refuse("picture.obj", b"\x89PNG\r\n\x1a\n" + bytes(100), "PNG")
    refuse("archive.stl", b"PK\x03\x04" + bytes(100), "ZIP")
    refuse("noise.obj", noise.randbytes(4000))
    refuse("noise.stl", noise.randbytes(4000))
    refuse("utf16.obj", text.encode("utf-16"), "UTF-16")
    refuse("html.obj", "<html><body>404</body></html>", "web page")
    refuse("comma.obj", text.replace("1.0", "1,5"), "point")
    refuse("nan.obj", text.replace("1.0", "nan"), "not a finite number")
    refuse("huge.obj", text.replace("v 1.0", "v 1e999"), "not a finite number")
    refuse("index.obj", text + "f 1 2 99\n", "there is no vertex 99")
    refuse("zero_index.obj", text + "f 0 1 2\n", "there is no vertex 0")
    refuse("two_coordinates.obj", "v 0 0\nv 1 0\nf 1 2 2\n", "three coordinates")
    refuse("one_place.obj", "v 1 1 1\nv 1 1 1\nv 1 1 1\nf 1 2 3\n", "no spring")
    binary, ascii_stl = stl_binary(OCTA), stl_ascii(OCTA).decode()
    refuse("cut.stl", binary[:300], "promises")
    refuse("header_only.stl", binary[:60] + b"\0", "less than the 84")
    refuse("no_facets.stl", "solid x\nendsolid x\n", "without a single facet")
    refuse("cut_ascii.stl", ascii_stl[:200], "cut short")
    refuse("nan.stl", stl_binary(Model([(0, 0, 0), (math.nan, 0, 0), (0, 1, 0)], [(0, 1, 2)])), "not a finite number")
    for kind, order in (("ascii", None), ("binary", "<")):
        data = ply(OCTA, order)
        refuse(f"lying_vertices_{kind}.ply", data.replace(b"vertex 6", b"vertex 1000000000"), "too small")
        refuse(f"lying_faces_{kind}.ply", data.replace(b"face 8", b"face 1000000000"), "too small")
        refuse(f"cut_{kind}.ply", data[:-20])
        refuse(f"cut_header_{kind}.ply", data[:70], "cut short")
    refuse("index.ply", ply(Model(OCTA.points, [(0, 1, 77)])), "there is no vertex 77")
    refuse("list_bomb.ply", ply(OCTA, "<").replace(b"list uchar int", b"list uint int"))
    refuse("point_cloud.ply", ply(Model(OCTA.points)), "point cloud")
    refuse("lying.off", off(OCTA).replace(b"6 8 0", b"1000000000 8 0"), "promise more")
    refuse("lying_faces.off", off(OCTA).replace(b"6 8 0", b"6 1000000000 0"), "promise more")
    refuse("index.off", off(Model(OCTA.points, [(0, 1, 77)])), "there is no vertex 77")
    refuse("cut.off", off(OCTA)[:-15])
    refuse("binary.dxf", b"AutoCAD Binary DXF\r\n\x1a\0" + bytes(50), "binary DXF")
    refuse("cut.dxf", dxf(LINES["polyline"])[:-10], "cut short")
    refuse("damaged.dxf", dxf(LINES["polyline"]).replace(b" 11\n", b"x11\n", 1), "group")
    refuse("lying.vtk", vtk(OCTA).replace(b"POINTS 6", b"POINTS 1000000000"), "too small")
    refuse("lying_binary.vtk", vtk(OCTA, True).replace(b"CELLS 8 32", b"CELLS 8 900000000"), "too small")
    refuse("image.vtk", vtk(OCTA).replace(b"UNSTRUCTURED_GRID", b"STRUCTURED_POINTS"), "no mesh of cells")
    refuse("cut.vtk", vtk(OCTA)[:200])
    refuse("cut.vtu", vtu(OCTA, "ascii")[:-30], "cut short")
    refuse("lying_raw.vtu", vtu(OCTA, "raw").replace(b">_" + struct.pack("<Q", 144), b">_" + struct.pack("<Q", 1 << 50)), "promises more")
    refuse("compressor.vtu", vtu(OCTA, "zlib").replace(b"vtkZLibDataCompressor", b"vtkLZMADataCompressor"), "is not read")
    refuse("index.vtu", vtu(Model(OCTA.points, [(0, 1, 77)]), "ascii"), "there is no point 77")
    refuse("lying.msh", msh(OCTA, "2.2").replace(b"$Nodes\n6", b"$Nodes\n900000000"), "promises 900000000")
    refuse("lying_blocks.msh", msh(OCTA, "4.1").replace(b"$Nodes\n1 6", b"$Nodes\n900000000 6"), "promises 900000000")
    refuse("old.msh", b"$NOD\n1\n1 0 0 0\n$ENDNOD\n", "1 points")
    refuse("cut.msh", msh(OCTA, "4.1", True)[:200], "cut short")
    refuse("node.msh", msh(OCTA, "2.2").replace(b" 5 11 17\n", b" 5 11 18\n"), "there is no node 18")


def corpus():
    files = {}
    for add in (formats, dialects, names, invalid):
        add(files)
    return files


def main():
    folder = pathlib.Path(sys.argv[1])
    files = corpus()
    for name, (data, _) in files.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_bytes(data)
    (folder / "expected.json").write_text(json.dumps({name: what for name, (_, what) in files.items()}, indent=1))
    print(f"{len(files)} files in {folder}")


if __name__ == "__main__":
    main()
