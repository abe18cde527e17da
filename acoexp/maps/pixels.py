"""The pixels of an image: PNG, BMP, JPEG, TGA, and PGM with its kin, by Pillow, and no more than a map can use."""

from __future__ import annotations

import warnings
from io import BytesIO
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from acoexp.console.plain import one_line
from acoexp.errors import MapError, shown
from acoexp.maps.reading import read_image

MOST = 2**26
"""Pixels that an image may have, 8192 x 8192: its header says how many, and what has more is not decoded."""

MOST_CELLS = 2**24
"""Cells that a map from an image may have, 4096 x 4096: mapping software writes 4000 x 4000 if nothing is said."""

_FORMATS = ("PNG", "PPM", "BMP", "JPEG", "TGA")
_MODES = ("1", "L", "LA", "P", "PA", "RGB", "RGBA")
"""Pillow's modes of 8 bits a channel at most, in grey or colour."""


def read_pixels(path: Path, key: str, scale: int = 1) -> NDArray[np.uint8]:
    """Return the pixels of an image's file.

    Args:
        path: The file.
        key: The key that it was given by, for messages.
        scale: Side of a cell in pixels.

    Returns:
        uint8[rows, columns, 4]: red, green, blue, and alpha, which is 255 where nothing shines through.

    Raises:
        MapError: if it is no readable file, no image of one of the formats or a broken one, has more than
            ``MOST`` pixels or ``MOST_CELLS`` cells, or channels of more than 8 bits.
    """
    from PIL import Image, UnidentifiedImageError

    content, name = BytesIO(read_image(path, key)), shown(str(path))
    limit = f"{key}: expected an image of at most {MOST / 1e6:.0f} megapixels; got {name}"
    try:
        with warnings.catch_warnings():
            # Pillow has a limit of its own, which is larger
            warnings.simplefilter("ignore", Image.DecompressionBombWarning)
            image = Image.open(content, formats=_FORMATS)
            width, height = image.size
            if width * height > MOST:
                raise MapError(f"{limit} ({width} x {height})")
            if -(-width // scale) * -(-height // scale) > MOST_CELLS:
                cells = f"{MOST_CELLS / 1e6:.0f} million cells, each of {scale} x {scale} pixels"
                raise MapError(f"{key}: expected an image of at most {cells}; got {name} ({width} x {height})")
            if image.mode not in _MODES or any("16" in str(tile[3]) for tile in image.tile):
                raise MapError(
                    f"{key}: expected an image in grey or colour of at most 8 bits a channel; got {name} "
                    f"(mode {image.mode}{'' if image.mode not in _MODES else ', 16 bits'})"
                )
            return np.asarray(image.convert("RGBA"))
    except MapError:
        raise
    except Image.DecompressionBombError as problem:
        raise MapError(f"{limit}, which has more") from problem
    except Exception as problem:  # a decoder raises what it likes at a broken file
        reason = "no such image" if isinstance(problem, UnidentifiedImageError) else one_line(str(problem))
        raise MapError(
            f"{key}: expected an image that can be decoded, PNG, PGM, BMP, JPEG or TGA; got {name} ({reason})"
        ) from problem
