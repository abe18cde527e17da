"""The claims of Sects 4 to 6, each with the trials that it is about and the kind of claim that it is."""

from __future__ import annotations

from typing import NamedTuple

from acoexp_paper.kinds import CountIs, Every, Fewer, Kind, MeanIs, MoreOften


class Claim(NamedTuple):
    """One claim.

    Attributes:
        key: A short name.
        where: Where the paper makes it.
        text: What it says.
        map: The environment it is about.
        kind: How it is tested.
        fitted: Whether the search for the maps looked at these numbers; then that it holds says little.
    """

    key: str
    where: str
    text: str
    map: str
    kind: Kind
    fitted: bool = False


CLAIMS = (
    Claim("pd-lost", "Sect. 4, Fig. 9", "ACO-PD loses fewer ants than standard ACO", "fig13", Fewer("lost ants", "pd", "aco")),
    Claim("pd-iterations", "Sect. 4, Fig. 10; Table 1", "ACO-PD finds the optimum in fewer iterations than standard ACO (7.9 against 11)", "fig13", Fewer("hitting time", "pd", "aco")),
    Claim("pd-length", "Sect. 4, Fig. 11; Table 1", "ACO-PD converges to shorter paths than standard ACO (31.7505 against 32.7747)", "fig13", Fewer("l2", "pd", "aco")),
    Claim("aco-finds", "Sect. 5, Table 1", "Every trial of standard ACO finds the optimum", "fig13", Every("found", "aco"), True),
    Claim("pd-finds", "Sect. 5, Table 1", "Every trial of ACO-PD finds the optimum", "fig13", Every("found", "pd")),
    Claim("pdg-finds", "Sect. 5, Table 1", "Every trial of ACO-PDG finds the optimum", "fig13", Every("found", "pdg")),
    Claim("aco-11", "Sect. 5, Table 1", "Standard ACO needs 11 iterations on average", "fig13", MeanIs("x1", "aco", 11.0), True),
    Claim("aco-3-of-10", "Sect. 5, Table 1", "Standard ACO converges to the optimum three times in ten, to a local one seven times", "fig13", CountIs("converged", "aco", 3), True),
    Claim("pd-7.9", "Sect. 5, Table 1", "ACO-PD needs 7.9 iterations on average", "fig13", MeanIs("x1", "pd", 7.9)),
    Claim("pd-6-of-10", "Sect. 5, Table 1", "ACO-PD converges to the optimum six times in ten", "fig13", CountIs("converged", "pd", 6)),
    Claim("pd-converges", "Sect. 5, Table 1", "ACO-PD converges to the optimum more often than standard ACO", "fig13", MoreOften("converged", "pd", "aco")),
    Claim("pd-gap", "Sect. 5, Table 1", "x2 - x1 is smaller for ACO-PD than for standard ACO", "fig13", Fewer("x2 - x1", "pd", "aco")),
    Claim("pdg-2.6", "Sect. 5, Table 1", "ACO-PDG needs 2.6 iterations on average", "fig13", MeanIs("x1", "pdg", 2.6)),
    Claim("pdg-always", "Sect. 5, Table 1", "Every trial of ACO-PDG converges to the optimum", "fig13", Every("converged", "pdg")),
    Claim("pdg-steady", "Sect. 5, Table 1", "x1 = x2 = x3 in every trial of ACO-PDG", "fig13", Every("steady", "pdg")),
    Claim("pdg-iterations", "Sect. 5, Table 1", "ACO-PDG finds the optimum in fewer iterations than ACO-PD", "fig13", Fewer("hitting time", "pdg", "pd")),
    Claim("pdg-settles", "Sect. 5, Table 1", "ACO-PDG settles (x3) earlier than ACO-PD", "fig13", Fewer("x3", "pdg", "pd")),
    Claim("pdg-converges", "Sect. 5, Table 1", "ACO-PDG converges to the optimum more often than ACO-PD", "fig13", MoreOften("converged", "pdg", "pd")),
    Claim("pd-lost-2", "Sects 5, 6", "ACO-PD loses fewer ants than standard ACO", "env2", Fewer("lost ants", "pd", "aco")),
    Claim("aco-5-of-10", "Sect. 5, Table 2", "Standard ACO finds the optimum five times in ten", "env2", CountIs("found", "aco", 5), True),
    Claim("aco-8-stuck", "Sect. 5, Table 2", "Standard ACO converges to a local optimum eight times in ten", "env2", CountIs("stuck", "aco", 8), True),
    Claim("pd-8-of-10", "Sect. 5, Table 2", "ACO-PD finds the optimum eight times in ten", "env2", CountIs("found", "pd", 8)),
    Claim("pd-stuck", "Sect. 5, Table 2", "ACO-PD converges to a local optimum five times in ten (its rows show four)", "env2", CountIs("stuck", "pd", 5)),
    Claim("pd-finds-more", "Sect. 5, Table 2", "ACO-PD finds the optimum more often than standard ACO", "env2", MoreOften("found", "pd", "aco")),
    Claim("pd-iterations-2", "Sect. 5, Table 2", "ACO-PD finds the optimum in fewer iterations than standard ACO (3.7 against 4.7)", "env2", Fewer("hitting time", "pd", "aco")),
    Claim("pd-converges-2", "Sect. 5, Table 2", "ACO-PD converges to the optimum more often than standard ACO", "env2", MoreOften("converged", "pd", "aco")),
    Claim("pd-gap-2", "Sect. 5, Table 2", "x2 - x1 is smaller for ACO-PD than for standard ACO", "env2", Fewer("x2 - x1", "pd", "aco")),
    Claim("pdg-1.2", "Sect. 5, Table 2", "ACO-PDG needs 1.2 iterations on average", "env2", MeanIs("x1", "pdg", 1.2)),
    Claim("pdg-finds-2", "Sect. 5, Tables 2, 3", "Every trial of ACO-PDG finds the optimum", "env2", Every("found", "pdg")),
    Claim("pdg-always-2", "Sect. 5, Table 2", "Every trial of ACO-PDG converges to the optimum", "env2", Every("converged", "pdg")),
    Claim("pdg-iterations-2", "Sect. 5, Table 2", "ACO-PDG finds the optimum in fewer iterations than ACO-PD", "env2", Fewer("hitting time", "pdg", "pd")),
    Claim("pdg-converges-2", "Sect. 5, Table 2", "ACO-PDG converges to the optimum more often than ACO-PD", "env2", MoreOften("converged", "pdg", "pd")),
    Claim("pf-finds-1", "Sect. 5, Table 3", "Every trial of ACO-PF finds the optimum", "env1", Every("found", "pf")),
    Claim("pdg-finds-1", "Sect. 5, Table 3", "Every trial of ACO-PDG finds the optimum", "env1", Every("found", "pdg")),
    Claim("pf-11", "Sect. 5, Table 3", "ACO-PF needs 11 iterations on average", "env1", MeanIs("n_bar", "pf", 11.0)),
    Claim("pdg-2", "Sect. 5, Table 3", "ACO-PDG needs 2 iterations on average", "env1", MeanIs("n_bar", "pdg", 2.0)),
    Claim("pdg-beats-pf-1", "Sect. 5, Table 3", "ACO-PDG finds the optimum in fewer iterations than ACO-PF (2 against 11)", "env1", Fewer("hitting time", "pdg", "pf")),
    Claim("pf-finds-2", "Sect. 5, Table 3", "Every trial of ACO-PF finds the optimum", "env2", Every("found", "pf")),
    Claim("pf-12", "Sect. 5, Table 3", "ACO-PF needs 12 iterations on average", "env2", MeanIs("n_bar", "pf", 12.0)),
    Claim("pdg-2.2", "Sect. 5, Table 3", "ACO-PDG needs 2.2 iterations on average (1.2 in Table 2)", "env2", MeanIs("n_bar", "pdg", 2.2)),
    Claim("pdg-beats-pf-2", "Sect. 5, Table 3", "ACO-PDG finds the optimum in fewer iterations than ACO-PF (2.2 against 12)", "env2", Fewer("hitting time", "pdg", "pf")),
)  # fmt: skip
"""All of them; lines too long for the formatter are one claim each."""
