// SPDX-License-Identifier: MIT
//
// Builds the page from its data (embedded in it or sent by a server), the player and the controls.
import { Calls } from './calls.js';
import { FieldView } from './field.js';
import { listen } from './live.js';
import { Player } from './player.js';
import { commandAt, download, situationAt } from './situation.js';
import { showHeat, showStatistics } from './statistics.js';
import { minutes, words } from './text.js';
import { Track, unpack } from './track.js';

const by = (id) => document.getElementById(id);
const leg = JSON.parse(by('leg').textContent);
const names = { blue: leg.teams.blue.name, yellow: leg.teams.yellow.name };
const track = new Track(leg.period);
const field = new FieldView(document.querySelector('.field'));
const player = new Player(track, show);
const calls = new Calls(by('calls'), by('marks'), by('banner'), names, (tick) => player.seek(tick * leg.period), leg.score);
const shownTick = () => Math.floor(player.time / leg.period + 1e-6);
const moments = [];  // {tick, state, phase, left, score}: from that tick on
let result = null;

function momentAt(tick) {
  let i = moments.length - 1;
  while (i > 0 && moments[i].tick > tick) --i;
  return moments[i];
}

function show() {
  if (track.isEmpty) return;
  const tick = shownTick();
  const moment = momentAt(tick);
  const scene = field.show(track, player.time, moment.left);
  calls.show(tick);
  const isOver = result !== null && tick >= track.lastTick;
  const score = isOver ? result.score : moment.score;
  by('score').textContent = `${score.blue} : ${score.yellow}`;
  by('phase').textContent = isOver ? words(result.end) : words(moment.phase);
  by('clock').textContent = minutes(scene.clock);
  by('time').textContent = `${minutes(player.time, 2)} · tick ${tick}`;
  const scrub = by('scrub');
  scrub.value = tick;
  scrub.setAttribute('aria-valuetext', minutes(player.time, 1));
  scrub.style.setProperty('--done', `${(100 * (tick - track.firstTick)) / Math.max(track.lastTick - track.firstTick, 1)}%`);
  by('play').classList.toggle('playing', player.isPlaying);
  by('play').setAttribute('aria-label', player.isPlaying ? 'Pause' : 'Play');
  by('live').classList.toggle('on', player.isFollowing);
  rememberMoment();
}

// Writes the shown moment into the page's address, at most twice a second: browsers refuse more.
let rememberLater = 0;
function rememberMoment() {
  if (rememberLater || player.isFollowing) return;
  rememberLater = setTimeout(() => {
    rememberLater = 0;
    if (!player.isFollowing) history.replaceState(null, '', `#t=${player.time.toFixed(2)}`);
  }, 500);
}

function goToAddress() {
  const match = /^#t=([0-9]+(\.[0-9]+)?)$/.exec(location.hash);
  if (match) player.seek(Number(match[1]));
  return match !== null;
}

function fitTimeline() {
  by('scrub').min = track.firstTick;
  by('scrub').max = track.lastTick;
  calls.spread(track.firstTick, track.lastTick);
}

function showNumbers(numbers) {
  showStatistics(by('statistics'), numbers);
  showHeat(by('heat'), numbers.heat);
}

async function copyLink() {
  history.replaceState(null, '', `#t=${player.time.toFixed(2)}`);
  try {
    await navigator.clipboard.writeText(location.href);
    by('link').textContent = 'Copied';
  } catch {
    by('link').textContent = 'In the address bar';
  }
  setTimeout(() => { by('link').textContent = 'Link'; }, 1500);
}

// Shows the command that plays on from the shown moment, and copies it.
async function playOn() {
  const command = by('command');
  command.textContent = commandAt(shownTick(), leg.teams);
  command.hidden = false;
  try {
    await navigator.clipboard.writeText(command.textContent);
    by('play-on').textContent = 'Copied';
  } catch {
    by('play-on').textContent = 'Below';
  }
  setTimeout(() => { by('play-on').textContent = 'Play on'; }, 1500);
}

function saveSituation() {
  const tick = shownTick();
  const call = leg.decisions.filter((one) => one.restart && one.tick <= tick).pop();
  download('situation.json', situationAt({ track, tick, moment: momentAt(tick), call, league: leg.league }));
}

function toCall(direction) {
  const tick = calls.neighbour(shownTick(), direction);
  if (tick !== undefined) player.seek(tick * leg.period);
}

function changeSpeed(direction) {
  const select = by('speed');
  select.selectedIndex = Math.min(Math.max(select.selectedIndex + direction, 0), select.length - 1);
  player.speed = Number(select.value);
}

const keys = {
  ' ': () => player.toggle(),
  ArrowLeft: (event) => player.seek(player.time - (event.shiftKey ? 10 : 1)),
  ArrowRight: (event) => player.seek(player.time + (event.shiftKey ? 10 : 1)),
  Home: () => player.seek(player.begin),
  End: () => player.seek(player.end),
  ',': () => player.step(-1),
  '.': () => player.step(1),
  '[': () => toCall(-1),
  ']': () => toCall(1),
  '-': () => changeSpeed(-1),
  '+': () => changeSpeed(1),
  '=': () => changeSpeed(1),
  l: copyLink,
  p: playOn,
  s: saveSituation,
};

function onKey(event) {
  const isChoice = event.target.tagName === 'SELECT';
  const isPress = event.key === ' ' && event.target.tagName === 'BUTTON';
  const action = leg.live && 'ps'.includes(event.key) ? undefined : keys[event.key];
  if (!action || isChoice || isPress || event.ctrlKey || event.altKey || event.metaKey) return;
  event.preventDefault();
  action(event);
}

function connectControls() {
  by('play').addEventListener('click', () => player.toggle());
  by('back').addEventListener('click', () => player.step(-1));
  by('forward').addEventListener('click', () => player.step(1));
  by('previous').addEventListener('click', () => toCall(-1));
  by('next').addEventListener('click', () => toCall(1));
  by('link').addEventListener('click', copyLink);
  by('play-on').addEventListener('click', playOn);
  by('save').addEventListener('click', saveSituation);
  by('live').addEventListener('click', () => player.follow());
  by('speed').addEventListener('change', () => { player.speed = Number(by('speed').value); });
  by('scrub').addEventListener('input', () => player.seek(Number(by('scrub').value) * leg.period));
  document.addEventListener('keydown', onKey);
  addEventListener('hashchange', goToAddress);
}

function showReplay() {
  unpack(leg.track.packed, leg.track.frames, 3 + 6 * leg.robots).forEach((frame, tick) => track.add(tick, frame));
  moments.push(...leg.moments);
  result = leg.result;
  leg.decisions.forEach((call) => calls.add(call));
  calls.addFaults(result, track.lastTick, track.lastClock);
  showNumbers(leg.statistics);
  fitTimeline();
  if (!goToAddress()) player.show(0);
}

function followMatch() {
  by('live').hidden = false;
  for (const id of ['link', 'play-on', 'save']) by(id).hidden = true;
  document.body.classList.add('live');
  listen(leg.live, {
    onStart({ decisions }) {
      document.body.classList.remove('lost');
      decisions.slice(calls.calls.length).forEach((call) => calls.add(call));
      if (!player.isPlaying) player.follow();
    },
    onFrame({ tick, frame, moment }) {
      track.add(tick, frame);
      moments.push({ tick, ...moment });
      fitTimeline();
    },
    onCall(call) { calls.add(call); },
    onStatistics: showNumbers,
    onEnd(end) {
      result = end;
      calls.addFaults(result, track.lastTick, track.lastClock);
      document.body.classList.add('ended');
      by('live').textContent = 'Ended';
    },
    onLost() { document.body.classList.add('lost'); },
  });
}

by('about').textContent = leg.about;
connectControls();
if (leg.live) followMatch();
else showReplay();
