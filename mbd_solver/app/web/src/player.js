// The time that is shown, and how it runs.

export class Player {
  // start, end [s]; marks: times of the frames, for single steps [s].
  constructor({ start, end, marks }) {
    Object.assign(this, { start, end, marks });
    this.time = start;
    this.seconds = 8;  // of the viewer, for the whole run at speed 1
    this.speed = 1;
    this.playing = false;
    this.live = false;   // stays at the end of a run in progress
    this.follows = false;  // it is one
    this.onLive = () => {};
    this.onTime = () => {};
    this.onPlaying = () => {};
    this.onStopped = () => {};
    this.drawn = [];   // moments of the last pictures, for the rate [ms]
  }

  seek(t) {
    this.time = Math.min(this.end, Math.max(this.start, t));
    this.onTime(this.time);
  }
  // The run has come to this time.
  grow(end) {
    this.end = Math.max(this.end, end);
    this.live && !this.playing ? this.seek(this.end) : this.onTime(this.time);
  }
  setLive(on) {
    if (this.live === on) return;
    this.live = on;
    this.onLive(on);
    if (on) this.seek(this.end);
  }
  step(count) {
    this.play(false);
    const marks = this.marks, tiny = 1e-9 * (this.end - this.start);
    if (count > 0) this.seek(marks.find((t) => t > this.time + tiny) ?? this.end);
    else this.seek([...marks].reverse().find((t) => t < this.time - tiny) ?? this.start);
  }
  play(on = !this.playing) {
    this.setLive(false);
    if (on === this.playing) return;
    this.playing = on;
    if (on && this.time >= this.end) this.seek(this.start);
    this.onPlaying(on);
    this.last = null;
    this.drawn = [];
    if (!on) this.onStopped();
    if (on) requestAnimationFrame((now) => this.tick(now));
  }
  tick(now) {
    if (!this.playing) return;
    if (this.last !== null) {
      const rate = ((this.end - this.start) / this.seconds) * this.speed;
      const next = this.time + (rate * (now - this.last)) / 1000;
      this.seek(next);
      if (next >= this.end) {
        this.play(false);
        return this.follows && this.setLive(true);
      }
      this.drawn.push(now);
      if (this.drawn.length > 30) this.drawn.shift();
    }
    this.last = now;
    requestAnimationFrame((later) => this.tick(later));
  }
  // Pictures in a second, of the last thirty; 0 while fewer than six are known.
  rate() {
    const n = this.drawn.length;
    return n > 5 ? (1000 * (n - 1)) / (this.drawn[n - 1] - this.drawn[0]) : 0;
  }
}
