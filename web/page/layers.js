// SPDX-License-Identifier: MIT
//
// What can be shown in the picture besides the bodies: trails of the robots, velocities, the zones
// that the laws know, who counts as keeper, shots and passes. Each is off until it is switched on.
import { Actions } from './actions.js';
import { shape } from './text.js';

const robotTrailSeconds = 2;
const keeperRadius = 66;  // mm
const velocitySeconds = 0.25;  // an arrow ends where the body would be after that time

const pathOf = (runs) => runs.map((run) => `M${run.map((p) => p.join(' ')).join('L')}`).join('');

export class Layers {
  // `zones`: path data of the areas of the left and of the right end. `keepersAt(tick)`: the robots
  // that count as keepers, blue's and yellow's; -1: none does.
  constructor(svg, robots, zones, keepersAt) {
    this.isOn = { trails: false, velocities: false, zones: false, shots: false, passes: false, keepers: false };
    this.robots = robots;
    this.keepersAt = keepersAt;
    const below = svg.querySelector('.trail');
    this.zones = ['left', 'right'].map((end) => {
      const zone = shape('path', { class: 'zone', d: zones[end] });
      below.before(zone);
      return zone;
    });
    const team = (i) => (i < robots ? 'blue' : 'yellow');
    this.trails = Array.from({ length: 2 * robots }, (_, i) => shape('path', { class: `robot_trail ${team(i)}` }));
    below.before(...this.trails);
    this.actions = new Actions(below);
    this.keepers = ['blue', 'yellow'].map((name) => shape('circle', { class: `keeper ${name}`, r: keeperRadius }));
    for (const ring of this.keepers) ring.style.display = 'none';
    svg.append(...this.keepers);
    this.velocities = Array.from({ length: 2 * robots + 1 }, (_, i) =>
      shape('path', { class: i === 0 ? 'velocity of_ball' : 'velocity' }));
    svg.append(...this.velocities);
  }

  set(name, isOn) { this.isOn[name] = isOn; }

  show(track, time, leftTeam) {
    const rightTeam = leftTeam === 'blue' ? 'yellow' : 'blue';
    this.zones.forEach((zone, i) => {
      zone.setAttribute('class', `zone ${i === 0 ? leftTeam : rightTeam}`);
      zone.style.display = this.isOn.zones ? '' : 'none';
    });
    this.trails.forEach((trail, i) => {
      trail.setAttribute('d', this.isOn.trails ? pathOf(track.trail(time, robotTrailSeconds, 3 + 3 * i)) : '');
    });
    const tick = Math.floor(time / track.period + 1e-6);
    this.actions.show(this.isOn, tick, leftTeam);
    this.#showKeepers(track.at(time).robots, tick);
    const arrows = this.isOn.velocities ? track.velocities(time) : [];
    this.velocities.forEach((arrow, i) => {
      const v = arrows[i];
      arrow.setAttribute('d', v ? `M${v.x} ${v.y}l${(v.dx * velocitySeconds).toFixed(1)} ${(v.dy * velocitySeconds).toFixed(1)}` : '');
    });
  }

  #showKeepers(places, tick) {
    const numbers = this.isOn.keepers ? this.keepersAt(tick) : [-1, -1];
    this.keepers.forEach((ring, i) => {
      ring.style.display = numbers[i] < 0 ? 'none' : '';
      if (numbers[i] < 0) return;
      const { x, y } = places[i * this.robots + numbers[i]];
      ring.setAttribute('transform', `translate(${x.toFixed(1)} ${y.toFixed(1)})`);
    });
  }
}
