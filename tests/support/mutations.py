"""Small valid files of every format that a map may have, and what becomes of them in a hard life."""

from __future__ import annotations

import random
import struct
import zlib
from io import BytesIO
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray
from PIL import Image as Pillow

from acoexp.maps.file import MapFile
from acoexp.maps.image import Image
from acoexp.maps.movingai import MovingAI
from acoexp.maps.ros import Ros
from acoexp.maps.source import MapSource
from acoexp.parameters import build

_TOKENS = (
    *(
        b"\0",
        b"\n",
        b"\r\n",
        b"\t",
        b" ",
        b"\x1a",
        b"\xff\xfe",
        b"\xef\xbb\xbf",
        b"\xed\xa0\x80",
        b"#",
        b"%",
        b";",
    ),
    *(b"-1", b"0", b"1", b"2", b"255", b"256", b"65535", b"65536", b"4294967296", b"9" * 400, b"9" * 5000),
    *(
        b"nan",
        b".nan",
        b".inf",
        b"-.inf",
        b"1e999",
        b"1e-320",
        b"0x10",
        b"1_0",
        b"1:2:3",
        b"2020-99-99",
        b"~",
        b"null",
    ),
    *(
        b"&a ",
        b"*a",
        b"&a [*a]",
        b"!!timestamp ",
        b"!!binary ",
        b"!!python/name:os.getcwd ",
        b"<<: ",
        b"? ",
        b"- ",
    ),
    *(b"[", b"[" * 4000, b"{", b"]", b"}", b"'", b'"', b": ", b"../", b"/dev/zero", b"true", b"raw", b"scale"),
    *(b"\xff" * 4, b"\x7f\xff\xff\xff", b"\0" * 64, b"P2", b"P5", b"P6", b"P4", b"Pf", b"IHDR", b"PLTE", b"tRNS"),
)


class Format(NamedTuple):
    """A way to write a map down.

    Attributes:
        source: What reads it.
        files: Small valid files by their names; the first is ``map.path``.
        options: Other parameters; one that is a file's name becomes that file's path.
    """

    source: type[MapSource]
    files: dict[str, bytes]
    options: dict[str, Any]

    def load(self, folder: Path, files: dict[str, bytes]) -> None:
        """Write files like these into a folder and read the map that they are."""
        for name, content in files.items():
            (folder / name).write_bytes(content)
        options = {key: str(folder / o) if o in [*files] else o for key, o in self.options.items()}
        build(self.source, {"path": str(folder / next(iter(files))), **options}, "map.").load()


def _npy(array: NDArray[Any]) -> bytes:
    """Return an array as NumPy's file."""
    file = BytesIO()
    np.save(file, array)
    return file.getvalue()


def _saved(kind: str, mode: str = "RGB", **options: Any) -> bytes:
    """Return an image of 6 x 4 pixels with a wall and two dots."""
    pixels = np.full((4, 6, 3), 254, dtype=np.uint8)
    pixels[:2, 3], pixels[0, 0], pixels[3, 5] = 0, (0, 200, 0), (220, 0, 0)
    buffer = BytesIO()
    Pillow.fromarray(pixels).convert(mode).save(buffer, kind, **options)
    return buffer.getvalue()


_YAML = (
    b"image: yard.img\nresolution: 0.5\norigin: [-1.0, 2.0, 0.5]\nnegate: 0\noccupied_thresh: 0.65\n"
    b"free_thresh: 0.196\nmode: trinary\n"
)
_ENDS = {"start": [1, 1], "goal": [2, 4]}
_IMAGES = {
    "png": _saved("PNG"),
    "png of a palette": _saved("PNG", "P"),
    "png with alpha": _saved("PNG", "RGBA"),
    "bmp": _saved("BMP"),
    "jpeg": _saved("JPEG", quality=95, subsampling=0),
    "tga": _saved("TGA", compression="tga_rle"),
    "pgm": _saved("PPM", "L"),
    "pgm in words": b"P2\n# drawn\n6 4\n100\n" + b"99 99 99 0 99 99\n" * 2 + b"99 99 99 99 99 99\n" * 2,
}

_WITH_DOTS = ("png", "bmp", "tga")

FORMATS = {
    "text": Format(MapFile, {"yard.txt": b"; moves: free\nS..#\n.#..\n...G\n"}, {}),
    "digits": Format(MapFile, {"yard.txt": b"0 0 0 1\n0 1 0 0\n0 0 0 0\n"}, {}),
    "csv": Format(MapFile, {"yard.csv": b"# a yard\n2,0,1\n0,1,0\n0,0,3\n"}, {}),
    "matlab": Format(MapFile, {"yard.m": b"yard = [2 0 1; ... a yard\n0, 1, 0 % wall\n0 0 3];\n"}, {}),
    "python": Format(MapFile, {"yard.py": b"yard = np.array([[2, 0, 1],\n [0, 1.0, 0], [0, 0, 3]])\n"}, {}),
    **{
        f"npy, {kind}": Format(MapFile, {"yard.npy": _npy(np.array([[0, 0], [1, 0]], kind))}, {})
        for kind in ("u1", "?", ">f8")
    },
    "movingai": Format(
        MovingAI,
        {"yard.map": b"type octile\nheight 3\nwidth 4\nmap\n.GSS\n@OTW\n....\n"},
        {"start": [0, 0], "goal": [0, 3]},
    ),
    "scenario": Format(
        MovingAI,
        {
            "yard.map": b"type octile\nheight 3\nwidth 4\nmap\n.GSS\n@OTW\n....\n",
            "yard.scen": b"version 1\n7\tmaps/yard.map\t4\t3\t0\t2\t3\t2\t3.00000000\n",
        },
        {"scenario": "yard.scen"},
    ),
    **{
        f"ros, {name}": Format(
            Ros, {"yard.yaml": _YAML, "yard.img": image}, {**_ENDS, "unit": "cell", "radius": 0.2}
        )
        for name, image in _IMAGES.items()
    },
    **{
        f"image, {name}": Format(Image, {"yard.img": image}, {} if name in _WITH_DOTS else _ENDS)
        for name, image in _IMAGES.items()
    },
}
"""Every format, by name. Whoever adds one adds it here."""


def mutated(draw: random.Random, files: dict[str, bytes]) -> dict[str, bytes]:
    """Return files one of which was changed in one to four places."""
    name = draw.choice(list(files))
    content = bytearray(files[name])
    for _ in range(draw.choice([1, 1, 1, 2, 4])):
        at, length = draw.randint(0, len(content)), draw.choice([0, 1, 1, 1, 2, 4, draw.randint(0, 40)])
        piece = bytes(content[at : at + length])
        content[at : at + length] = draw.choice(
            [
                b"",
                draw.choice(_TOKENS),
                draw.choice(_TOKENS),
                draw.randbytes(length),
                bytes(byte ^ 1 << draw.randrange(8) for byte in piece),
                piece * draw.choice([2, 3, 50]),
                draw.choice(list(files.values()))[:40],
            ]
        )
        if draw.random() < 0.05:
            del content[at:]
    return {**files, name: _with_true_sums(bytes(content)) if draw.random() < 0.7 else bytes(content)}


def _with_true_sums(content: bytes) -> bytes:
    """Return a PNG whose check sums are right again, so that more than its first one is looked at."""
    if not content.startswith(b"\x89PNG\r\n\x1a\n"):
        return content
    done, at = content[:8], 8
    while at + 12 <= len(content):
        (length,) = struct.unpack(">I", content[at : at + 4])
        body = content[at + 4 : at + 8 + length]
        done += content[at : at + 4] + body + struct.pack(">I", zlib.crc32(body))
        at += 12 + length
    return done + content[at:]
