"""The claims of Sects 4 to 6, each with the trials that it is about and the kind of claim that it is."""

from __future__ import annotations

from acoexp_paper.claims.comparisons import Fewer, MoreOften
from acoexp_paper.claims.kinds import Claim
from acoexp_paper.claims.statements import CountIs, Every, MeanIs

CLAIMS = (
    Claim("Sect. 4, Fig. 9", "fig13", Fewer("lost ants", "pd", "aco")),
    Claim("Sect. 4, Fig. 10; Table 1", "fig13", Fewer("hitting time", "pd", "aco"), "7.9 against 11"),
    Claim("Sect. 4, Fig. 11; Table 1", "fig13", Fewer("l2", "pd", "aco"), "31.7505 against 32.7747"),
    Claim("Sect. 5, Table 1", "fig13", Every("found", "aco"), fitted=True),
    Claim("Sect. 5, Table 1", "fig13", Every("found", "pd")),
    Claim("Sect. 5, Table 1", "fig13", Every("found", "pdg")),
    Claim("Sect. 5, Table 1", "fig13", MeanIs("x1", "aco", 11.0), fitted=True),
    Claim("Sect. 5, Table 1", "fig13", CountIs("converged", "aco", 3), fitted=True),
    Claim("Sect. 5, Table 1", "fig13", MeanIs("x1", "pd", 7.9)),
    Claim("Sect. 5, Table 1", "fig13", CountIs("converged", "pd", 6)),
    Claim("Sect. 5, Table 1", "fig13", MoreOften("converged", "pd", "aco")),
    Claim("Sect. 5, Table 1", "fig13", Fewer("x2 - x1", "pd", "aco")),
    Claim("Sect. 5, Table 1", "fig13", MeanIs("x1", "pdg", 2.6)),
    Claim("Sect. 5, Table 1", "fig13", Every("converged", "pdg")),
    Claim("Sect. 5, Table 1", "fig13", Every("steady", "pdg")),
    Claim("Sect. 5, Table 1", "fig13", Fewer("hitting time", "pdg", "pd")),
    Claim("Sect. 5, Table 1", "fig13", Fewer("x3", "pdg", "pd")),
    Claim("Sect. 5, Table 1", "fig13", MoreOften("converged", "pdg", "pd")),
    Claim("Sects 5, 6", "env2", Fewer("lost ants", "pd", "aco")),
    Claim("Sect. 5, Table 2", "env2", CountIs("found", "aco", 5), fitted=True),
    Claim("Sect. 5, Table 2", "env2", CountIs("stuck", "aco", 8), fitted=True),
    Claim("Sect. 5, Table 2", "env2", CountIs("found", "pd", 8)),
    Claim("Sect. 5, Table 2", "env2", CountIs("stuck", "pd", 5), "its rows show four"),
    Claim("Sect. 5, Table 2", "env2", MoreOften("found", "pd", "aco")),
    Claim("Sect. 5, Table 2", "env2", Fewer("hitting time", "pd", "aco"), "3.7 against 4.7"),
    Claim("Sect. 5, Table 2", "env2", MoreOften("converged", "pd", "aco")),
    Claim("Sect. 5, Table 2", "env2", Fewer("x2 - x1", "pd", "aco")),
    Claim("Sect. 5, Table 2", "env2", MeanIs("x1", "pdg", 1.2)),
    Claim("Sect. 5, Tables 2, 3", "env2", Every("found", "pdg")),
    Claim("Sect. 5, Table 2", "env2", Every("converged", "pdg")),
    Claim("Sect. 5, Table 2", "env2", Fewer("hitting time", "pdg", "pd")),
    Claim("Sect. 5, Table 2", "env2", MoreOften("converged", "pdg", "pd")),
    Claim("Sect. 5, Table 3", "env1", Every("found", "pf")),
    Claim("Sect. 5, Table 3", "env1", Every("found", "pdg")),
    Claim("Sect. 5, Table 3", "env1", MeanIs("n_bar", "pf", 11.0)),
    Claim("Sect. 5, Table 3", "env1", MeanIs("n_bar", "pdg", 2.0)),
    Claim("Sect. 5, Table 3", "env1", Fewer("hitting time", "pdg", "pf"), "2 against 11"),
    Claim("Sect. 5, Table 3", "env2", Every("found", "pf")),
    Claim("Sect. 5, Table 3", "env2", MeanIs("n_bar", "pf", 12.0)),
    Claim("Sect. 5, Table 3", "env2", MeanIs("n_bar", "pdg", 2.2), "1.2 in Table 2"),
    Claim("Sect. 5, Table 3", "env2", Fewer("hitting time", "pdg", "pf"), "2.2 against 12"),
)
