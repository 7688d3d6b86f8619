# SPDX-FileCopyrightText: 2026 The ESM authors
# SPDX-License-Identifier: MIT
"""Small readers of what `esm` writes, made from the formats' descriptions and not from its code."""
import csv
import json
import struct
import xml.etree.ElementTree as xml

_TYPES = {"Float64": "d", "Int64": "q", "UInt8": "B", "Int32": "i"}


def read_vtu(path):
    """Dictionary: points, cells [(type, nodes)], point and cell arrays by name, time, counts."""
    content = path.read_bytes()
    start = content.index(b'<AppendedData encoding="raw">')
    end = content.rindex(b"</AppendedData>")
    blocks = content[content.index(b"_", start) + 1:end]
    root = xml.fromstring(content[:start] + b"</VTKFile>")
    assert root.attrib["byte_order"] == "LittleEndian" and root.attrib["header_type"] == "UInt64", root.attrib

    def array(element):
        offset = int(element.attrib["offset"])
        size, = struct.unpack_from("<Q", blocks, offset)
        kind = _TYPES[element.attrib["type"]]
        values = struct.unpack_from(f"<{size // struct.calcsize(kind)}{kind}", blocks, offset + 8)
        width = int(element.attrib.get("NumberOfComponents", "1"))
        return list(values) if width == 1 else [values[i:i + width] for i in range(0, len(values), width)]

    piece = root.find("UnstructuredGrid/Piece")
    named = {group: {e.attrib["Name"]: array(e) for e in piece.find(group)} for group in
             ("PointData", "CellData", "Points", "Cells")}
    cells, begin = [], 0
    for kind, stop in zip(named["Cells"]["types"], named["Cells"]["offsets"]):
        cells.append((kind, named["Cells"]["connectivity"][begin:stop]))
        begin = stop
    assert begin == len(named["Cells"]["connectivity"])
    return {"points": next(iter(named["Points"].values())), "cells": cells, "point_data": named["PointData"],
            "cell_data": named["CellData"], "point_count": int(piece.attrib["NumberOfPoints"]),
            "cell_count": int(piece.attrib["NumberOfCells"]),
            "time": float(root.find("UnstructuredGrid/FieldData/DataArray[@Name='TimeValue']").text)}


def read_pvd(path):
    """List of (time, path of the frame)."""
    root = xml.parse(path).getroot()
    assert root.attrib["type"] == "Collection", root.attrib
    return [(float(e.attrib["timestep"]), path.parent / e.attrib["file"]) for e in root.find("Collection")]


def read_glb(path):
    """(document, {accessor number: list of values}) of a binary glTF."""
    content = path.read_bytes()
    magic, version, length = struct.unpack_from("<4sII", content)
    assert magic == b"glTF" and version == 2 and length == len(content), (magic, version, length)
    chunks, place = [], 12
    while place < length:
        size, kind = struct.unpack_from("<I4s", content, place)
        assert size % 4 == 0
        chunks.append((kind, content[place + 8:place + 8 + size]))
        place += 8 + size
    assert [kind for kind, _ in chunks] == [b"JSON", b"BIN\0"]
    document, binary = json.loads(chunks[0][1]), chunks[1][1]
    values = {}
    for number, accessor in enumerate(document["accessors"]):
        view = document["bufferViews"][accessor["bufferView"]]
        kind = {5126: "f", 5125: "I"}[accessor["componentType"]]
        width = {"VEC3": 3, "SCALAR": 1}[accessor["type"]]
        count = accessor["count"] * width
        assert view["byteLength"] == 4 * count and view["byteOffset"] + view["byteLength"] <= len(binary)
        flat = struct.unpack_from(f"<{count}{kind}", binary, view["byteOffset"])
        values[number] = list(flat) if width == 1 else [flat[i:i + 3] for i in range(0, count, 3)]
    return document, values


def read_ply(path):
    """{element: list of rows}; a row is a dictionary by property."""
    sizes = {"double": "d", "int": "i", "uchar": "B", "float": "f"}
    content = path.read_bytes()
    head, body = content.split(b"end_header\n", 1)
    elements = []
    for line in head.decode().splitlines():
        words = line.split()
        if words[0] == "element":
            elements.append((words[1], int(words[2]), []))
        elif words[0] == "property":
            elements[-1][2].append(words[1:])
    tables, place = {}, 0
    for name, count, properties in elements:
        tables[name] = []
        for _ in range(count):
            row = {}
            for words in properties:
                if words[0] == "list":
                    size = body[place]
                    row[words[3]] = struct.unpack_from(f"<{size}{sizes[words[2]]}", body, place + 1)
                    place += 1 + struct.calcsize(f"<{size}{sizes[words[2]]}")
                else:
                    row[words[1]], = struct.unpack_from("<" + sizes[words[0]], body, place)
                    place += struct.calcsize("<" + sizes[words[0]])
            tables[name].append(row)
    assert place == len(body), (place, len(body))
    return tables


def read_f64(path, nodes):
    """Frames of nodes of (x, y, z)."""
    content = path.read_bytes()
    values = struct.unpack(f"<{len(content) // 8}d", content)
    assert len(values) % (3 * nodes) == 0
    points = [values[i:i + 3] for i in range(0, len(values), 3)]
    return [points[i:i + nodes] for i in range(0, len(points), nodes)]


def read_csv(path):
    """List of rows as dictionaries of text."""
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))
