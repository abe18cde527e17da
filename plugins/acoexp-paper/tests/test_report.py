"""``report=paper`` as a whole."""

from __future__ import annotations

import json
import re
import shutil
import subprocess
import sys
from dataclasses import replace
from html import unescape
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from acoexp_paper.claims.words import VERDICTS
from acoexp_paper.report import Paper
from acoexp_paper.trials.experiment import Experiment
from PIL import Image
from small import ENSEMBLE_TRIALS, FIGURES, MAPS, OWN, TABLES, TRIALS, context

from acoexp import solve_many
from acoexp.errors import AcoexpError
from acoexp.registry.load_map import load_map
from acoexp.registry.resolve import resolve

pytestmark = pytest.mark.slow_without_jit

CHROMIUM = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")
PDFLATEX = shutil.which("pdflatex")

_FLAGS = (
    "--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-sync",
    "--disable-background-networking", "--disable-component-update", "--window-size=1100,900",
)  # fmt: skip
_MEASURE = """\
<pre id="measured"></pre><script>
const boxes = {};
for (const folded of document.querySelectorAll("details")) folded.open = true;
for (const figure of document.querySelectorAll("figure")) {
  const box = figure.querySelector("svg, table").getBoundingClientRect();
  const within = figure.querySelector("svg, div").getBoundingClientRect();
  boxes[figure.id] = [box.width, box.height, within.right];
}
document.getElementById("measured").textContent = JSON.stringify([boxes, document.documentElement.scrollWidth]);
</script>
"""


def content(report: Path) -> dict[str, Any]:
    found: dict[str, Any] = json.loads((report / "tables.json").read_text(encoding="utf-8"))
    return found


def average(report: Path, *where: object) -> dict[str, Any]:
    keys = ("table", "map", "algorithm", "column")
    (found,) = (row for row in content(report)["tables"] if tuple(row[key] for key in keys) == where)
    return dict(found)


def test_it_leaves_every_table_and_figure_in_every_form(report: Path) -> None:
    names = {str(path.relative_to(report)) for path in report.rglob("*") if path.is_file()}
    assert names == {
        "index.html",
        "report.md",
        "tables.json",
        "time.json",
        "tables/all.tex",
        *(f"figures/{name}.{form}" for name in FIGURES for form in ("svg", "png")),
        *(f"tables/{name}.{form}" for name in TABLES for form in ("md", "tex", "csv")),
    }
    for name in FIGURES:
        with Image.open(report / "figures" / f"{name}.png") as picture:
            assert min(picture.size) > 200


def test_an_average_is_what_its_trials_say(report: Path) -> None:
    trials = solve_many("fig13", "pdg", seeds=range(TRIALS), **OWN)
    x1 = np.array([trial.x1 for trial in trials])
    row = average(report, 1, "fig13", "pdg", "x1")
    assert row["published"] == 2.6
    assert row["mean"] == pytest.approx(x1.mean())
    assert row["first_ten"] == pytest.approx(x1[:10].mean())
    low, high = row["interval"]
    means = [np.random.default_rng(seed).choice(x1, 10).mean() for seed in range(4000)]
    assert np.mean((np.array(means) >= low) & (np.array(means) <= high)) == pytest.approx(0.95, abs=0.03)
    assert row["inside"] == (low - 0.05 <= 2.6 <= high + 0.05)


def test_success_is_counted_over_ten_trials(report: Path) -> None:
    trials = solve_many("env2", "pf", seeds=range(TRIALS), **OWN)
    found = np.array([trial.found_optimum for trial in trials])
    row = average(report, 3, "env2", "pf", "n_c")
    assert row["first_ten"] == found[:10].sum()
    assert row["mean"] == pytest.approx(10 * found.mean())


def test_tables_have_the_papers_form(report: Path) -> None:
    lines = (report / "tables" / "table1.csv").read_text(encoding="utf-8").splitlines()
    assert lines[0].startswith("Algorithm,Trial,ours x1,ours l1,ours x2,ours l2,ours x3,paper x1,")
    assert [line.split(",")[0] for line in lines[1:]].count("Average result") == 3
    assert len(lines) == 1 + 3 * 11
    latex = (report / "tables" / "table1.tex").read_text(encoding="utf-8")
    assert all(rule in latex for rule in (r"\toprule", r"\midrule", r"\bottomrule"))


def test_every_claim_has_its_effect_over_all_maps_and_a_verdict(report: Path) -> None:
    for claim in content(report)["claims"]:
        assert len(claim["on_maps"]) == 1 + MAPS
        assert 0.0 <= claim["p"] <= claim["p_holm"] <= 1.0
        assert claim["verdict"] in VERDICTS


def test_claims_averages_and_tables_are_of_the_same_trials(report: Path) -> None:
    claims = {claim["key"]: claim for claim in content(report)["claims"]}
    count = claims["fig13: ACO-PD converges to the optimum in 6 of ten trials"]["on_maps"][0]["effect"]
    trials = solve_many("fig13", "pd", seeds=range(TRIALS), **OWN)
    assert count == pytest.approx(10 * np.mean([trial.l2 == trial.grid.optimum for trial in trials]))
    mean = claims["fig13: ACO-PDG needs 2.6 iterations on average"]["on_maps"][0]["effect"]
    assert mean == average(report, 1, "fig13", "pdg", "x1")["mean"]


def test_its_headline_counts_the_verdicts_of_each_environment(smaller: Paper, report: Path) -> None:
    headings, *rows = smaller.headline(report)
    assert headings == ["claims", *VERDICTS]
    assert [row[0] for row in rows] == ["fig13", "env1", "env2"]
    claims = [claim for claim in content(report)["claims"] if claim["map"] == "env2" and not claim["fitted"]]
    verdicts = [claim["verdict"] for claim in claims]
    assert rows[2][1:] == [str(verdicts.count(verdict)) for verdict in headings[1:]]


def test_it_says_first_what_holds(report: Path) -> None:
    text = (report / "report.md").read_text(encoding="utf-8")
    assert text.index("## Summary") < text.index("## The claims") < text.index("## Tables 1 to 3")
    verdicts = [claim["verdict"] for claim in content(report)["claims"] if not claim["fitted"]]
    assert f"Of {len(verdicts)} claims that the maps were not fitted to, " in text


def test_written_again_its_tables_are_the_same_bytes(smaller: Paper, report: Path, tmp_path: Path) -> None:
    again = smaller.write(context(tmp_path / "paper"))
    files = [
        "index.html",
        "tables.json",
        "report.md",
        *(f"tables/{f.name}" for f in (report / "tables").iterdir()),
    ]
    files += [f"figures/{f.name}" for f in (report / "figures").iterdir()]
    assert [name for name in files if (report / name).read_bytes() != (again / name).read_bytes()] == []


def test_what_was_there_stays_if_it_cannot_be_written(report: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    before = (report / "index.html").read_bytes()
    monkeypatch.setattr("acoexp_paper.figures.everything.save_figures", lambda *_: 1 / 0)
    with pytest.raises(ZeroDivisionError):
        Paper(trials=10, ensemble_trials=0, reading_trials=0).write(context(report))
    assert (report / "index.html").read_bytes() == before


def test_a_true_map_takes_the_place_of_the_reconstruction_and_its_ensemble(smaller: Paper, tmp_path: Path) -> None:
    grid = load_map("fig13")
    rows = "\n".join("".join(".#"[cell] for cell in row) for row in grid.obstacles.astype(int))
    (tmp_path / "true.txt").write_text(f"; moves: {grid.moves}\n{rows}\n", encoding="utf-8")
    paper = replace(smaller, maps=(f"fig13={tmp_path / 'true.txt'}",))
    given = paper.true_maps()
    assert given["fig13"].digest == grid.digest
    maps = {"fig13": given["fig13"], "env2": load_map("env2")}
    experiment = Experiment(context(tmp_path), maps, frozenset(given), 10, ENSEMBLE_TRIALS)
    assert experiment.further_maps("fig13") == []
    assert len(experiment.further_maps("env2")) == MAPS


@pytest.mark.parametrize(
    ("given", "message"),
    [
        (
            "env3=x.txt",
            "report.maps: expected some of: fig13=path, env1=path, env2=path, each once; got 'env3=x.txt'",
        ),
        ("fig13", "report.maps: expected some of: .* got 'fig13'"),
        ("fig13=nowhere.txt", "report.maps: fig13: map.path: expected a readable text file"),
        (
            "env1=empty.txt",
            "report.maps: env1: expected a map with the published optimum, 32.1421; got one with 26.8701",
        ),
    ],
)
def test_a_map_that_is_not_the_papers_is_refused(
    given: str, message: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("empty.txt").write_text(("." * 20 + "\n") * 20, encoding="utf-8")
    with pytest.raises(AcoexpError, match=message):
        Paper(maps=(given,)).check(context(tmp_path))


def test_settings_that_would_not_be_used_are_refused(tmp_path: Path) -> None:
    other_map = replace(context(tmp_path), grid=load_map("env2"))
    with pytest.raises(AcoexpError, match="map: expected none with report=paper"):
        Paper().check(other_map)
    other_part = replace(context(tmp_path), settings=resolve("pdg", {"post": "none"}))
    with pytest.raises(AcoexpError, match="post: expected none with report=paper"):
        Paper().check(other_part)
    hasty = replace(context(tmp_path), settings=resolve("pdg", {"patience": 5}))
    with pytest.raises(AcoexpError, match="patience: expected none with report=paper"):
        Paper().check(hasty)


def test_the_command_finds_it_by_its_entry_point(tmp_path: Path) -> None:
    left_out = ("report.ensemble_trials=0", "report.reading_trials=0")
    small = ("report.trials=10", *left_out, "iterations=4", "ants=3", "tracking=none")
    command = [sys.executable, "-m", "acoexp", "report=paper", *small]
    ended = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, timeout=300, check=False)
    assert ended.returncode == 0, ended.stderr
    assert "depends on the map" in ended.stdout
    assert (tmp_path / "outputs" / "reports" / "paper" / "index.html").exists()


@pytest.mark.skipif(CHROMIUM is None, reason="no chromium to open the page in")
def test_a_browser_shows_every_table_and_figure(report: Path, tmp_path: Path) -> None:
    html = (report / "index.html").read_text(encoding="utf-8")
    page = tmp_path / "page.html"
    page.write_text(html.replace("</body>", f"{_MEASURE}</body>"), encoding="utf-8")
    command = [str(CHROMIUM), *_FLAGS, f"--user-data-dir={tmp_path / 'profile'}", "--dump-dom", page.as_uri()]
    shown = subprocess.run(command, capture_output=True, text=True, timeout=120, check=True).stdout
    found = re.search(r'<pre id="measured">(.*?)</pre>', shown, re.DOTALL)
    assert found is not None
    boxes, width = json.loads(unescape(found[1]))
    assert set(boxes) == {*FIGURES, *TABLES}
    assert width <= 1100
    for name, (wide, high, right) in boxes.items():
        assert wide > 150, name
        assert high > 40, name
        assert right <= 1100, name


@pytest.mark.skipif(PDFLATEX is None, reason="no pdflatex to set the tables with")
def test_latex_sets_all_tables_on_a4_within_the_margins(report: Path, tmp_path: Path) -> None:
    shutil.copytree(report / "tables", tmp_path / "tables")
    command = [str(PDFLATEX), "-interaction=nonstopmode", "-halt-on-error", "all.tex"]
    ended = subprocess.run(
        command, cwd=tmp_path / "tables", capture_output=True, text=True, timeout=120, check=False
    )
    assert ended.returncode == 0, ended.stdout[-2000:]
    log = (tmp_path / "tables" / "all.log").read_text(encoding="latin-1")
    too_wide = [float(points) for points in re.findall(r"Overfull \\hbox \((.*?)pt", log)]
    assert [points for points in too_wide if points > 1] == []
    text = (report / "tables" / "all.tex").read_text(encoding="utf-8")
    assert re.findall(r"\\input{(.*?)}", text) == TABLES


def test_it_needs_no_other_file_and_links_to_doi_alone(report: Path) -> None:
    html = (report / "index.html").read_text(encoding="utf-8")
    links = re.findall(r'(?:src|href)="(?!#|data:)([^"]*)"', html)
    assert all(link.startswith("https://doi.org/10.") for link in links)
    assert html.count(' src="') == html.count(' src="data:')


def test_every_link_of_the_page_has_one_target(report: Path) -> None:
    html = (report / "index.html").read_text(encoding="utf-8")
    targets = re.findall(r'<(?:section|figure)(?: class="table")? id="([^"]*)"', html)
    links = re.findall(r'<a href="#([^"]*)"', html)
    assert sorted(targets) == sorted({*links, "summary"})
    assert not re.search(r"url\((?!#)", html)
