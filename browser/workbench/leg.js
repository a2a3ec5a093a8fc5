// SPDX-License-Identifier: MIT
//
// The worker in which a leg of the workbench is played: no page, no storage, and a compiled team that can call only what teams.js
// gives it.
import { answering, handActs, loadMirocup } from './mirocup.js';
import { Teams } from './teams.js';

let teams;
let mirocup;
const acts = handActs(async (wasm) => (mirocup = await loadMirocup(wasm, teams)));
const looked = (act) => async (question) => {
  const answer = await act(question);
  return answer?.thoughts ? { ...answer, ...teams.look(answer.thoughts) } : answer;
};

onmessage = answering({
  ...Object.fromEntries(Object.entries(acts).map(([name, act]) => [name, looked(act)])),
  // Answers the name under which the team takes a seat. The page gives both modules, so this worker needs no network.
  async load({ team, game, parameters }) {
    teams = new Teams(await WebAssembly.compile(team), parameters);
    await acts.load({ wasm: game });
    return teams.name;
  },
  // Plays a whole leg without drawing it. Returns the leg's status.
  result({ options }) {
    const leg = mirocup.leg(options);
    leg.play(2 ** 31 - 1);
    const status = leg.status();
    leg.free();
    return status;
  },
});
