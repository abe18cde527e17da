// The convergence curves of all colonies, with a cursor that can be dragged.

const SVG = "http://www.w3.org/2000/svg";

function made(parent, name, attributes, text) {
  const element = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  if (text !== undefined) element.textContent = text;
  parent.append(element);
  return element;
}

class Chart {
  constructor(svg, colonies, seek) {
    Object.assign(this, { svg, colonies, cycles: Math.max(...colonies.map((one) => one.cycles)) });
    this.optimum = colonies[0].map.optimum;
    this.highest = this.highestShown();
    const follow = (event) => {
      if (event.buttons & 1) seek(Math.round(this.cycleAt(event.clientX - svg.getBoundingClientRect().left)));
    };
    svg.addEventListener("pointerdown", (event) => { svg.setPointerCapture(event.pointerId); follow(event); });
    svg.addEventListener("pointermove", follow);
    new ResizeObserver(() => this.draw()).observe(svg);
  }

  /** The upper end of the axis: all but the worst lengths, which would flatten the rest. */
  highestShown() {
    const lengths = this.colonies.flatMap((one) => one.curve).filter((length) => length !== null).sort((a, b) => a - b);
    if (!lengths.length) return this.optimum * 1.5;
    return Math.max(lengths[Math.floor(0.985 * (lengths.length - 1))], this.optimum * 1.02);
  }

  x(cycle) {
    const share = this.cycles > 1 ? Math.log(Math.max(1, cycle)) / Math.log(this.cycles) : 0.5;
    return this.left + share * (this.right - this.left);
  }

  cycleAt(x) {
    const share = Math.min(1, Math.max(0, (x - this.left) / (this.right - this.left)));
    return this.cycles ** share;
  }

  y(length) {
    const low = this.optimum - 0.06 * (this.highest - this.optimum);
    const share = (Math.min(length, this.highest) - low) / (this.highest - low);
    return this.bottom - share * (this.bottom - this.top);
  }

  draw() {
    const { width, height } = this.svg.getBoundingClientRect();
    if (!width) return;
    Object.assign(this, { left: 46, right: width - 14, top: 12, bottom: height - 32 });
    this.svg.replaceChildren();
    this.drawAxes();
    this.colonies.forEach((colony, place) => this.drawColony(colony, theme.series(place), DASHES[place]));
    this.cursor = made(this.svg, "line", { class: "cursor", y1: this.top - 6, y2: this.bottom });
    this.dots = this.colonies.map((_, place) => made(this.svg, "circle", { r: 4.5, fill: theme.series(place) }));
    if (this.at !== undefined) this.show(this.at);
  }

  drawAxes() {
    const { left, right, bottom, top } = this;
    for (const base of [1, 10, 100, 1000, 10000, 100000]) {
      for (const cycle of [base, 2 * base, 5 * base].filter((tick) => tick <= this.cycles)) {
        made(this.svg, "line", { class: "axis", x1: this.x(cycle), x2: this.x(cycle), y1: top, y2: bottom });
        made(this.svg, "text", { x: this.x(cycle), y: bottom + 14, "text-anchor": "middle" }, cycle);
      }
    }
    made(this.svg, "text", { x: (left + right) / 2, y: bottom + 28, "text-anchor": "middle" }, "cycle");
    const span = this.highest - this.optimum, unit = 10 ** Math.floor(Math.log10(span));
    const step = [0.2, 0.5, 1, 2, 5].map((factor) => factor * unit).find((size) => span / size <= 4);
    const digits = Math.max(0, -Math.floor(Math.log10(step)));
    for (let length = Math.ceil(this.optimum / step) * step; length <= this.highest; length += step) {
      made(this.svg, "line", { class: "axis", x1: left, x2: right, y1: this.y(length), y2: this.y(length) });
      made(this.svg, "text", { x: left - 6, y: this.y(length) + 4, "text-anchor": "end" }, length.toFixed(digits));
    }
    const level = this.y(this.optimum);
    made(this.svg, "line", { class: "optimum", x1: left, x2: right, y1: level, y2: level });
    made(this.svg, "text", { x: right, y: level + 12, "text-anchor": "end" }, `optimum ${this.optimum.toFixed(4)}`);
  }

  drawColony(colony, colour, dashes) {
    let curve = "", soFar = "", best = Infinity, gap = true;
    colony.curve.forEach((length, row) => {
      const x = this.x(row + 1).toFixed(1);
      if (length === null) { gap = true; } else {
        curve += `${gap ? "M" : "L"}${x} ${this.y(length).toFixed(1)}`;
        gap = false;
      }
      if (length !== null && length < best) {
        soFar += best === Infinity ? `M${x} ` : `H${x}V`;
        best = length;
        soFar += this.y(best).toFixed(1);
      }
    });
    if (best < Infinity) soFar += `H${this.x(colony.cycles).toFixed(1)}`;
    made(this.svg, "path", { class: "curve", d: curve, stroke: colour });
    made(this.svg, "path", { class: "so-far", d: soFar, stroke: colour, "stroke-dasharray": dashes });
  }

  /** Put the cursor to a cycle, which may be between two. */
  show(cycle) {
    this.at = cycle;
    if (!this.cursor) return;
    const x = this.x(cycle);
    this.cursor.setAttribute("x1", x);
    this.cursor.setAttribute("x2", x);
    this.colonies.forEach((colony, place) => {
      const best = colony.bestBy(Math.floor(cycle)), dot = this.dots[place];
      dot.style.display = best ? "" : "none";
      if (best) { dot.setAttribute("cx", x); dot.setAttribute("cy", this.y(best.length)); }
    });
  }
}
