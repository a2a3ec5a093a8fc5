// SPDX-License-Identifier: MIT
//
// The viewer: any moment of a leg in a picture of the field. A page that holds one gives it the picture and the leg
// (mirocup/page/1), and says which time to show; the player, lists and buttons around it are the page's.
import { FieldView } from './field.js';
import { Layers } from './layers.js';
import { Track } from './track.js';

export class Viewer {
  // `svg`: the picture of the first moment; `leg`: {period, robots, zones}. `keepersNow()`: the keepers when the track does not
  // know them, or null.
  constructor(svg, { period, robots, zones }, keepersNow = () => null) {
    Object.assign(this, { svg, robots, track: new Track(period) });
    this.moments = [];  // {tick, state, phase, left, score}: from that tick on
    this.keepers = [];  // [tick, blue's, yellow's]: from that tick on
    this.field = new FieldView(svg);
    this.layers = new Layers(svg, robots, zones, (tick) => keepersNow() ?? this.keepersAt(tick));
  }

  // Takes over a whole leg.
  load({ track, moments, keepers }) {
    this.track.load(track, this.robots);
    this.moments.push(...moments);
    this.keepers.push(...keepers);
  }

  // Adds a tick of a running leg.
  add({ tick, frame, moment, keepers }) {
    this.track.add(tick, frame);
    if (String(keepers) !== String(this.keepersAt(tick))) this.keepers.push([tick, ...keepers]);
    this.moments.push({ tick, ...moment });
  }

  // Where a tick is between the ends of the leg, 0 to 1.
  shareOf(tick) { return (tick - this.track.firstTick) / Math.max(this.track.lastTick - this.track.firstTick, 1); }

  momentAt(tick) { return this.moments.findLast((moment) => moment.tick <= tick) ?? this.moments[0]; }

  keepersAt(tick) { return (this.keepers.findLast(([from]) => from <= tick) ?? this.keepers[0] ?? [0, -1, -1]).slice(1); }

  // Draws a time (s) and returns {tick, clock, ball, robots} of it, as Track.at().
  show(time) {
    const { left } = this.momentAt(Math.floor(time / this.track.period + 1e-6));
    const scene = this.field.show(this.track, time, left);
    this.layers.show(this.track, time, left);
    return scene;
  }
}
