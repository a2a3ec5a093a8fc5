// SPDX-License-Identifier: MIT
//
// The workbench: a team in C++, which the page compiles and plays. Compiler and leg have a worker each; Stop ends them.
import { Inspector } from './inspector.js';
import { momentum, MomentumView } from './momentum.js';
import { houseTeams } from './play.js';
import { acts, given, optionsOf, play } from './playground.js';
import { download } from './situation.js';
import { by, element } from './text.js';

const bench = given.workbench;  // {parts, clang: folders beside the page, bytes: of the packed compiler, team: the first text}
const compileLimit = 120;  // s without a sign of progress
const nearlyAll = 0.98;  // of the bytes of the compiler; the rest are scripts
const answerLimit = 20;  // s for a question to the leg
const chunk = 300;  // ticks in a question, if the leg is played to its end
const seeds = 10;
const student = 2.262;  // Student's t for 95 % of ten values
const leastMemory = 1;  // GB of a device; the compiler takes half of it
const pause = 2000;  // ms between two questions for the verdict
const mostLines = 2000;  // of the log
const keptAs = `mirocup/workbench${location.pathname}`;
const isOnDisk = location.protocol === 'file:';
const addressOf = (folder, name = '') => new URL(`${folder}/${name}`, location.href).href;
const tell = (text) => { by('code_told').textContent = text; };

let compiler = null;  // the worker
let isCompiling = false;
const rejects = new Set();  // of the promises that wait for a worker

// Ends the leg, and the compiler if it is at work, which must then be loaded again.
function stop(why = 'it was stopped') {
  play.worker?.terminate();
  play.worker = null;
  play.asked = Promise.resolve();
  if (isCompiling) {
    compiler.terminate();
    compiler = null;
  }
  rejects.forEach((reject) => reject(new Error(why)));
}

// A promise that stop() rejects. After so many seconds without a call of `again` it stops the work itself.
async function limited(seconds, what, act) {
  let timer;
  let rejectIt;
  const again = () => {
    clearTimeout(timer);
    timer = setTimeout(() => stop(`${what} took more than ${seconds} s`), 1000 * seconds);
  };
  try {
    return await new Promise((resolve, reject) => {
      rejects.add(rejectIt = reject);
      again();
      act(resolve, reject, again);
    });
  } finally {
    clearTimeout(timer);
    rejects.delete(rejectIt);
  }
}

// Returns {wasm, text, seconds}: compile.js.
async function compile(source) {
  isCompiling = true;
  compiler ??= new Worker(addressOf(bench.parts, 'compile.js'), { type: 'module' });
  try {
    let loaded = 0;
    return await limited(compileLimit, 'the compiler', (resolve, reject, again) => {
      compiler.onmessage = ({ data }) => {
        by('loaded').hidden = !data.loaded;
        if (data.problem) return reject(new Error(data.problem));
        if (!data.loaded) return resolve(data);
        loaded += data.loaded;
        by('loaded').value = loaded / bench.bytes;
        if (loaded > nearlyAll * bench.bytes) tell('Compiling, for the first time …');
        return again();
      };
      compiler.onerror = (event) => reject(new Error(`the compiler ended: ${event.message || 'is there enough memory?'}`));
      compiler.postMessage({ clang: addressOf(bench.clang), source });
    });
  } finally {
    isCompiling = false;
    by('loaded').hidden = true;
  }
}

const beginnings = { 'a whole team': bench.team };

// Offers the texts with which a team can begin, of which the build has made some from the tutorial.
async function offerBeginnings() {
  if (!isOnDisk) Object.assign(beginnings, await (await fetch(addressOf(bench.parts, 'beginnings.json'))).json());
  by('beginning').replaceChildren(...Object.keys(beginnings).map((name) => new Option(name)));
}

function makeEditor() {
  const editor = globalThis.ace.edit(by('editor'), {
    mode: 'ace/mode/c_cpp', theme: matchMedia('(prefers-color-scheme: dark)').matches ? 'ace/theme/one_dark' : 'ace/theme/chrome',
    fontSize: 14, tabSize: 2, useSoftTabs: true, useWorker: false, wrap: 'free', indentedSoftWrap: true, enableKeyboardAccessibility: true, showPrintMargin: false,
    vScrollBarAlwaysVisible: true, customScrollbar: true,  // a bar that takes no place would cover the ends of lines
    value: localStorage.getItem(keptAs) ?? bench.team,
  });
  editor.renderer.once('afterRender', () => editor.resize(true));  // its first lines took the place of the bar
  editor.textInput.getElement().setAttribute('aria-label', 'The source of your team');
  editor.commands.addCommand({ name: 'run', bindKey: { win: 'Ctrl-Enter', mac: 'Command-Enter' }, exec: () => by('run').click() });
  editor.session.on('change', () => localStorage.setItem(keptAs, editor.getValue()));
  return editor;
}
const editor = makeEditor();

// Completion and hints for the functions that a team may call, with their comments.
async function describeFunctions() {
  advice = await (await fetch(addressOf(bench.parts, 'advice.json'))).json();
  const functions = await (await fetch(addressOf(bench.parts, 'functions.json'))).json();
  const rows = Object.entries(functions).map(([name, docText]) => ({ value: name, meta: 'mirocup', docText }));
  editor.setOptions({
    enableBasicAutocompletion: [{ getCompletions: (of, session, place, prefix, done) => done(null, rows) }], enableLiveAutocompletion: true,
  });
  const { HoverTooltip } = globalThis.ace.require('ace/tooltip');
  const hint = new HoverTooltip();
  hint.setDataProvider((event) => {
    const place = event.getDocumentPosition();
    const range = editor.session.getWordRange(place.row, place.column);
    const text = functions[editor.session.getTextRange(range)];
    if (text) hint.showForRange(editor, range, element('pre', 'hint', text), event);
  });
  hint.addToEditor(editor);
}

let advice = [];  // [[words of the compiler, what to do]…]

// Shows what the compiler says, each message at its line, with what to do about a usual mistake. Below the first error the others
// often follow from it.
function showMessages(text) {
  const found = [...text.matchAll(/^team\.cpp:([0-9]+):([0-9]+): (?:fatal )?(error|warning): (.*)$/gm)];
  const cure = (said) => advice.filter(([words]) => said.includes(words)).slice(0, 1).map(([, what]) => `\ndo: ${what}`).join('');
  editor.session.setAnnotations(found.map(([, row, column, type, said]) => ({ row: row - 1, column: column - 1, type, text: said + cure(said) })));
  by('errors').hidden = text === '';
  by('errors').textContent = text.replace(/^team\.cpp:.*: (?:fatal )?error: (.*)$/m, (line, said) => line + cure(said));
  const first = found.find(([, , , type]) => type === 'error');
  if (first) editor.gotoLine(Number(first[1]), Number(first[2]) - 1, false);
}

// The leg is played by leg.js, whose answers also have what the team printed.
let game;  // the bytes of mirocup.wasm
play.connect = async ({ wasm }) => {
  game ??= await (await fetch(addressOf(bench.parts, 'mirocup.wasm'))).arrayBuffer();
  play.worker = new Worker(addressOf(bench.parts, 'leg.js'), { type: 'module' });
  play.seatName = await play.ask({ act: 'load', team: wasm, game, parameters: {} });
};
const { ask, shown } = play;
const askInTime = (question) => limited(answerLimit, 'your team', (resolve, reject) => ask.call(play, question).then(resolve, reject));
play.ask = async (question) => {
  if (!play.worker) throw new Error('press Run to begin a leg');
  let answer;
  try {
    answer = await askInTime(question);
  } catch (error) {
    tell(`The leg ended: ${error.message}.`);
    throw error;
  }
  if (answer?.isNew) goals = [];  // its decisions are those of the whole leg
  for (const { decision, tick, gainer } of answer?.status?.decisions ?? []) if (decision === 'GOAL') goals.push({ tick, team: gainer });
  for (const { tick, text } of answer?.log ?? []) {
    printed.set(tick, [...(printed.get(tick) ?? []), text]);
    const row = element('li');
    row.append(element('span', 'when', tick), ` ${text}`);
    if (by('log').childElementCount < mostLines) by('log').append(row);
  }
  if (answer?.status?.over && !answer.isBack) await tellEnd(answer);
  return answer;
};
// The numbers of a robot beside the code, as on the page of a replay, and the momentum of the leg.
const printed = new Map();  // lines of the team, by tick
let ends = [];  // from a tick on, which team defends the left end
let goals = [];
let inspector = null;
const curve = new MomentumView(by('momentum'), (share) => {
  play.time = share * play.lastTime;
  play.show();
});
const endsAt = (tick) => ends.findLast((end) => end.tick <= tick) ?? ends[0];

function forgetLeg() {
  inspector = null;
  printed.clear();
  ends = [];
}

function inspect() {
  for (const old of document.querySelectorAll('.inspected')) old.remove();
  const fresh = by('inspected').cloneNode();  // without the former leg's choice
  by('inspected').replaceWith(fresh);
  by('inspector').replaceChildren();
  const viewer = { svg: play.view.svg, robots: play.robots, track: play.track, momentAt: endsAt };
  inspector = new Inspector({ place: by('inspector'), body: fresh, names: { blue: play.seatName, yellow: by('opponent').value } }, viewer, null,
    (team, tick) => (team === 'blue' ? { shapes: [], lines: printed.get(tick) ?? [] } : null), () => play.show());
}

function drawMomentum() {
  const { track } = play;
  const farthest = Math.max(...track.frames.map((frame) => Math.abs(frame[1])), 1);
  curve.draw(momentum(track, farthest, (tick) => endsAt(tick).left), goals.map(({ tick, team }) => ({ share: tick / track.lastTick, team })));
}

play.shown = (left) => {
  shown.call(play, left);
  if (endsAt(play.status.tick)?.left !== left) ends.push({ tick: play.status.tick, left });
  inspector?.show(play.time);
  curve.show(play.time / play.lastTime || 0);
  by('scrub').max = play.track.lastTick;
  by('scrub').value = play.time / play.track.period;
  by('scrub').disabled = play.isPlaying;
  by('finish').disabled = play.status.over;
};

async function tellEnd({ slowest, status }) {
  const hash = await askInTime({ act: 'hash' });
  const advice = status.result ? await askInTime({ act: 'advice', team: 'blue' }) : [];
  by('why').replaceChildren(...advice.map(({ drill, why }) => {
    const row = element('li', '', `${why}: `);
    const button = element('button', 'text', `try the drill ${drill}`);
    button.addEventListener('click', () => {
      by('start').value = drill;
      by('start').dispatchEvent(new Event('change'));
      by('run').click();
    });
    row.append(button);
    return row;
  }));
  by('why_title').hidden = advice.length === 0;
  drawMomentum();
  const end = status.drill ? `The drill is over: ${Math.round(100 * status.drill.marks)} of 100 marks` : 'The leg is over';
  tell(`${end}. Its state hash: ${hash}. Your slowest tick took about ${slowest.toFixed(1)} ms here, with the pauses of the browser; a league measures the processor time on its own computer.`);
}

// Compiles the team and gives it to a new worker. Returns the options of a leg, or null if the compiler refuses the team.
async function prepare() {
  stop();
  play.pause();
  by('stop').disabled = false;
  tell(compiler ? 'Compiling …' : 'Loading the compiler, once …');
  const { wasm, text, seconds } = await compile(editor.getValue());
  showMessages(text);
  if (wasm) {
    by('hand_told').textContent = '';
    by('log').replaceChildren();
    by('why').replaceChildren();
    by('why_title').hidden = true;
    by('seeds').replaceChildren();  // of the text before
    by('seeds_told').textContent = '';
    await play.connect({ wasm });
  }
  tell(wasm ? `Compiled in ${seconds.toFixed(1)} s.` : 'The compiler refused the team: its words are below, and in the editor at their lines.');
  return wasm ? optionsOf({ blue: play.seatName, yellow: by('opponent').value }) : null;
}

// Acts with the compiled team, and tells what went wrong.
async function withTeam(act) {
  if (isCompiling) return;
  try {
    const options = await prepare();
    if (options) await act(options);
  } catch (error) {
    tell(`It ended: ${error.message}.`);
  }
}

const run = () => withTeam(async (options) => {
  forgetLeg();
  await play.begin(null, { options });
  inspect();
  play.toggle();
});

// Plays ten legs with seeds from the chosen one on, each as a row: blue's goals or marks against yellow's.
const playSeeds = () => withTeam(async (options) => {
  const gains = [];
  by('seeds').replaceChildren();
  for (let seed = options.seed; seed < options.seed + seeds; ++seed) {
    const { score, drill } = await play.ask({ act: 'result', options: { ...options, seed } });
    gains.push(drill ? 100 * drill.marks : score.blue - score.yellow);
    const row = element('tr');
    row.append(element('th', '', `seed ${seed}`), element('td', '', drill ? `${(100 * drill.marks).toFixed(0)} marks` : `${score.blue} : ${score.yellow}`));
    by('seeds').append(row);
  }
  stop();  // this worker has no leg to go on with
  const mean = gains.reduce((sum, gain) => sum + gain, 0) / seeds;
  const error = Math.sqrt(gains.reduce((sum, gain) => sum + (gain - mean) ** 2, 0) / (seeds - 1) / seeds);
  const [low, high] = [mean - student * error, mean + student * error].map((value) => value.toFixed(1));
  by('seeds_told').textContent = `Mean ${options.drill ? 'marks' : 'goal difference'}: ${mean.toFixed(1)}, with 95 % certainty between ${low} and ${high}.`;
});

// Plays the rest of the leg at once.
async function finish() {
  for (let tick = -1; !play.status.over && play.status.tick > tick;) {
    tick = play.status.tick;
    await play.act({ act: 'play', ticks: chunk, hand: null });
  }
}

// Hands the text in to the league that has this page, with the log-in of this browser, and follows the check.
async function handIn() {
  const say = (text) => { by('verdict').textContent = text; };
  say('Sending …');
  const reply = await fetch('api/v1/entries?name=team.cpp', { method: 'PUT', body: editor.getValue() });
  const sent = await reply.json();
  if (reply.status === 401) {
    const link = element('a', '', 'Log in with your token');
    link.href = 'hand-in';
    return by('verdict').replaceChildren(link, ', then return to this page: your text stays.');
  }
  if (reply.status !== 202) return say(`Not taken: ${sent.error}.`);
  for (let report = {}; !['accepted', 'refused', 'void'].includes(report.state);) {
    await new Promise((resolve) => { setTimeout(resolve, pause); });
    report = await (await fetch(sent.url.slice(1))).json();
    say(`Entry ${sent.entry}: ${report.message ?? report.reason ?? report.state}`);
  }
  return null;
}

acts.start = run;
acts.choose = async () => optionsOf({});
for (const team of houseTeams) by('opponent').append(new Option(team, team, team === 'chaser', team === 'chaser'));
by('run').addEventListener('click', run);
by('play_seeds').addEventListener('click', playSeeds);
by('stop').addEventListener('click', () => {
  stop();
  play.pause();
  tell('The leg ended: it was stopped.');
});
by('finish').addEventListener('click', finish);
by('scrub').addEventListener('input', () => {
  play.time = Number(by('scrub').value) * play.track.period;
  play.show();
});
by('hand_in')?.addEventListener('click', () => handIn().catch((error) => { by('verdict').textContent = `The server does not answer: ${error.message}.`; }));
by('export').addEventListener('click', () => download('team.cpp', editor.getValue()));
by('import').addEventListener('click', () => by('source_file').click());
by('source_file').addEventListener('change', async () => {
  const [chosen] = by('source_file').files;
  if (chosen) editor.setValue(await chosen.text(), -1);
  by('source_file').value = '';
});
by('again').addEventListener('click', () => {
  const text = editor.getValue();
  const isOwn = text.trim() !== '' && !Object.values(beginnings).includes(text);
  if (!isOwn || window.confirm('Replace your text? Export saves it as a file.')) editor.setValue(beginnings[by('beginning').value], -1);
});
if (isOnDisk) {
  by('run').disabled = true;
  tell('Run needs a web server: a browser starts no compiler from a disk. Put this folder on any web server, or call “python3 -m http.server” in it. To play by hand, open playground.html.');
} else {
  describeFunctions();
}
offerBeginnings();
if (navigator.deviceMemory < leastMemory) {
  tell('This device has little memory, and the compiler may end before it is done. You can still read, change and export the team.');
}
