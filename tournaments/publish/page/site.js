// SPDX-License-Identifier: MIT
//
// What the pages of a league can do where scripts run: show one team only. `league serve` replaces
// the body of a page that changes, so listeners are those of the document.
'use strict';

function isOf(element, team) {
  return element.dataset.home === team || element.dataset.away === team;
}

function showTeam(team) {
  for (const fixture of document.querySelectorAll('.fixtures > li[data-home]')) {
    fixture.hidden = team !== '' && !isOf(fixture, team);
  }
  for (const row of document.querySelectorAll('[data-team]')) {
    row.classList.toggle('chosen', row.dataset.team === team);
  }
  if (team === '') return;
  for (const round of document.querySelectorAll('details.round, details.fold')) {
    round.open = round.querySelector('li[data-home]:not([hidden])') !== null;
  }
}

function start() {
  for (const part of document.querySelectorAll('.filter')) part.hidden = false;
}

document.addEventListener('change', (event) => {
  if (event.target.id === 'filter') showTeam(event.target.value);
});
document.addEventListener('mirocup:page', start);
start();
