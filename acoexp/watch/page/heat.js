// The heat map: pheromone in colours, one pixel a cell, painted anew only where it changes.

class Heat {
  constructor(colony) {
    const { map, touched, place } = colony;
    Object.assign(this, { colony, touched, base: null });
    this.canvas = new OffscreenCanvas(map.cols, map.rows);
    this.pencil = this.canvas.getContext("2d");
    this.image = new ImageData(map.cols, map.rows);
    this.pixels = new Int32Array(this.image.data.buffer);
    this.ground = Int32Array.from(place.keys()).filter((cell) => place[cell] < 0 && !map.obstacles[cell]);
    this.places = Int32Array.from(touched.keys()).filter((i) => !map.obstacles[touched[i]]);
  }

  dress(ramp, wall) {
    this.ramp = ramp;
    this.pixels.fill(wall);
    this.base = null;
  }

  frame(cycle) {
    const count = this.touched.length;
    return this.colony.frames.subarray(cycle * count, (cycle + 1) * count);
  }

  /** Paint what is between two cycles, such a share after the first. */
  paint(cycle, share) {
    if (this.base === cycle && this.share === share) return;
    if (this.base !== cycle) this.enter(cycle);
    this.blend(share);
    this.share = share;
    this.pencil.putImageData(this.image, 0, 0);
  }

  /** Find what changes in the cycle to come. */
  enter(cycle) {
    if (this.base !== null && this.base === cycle - 1) this.blend(1);
    else this.paintAll(cycle);
    this.base = cycle;
    this.old = this.frame(cycle);
    this.now = this.frame(cycle + 1);
    this.changing = this.places.filter((i) => this.old[i] !== this.now[i]);
  }

  paintAll(cycle) {
    const frame = this.frame(cycle), { pixels, ramp, touched } = this;
    for (const i of this.places) pixels[touched[i]] = ramp[frame[i]];
    this.paintGround(this.colony.common[cycle]);
  }

  blend(share) {
    const { pixels, ramp, touched, old, now } = this, { common } = this.colony;
    for (const i of this.changing) pixels[touched[i]] = ramp[Math.round(old[i] + share * (now[i] - old[i]))];
    const [from, to] = [common[this.base], common[this.base + 1]];
    if (from !== to) this.paintGround(Math.round(from + share * (to - from)));
  }

  paintGround(byte) {
    for (const cell of this.ground) this.pixels[cell] = this.ramp[byte];
  }
}
