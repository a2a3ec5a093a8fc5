// SPDX-License-Identifier: MIT
//
// Builds the page from its data (embedded in it or sent by a server), the player and the controls.
import { Calls } from './calls.js';
import { canRecord, Painter, record } from './clip.js';
import { nameEnds, placeIn } from './field.js';
import { Inspector } from './inspector.js';
import { momentum, MomentumView } from './momentum.js';
import { Player } from './player.js';
import { houseTeams, Play } from './play.js';
import { offerProof, proofData } from './proof.js';
import { Reel } from './reel.js';
import { commandAt, download, situationAt } from './situation.js';
import { heatOf, showHeat, showStatistics } from './statistics.js';
import { by, element, minutes, words } from './text.js';
import { ThoughtsView, unpackBytes, unpackText } from './thoughts.js';
import { Viewer } from './viewer.js';

const leg = JSON.parse(by('leg').textContent);
const names = { blue: leg.teams.blue.name, yellow: leg.teams.yellow.name };
const picture = document.querySelector('.field');
const viewer = new Viewer(picture, leg, () => (play?.isOn ? play.keepers : null));
const { track, field, layers } = viewer;
const reel = new Reel(() => calls.goals.map((call) => call.tick * leg.period));
const player = new Player(track, reel, show);
const calls = new Calls(by('calls'), by('marks'), by('banner'), names, (tick) => player.seek(tick * leg.period), leg.score);
const shownTick = () => Math.floor(player.time / leg.period + 1e-6);
// A goal of this tick counts; the moment that has it begins with the next one.
const scoreAt = (tick) => viewer.momentAt(tick + 1).score;
const curve = new MomentumView(by('momentum'), (share) =>
  player.seek((track.firstTick + share * (track.lastTick - track.firstTick)) * leg.period));
let result = null;
let thoughts = null;  // of a replay that has any
let inspector = null;
const play = by('hand') ? new Play(() => ({ svg: picture, field, layers }), showEnds) : null;

function show() {
  if (track.isEmpty || play?.isOn) return;
  const tick = shownTick();
  const moment = viewer.momentAt(tick);
  const scene = viewer.show(player.time);
  inspector?.show(player.time);
  thoughts?.show(tick, moment.left);
  calls.show(tick);
  showEnds(moment.left);
  curve.show(viewer.shareOf(player.time / leg.period));
  by('slow').hidden = !(player.isPlaying && reel.isSlow(player.time));
  const isOver = result !== null && tick >= track.lastTick;
  const score = isOver ? result.score : scoreAt(tick);
  by('score').textContent = `${score.blue} : ${score.yellow}`;
  by('phase').textContent = isOver ? words(result.end) : words(moment.phase);
  by('clock').textContent = minutes(scene.clock);
  by('time').textContent = `tick ${tick}`;
  by('time').title = `${player.time.toFixed(2)} s since the leg began; the clock beside the score counts play only`;
  const scrub = by('scrub');
  scrub.value = tick;
  scrub.setAttribute('aria-valuetext', minutes(player.time, 1));
  scrub.style.setProperty('--done', `${100 * viewer.shareOf(tick)}%`);
  by('play').classList.toggle('playing', player.isPlaying);
  by('play').setAttribute('aria-label', player.isPlaying ? 'Pause' : 'Play');
  by('live').classList.toggle('on', player.isFollowing);
  rememberMoment();
}

// Each team's name stands at the end that it defends.
let leftShown = null;
function showEnds(left) {
  if (left === leftShown) return;
  leftShown = left;
  nameEnds(left, names);
}

// The shown moment as a part of an address. It is rounded up: a moment before a goal's is before the goal.
const momentLink = () => `#t=${(Math.ceil(1000 * player.time - 1e-6) / 1000).toFixed(3)}`;

let knownAddress = location.hash;  // of the address that this page has followed or written
function writeAddress() {
  history.replaceState(null, '', momentLink());
  knownAddress = location.hash;
}

// Writes the shown moment into the page's address, at most twice a second: browsers refuse more. The page first follows a new
// address that a visitor has typed.
let rememberLater = 0;
function rememberMoment() {
  if (rememberLater || player.isFollowing) return;
  rememberLater = setTimeout(() => {
    rememberLater = 0;
    if (!player.isFollowing && location.hash === knownAddress) writeAddress();
  }, 500);
}

function goToAddress() {
  knownAddress = location.hash;
  const match = /^#t=([0-9]+(\.[0-9]+)?)$/.exec(location.hash);
  if (match) player.seek(Number(match[1]));
  return match !== null;
}

function fitTimeline() {
  by('scrub').min = track.firstTick;
  by('scrub').max = track.lastTick;
  calls.spread(track.firstTick, track.lastTick);
}

function drawMomentum() {
  const goals = calls.goals.map((call) => ({ share: viewer.shareOf(call.tick), team: calls.colour(call) }));
  curve.draw(momentum(track, leg.half_length / 0.0005, (tick) => viewer.momentAt(tick).left), goals);
}

// Fills the choice of the ball and robots, and draws the heat map of the chosen one.
function offerBodies() {
  const offer = (text, column) => {
    const option = element('option', '', text);
    option.value = column;  // of its x in a frame (track.js)
    by('heat_of').append(option);
  };
  offer('the ball', 1);
  for (const [t, team] of ['blue', 'yellow'].entries()) {
    for (let i = 0; i < leg.robots; ++i) {
      offer(`${names[team]}, robot ${i}`, 3 + 3 * (t * leg.robots + i));
    }
  }
  const [, , width, height] = picture.getAttribute('viewBox').split(' ').map((mm) => mm / 1000);
  const draw = () => {
    const heat = heatOf(track, Number(by('heat_of').value), [width, height],
      (tick) => viewer.momentAt(tick).state === 'PLAY', (tick) => viewer.momentAt(tick).left);
    showHeat(by('heat'), heat, by('heat_of').selectedOptions[0].textContent);
  };
  by('heat_of').addEventListener('change', draw);
  by('heat_part').hidden = false;
  draw();
}

function showNumbers(numbers) {
  by('statistics_title').textContent = leg.live ? 'Statistics so far' : 'Statistics of the whole leg';
  showStatistics(by('statistics'), numbers);
  layers.actions.set(numbers);
}

// Copies a text, and says so for a moment on the button; or where the text is. `name()`: what the button says then.
async function copy(text, button, where, name) {
  try {
    await navigator.clipboard.writeText(text);
    button.textContent = 'Copied';
  } catch {
    button.textContent = where;
  }
  setTimeout(() => { button.textContent = name(); }, 1500);
}

async function copyLink() {
  writeAddress();
  await copy(location.href, by('link'), 'In the address bar', () => 'Link');
}

// Plays on in this page, from the shown moment, or goes back to the replay.
async function playHere() {
  if (play.isOn) {
    play.end();
  } else {
    const { module, record, replay } = await proofData();
    const houseTeam = (name) => (houseTeams.includes(name) ? name : 'striker');
    await play.begin(module, {
      record: await unpackText(record), replay: await unpackBytes(replay), tick: Math.min(shownTick(), track.lastTick - 1),
      teams: { blue: 'recorded', yellow: 'recorded' }, substitutes: { blue: houseTeam(names.blue), yellow: houseTeam(names.yellow) },
    });
  }
  document.querySelector('.stage').classList.toggle('by_hand', play.isOn);
  pressed('play-on', play.isOn);
  by('play-on').textContent = play.isOn ? 'Back to the replay' : 'Play on';
  by('banner').hidden = true;
  player.changed();
}

// Shows the command that plays on from the shown moment, and copies it; with the module, the page plays on, too. Again: back.
async function playOn() {
  const command = by('command');
  if (play?.isOn) {
    command.hidden = true;
    await playHere();
    return;
  }
  player.isPlaying = player.isPlaying && !play;
  command.textContent = commandAt(shownTick(), leg.teams);
  command.hidden = false;
  await copy(command.textContent, by('play-on'), 'Below', () => (play?.isOn ? 'Back to the replay' : 'Play on'));
  if (play) await playHere().catch((error) => { command.textContent = `It cannot be played on here: ${error.message}.`; });
}

function saveSituation() {
  const tick = shownTick();
  const call = leg.decisions.filter((one) => one.restart && one.tick <= tick).pop();
  download('situation.json', situationAt({ track, tick, moment: viewer.momentAt(tick), call, league: leg.league }));
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

function pressed(id, isOn) { by(id).setAttribute('aria-pressed', String(isOn)); }

function toggleReel() {
  if (!reel.isOn && calls.goals.length === 0) return;
  reel.isOn = !reel.isOn;
  pressed('reel', reel.isOn);
  if (!reel.isOn) return player.changed();
  player.seek(player.start);
  if (!player.isPlaying) player.toggle();
}

function toggleLoop() {
  player.isLooping = !player.isLooping;
  pressed('loop', player.isLooping);
}

function toggleFull() {
  if (document.fullscreenElement) document.exitFullscreen();
  else document.querySelector('.stage').requestFullscreen?.();
}

function toggleLayer(name) {
  layers.set(name, !layers.isOn[name]);
  by(name).checked = layers.isOn[name];
  by('shots_about').hidden = !(layers.isOn.shots || layers.isOn.passes);
  show();
}

const clipSeconds = 6;

// Saves the seconds before the shown moment as a video.
let isRecording = false;
async function saveClip() {
  if (isRecording || !canRecord() || track.isEmpty) return;
  isRecording = true;
  by('clip').disabled = true;
  by('clip').textContent = 'Recording';
  const to = player.time > player.begin + 1 ? player.time : Math.min(player.begin + clipSeconds, player.end);
  const painter = new Painter(picture);
  const paint = (time) => {
    const tick = Math.floor(time / leg.period + 1e-6);
    const { left } = viewer.momentAt(tick);
    const score = scoreAt(tick);
    painter.paint(track.at(time), { leftTeam: left, names, text: `${score.blue} : ${score.yellow}` });
  };
  try {
    const from = Math.max(to - clipSeconds, player.begin);
    download(`clip-${from.toFixed(0)}-${to.toFixed(0)}.webm`, await record(painter.canvas, from, to, paint), 'video/webm');
    by('clip').textContent = 'Clip';
  } catch {
    by('clip').textContent = 'No video here';
  }
  by('clip').disabled = false;
  isRecording = false;
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
  g: toggleReel,
  o: toggleLoop,
  f: toggleFull,
  c: saveClip,
  t: () => toggleLayer('trails'),
  v: () => toggleLayer('velocities'),
  z: () => toggleLayer('zones'),
  h: () => toggleLayer('shots'),
  a: () => toggleLayer('passes'),
  k: () => toggleLayer('keepers'),
  n: () => inspector?.next(),
  x: () => inspector?.toggleKept(),
};

function onKey(event) {
  if (play?.isOn && event.key !== 'p') return;
  const isChoice = event.target.tagName === 'SELECT';
  const isPress = event.key === ' ' && ['BUTTON', 'INPUT', 'A'].includes(event.target.tagName) && event.target.id !== 'scrub';
  const action = leg.live && 'ps'.includes(event.key) ? undefined : keys[event.key];
  if (!action || isChoice || isPress || event.ctrlKey || event.altKey || event.metaKey) return;
  event.preventDefault();
  action(event);
}

function connectControls() {
  const acts = {
    play: () => player.toggle(), back: () => player.step(-1), forward: () => player.step(1), live: () => player.follow(),
    previous: () => toCall(-1), next: () => toCall(1), reel: toggleReel, loop: toggleLoop, full: toggleFull,
    link: copyLink, 'play-on': playOn, save: saveSituation, clip: saveClip,
  };
  for (const [id, act] of Object.entries(acts)) by(id).addEventListener('click', act);
  by('clip').hidden = !canRecord();
  for (const name of Object.keys(layers.isOn)) by(name).addEventListener('change', () => toggleLayer(name));
  by('speed').addEventListener('change', () => { player.speed = Number(by('speed').value); });
  by('scrub').addEventListener('input', () => player.seek(Number(by('scrub').value) * leg.period));
  document.addEventListener('keydown', onKey);
  addEventListener('hashchange', goToAddress);
}

function showReplay() {
  viewer.load(leg);
  result = leg.result;
  leg.decisions.forEach((call) => calls.add(call));
  calls.addFaults(result, track.lastTick, track.lastClock);
  showNumbers(leg.statistics);
  fitTimeline();
  drawMomentum();
  offerBodies();
  showOwn();
  inspect();
  offerProof((tick) => player.seek(tick * leg.period));
  if (!goToAddress()) player.show(0);
}

// What only the teams and their host may see, if it is in the page.
function showOwn() {
  if (!leg.own) return;
  thoughts = new ThoughtsView(by('own'), picture, [track.firstTick, track.lastTick]);
  for (const [team, own] of Object.entries(leg.own)) thoughts.add(team, names[team], own);
  addEventListener('resize', show);
}

// Lets the reader ask for the numbers of a robot, by a click on it.
function inspect() {
  by('inspect').hidden = false;
  inspector = new Inspector({ place: by('inspector'), body: by('inspected'), names }, viewer, leg.wheels,
    (team, tick) => thoughts?.at(team, tick) ?? null, () => player.changed());
  document.querySelector('figure').addEventListener('click', (event) => {
    if (!play?.isOn) inspector.chooseAt(placeIn(picture, event), player.time);
  });
}

function followMatch() {
  by('live').hidden = false;
  for (const id of ['link', 'play-on', 'save']) by(id).hidden = true;
  document.body.classList.add('live');
  // A viewer may join in the middle or again after a lost connection.
  const source = new EventSource(leg.live);
  const on = {
    start({ decisions }) {
      document.body.classList.remove('lost');
      decisions.slice(calls.calls.length).forEach((call) => calls.add(call));
      if (!player.isPlaying) player.follow();
    },
    frame(now) {
      viewer.add(now);
      fitTimeline();
    },
    call(call) { calls.add(call); },
    statistics(numbers) {
      showNumbers(numbers);
      drawMomentum();
    },
    end(end) {
      source.close();
      result = end;
      calls.addFaults(result, track.lastTick, track.lastClock);
      document.body.classList.add('ended');
      by('live').textContent = 'Ended';
      drawMomentum();
      offerBodies();
      linkReplay();
    },
  };
  for (const [name, handle] of Object.entries(on)) source.addEventListener(name, ({ data }) => handle(JSON.parse(data)));
  source.addEventListener('error', () => document.body.classList.add('lost'));
}

// `league serve` shows a running leg below /live/ and its replay, once it is over, below /replays/.
function linkReplay() {
  const leg = /^\/live\/([^/]+)\/$/.exec(location.pathname);
  if (!leg) return;
  const link = element('a', '', 'Replay of this leg');
  link.href = `/replays/${leg[1]}.html`;
  by('about').before(link);
}

by('waiting').remove();
by('about').textContent = leg.about;
connectControls();
if (leg.live) followMatch();
else showReplay();
