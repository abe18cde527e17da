"""Make the README's pictures anew: python docs/images/make.py [trial | watching | comparison] (needs chromium)."""

from __future__ import annotations

import io
import json
import shutil
import subprocess
import sys
import tempfile
import time
import urllib.error
import urllib.parse
import urllib.request
from pathlib import Path

from PIL import Image
from playwright.sync_api import Page, sync_playwright

IMAGES = Path(__file__).parent
CYCLES, FRAMES_A_CYCLE = 7, 8
PORT = 5599
ADDRESS = f"http://127.0.0.1:{PORT}"
STORE = ["--backend-store-uri", "sqlite:///outputs/mlflow.db"]
CHROMIUM = [
    "chromium", "--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
    "--disable-background-networking", "--disable-component-update", "--disable-sync", "--window-size=1500,1300",
    "--virtual-time-budget=30000",
]  # fmt: skip


def acoexp(folder: Path, *arguments: str) -> None:
    """Run acoexp in a folder."""
    subprocess.run([sys.executable, "-m", "acoexp", *arguments], cwd=folder, check=True)


def trial(folder: Path) -> None:
    """One trial's two pictures, side by side."""
    acoexp(folder, "algo=pdg", "map=env1", "seed=2", "tracking=none")
    (run,) = {file.parent for file in folder.glob("outputs/runs/*/*/path.png")}
    left, right = (Image.open(run / f"{name}.png").convert("RGB") for name in ("path", "convergence"))
    whole = Image.new("RGB", (left.width + right.width, left.height), "white")
    whole.paste(left, (0, 0))
    whole.paste(right, (left.width, (left.height - right.height) // 2))
    whole.quantize(256).save(IMAGES / "trial.png", optimize=True)


def watching(folder: Path) -> None:
    """The first cycles of two colonies side by side, as the page of report=watch plays them."""
    acoexp(folder, "report=watch", "report.cells=[aco,pdg]", "map=env2", "seed=3", "tracking=none")
    page_file = folder / "outputs/reports/watch/index.html"
    with sync_playwright() as driver:
        browser = driver.chromium.launch(executable_path=shutil.which("chromium"), args=["--no-sandbox"])
        page = browser.new_page(viewport={"width": 900, "height": 720}, color_scheme="dark")
        page.goto(page_file.as_uri())
        page.wait_for_selector("canvas[aria-label]")
        frames = [frame_at(page, step / FRAMES_A_CYCLE) for step in range(CYCLES * FRAMES_A_CYCLE + 1)]
        browser.close()
    palette = frames[len(frames) // 4].quantize(80)
    first, *others = [frame.quantize(palette=palette, dither=Image.Dither.NONE) for frame in frames]
    first.save(
        IMAGES / "watching.gif", save_all=True, append_images=others, duration=[90] * len(others) + [2000], loop=0
    )


def frame_at(page: Page, time: float) -> Image.Image:
    """The page as it is at a time, in cycles."""
    page.evaluate(f"acoexp.seek({time})")
    return Image.open(io.BytesIO(page.screenshot())).convert("RGB")


def comparison(folder: Path) -> None:
    """MLflow's page that compares ten trials."""
    acoexp(folder, "algo=aco,pdg", "map=fig13", "-m", "seed=0-4")
    server = subprocess.Popen([sys.executable, "-m", "mlflow", "server", *STORE, "--port", str(PORT)], cwd=folder)
    try:
        runs = json.dumps(finished_runs())
        page = f"{ADDRESS}/#/compare-runs?runs={urllib.parse.quote(runs)}&experiments=%5B%221%22%5D"
        picture = folder / "page.png"
        subprocess.run(
            [*CHROMIUM, f"--user-data-dir={folder}/chromium", f"--screenshot={picture}", page], check=True
        )
        Image.open(picture).convert("RGB").crop((0, 0, 1100, 1300)).quantize(256).save(
            IMAGES / "mlflow.png", optimize=True
        )
    finally:
        server.terminate()
        server.wait()


def finished_runs() -> list[str]:
    """Ask the server for the runs, once it has come up."""
    query = json.dumps({"experiment_ids": ["1"]}).encode()
    address = f"{ADDRESS}/ajax-api/2.0/mlflow/runs/search"
    for _ in range(60):
        try:
            request = urllib.request.Request(address, query, {"Content-Type": "application/json"})
            with urllib.request.urlopen(request) as answer:
                return [run["info"]["run_id"] for run in json.load(answer)["runs"]]
        except urllib.error.URLError:
            time.sleep(1)
    raise SystemExit("the MLflow server did not come up")


if __name__ == "__main__":
    known = {make.__name__: make for make in (trial, watching, comparison)}
    for make in [known[name] for name in sys.argv[1:]] or known.values():
        with tempfile.TemporaryDirectory() as folder:
            make(Path(folder))
