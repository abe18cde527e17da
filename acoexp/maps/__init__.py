"""Where maps come from: the package's own, a file, or whatever an installed package registers."""

from acoexp.maps.ensemble import ensemble
from acoexp.maps.source import MapSource
from acoexp.maps.text import parse_map

__all__ = ["MapSource", "ensemble", "parse_map"]
