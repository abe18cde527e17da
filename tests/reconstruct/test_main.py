"""``python -m acoexp.reconstruct``: what it writes, and what it says of what it can't do."""

from __future__ import annotations

from pathlib import Path

import pytest

from acoexp.maps import parse_map
from acoexp.reconstruct import calibration, search
from acoexp.reconstruct.__main__ import main


@pytest.fixture(autouse=True)
def _small(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(search, "_STARTS", 8)
    monkeypatch.setattr(search, "_MOST_TRIALS", 32)
    monkeypatch.setattr(calibration, "FRESH_SEEDS", range(20))


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ("env=nope", "env: expected one of: fig13, env1, env2; got 'nope'"),
        ("seed=abc", "seed: expected a whole number from 0 to 999999; got 'abc'"),
        ("steps=0", "steps: expected a whole number from 1 to 999999; got 0"),
        ("moves=nope", "moves: expected one of: free, no_squeeze, no_cut; got 'nope'"),
        ("nope=1", "nope is not a known key; expected one of: env, seed, runs, steps, moves, begin, threads, out"),
        ("env", "expected key=value; got 'env'"),
        ("moves=free begin=x", "moves: expected nothing beside begin, whose map has its rule; got 'free'"),
        ("seed=[1", "expected key=value with a plain value; got 'seed=[1'"),
    ],
)
def test_a_bad_setting_is_refused(
    given: str, said: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    with pytest.raises(SystemExit) as ended:
        main(given.split())
    assert ended.value.code == 1
    assert capsys.readouterr().err == f"acoexp: error: {said}\n"
    assert not list(tmp_path.iterdir())


def test_a_folder_that_cannot_be_is_refused(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "file"
    file.touch()
    with pytest.raises(SystemExit):
        main([f"out={file}"])
    assert f"out: expected a folder to write to; got '{file}'" in capsys.readouterr().err


def test_help_names_every_key(capsys: pytest.CaptureFixture[str]) -> None:
    main(["--help"])
    told = capsys.readouterr().out
    assert all(
        f"\n  {key} " in told for key in ("env", "seed", "runs", "steps", "moves", "begin", "threads", "out")
    )


@pytest.mark.slow_without_jit
def test_maps_do_not_depend_on_threads_and_each_says_how_to_find_it_again(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    main(["env=env1", "runs=2", "steps=4", "threads=2", "out=both"])
    for seed in (0, 1):
        text = (tmp_path / "both" / f"env1-0{seed}.txt").read_text(encoding="utf-8")
        module, *arguments = parse_map(text, name="found").metadata["command"].split()[2:]
        assert module == "acoexp.reconstruct"
        main([*arguments, "out=one"])
        assert (tmp_path / "one" / f"env1-0{seed}.txt").read_text(encoding="utf-8") == text


@pytest.mark.slow_without_jit
def test_a_run_may_go_on_from_another_map(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    main(["env=env1", "steps=1", "moves=no_squeeze", "out=first"])
    main(["env=env1", "steps=1", "seed=5", "begin=first/env1-00.txt", "out=then"])
    first, then = (
        parse_map((tmp_path / name).read_text(encoding="utf-8"), name=name)
        for name in ("first/env1-00.txt", "then/env1-05.txt")
    )
    assert then.moves == "no_squeeze"
    assert then.metadata["command"].endswith("seed=5 steps=1 begin=first/env1-00.txt")
    assert (first.obstacles != then.obstacles).mean() < 0.3


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (None, "begin: expected a readable text file; got 'my.txt' (No such file or directory)"),
        ("..\n..", "begin: expected a map file with a line '; rectangles: ...'; got 'my.txt'"),
        (
            "; rectangles: 0 0 a b\n..\n..",
            "begin: expected a map file with a line '; rectangles: ...'; got 'my.txt'",
        ),
        ("; rectangles: 0 0 1 2\n..\n..", "begin: expected a 20 x 20 map with the optimum of fig13; got 'my.txt'"),
    ],
)
def test_a_beginning_that_is_none_is_refused(
    text: str | None,
    said: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.chdir(tmp_path)
    if text is not None:
        Path("my.txt").write_text(text, encoding="utf-8")
    with pytest.raises(SystemExit):
        main(["begin=my.txt"])
    assert not Path("outputs").exists()
    assert capsys.readouterr().err == f"acoexp: error: {said}\n"
