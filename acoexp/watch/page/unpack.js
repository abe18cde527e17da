// From the page's data to what is drawn; see acoexp/watch/packing.py, which is the other side of it.

const STEPS = [[0, 1], [-1, 1], [-1, 0], [-1, -1], [0, -1], [1, -1], [1, 0], [1, 1]];
const ARROWS = "→↗↑↖←↙↓↘";

async function inflated(text) {
  const bytes = Uint8Array.from(atob(text), (sign) => sign.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Response(stream).arrayBuffer();
}

/** The cells of a way, its first included, numbered row by row; it is given by its turns from east on. */
function follow({ start, cols }, turns) {
  const jumps = STEPS.map(([down, right]) => down * cols + right);
  const cells = new Int32Array(turns.length + 1);
  cells[0] = start[0] * cols + start[1];
  for (let i = 0, move = 0; i < turns.length; i++) {
    move = (move + turns[i]) & 7;
    cells[i + 1] = cells[i] + jumps[move];
  }
  return cells;
}

/** Those cells of a way at which it turns, and its ends. */
function corners(cells) {
  return cells.filter((cell, i) => 2 * cell !== cells[i - 1] + cells[i + 1]);
}

class Colony {
  static async unpacked(packed, data) {
    const colony = Object.assign(new Colony(), packed);
    const bytes = async (name) => new Uint8Array(await inflated(packed[name]));
    const words = async (name) => new Uint32Array(await inflated(packed[name]));
    for (const name of ["common", "frames", "force", "forceAngle", "heuristic", "turns", "stuck", "winners"]) {
      colony[name] = await bytes(name);
    }
    for (const name of ["touched", "steps"]) colony[name] = await words(name);
    colony.size = packed.ants;
    delete colony.ants; // a method here
    colony.map = data.map;
    colony.undo();
    return colony;
  }

  /** Undo the differences: between cells, between cycles, between ways. */
  undo() {
    const { touched, frames, steps } = this;
    for (let i = 1; i < touched.length; i++) touched[i] += touched[i - 1];
    for (let i = touched.length; i < frames.length; i++) frames[i] += frames[i - touched.length];
    this.place = new Int32Array(this.map.rows * this.map.cols).fill(-1);
    touched.forEach((cell, i) => { this.place[cell] = i; });
    this.begins = new Uint32Array(steps.length + 1);
    steps.forEach((count, i) => { this.begins[i + 1] = this.begins[i] + count; });
    this.bests = this.bests.map((best) => {
      const cells = follow(this.map, Array.from(best.turns, Number));
      return { ...best, cells, corners: corners(cells) };
    });
    this.pace = Array.from({ length: this.cycles }, (_, k) => this.paceOf(k * this.shown));
  }

  /** Moves that ants make in a cycle: those of the last to arrive; where none arrives, of the last to be lost. */
  paceOf(first) {
    const stuck = this.stuck.subarray(first, first + this.shown), steps = this.steps.subarray(first, first + this.shown);
    const arrived = steps.filter((_, ant) => !stuck[ant]);
    return Math.max(1, ...(arrived.length ? arrived : steps));
  }

  /** The ants of a cycle that are shown: the cells of their ways, and who is lost. */
  ants(cycle) {
    if (this.of === cycle) return this.walking;
    const first = (cycle - 1) * this.shown;
    this.walking = Array.from({ length: this.shown }, (_, slot) => {
      const ant = first + slot;
      const cells = follow(this.map, this.turns.subarray(this.begins[ant], this.begins[ant + 1]));
      return { cells, lost: this.stuck[ant] === 1, best: this.winners[cycle - 1] === slot };
    });
    this.of = cycle;
    return this.walking;
  }

  /** The best path by the end of a cycle, or null. */
  bestBy(cycle) {
    return this.bests.findLast((best) => best.cycle <= cycle) ?? null;
  }

  /** Pheromone of a cell after a cycle, a byte on the logarithmic scale. */
  byteAt(cell, cycle) {
    const place = this.place[cell];
    return place < 0 ? this.common[cycle] : this.frames[cycle * this.touched.length + place];
  }

  /** What is known of a cell after a cycle, in words. */
  tell(row, col, cycle) {
    const cell = row * this.map.cols + col, byte = this.byteAt(cell, cycle);
    const words = [`pheromone ${byte === 0 ? "at most " : ""}${valueOf(byte, this.scales[cycle]).toPrecision(2)}`];
    const force = this.force[cell];
    if (force > 0) {
      const strength = valueOf(force, this.forceScale).toPrecision(2);
      words.push(`force ${strength} ${ARROWS[Math.round(this.forceAngle[cell] / 32) % 8]}`);
    }
    const liked = this.heuristic[cell];
    if (liked < 8) words.push(`heuristic ${ARROWS[liked]}`);
    return words.join(" · ");
  }
}

function valueOf(byte, [low, high]) {
  return low * (high / low) ** (byte / 255);
}

/** Where a cell's centre lies in metres, for maps that say it. */
function metres(map, row, col) {
  const [resolution, x, y, yaw] = map.frame;
  const across = (col + 0.5) * resolution, along = (map.rows - row - 0.5) * resolution;
  return [x + Math.cos(yaw) * across - Math.sin(yaw) * along, y + Math.sin(yaw) * across + Math.cos(yaw) * along];
}
