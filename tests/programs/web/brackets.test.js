// SPDX-License-Identifier: MIT
//
// bracket.json of each format, drawn by brackets-viewer as a page would have it. Catches a table or a key that it needs and that
// is not there, and a match that it does not show.
import assert from 'node:assert/strict';
import { after, test } from 'node:test';
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { closeBrowser, folder, moduleFile, openPage, readJson, run } from './support.js';

after(closeBrowser);

const viewer = join(folder, 'viewer.html');
writeFileSync(viewer, `<!doctype html><meta charset="utf-8"><div id="bracket" class="brackets-viewer"></div>
<script src="${moduleFile('brackets-viewer/dist/brackets-viewer.min.js')}"></script>`);

// Returns how many matches of a bracket the viewer shows, the names of the teams there, and the cells of its ranking.
async function drawn(bracket) {
  const page = await openPage(`file://${viewer}`);
  const shown = await page.evaluate(async (tables) => {
    await globalThis.bracketsViewer.render({
      stages: tables.stage, matches: tables.match, matchGames: tables.match_game, participants: tables.participant,
    }, { selector: '#bracket' });
    const texts = (what) => [...document.querySelectorAll(what)].map((element) => element.textContent);
    const ranking = [...document.querySelectorAll('#bracket table tr')].map((row) => [...row.children].map((cell) => cell.textContent));
    return { matches: texts('#bracket .match').length, names: texts('#bracket .name'), ranking };
  }, bracket);
  assert.deepEqual(page.problems, []);
  await page.close();
  return shown;
}

const formats = {
  knockout: [{ kind: 'knockout' }, 6],
  'knockout-of-two-legs': [{ kind: 'knockout', legs: 2, third_place: false }, 5],
  groups: [{ kind: 'groups', groups: 2, qualifiers: 1 }, 6],
  'round-robin': [{ kind: 'round_robin' }, 3],
  swiss: [{ kind: 'swiss', rounds: 2 }, 5],
};
for (const [name, [format, count]] of Object.entries(formats)) {
  test(`a bracket of the format ${name} is drawn before and after its legs`, async () => {
    const league = join(folder, name);
    const teams = Array.from({ length: count }, (_, i) => ({ name: `team${i}`, entry: `house:${i % 2 ? 'idle' : 'chaser'}` }));
    writeFileSync(`${league}.json`, JSON.stringify({
      schema: 'mirocup/league/1', title: 'Cup & <Co> "Ünïcode" 杯', format, rules: { half_s: 1 }, teams,
    }));
    run('league', 'init', league, '--config', `${league}.json`);
    for (const part of ['before', 'after']) {
      if (part === 'after') run('league', 'start', league);
      run('league', 'export', league, '-o', `${league}-${part}`);
      const bracket = readJson(join(`${league}-${part}`, 'bracket.json'));
      const shown = await drawn(bracket);
      assert.equal(shown.matches, bracket.match.length, part);
      for (const team of teams) assert.ok(shown.names.some((text) => text.includes(team.name)), `${team.name} ${part}`);
      if (!['round-robin', 'swiss'].includes(name)) continue;
      const { table } = readJson(join(`${league}-${part}`, 'table.json'));
      const rows = shown.ranking.slice(1).map((cells) => [cells[1], ...[...cells.slice(2, 6), cells.at(-1)].map((cell) => Number(cell) || 0)]);
      assert.deepEqual(rows.sort(), table.map((row) => [row.team, row.played, row.won, row.drawn, row.lost, row.points]).sort(), part);
    }
  });
}
