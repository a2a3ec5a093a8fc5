// SPDX-License-Identifier: MIT
//
// The playground: legs by house teams and by hand, without a server. In the workbench, workbench.js comes after this.
import { FieldView, nameEnds } from './field.js';
import { Layers } from './layers.js';
import { Play } from './play.js';
import { by } from './text.js';

export const given = JSON.parse(by('playground').textContent);  // {module, leagues: {small: {robots, zones}…}, drills: {NAME: drill}}
const views = {};
let file = null;  // the JSON of a situation or a drill

function viewOf(league) {
  for (const name of Object.keys(given.leagues)) by(`pitch_${name}`).hidden = name !== league;
  if (!views[league]) {
    const svg = document.querySelector(`#pitch_${league} .field`);
    const { robots, zones } = given.leagues[league];
    views[league] = { svg, field: new FieldView(svg), layers: new Layers(svg, robots, zones, () => play.keepers) };
  }
  for (const name of ['trails', 'velocities', 'zones', 'keepers']) views[league].layers.set(name, by(name).checked);
  return views[league];
}

export const play = new Play(viewOf, (left) => {
  const nameOf = (colour) => [play.teams[colour], play.driven === colour && 'you'].filter(Boolean).join(' and ') || 'nobody';
  const names = { blue: nameOf('blue'), yellow: nameOf('yellow') };
  nameEnds(left, names);
  for (const team of ['blue', 'yellow']) by(`${team}_name`).textContent = names[team];
});

export function optionsOf(teams) {
  const common = { seed: Number(by('seed').value), teams };
  const drill = file?.schema === 'mirocup/drill/1' ? file : given.drills[by('start').value];
  by('teaches').textContent = drill ? `${drill.title}. ${drill.teaches ?? ''} You are blue, and have ${drill.seconds} s.` : '';
  if (drill) return { ...common, drill: JSON.stringify(drill) };
  const options = {
    ...common, league: file?.league ?? by('league').value, conditions: by('conditions').value, pitch: by('pitch').value,
    rules: { preset: by('rules').value, half_s: Number(by('half').value) },
  };
  return file ? { ...options, situation: file } : options;
}

const teamOf = (colour, first) => (by(`hand_${colour}`).length === 0 ? first : by(`hand_${colour}`).value);

async function start() {
  by('hand_told').textContent = '';
  const teams = { blue: teamOf('blue', 'striker'), yellow: teamOf('yellow', 'tactician') };
  if (teams.yellow.startsWith('drill:')) teams.yellow = 'tactician';
  await play.begin(given.module, { options: optionsOf(teams) });
}

// Begins a leg, and follows a changed option.
export const acts = { start, choose: start };

async function openFile() {
  const [chosen] = by('file').files;
  try {
    file = chosen ? JSON.parse(await chosen.text()) : null;
  } catch {
    throw new Error(`${chosen.name} is not a situation or a drill of mirocup`);
  }
  await acts.choose();
}

for (const [name, drill] of Object.entries(given.drills)) by('start').append(new Option(`drill: ${drill.title}`, name));
by('options').addEventListener('submit', (event) => {
  event.preventDefault();
  play.try(acts.start);
  by('hand_play').focus();  // so that the next key plays
  document.querySelector('figure').scrollIntoView({ block: 'nearest' });
});
by('start').addEventListener('change', () => {
  file = null;
  by('file').value = '';
  play.try(acts.choose);
});
by('file').addEventListener('change', () => play.try(openFile));
for (const name of ['trails', 'velocities', 'zones', 'keepers']) {
  by(name).addEventListener('change', () => {
    for (const { layers } of Object.values(views)) layers.set(name, by(name).checked);
    play.show();
  });
}
by('pitch_small').hidden = false;  // at once, before the module is there
if (given.module) {
  by('hand').hidden = false;
  play.try(start);
}
