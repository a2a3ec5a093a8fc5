// SPDX-License-Identifier: MIT
//
// The page of the coach: each goal as it was played, beside a future without it, with one time for both. The goals are
// {period, robots, left, played, other, substituted, marks: {decides, goal}}; films and marks begin at the first tick of the
// study. `substituted` is the place of the robot among all robots, blue ones first.
import { FieldView } from './field.js';
import { Player } from './player.js';
import { by, element } from './text.js';
import { Track } from './track.js';

const halfSpeed = { isOn: false, speedAt: () => 0.5 };

function filmIn(figure, film, { period, robots, left }) {
  const view = new FieldView(figure.querySelector('svg'));
  const track = new Track(period);
  track.load(film, robots);
  return { track, show: (time) => view.show(track, time, left) };
}

function showGoal(section, goal) {
  const part = (name) => section.querySelector(`.${name}`);
  const films = ['played', 'other'].filter((name) => goal[name]).map((name) => filmIn(part(name), goal[name], goal));
  const { track } = films.reduce((a, b) => (b.track.lastTick > a.track.lastTick ? b : a));
  part('other')?.querySelectorAll('.robot')[goal.substituted].classList.add('substituted');
  const scrub = part('scrub');
  const player = new Player(track, halfSpeed, () => {
    films.forEach((film) => film.show(player.time));
    scrub.value = Math.round(player.time / goal.period);
    const seconds = player.time - goal.marks.goal * goal.period;
    part('time').textContent = `${Math.abs(seconds).toFixed(2)} s ${seconds < 0 ? 'before' : 'after'} the goal`;
    part('play').textContent = player.isPlaying ? 'Pause' : 'Play';
  });
  scrub.max = track.lastTick;
  // The words stand on both sides of the two moments, which may be near to each other.
  const mark = (name, words, side, share) => {
    part('marks').appendChild(element('span', name, words)).style[side] = `${100 * share}%`;
  };
  mark('goal', 'goal', 'left', goal.marks.goal / track.lastTick);
  if (goal.other) mark('decides', 'substitute decides', 'right', 1 - goal.marks.decides / track.lastTick);
  scrub.addEventListener('input', () => player.seek(scrub.value * goal.period));
  part('play').addEventListener('click', () => player.toggle());
  player.seek((goal.marks.decides ?? goal.marks.goal) * goal.period);
}

const goals = JSON.parse(by('goals').textContent);
document.querySelectorAll('section').forEach((section, i) => showGoal(section, goals[i]));
