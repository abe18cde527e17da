"""The references."""

from __future__ import annotations

import re

from acoexp_paper.page.references import references


def test_each_has_a_year_and_its_doi_where_there_is_one() -> None:
    (block,) = references()
    assert block.items[0].doi == "10.1007/s00500-016-2161-7"
    for source in block.items:
        assert re.search(r"\((19|20)\d\d\)", source.text)
        assert source.doi is None or re.fullmatch(r"10\.\d{4,}/\S+", source.doi)
