"""Pixels: the same from every format, and what is broken, deep or too large is refused at little cost."""

from __future__ import annotations

import struct
import zlib
from io import BytesIO
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image

from acoexp import MapError
from acoexp.maps.pixels import MOST, read_pixels

GREY = np.array([[0, 100, 205], [254, 255, 7]], dtype=np.uint8)


def written(tmp_path: Path, content: bytes) -> Path:
    (tmp_path / "yard").write_bytes(content)
    return tmp_path / "yard"


def encoded(array: Any, kind: str, **options: Any) -> bytes:
    """Return an image's file."""
    buffer = BytesIO()
    Image.fromarray(array).save(buffer, kind, **options)
    return buffer.getvalue()


def png(width: int, height: int) -> bytes:
    """Return a small file that says to have many pixels."""
    chunks = b""
    for kind, data in (
        (b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 0, 0, 0, 0)),
        (b"IDAT", zlib.compress(bytes(10**6))),
        (b"IEND", b""),
    ):
        chunks += struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    return b"\x89PNG\r\n\x1a\n" + chunks


def refusal(tmp_path: Path, content: bytes) -> str:
    with pytest.raises(MapError) as caught:
        read_pixels(written(tmp_path, content), "map.path")
    assert "\n" not in str(caught.value)
    return str(caught.value).replace(str(tmp_path), "")


@pytest.mark.parametrize(
    "content",
    [
        b"P5\n3 2\n255\n" + GREY.tobytes(),
        b"P5\n# drawn by hand\n3 2\n# 0.05 m\n255\n" + GREY.tobytes(),
        b"P2\n# drawn by hand\n3 2\n255\n0 100 205\n254 255 7\n",
        *(encoded(GREY, kind) for kind in ("PNG", "BMP", "TGA", "PPM")),
        encoded(np.stack([GREY] * 3, axis=2), "PNG"),
        encoded(np.stack([GREY] * 3, axis=2), "TGA", compression="tga_rle"),
        encoded(np.stack([GREY] * 3, axis=2), "PPM"),
    ],
)
def test_every_format_has_the_same_pixels(tmp_path: Path, content: bytes) -> None:
    pixels = read_pixels(written(tmp_path, content), "map.path")
    assert pixels[..., :3].tolist() == np.stack([GREY] * 3, axis=2).tolist()
    assert (pixels[..., 3] == 255).all()


def test_a_jpeg_has_about_the_same(tmp_path: Path) -> None:
    large = np.kron(GREY, np.ones((16, 16), np.uint8))
    pixels = read_pixels(written(tmp_path, encoded(large, "JPEG", quality=95)), "map.path")
    assert np.abs(pixels[8::16, 8::16, 0].astype(int) - GREY).max() <= 3


def test_colours_and_alpha_are_kept(tmp_path: Path) -> None:
    colours = np.arange(24, dtype=np.uint8).reshape(2, 3, 4)
    assert read_pixels(written(tmp_path, encoded(colours, "PNG")), "map.path").tolist() == colours.tolist()
    clear = read_pixels(written(tmp_path, encoded(GREY, "PNG", transparency=100)), "map.path")
    assert clear[..., 3].tolist() == [[255, 0, 255], [255, 255, 255]]


def test_a_pgm_of_another_depth_is_scaled(tmp_path: Path) -> None:
    pixels = read_pixels(written(tmp_path, b"P2\n3 1\n100\n0 50 100\n"), "map.path")
    assert pixels[0, :, 0].tolist() == [0, 128, 255]


@pytest.mark.parametrize(
    "content",
    [
        encoded(GREY.astype(np.uint16) * 257, "PNG"),
        b"P5\n3 2\n65535\n" + bytes(12),
        b"P2\n1 1\n1000\n500\n",
    ],
)
def test_channels_of_16_bits_are_refused(tmp_path: Path, content: bytes) -> None:
    said = refusal(tmp_path, content)
    assert said.startswith(
        "map.path: expected an image in grey or colour of at most 8 bits a channel; got '/yard' ("
    )


@pytest.mark.parametrize(("width", "height"), [(8193, 8192), (10_000, 10_000), (30_000, 30_000), (2**31 - 1, 2)])
def test_what_says_to_be_too_large_is_not_decoded(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, width: int, height: int
) -> None:
    monkeypatch.setattr("PIL.ImageFile.ImageFile.load", lambda image: pytest.fail("it is decoded"))
    assert width * height > MOST
    for content in (png(width, height), f"P5\n{width} {height}\n255\n".encode() + bytes(100)):
        said = refusal(tmp_path, content)
        assert said.startswith("map.path: expected an image of at most 67 megapixels; got '/yard'")


@pytest.mark.parametrize(
    "content",
    [
        b"",
        b"P5\n",
        b"P5\n3 2\n255\n" + GREY.tobytes()[:-1],
        b"P2\n3 2\n255\n0 1 2 3 4",
        b"P2\n3 2\n255\n0 1 2 3 4 x",
        b"P5\n0 2\n255\n",
        b"P5\n-3 2\n255\n",
        b"P5\n3 2\n0\n" + GREY.tobytes(),
        b"GIF89a" + bytes(100),
        b"..#\n...\n",
        encoded(GREY, "PNG")[:-30],
        png(100, 100)[:60],
        encoded(GREY, "BMP")[:40],
    ],
)
def test_what_is_broken_or_no_image_is_refused(tmp_path: Path, content: bytes) -> None:
    said = refusal(tmp_path, content)
    assert said.startswith(
        "map.path: expected an image that can be decoded, PNG, PGM, BMP, JPEG or TGA; got '/yard'"
    )


def test_what_is_no_file_is_refused_by_its_kind(tmp_path: Path) -> None:
    for path, kind in (
        (tmp_path, "a folder"),
        (Path("/dev/zero"), "a device"),
        (tmp_path / "no", "No such file or d"),
    ):
        with pytest.raises(MapError, match=rf"^map\.path: expected a readable image; got '{path}' \({kind}"):
            read_pixels(path, "map.path")
