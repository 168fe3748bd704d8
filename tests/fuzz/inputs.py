# SPDX-License-Identifier: GPL-3.0-or-later
"""Initial inputs and dictionaries of the fuzzers of tests/fuzzing: `seeds(input)` and `words(input)`."""
import pathlib
import re
import struct
import zlib

ROOT = pathlib.Path(__file__).resolve().parents[2]
# Sources whose string literals are the words of an input's dictionary.
SOURCES = {"obj": ["meshops/read_write/parse_obj.cpp", "meshops/read_write/material_library.cpp"], "off": ["meshops/read_write/parse_off.cpp"],
           "ply": ["meshops/read_write/parse_ply.cpp", "meshops/read_write/ply_header.cpp"], "stl": ["meshops/read_write/parse_stl.cpp"],
           "scene": ["app/scene/read", "app/scene/toml"], "cache": ["app/files/point_cache.cpp"],
           "study": ["app/sweep/study/study.cpp", "app/sweep/study/study.cpp", "app/sweep/study/study_measures.cpp"],
           "csv": [], "edges": [], "png": []}
NUMBERS = ["0", "1", "-1", "4", "0.5", "1e999", "1e-320", "nan", "inf", "4294967295", "4294967296", "99999999999",
           "18446744073709551615", "\n", " ", "#"]

SQUARE = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)]
TRIANGLES = [(0, 1, 2), (0, 2, 3)]


def obj():
    yield ("mtllib a.mtl\no square\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\ng low high\n"
           "usemtl clay\nf 1/1 2/2 3/3\nusemtl none\nf -4 -2 \\\n -1\0newmtl clay\nKd 0.8 0.2 0.2\n"
           "map_Kd -s 1 1 -o 0 clay.png\n"
           "newmtl none\nillum 2\n").encode()
    # A box whose sides are polygons, with a fin on an edge, a vertex of two fans, and repeated faces.
    yield (b"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\nv 2 2 2\nv 3 2 2\nv 2 .5 0\n"
           b"f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\nf 2 3 11\nf 7 9 10\nf 1 2 6\n"
           b"f 2 3 11 3\nf 1 1 2\n")


def off():
    points = "".join(f"{x} {y} {z}\n" for x, y, z in SQUARE)
    yield f"OFF\n4 2 0\n{points}3 0 1 2\n3 0 2 3 0.5 0.5 0.5\n".encode()
    yield f"STCOFF # a comment\n4 1 4\n{points.replace('0', '0 0 0 1 0 0 0')}4 0 1 2 3\n".encode()
    faces = b"".join(struct.pack(">iiiii", 3, *face, 0) for face in TRIANGLES)
    yield b"OFF BINARY\n" + struct.pack(">iii", 4, 2, 0) + b"".join(struct.pack(">fff", *p) for p in SQUARE) + faces


def ply():
    head = ("element vertex 4\nproperty float x\nproperty float y\nproperty float z\nproperty uchar red\n"
            "property uchar green\nproperty uchar blue\nelement face 2\nproperty list uchar int vertex_indices\n"
            "property float axis_x\nproperty float axis_y\nproperty float axis_z\nend_header\n")
    yield ("ply\nformat ascii 1.0\ncomment a square\n" + head + "".join(f"{x} {y} {z} 255 0 9\n" for x, y, z in SQUARE)
           + "".join(f"3 {a} {b} {c} 1 0 0\n" for a, b, c in TRIANGLES)).encode()
    for name, order in (("little", "<"), ("big", ">")):
        yield (f"ply\nformat binary_{name}_endian 1.0\n{head}".encode()
               + b"".join(struct.pack(order + "fffBBB", *p, 255, 0, 9) for p in SQUARE)
               + b"".join(struct.pack(order + "Biiifff", 3, *face, 1, 0, 0) for face in TRIANGLES))


def stl():
    corners = [[SQUARE[i] for i in face] for face in TRIANGLES]
    yield ("solid a\n" + "".join(
        "facet normal 0 0 1\nouter loop\n" + "".join(f"vertex {x} {y} {z}\n" for x, y, z in face)
        + "endloop\nendfacet\n" for face in corners) + "endsolid a\n").encode()
    yield b"\0" * 80 + struct.pack("<I", 2) + b"".join(
        struct.pack("<12fH", 0, 0, 1, *sum(face, ()), 0) for face in corners)


def cache():
    """Yields point caches with two points in two samples."""
    points = [0, 0, 0, 1, 0, 0, 0, 0, 1, 1, 0, 1]
    yield b"POINTCACHE2\0" + struct.pack("<iiffi12f", 1, 2, 1, 1, 2, *points)
    yield struct.pack(">ii2f12f", 2, 2, 0, 0.5, *points)


def edges():
    yield b"# cracks\n0 4\n1 4 # and another\n\n2 4\n"
    yield b"\xef\xbb\xbf4 0\r\n4 3\r\n"


def block(name, content):
    return struct.pack(">I", len(content)) + name + content + struct.pack(">I", zlib.crc32(name + content))


def png():
    """Yields pictures of 2 x 3 pixels of every colour type and depth, and an interlaced pixel."""
    channels = {0: 1, 2: 3, 3: 1, 4: 2, 6: 4}
    for colour, depths in {0: (1, 2, 4, 8, 16), 2: (8, 16), 3: (1, 2, 4, 8), 4: (8, 16), 6: (8, 16)}.items():
        for depth in depths:
            row = b"\0" + bytes(range((2 * channels[colour] * depth + 7) // 8))
            yield (b"\x89PNG\r\n\x1a\n" + block(b"IHDR", struct.pack(">IIBBBBB", 2, 3, depth, colour, 0, 0, 0))
                   + (block(b"PLTE", bytes(range(6))) + block(b"tRNS", b"\x10") if colour == 3 else b"")
                   + block(b"IDAT", zlib.compress(3 * row)) + block(b"IEND", b""))
    # A block that is not pixels and claims a length of a gigabyte.
    yield (b"\x89PNG\r\n\x1a\n" + block(b"IHDR", struct.pack(">IIBBBBB", 2, 3, 8, 0, 0, 0, 0))
           + struct.pack(">I", 1 << 30) + b"eXIfMM" + bytes(40))
    one = b"\0\1\2\3"
    yield (b"\x89PNG\r\n\x1a\n" + block(b"IHDR", struct.pack(">IIBBBBB", 1, 1, 8, 2, 0, 0, 1))
           + block(b"gAMA", b"\0\0\1\0") + block(b"IDAT", zlib.compress(one)) + block(b"IEND", b""))


def scene():
    """Yields the project's scenes, with the name of their first variant as the first line."""
    for file in sorted([*ROOT.glob("scenes/*.toml"), *ROOT.glob("scenes/paper/*.toml"),
                        *ROOT.glob("tests/frozen/*.toml")]):
        text = "\n".join(line for line in file.read_text().splitlines() if not line.lstrip().startswith("#"))
        variant = re.search(r"^\[variant\.(\w+)", text, re.MULTILINE)
        yield (f"#{variant.group(1)}\n" if variant else "").encode() + text.encode()


def study():
    for file in sorted(ROOT.glob("scenes/studies/*.toml")):
        yield file.read_bytes()
    yield (b'scene = "a"\nvariant = "b"\nset = ["c=1"]\ndesign = "latin"\nsamples = 5\nseed = 2\nrepeats = 2\n'
           b'about = [0, 0, 1]\nradius = 0.1\npython = "d.py"\nkeep = "failed"\nmeasures = ["peak_force.floor"]\n'
           b'[parameters]\nsheet.a.b = { uniform = [1, 2] }\nc = { set = ["d={}", "e=[{}, 0]"], values = ["x", 2, true] }\n'
           b'n = { normal = [0, 1] }\nl = { log_uniform = [1e-3, 1] }\nm = { lognormal = [1, 2] }\n'
           b'[slurm]\npartition = "p"\naccount = "q"\ntime = "1:00"\nmemory = "1G"\nchunk = 3\n')
    yield (b'scene = "a"\ndesign = "zip"\n[parameters]\na = { from = 1, to = 8, steps = 4, log = true }\n'
           b'b = { from = 0, to = 0.3, step = 0.1 }\n')


def csv():
    yield b'row,sheet.velocity,message\n0,1.5,\n1,"a, ""b""\nc",nan\r\n'


def seeds(name):
    return list(globals()[name]())


def words(name):
    """Returns the words of an input's dictionary: short string literals of the sources that read it, and numbers."""
    found = set(NUMBERS)
    for source in SOURCES[name]:
        path = ROOT / source
        for file in sorted(path.rglob("*.cpp")) if path.is_dir() else [path]:
            found.update(re.findall(r'"([A-Za-z_][\w. -]{0,24})"', file.read_text()))
    if name == "png":
        found = {"IHDR", "PLTE", "IDAT", "IEND", "tRNS", "gAMA", "iCCP", "sBIT", "sRGB", "cHRM", "zTXt", "iTXt", "eXIf"}
    return sorted(found)


def dictionary(name):
    """Returns the dictionary of an input in the format of libFuzzer."""
    return "".join('"' + "".join(f"\\x{byte:02x}" for byte in word.encode()) + '"\n' for word in words(name))
