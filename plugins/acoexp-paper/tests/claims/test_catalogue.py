"""The paper's claims as they were typed out, held against its tables."""

from __future__ import annotations

from acoexp_paper.claims.catalogue import CLAIMS
from acoexp_paper.claims.statements import CountIs, MeanIs
from acoexp_paper.published import tables
from acoexp_paper.published.tables import ENVIRONMENTS, TABLES


def test_no_two_claims_are_one() -> None:
    assert len({claim.key for claim in CLAIMS}) == len(CLAIMS)


def test_a_claim_is_about_algorithms_that_the_paper_ran_on_its_map() -> None:
    assert [c.key for c in CLAIMS if not set(c.kind.algos) <= set(ENVIRONMENTS[c.map].algos)] == []


def test_printed_means_are_those_of_the_tables() -> None:
    table_of = {env: table for table, env in TABLES.items()}
    for claim in CLAIMS:
        if isinstance(claim.kind, MeanIs):
            column, algo, printed = claim.kind.what, claim.kind.algo, claim.kind.printed
            of_table_3 = column == "n_bar"
            assert printed == (
                tables.performance(claim.map, algo, column)
                if of_table_3
                else tables.average(table_of[claim.map], algo, column)
            ), claim.key


def test_printed_counts_of_convergence_are_those_of_the_rows_but_for_one_that_says_so() -> None:
    table_of = {env: table for table, env in TABLES.items()}
    for claim in CLAIMS:
        if isinstance(claim.kind, CountIs) and claim.kind.what in ("converged", "stuck") and claim.map in table_of:
            l2 = tables.column(table_of[claim.map], claim.kind.algo, "l2")
            converged = int((l2 == round(ENVIRONMENTS[claim.map].optimum, 4)).sum())
            rows = converged if claim.kind.what == "converged" else l2.size - converged
            assert (claim.kind.printed == rows) == ("rows show" not in claim.remark), claim.key


def test_the_search_for_the_maps_looked_at_standard_aco_alone() -> None:
    assert {claim.kind.algos for claim in CLAIMS if claim.fitted} == {("aco",)}
