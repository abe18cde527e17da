// A board: one colony's map with its pheromone, ants and best path.

const WALKED = 0.85; // the share of a cycle after which all have walked; in the rest the pheromone is updated

class Board {
  constructor(colony, place, hover) {
    Object.assign(this, { colony, place, map: colony.map, cell: null });
    [this.top, this.left, this.below, this.beyond] = this.map.window;
    this.heat = new OffscreenCanvas(this.map.cols, this.map.rows);
    this.image = new ImageData(this.map.cols, this.map.rows);
    this.pixels = new Int32Array(this.image.data.buffer);
    this.trails = document.createElement("canvas");
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
    this.tracer = this.trails.getContext("2d");
  }

  /** Take the theme's colours over. */
  dress() {
    this.ramp = rampOf(theme.name);
    this.wall = word(parsed(theme.colour("--wall")));
    this.colours = {};
    for (const name of ["best", "halo", "ant", "ant-rim", "trail", "stuck", "ink"]) this.colours[name] = theme.colour(`--${name}`);
    const line = this.element.querySelector("h2 path");
    line.setAttribute("stroke", theme.series(this.place));
    line.setAttribute("stroke-dasharray", DASHES[this.place]);
    this.heated = this.traced = null;
  }

  resize() {
    const { width, height } = this.canvas.getBoundingClientRect(), dense = window.devicePixelRatio || 1;
    if (!width) return;
    for (const canvas of [this.canvas, this.trails]) {
      canvas.width = Math.round(width * dense);
      canvas.height = Math.round(height * dense);
    }
    this.dense = dense;
    this.scale = this.canvas.width / (this.beyond - this.left);
    this.traced = null;
  }

  cellAt(event) {
    const box = this.canvas.getBoundingClientRect();
    const row = this.top + Math.floor(((event.clientY - box.top) / box.height) * (this.below - this.top));
    const col = this.left + Math.floor(((event.clientX - box.left) / box.width) * (this.beyond - this.left));
    return row >= 0 && row < this.map.rows && col >= 0 && col < this.map.cols ? [row, col] : null;
  }

  centre([row, col]) {
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
    if (!this.scale || !this.ramp || this.cycle === undefined) return;
    this.paintHeat();
    this.traceWays();
    const { pencil, canvas } = this, wide = this.beyond - this.left, high = this.below - this.top;
    pencil.imageSmoothingEnabled = this.scale < 1;
    pencil.drawImage(this.heat, this.left, this.top, wide, high, 0, 0, canvas.width, canvas.height);
    pencil.globalAlpha = 0.6;
    pencil.drawImage(this.trails, 0, 0);
    pencil.globalAlpha = 1;
    this.drawBest();
    this.drawEnds();
    this.drawAnts();
    this.drawPointed();
  }

  /** Colour the cells that are not as they were drawn last. */
  paintHeat() {
    const { colony, pixels, ramp } = this, count = colony.touched.length;
    const before = this.cycle - 1, share = this.update, key = before + share;
    if (this.heated === key) return;
    const blend = (from, to) => Math.round(from + share * (to - from));
    const common = ramp[blend(colony.common[before], colony.common[before + 1])];
    if (this.heated === null || common !== this.ground) {
      for (let cell = 0; cell < pixels.length; cell++) pixels[cell] = this.map.obstacles[cell] ? this.wall : common;
      this.ground = common;
    }
    const old = colony.frames.subarray(before * count, (before + 1) * count);
    const now = colony.frames.subarray((before + 1) * count, (before + 2) * count);
    for (let i = 0; i < count; i++) {
      const cell = colony.touched[i];
      if (!this.map.obstacles[cell]) pixels[cell] = ramp[old[i] === now[i] ? now[i] : blend(old[i], now[i])];
    }
    this.heat.getContext("2d").putImageData(this.image, 0, 0);
    this.heated = key;
  }

  /** Draw what the ants have walked since the last time; all of it if they are others. */
  traceWays() {
    const { tracer, colours } = this, reached = this.walk * this.colony.longest[this.cycle - 1];
    const goesOn = this.traced !== null && this.traced.cycle === this.cycle && this.traced.reached <= reached;
    if (!goesOn) tracer.clearRect(0, 0, this.trails.width, this.trails.height);
    const from = goesOn ? this.traced.reached : 0;
    tracer.lineWidth = Math.max(1.1 * this.dense, Math.min(2.2 * this.dense, 0.1 * this.scale));
    tracer.lineJoin = tracer.lineCap = "round";
    for (const lost of [false, true]) {
      tracer.beginPath();
      for (const ant of this.colony.ants(this.cycle)) if (ant.lost === lost) this.trace(ant.cells, from, reached);
      tracer.strokeStyle = lost ? colours.stuck : colours.trail;
      tracer.stroke();
    }
    this.traced = { cycle: this.cycle, reached };
  }

  trace(cells, from, reached) {
    const last = Math.min(Math.floor(reached), cells.length - 1);
    const first = Math.floor(from);
    if (first >= last) return;
    this.tracer.moveTo(...this.centre(cells[first]));
    for (let i = first + 1; i <= last; i++) this.tracer.lineTo(...this.centre(cells[i]));
  }

  drawBest() {
    const best = this.colony.bestBy(this.after), { pencil, colours } = this;
    if (!best) return;
    pencil.beginPath();
    best.cells.forEach((cell) => pencil.lineTo(...this.centre(cell)));
    pencil.lineJoin = pencil.lineCap = "round";
    const width = Math.max(2.4 * this.dense, Math.min(5 * this.dense, 0.2 * this.scale));
    for (const [colour, wide] of [[colours.halo, width + 2.4 * this.dense], [colours.best, width]]) {
      pencil.strokeStyle = colour;
      pencil.lineWidth = wide;
      pencil.stroke();
    }
  }

  drawEnds() {
    const { pencil, colours } = this, size = Math.max(7.5 * this.dense, Math.min(13 * this.dense, 0.42 * this.scale));
    pencil.font = `700 ${1.25 * size}px system-ui, sans-serif`;
    pencil.textAlign = "center";
    pencil.textBaseline = "middle";
    for (const [sign, cell] of [["S", this.map.start], ["G", this.map.goal]]) {
      const [x, y] = this.centre(cell);
      pencil.beginPath();
      pencil.arc(x, y, size, 0, 7);
      pencil.fillStyle = colours.ink;
      pencil.fill();
      pencil.fillStyle = colours.halo;
      pencil.fillText(sign, x, y + 0.06 * size);
    }
  }

  drawAnts() {
    const reached = this.walk * this.colony.longest[this.cycle - 1];
    const size = Math.max(2.6 * this.dense, Math.min(6 * this.dense, 0.2 * this.scale));
    for (const ant of this.colony.ants(this.cycle)) {
      const steps = ant.cells.length - 1;
      if (reached < steps) this.drawAnt(this.between(ant.cells, reached), ant.best ? 1.35 * size : size);
      else if (ant.lost) this.drawLost(ant.cells[steps], size, reached - steps);
    }
  }

  between(cells, reached) {
    const low = Math.floor(reached), share = reached - low;
    const [from, to] = [this.centre(cells[low]), this.centre(cells[low + 1])];
    return from.map((at, i) => at + share * (to[i] - at));
  }

  drawAnt([x, y], size) {
    const { pencil, colours } = this;
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
    pencil.globalAlpha = Math.max(0.4, 1 - since / (0.3 * this.colony.longest[this.cycle - 1]));
    pencil.strokeStyle = colours.stuck;
    pencil.lineWidth = 2 * this.dense;
    pencil.beginPath();
    for (const side of [1, -1]) { pencil.moveTo(x - size, y - side * size); pencil.lineTo(x + size, y + side * size); }
    pencil.stroke();
    pencil.globalAlpha = 1;
  }

  drawPointed() {
    if (!this.cell) return;
    const { pencil } = this, [x, y] = this.centre(this.cell), half = Math.max(this.scale, 6 * this.dense) / 2;
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
