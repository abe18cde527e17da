// The ways of a cycle's ants as far as they have walked: lines, or on a large map the cells themselves.

const FINE = 4; // pixels a cell below which lines would take too long, and say no more

class Ways {
  constructor(colony) {
    Object.assign(this, { colony, map: colony.map, drawn: null });
    this.canvas = document.createElement("canvas");
    this.pencil = this.canvas.getContext("2d");
  }

  /** Take over how large a cell is, what colours there are, and where a cell's centre lies. */
  dress({ width, height, scale, dense, colours, centre }) {
    Object.assign(this, { scale, dense, colours, centre, drawn: null, fine: scale < FINE });
    this.canvas.width = this.fine ? this.map.cols : width;
    this.canvas.height = this.fine ? this.map.rows : height;
    this.width = Math.max(1.1 * dense, Math.min(2.2 * dense, 0.1 * scale));
    this.image = this.fine ? new ImageData(this.map.cols, this.map.rows) : null;
    this.pixels = this.fine ? new Int32Array(this.image.data.buffer) : null;
  }

  /** How far an ant has come: all are through when the last one arrives, and those that wander hurry. */
  reached(ant, walk) {
    const steps = ant.cells.length - 1;
    return Math.min(steps, walk * Math.max(this.colony.pace[this.cycle - 1], ant.lost ? steps : 0));
  }

  /** Draw what has been walked since the last time; all of it if it is another cycle. */
  draw(cycle, walk) {
    const goesOn = this.drawn !== null && this.cycle === cycle && this.drawn <= walk;
    this.cycle = cycle;
    if (goesOn && this.drawn === walk) return;
    if (!goesOn) this.clear();
    const ants = this.colony.ants(cycle), since = goesOn ? this.drawn : 0;
    for (const lost of [false, true]) {
      for (const ant of ants.filter((one) => one.lost === lost)) {
        const from = Math.floor(this.reached(ant, since)), to = Math.floor(this.reached(ant, walk));
        if (from < to || !goesOn) this.trace(ant, from, to);
      }
    }
    if (this.fine) this.pencil.putImageData(this.image, 0, 0);
    this.drawn = walk;
  }

  clear() {
    if (this.fine) this.pixels.fill(0);
    else this.pencil.clearRect(0, 0, this.canvas.width, this.canvas.height);
  }

  trace({ cells, lost }, from, to) {
    const { pencil, colours } = this, colour = lost ? colours.stuck : colours.trail;
    if (this.fine) {
      const shade = lost ? word(parsed(colour), 110) : word(parsed(colour)); // one that wanders covers the map
      for (let i = from; i <= to; i++) this.pixels[cells[i]] = shade;
      return;
    }
    pencil.beginPath();
    for (let i = from; i <= to; i++) pencil.lineTo(...this.centre(cells[i]));
    pencil.lineJoin = pencil.lineCap = "round";
    for (const [paint, wide] of [[colours.halo, this.width + 1.6 * this.dense], [colour, this.width]]) {
      pencil.strokeStyle = paint;
      pencil.lineWidth = wide;
      pencil.stroke();
    }
  }
}
