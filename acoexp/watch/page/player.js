// The player: a clock in cycles, and what moves it.

const SPEEDS = [0.25, 0.5, 1, 2, 4, 8, 16, 32, 64];

class Player {
  /** Time runs from 0, before the first cycle, to the number of cycles; ``show`` is told of every change. */
  constructor(cycles, show) {
    Object.assign(this, { cycles, show, time: cycles, playing: false, speed: 2 });
    this.calm = window.matchMedia("(prefers-reduced-motion: reduce)");
  }

  seek(time) {
    this.time = Math.min(this.cycles, Math.max(0, time));
    this.show();
  }

  /** Go to the end of a cycle before or after. */
  step(by) {
    this.pause();
    this.seek(by > 0 ? Math.floor(this.time) + by : Math.ceil(this.time) + by);
  }

  play() {
    if (this.playing) return;
    if (this.time >= this.cycles) this.time = 0;
    this.playing = true;
    this.before = null;
    this.show();
    requestAnimationFrame((now) => this.tick(now));
  }

  pause() {
    if (!this.playing) return;
    this.playing = false;
    this.show();
  }

  toggle() {
    if (this.playing) this.pause(); else this.play();
  }

  faster(by) {
    const place = Math.min(SPEEDS.length - 1, Math.max(0, SPEEDS.indexOf(this.speed) + by));
    this.speed = SPEEDS[place];
    this.show();
  }

  tick(now) {
    if (!this.playing) return;
    // a tab that was hidden goes on where it was
    if (this.before !== null) this.run(Math.min(0.25, (now - this.before) / 1000));
    this.before = now;
    if (this.playing) requestAnimationFrame((next) => this.tick(next));
  }

  run(seconds) {
    const time = (this.exact ?? this.time) + seconds * this.speed;
    const shown = this.calm.matches ? Math.floor(time) : time; // whole cycles, nothing that moves
    this.exact = this.calm.matches ? time : null;
    if (time >= this.cycles) {
      this.exact = null;
      this.playing = false;
    }
    if (shown !== this.time) this.seek(shown);
  }
}
