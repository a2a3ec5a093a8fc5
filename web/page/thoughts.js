// SPDX-License-Identifier: MIT
//
// What a team drew in the leg (mirocup/thoughts/1): shapes over the picture, in step with time and in
// layers that can be switched; texts such as "speed = 1.2" as curves; and what the team printed.
import { TeamLog } from './log.js';
import { element, shape } from './text.js';
import { lastAt } from './track.js';

const curvePoints = 400;  // of a value over the leg, at most
const valueText = /^(.{1,31}) = (-?[0-9.]+(?:e[-+]?[0-9]+)?)$/;

// Unpacks bytes, or a text, that the program packed with zlib and base64.
export async function unpackBytes(packed) {
  const text = atob(packed);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}
export const unpackText = async (packed) => new TextDecoder().decode(await unpackBytes(packed));

// The shapes of one team. A line of the text is parsed only when its tick is shown.
export class Thoughts {
  constructor(text) {
    this.lines = text.split('\n').filter((line) => line !== '');
    this.first = new Map();  // tick -> index of its first line
    this.layers = [];
    this.values = new Map();  // name -> [[tick, value]...]
    const seen = new Set();
    let last = -1;
    this.lines.forEach((line, i) => {
      const tick = parseInt(line.slice('{"tick":'.length), 10);
      if (tick !== last) this.first.set(tick, i);
      last = tick;
      const name = /"layer":("(?:[^"\\]|\\.)*")/.exec(line)[1];
      if (!seen.has(name)) {
        seen.add(name);
        this.layers.push(JSON.parse(name));
      }
      if (line.includes(' = ')) this.#addValue(tick, JSON.parse(line).text?.[2]);
    });
  }

  #addValue(tick, text) {
    const match = valueText.exec(text ?? '');
    if (!match) return;
    if (!this.values.has(match[1])) this.values.set(match[1], []);
    this.values.get(match[1]).push([tick, Number(match[2])]);
  }

  // Returns the shapes of a tick, in the order in which they were drawn.
  at(tick) {
    const shapes = [];
    for (let i = this.first.get(tick) ?? this.lines.length; i < this.lines.length; ++i) {
      const one = JSON.parse(this.lines[i]);
      if (one.tick !== tick) break;
      shapes.push(one);
    }
    return shapes;
  }
}

// Draws shapes on a canvas that lies over the picture of the field.
export class ThoughtsCanvas {
  constructor(svg) {
    this.svg = svg;
    this.canvas = element('canvas', 'thoughts');
    this.canvas.setAttribute('aria-hidden', 'true');
    svg.after(this.canvas);
    this.context = this.canvas.getContext('2d');
  }

  // `isTurned`: the team defends the right end, so that its own frame is turned by half a turn.
  begin() {
    const box = this.svg.getBoundingClientRect();
    const frame = this.canvas.parentElement.getBoundingClientRect();
    const scale = devicePixelRatio || 1;
    const size = [Math.round(box.width * scale), Math.round(box.height * scale)];
    if (this.canvas.width !== size[0] || this.canvas.height !== size[1]) [this.canvas.width, this.canvas.height] = size;
    Object.assign(this.canvas.style, {
      left: `${box.left - frame.left}px`, top: `${box.top - frame.top}px`, width: `${box.width}px`, height: `${box.height}px`,
    });
    this.context.setTransform(1, 0, 0, 1, 0, 0);
    this.context.clearRect(0, 0, ...size);
    const map = this.svg.getScreenCTM();
    this.toPixels = ([x, y], isTurned) => {
      const sign = isTurned ? -1 : 1;
      const [mmX, mmY] = [1000 * sign * x, -1000 * sign * y];
      return [(map.a * mmX + map.e - box.left) * scale, (map.d * mmY + map.f - box.top) * scale];
    };
    this.perMetre = 1000 * map.a * scale;
    this.context.lineWidth = 2 * scale;
    this.context.font = `${13 * scale}px sans-serif`;
    this.context.textAlign = 'center';
  }

  draw(one, isTurned) {
    const c = this.context;
    const at = (x, y) => this.toPixels([x, y], isTurned);
    c.strokeStyle = c.fillStyle = one.colour;
    c.beginPath();
    if (one.line) {
      c.moveTo(...at(one.line[0], one.line[1]));
      c.lineTo(...at(one.line[2], one.line[3]));
      c.stroke();
    } else if (one.circle) {
      c.arc(...at(one.circle[0], one.circle[1]), Math.abs(one.circle[2]) * this.perMetre, 0, 2 * Math.PI);
      c.stroke();
    } else if (one.polygon) {
      one.polygon.forEach(([x, y], i) => (i === 0 ? c.moveTo(...at(x, y)) : c.lineTo(...at(x, y))));
      c.closePath();
      c.fill();
    } else if (one.text) {
      c.fillText(one.text[2], ...at(one.text[0], one.text[1]));
    }
  }
}

const shortened = (value) => String(Number(value.toPrecision(3)));

function curveOf(points, firstTick, lastTick) {
  const values = points.map(([, value]) => value);
  const low = Math.min(...values);
  const high = Math.max(...values);
  const x = (tick) => ((1000 * (tick - firstTick)) / Math.max(lastTick - firstTick, 1)).toFixed(1);
  const y = (value) => (38 - (36 * (value - low)) / Math.max(high - low, 1e-12)).toFixed(1);
  const step = Math.max(1, Math.ceil(points.length / curvePoints));
  const kept = points.filter((_, i) => i % step === 0);
  const svg = shape('svg', { viewBox: '0 0 1000 40', preserveAspectRatio: 'none', 'aria-hidden': 'true' });
  const now = shape('path', { class: 'now' });
  svg.append(shape('path', { class: 'value', d: 'M' + kept.map(([t, v]) => `${x(t)} ${y(v)}`).join('L') }), now);
  return { svg, low, high, show: (tick) => now.setAttribute('d', `M${x(tick)} 0V40`) };
}

// Returns the value of the last point at or before a tick.
function valueAt(points, tick) {
  const [at, value] = points[lastAt(points, tick, ([one]) => one)];
  return at <= tick ? value : null;
}

// The part of the page that shows the thoughts of the teams that have any, and their logs.
export class ThoughtsView {
  constructor(place, svg, ticks) {
    this.place = place;
    this.svg = svg;
    this.ticks = ticks;  // [first, last]
    this.teams = [];  // {team, thoughts, hidden: Set, curves: [{points, show, output}]}
    this.logs = {};  // by team
  }

  async add(team, name, { thoughts, log }) {
    const known = thoughts ? new Thoughts(await unpackText(thoughts)) : null;
    const draws = known !== null && known.layers.length + known.values.size > 0;
    if (!draws && !log) return;
    const part = element('section', `own ${team}`);
    part.append(element('h2', '', `${draws ? 'Thoughts' : 'Log'} of ${name}`));
    this.place.append(part);
    this.place.hidden = false;
    if (draws) this.#addThoughts(part, team, known);
    if (log) {
      const details = element('details');
      this.logs[team] = new TeamLog(log);
      details.append(element('summary', '', 'Log'), this.logs[team].list);
      details.addEventListener('toggle', () => this.show(this.tick, this.left));
      part.append(details);
    }
  }

  #addThoughts(part, team, thoughts) {
    this.canvas ??= new ThoughtsCanvas(this.svg);
    const one = { team, thoughts, hidden: new Set(), curves: [] };
    const layers = element('fieldset', 'layers');
    layers.append(element('legend', 'visually-hidden', 'Layers of the thoughts'));
    for (const layer of thoughts.layers) {
      const label = element('label');
      const box = element('input');
      Object.assign(box, { type: 'checkbox', checked: true });
      box.addEventListener('change', () => {
        if (box.checked) one.hidden.delete(layer);
        else one.hidden.add(layer);
        this.show(this.tick, this.left);
      });
      label.append(box, ` ${layer || 'no name'}`);
      layers.append(label);
    }
    part.append(layers);
    for (const [name, points] of thoughts.values) {
      const row = element('div', 'curve');
      const output = element('output');
      const { svg, low, high, show } = curveOf(points, ...this.ticks);
      const scale = element('span', 'scale');
      scale.append(element('span', '', shortened(high)), element('span', '', shortened(low)));
      row.append(element('span', 'name', name), scale, svg, output);
      part.append(row);
      one.curves.push({ points, show, output });
    }
    this.teams.push(one);
    if (this.tick !== undefined) this.show(this.tick, this.left);
  }

  // What a team drew and printed in a tick; null if neither is known.
  at(team, tick) {
    const shapes = this.teams.find((one) => one.team === team)?.thoughts.at(tick);
    const lines = this.logs[team]?.at(tick);
    return shapes || lines ? { shapes: shapes ?? [], lines: lines ?? [] } : null;
  }

  show(tick, left) {
    this.tick = tick;
    this.left = left;
    for (const log of Object.values(this.logs)) {
      if (log.list.parentElement.open) log.show(tick);
    }
    if (!this.canvas) return;
    this.canvas.begin();
    for (const { team, thoughts, hidden, curves } of this.teams) {
      thoughts.at(tick).filter(({ layer }) => !hidden.has(layer)).forEach((one) => this.canvas.draw(one, team !== left));
      for (const { points, show, output } of curves) {
        show(tick);
        output.textContent = valueAt(points, tick)?.toPrecision(4) ?? '–';
      }
    }
  }
}
