"""The contract's tests, for the author of a part to run over it with pytest.

from acoexp.testing import StrategyContract
from my_package.shy import Shy

class TestShy(StrategyContract):
    part = Shy()
"""

from acoexp.testing.checks import everything
from acoexp.testing.contract import StrategyContract

__all__ = ["StrategyContract", "everything"]
