// SPDX-License-Identifier: MIT
//
// What a team printed in a leg: its lines follow the shown time, as far as they know their tick ("tick 606: …").
import { element } from './text.js';

const marked = /^tick ([0-9]+): /;

export class TeamLog {
  constructor(text) {
    this.lines = [];  // {tick, text}: without a tick it is that of the line before
    let tick = 0;
    for (const line of text.replace(/\n$/, '').split('\n')) {
      const found = marked.exec(line);
      if (found) tick = Number(found[1]);
      this.lines.push({ tick, text: found ? line.slice(found[0].length) : line });
    }
    this.list = element('ol', 'log');
    this.list.tabIndex = 0;  // a keyboard scrolls it
    this.list.setAttribute('aria-label', 'Log');
    this.list.append(...this.lines.map(({ tick: at, text: said }) => {
      const row = element('li');
      row.append(element('span', 'when', at), ` ${said}`);
      return row;
    }));
  }

  // The lines of a tick.
  at(tick) { return this.lines.filter((line) => line.tick === tick).map(({ text }) => text); }

  show(tick) {
    let last = -1;
    this.lines.forEach((line, i) => {
      this.list.children[i].classList.toggle('now', line.tick === tick);
      if (line.tick <= tick) last = i;
    });
    if (last === this.last) return;
    this.last = last;
    const row = this.list.children[Math.max(last, 0)];
    this.list.scrollTop = row.offsetTop - this.list.clientHeight / 2;
  }
}
