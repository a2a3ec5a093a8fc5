// SPDX-License-Identifier: MIT
//
// The statistics of the leg: one line for each number, blue against yellow, and where a body was.
// docs/statistics.md defines the numbers.
import { element, words } from './text.js';

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

const whole = (value) => value.toFixed(0);

// One line for each name that has a number above 0 for one of the teams.
function lines(blue, yellow) {
  return [...new Set([...Object.keys(blue), ...Object.keys(yellow)])]
    .filter((name) => (blue[name] ?? 0) + (yellow[name] ?? 0) > 0)
    .map((name) => {
      const [row] = line(words(name), blue[name] ?? 0, yellow[name] ?? 0, whole);
      row.className = 'part';
      return row;
    });
}

export function showStatistics(table, { teams: { blue, yellow }, play_s, dead_ball_s }) {
  const percent = (of) => (value) => (of > 0 ? `${Math.round((100 * value) / of)} %` : '–');
  const held = percent(blue.possession_s + yellow.possession_s);
  const forward = percent(blue.opponent_half_s + yellow.opponent_half_s);
  table.replaceChildren(
    ...line('Possession', blue.possession_s, yellow.possession_s, held),
    ...line('Territory', blue.opponent_half_s, yellow.opponent_half_s, forward),
    ...line('Shots', blue.shots, yellow.shots, whole),
    ...line('Shots on goal', blue.shots_on_goal, yellow.shots_on_goal, whole),
    ...line('Saves', blue.saves, yellow.saves, whole),
    ...line('Goals', blue.goals, yellow.goals, whole),
    ...lines(blue.goals_by_kind, yellow.goals_by_kind),
    ...line('Passes', blue.passes, yellow.passes, whole),
    ...line('Interceptions', blue.interceptions, yellow.interceptions, whole),
    ...line('Ball lost', blue.losses, yellow.losses, whole),
    ...line('Duels won', blue.duels_won, yellow.duels_won, whole),
    ...line('Distance', blue.distance_m, yellow.distance_m, (m) => `${m.toFixed(0)} m`),
    ...line('Fouls', blue.fouls, yellow.fouls, whole),
    ...lines(blue.fouls_by_law, yellow.fouls_by_law),
  );
  const caption = element('caption', '', `${play_s.toFixed(0)} s of play, ${dead_ball_s.toFixed(0)} s dead ball`);
  table.prepend(caption);
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
export function showHeat(place, { columns, cells }, what) {
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
