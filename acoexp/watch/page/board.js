// A board: one colony's map with its pheromone, ants and best path.

const WALKED = 0.85; // the share of a cycle after which all have walked; in the rest the pheromone is updated

class Board {
  constructor(colony, place, hover) {
    Object.assign(this, { colony, place, map: colony.map, cell: null });
    [this.top, this.left, this.below, this.beyond] = this.map.window;
    this.heat = new Heat(colony);
    this.ways = new Ways(colony);
    this.centre = this.centre.bind(this);
    this.makeElements();
    this.canvas.addEventListener("pointermove", (event) => hover(this.cellAt(event)));
    this.canvas.addEventListener("pointerdown", (event) => hover(this.cellAt(event)));
    this.canvas.addEventListener("pointerleave", () => hover(null));
    new ResizeObserver(() => { this.resize(); this.redraw(); }).observe(this.canvas);
  }

  makeElements() {
    this.element = document.createElement("article");
    this.element.className = "board";
    this.element.innerHTML = `<h2><svg viewBox="0 0 26 8" aria-hidden="true"><path d="M0 4h26" stroke-width="4" fill="none"/>
      </svg><span></span></h2><canvas role="img"></canvas>
      <dl class="facts"><div><dt>best so far</dt><dd></dd></div><div><dt>cycle’s best</dt><dd></dd></div>
      <div><dt>lost</dt><dd></dd></div></dl><p class="cell" aria-live="off"></p>`;
    this.element.querySelector("h2 span").textContent = this.colony.name;
    this.canvas = this.element.querySelector("canvas");
    this.facts = this.element.querySelectorAll("dd");
    this.told = this.element.querySelector(".cell");
    const aspect = (this.beyond - this.left) / (this.below - this.top);
    this.canvas.style.aspectRatio = aspect;
    this.canvas.style.width = `min(100%, calc(var(--tall) * ${aspect}))`;
    this.pencil = this.canvas.getContext("2d");
  }

  /** Take the theme's colours over. */
  dress() {
    this.colours = {};
    for (const name of ["best", "halo", "ant", "ant-rim", "trail", "stuck", "ink", "wall"]) {
      this.colours[name] = theme.colour(`--${name}`);
    }
    const line = this.element.querySelector("h2 path");
    line.setAttribute("stroke", theme.series(this.place));
    line.setAttribute("stroke-dasharray", DASHES[this.place]);
    this.heat.dress(rampOf(theme.name), word(parsed(this.colours.wall)));
    this.resize();
  }

  resize() {
    const { width, height } = this.canvas.getBoundingClientRect(), dense = window.devicePixelRatio || 1;
    if (!width) return;
    this.canvas.width = Math.round(width * dense);
    this.canvas.height = Math.round(height * dense);
    this.dense = dense;
    this.scale = this.canvas.width / (this.beyond - this.left);
    this.drawnBest = null;
    if (this.colours) this.ways.dress({ ...this, width: this.canvas.width, height: this.canvas.height });
  }

  cellAt(event) {
    const box = this.canvas.getBoundingClientRect();
    const row = this.top + Math.floor(((event.clientY - box.top) / box.height) * (this.below - this.top));
    const col = this.left + Math.floor(((event.clientX - box.left) / box.width) * (this.beyond - this.left));
    return row >= 0 && row < this.map.rows && col >= 0 && col < this.map.cols ? [row, col] : null;
  }

  centre(cell) {
    const { cols } = this.map, col = cell % cols, row = (cell - col) / cols;
    return [(col - this.left + 0.5) * this.scale, (row - this.top + 0.5) * this.scale];
  }

  /** Show a moment: 0 is before the first cycle, 2.5 is in the middle of the third. */
  show(time) {
    const { colony } = this, end = Math.min(time, colony.cycles);
    this.cycle = Math.max(1, Math.ceil(end));
    const share = end - (this.cycle - 1);
    this.walk = Math.min(1, share / WALKED);
    this.update = Math.max(0, (share - WALKED) / (1 - WALKED));
    this.after = this.update > 0 ? this.cycle : this.cycle - 1;
    this.redraw();
    this.tell();
  }

  redraw() {
    if (!this.scale || !this.colours || this.cycle === undefined) return;
    this.heat.paint(this.cycle - 1, this.update);
    this.ways.draw(this.cycle, this.walk);
    const { pencil, canvas, ways } = this, seen = [this.left, this.top, this.beyond - this.left, this.below - this.top];
    pencil.imageSmoothingEnabled = this.scale < 1;
    pencil.drawImage(this.heat.canvas, ...seen, 0, 0, canvas.width, canvas.height);
    pencil.globalAlpha = 0.75;
    if (ways.fine) pencil.drawImage(ways.canvas, ...seen, 0, 0, canvas.width, canvas.height);
    else pencil.drawImage(ways.canvas, 0, 0);
    pencil.globalAlpha = 1;
    this.drawBest();
    this.drawEnds();
    this.drawAnts();
    this.drawPointed();
  }

  drawBest() {
    const best = this.colony.bestBy(this.after), { pencil, colours } = this;
    if (!best) return;
    if (this.drawnBest !== best) {
      this.drawnBest = best;
      this.line = new Path2D();
      for (const cell of best.corners) this.line.lineTo(...this.centre(cell));
    }
    pencil.lineJoin = pencil.lineCap = "round";
    const width = Math.max(2.4 * this.dense, Math.min(5 * this.dense, 0.2 * this.scale));
    for (const [colour, wide] of [[colours.halo, width + 2.4 * this.dense], [colours.best, width]]) {
      pencil.strokeStyle = colour;
      pencil.lineWidth = wide;
      pencil.stroke(this.line);
    }
  }

  drawEnds() {
    const { pencil, colours } = this, size = Math.max(7.5 * this.dense, Math.min(13 * this.dense, 0.42 * this.scale));
    pencil.font = `700 ${1.25 * size}px system-ui, sans-serif`;
    pencil.textAlign = "center";
    pencil.textBaseline = "middle";
    for (const [sign, [row, col]] of [["S", this.map.start], ["G", this.map.goal]]) {
      const within = (at, side) => Math.min(Math.max(at, size + this.dense), side - size - this.dense);
      const [across, down] = this.centre(row * this.map.cols + col);
      const x = within(across, this.canvas.width), y = within(down, this.canvas.height);
      pencil.beginPath();
      pencil.arc(x, y, size, 0, 7);
      pencil.fillStyle = colours.ink;
      pencil.fill();
      pencil.fillStyle = colours.halo;
      pencil.fillText(sign, x, y + 0.06 * size);
    }
  }

  drawAnts() {
    const size = Math.max(2.6 * this.dense, Math.min(6 * this.dense, 0.2 * this.scale));
    for (const ant of this.colony.ants(this.cycle)) {
      const steps = ant.cells.length - 1, reached = this.ways.reached(ant, this.walk);
      if (reached < steps) this.drawAnt(ant, reached, ant.best ? 1.35 * size : size);
      else if (ant.lost) this.drawLost(ant.cells[steps], size, this.walk * this.colony.pace[this.cycle - 1] - steps);
    }
  }

  /** An ant between two cells, and its way from the last one. */
  drawAnt({ cells, lost }, reached, size) {
    const { pencil, colours } = this, low = Math.floor(reached), share = reached - low;
    const from = this.centre(cells[low]), to = this.centre(cells[low + 1]);
    const [x, y] = from.map((at, i) => at + share * (to[i] - at));
    pencil.beginPath();
    pencil.moveTo(...from);
    pencil.lineTo(x, y);
    pencil.strokeStyle = lost ? colours.stuck : colours.trail;
    pencil.lineWidth = this.ways.width;
    pencil.stroke();
    pencil.beginPath();
    pencil.arc(x, y, size, 0, 7);
    pencil.fillStyle = colours.ant;
    pencil.strokeStyle = colours["ant-rim"];
    pencil.lineWidth = 1.2 * this.dense;
    pencil.fill();
    pencil.stroke();
  }

  /** A lost ant fades for a while, and stays faint until the cycle ends. */
  drawLost(cell, size, since) {
    const { pencil, colours } = this, [x, y] = this.centre(cell);
    pencil.globalAlpha = Math.max(0.4, 1 - since / (0.3 * this.colony.pace[this.cycle - 1]));
    pencil.strokeStyle = colours.stuck;
    pencil.lineWidth = 2 * this.dense;
    pencil.beginPath();
    for (const side of [1, -1]) { pencil.moveTo(x - size, y - side * size); pencil.lineTo(x + size, y + side * size); }
    pencil.stroke();
    pencil.globalAlpha = 1;
  }

  drawPointed() {
    if (!this.cell) return;
    const { pencil } = this, [row, col] = this.cell;
    const [x, y] = this.centre(row * this.map.cols + col), half = Math.max(this.scale, 6 * this.dense) / 2;
    pencil.lineWidth = 1.5 * this.dense;
    pencil.strokeStyle = this.colours.ink;
    pencil.strokeRect(x - half, y - half, 2 * half, 2 * half);
  }

  tell() {
    const { colony, facts } = this, best = colony.bestBy(this.after), row = this.cycle - 1, { optimum } = this.map;
    const longer = best ? 100 * (best.length / optimum - 1) : 0;
    const own = this.walk < 1 || colony.curve[row] === null ? "–" : colony.curve[row].toFixed(4);
    const lost = this.walk < 1 ? "–" : `${colony.lost[row]} of ${colony.size}`;
    const texts = [best ? `${best.length.toFixed(4)} (${longer < 5e-5 ? "optimum" : `+${longer.toFixed(1)} %`})` : "–", own, lost];
    texts.forEach((text, i) => { if (facts[i].textContent !== text) facts[i].textContent = text; });
    this.tellCell();
  }

  tellCell() {
    let text = "";
    if (this.cell) {
      const [row, col] = this.cell, wall = this.map.obstacles[row * this.map.cols + col];
      const at = this.map.frame ? ` (${metres(this.map, row, col).map((m) => m.toFixed(2)).join(", ")} m)` : "";
      text = `row ${row}, column ${col}${at}: ${wall ? "obstacle" : this.colony.tell(row, col, this.after)}`;
    }
    if (this.told.textContent !== text) this.told.textContent = text;
  }
}
