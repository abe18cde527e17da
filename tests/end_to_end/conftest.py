"""What tests of the docs share."""

from documented import as_a_reader  # noqa: F401
from pages import browser, show  # noqa: F401
