// SPDX-License-Identifier: MIT
//
// The statistics of the leg: one line for each number, blue against yellow, and the ball's heat map.
import { element } from './text.js';

function line(label, blue, yellow, text) {
  const row = element('tr');
  const bar = element('td', 'bar');
  const total = blue + yellow;
  for (const [team, value] of [['blue', blue], ['yellow', yellow]]) {
    const part = element('span', team);
    part.style.width = `${total > 0 ? (50 * value) / total : 0}%`;
    bar.append(part);
  }
  const middle = element('th', '', label);
  middle.scope = 'row';
  row.append(element('td', 'blue', text(blue)), middle, element('td', 'yellow', text(yellow)));
  const bars = element('tr', 'bars');
  bar.colSpan = 3;
  bar.setAttribute('aria-hidden', 'true');
  bars.append(bar);
  return [row, bars];
}

export function showStatistics(table, { blue, yellow }) {
  const held = blue.possession + yellow.possession;
  const share = (value) => (held > 0 ? `${Math.round((100 * value) / held)} %` : '–');
  const whole = (value) => value.toFixed(0);
  table.replaceChildren(
    ...line('Possession', blue.possession, yellow.possession, share),
    ...line('Shots', blue.shots, yellow.shots, whole),
    ...line('Distance', blue.distance, yellow.distance, (m) => `${m.toFixed(0)} m`),
    ...line('Fouls', blue.fouls, yellow.fouls, whole),
  );
  if (!blue.budget) return;
  if ('cpu_seconds' in blue.budget) {
    const seconds = (s) => `${s.toFixed(2)} s`;
    const milliseconds = (ms) => `${ms.toFixed(2)} ms`;
    table.append(
      ...line('CPU time', blue.budget.cpu_seconds, yellow.budget.cpu_seconds, seconds),
      ...line('Slowest tick', blue.budget.slowest_tick_ms, yellow.budget.slowest_tick_ms, milliseconds),
    );
  }
  for (const [label, key] of [['Late ticks', 'late_ticks'], ['Bad commands', 'bad_commands']]) {
    if (blue.budget[key] + yellow.budget[key] > 0) {
      table.append(...line(label, blue.budget[key], yellow.budget[key], whole));
    }
  }
}

// Counts where a body was while it was in play, in squares of a tenth of a metre, in the frame in
// which blue attacks to the right. `column` is that of its x in a frame (track.js).
export function heatOf(track, column, size, isInPlay, leftTeamAt) {
  const [width, height] = size;
  const columns = Math.max(Math.round(width / 0.1), 1);
  const rows = Math.max(Math.round(height / 0.1), 1);
  const cells = new Array(columns * rows).fill(0);
  const unit = 0.0005;  // m
  const cell = (at, length, count) => Math.min(Math.max(Math.floor((at / length + 0.5) * count), 0), count - 1);
  track.ticks.forEach((tick, i) => {
    if (!isInPlay(tick)) return;
    const sign = leftTeamAt(tick) === 'blue' ? 1 : -1;
    const x = sign * track.frames[i][column] * unit;
    const y = -sign * track.frames[i][column + 1] * unit;
    ++cells[cell(y, height, rows) * columns + cell(x, width, columns)];
  });
  return { columns, cells };
}

// Blue attacks to the right in both halves.
export function showHeat(place, { columns, cells }, what = 'the ball') {
  const canvas = element('canvas');
  canvas.width = columns;
  canvas.height = cells.length / columns;
  canvas.setAttribute('role', 'img');
  canvas.setAttribute('aria-label', `Heat map of ${what}, blue attacks to the right`);
  const context = canvas.getContext('2d');
  const most = Math.max(...cells, 1);
  cells.forEach((count, i) => {
    context.fillStyle = `rgb(226 88 34 / ${((count / most) ** 0.7).toFixed(3)})`;
    context.fillRect(i % columns, Math.floor(i / columns), 1, 1);
  });
  const caption = element('p', 'caption');
  caption.append(element('span', 'blue', 'blue →'), element('span', 'yellow', '← yellow'));
  place.replaceChildren(canvas, caption);
}
