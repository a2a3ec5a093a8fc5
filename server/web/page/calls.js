// SPDX-License-Identifier: MIT
//
// The referee's calls: a list to click, marks on the time line, and a banner at the moment of a call.
import { element, minutes, words } from './text.js';

const bannerTicks = 60;  // time for which a banner is shown

export class Calls {
  // `names`: the teams' names by colour. `jump(tick)` moves the player to that tick.
  constructor(list, marks, banner, names, jump) {
    Object.assign(this, { list, marks, banner, names, jump });
    list.replaceChildren();  // the page has the calls as text, for readers without scripts
    this.calls = [];
    this.score = { blue: 0, yellow: 0 };  // after the calls so far
    this.rows = [];
    this.shown = -1;
  }

  add(call) {
    if (call.decision === 'GOAL') ++this.score[call.team];
    call = { ...call, score: { ...this.score } };
    const colour = this.colour(call);
    this.calls.push(call);
    const row = element('li', call.decision === 'GOAL' ? 'goal' : '');
    const button = element('button', colour);
    button.append(element('span', 'when', minutes(call.clock, 0)),
      element('span', 'what', this.title(call)));
    const who = this.scorers(call);
    if (who) button.append(element('span', 'who', who));
    button.append(element('span', 'why', call.reason));
    button.addEventListener('click', () => this.jump(call.tick));
    row.append(button);
    this.list.append(row);
    this.rows.push(row);
    const mark = element('button', `${call.decision === 'GOAL' ? 'goal' : 'call'} ${colour}`);
    mark.title = `${minutes(call.clock, 0)} ${this.title(call)}`;
    mark.tabIndex = -1;  // keyboard users reach the calls through the list
    mark.setAttribute('aria-hidden', 'true');
    mark.addEventListener('click', () => this.jump(call.tick));
    this.marks.append(mark);
  }

  // Colours follow the team that gains; records from before it was written down name one team only.
  colour(call) {
    return ('gainer' in call ? call.gainer : call.team) ?? 'nobody';
  }

  // "Goal · striker 2 : 1", "Penalty kick for striker".
  title(call) {
    const gainer = call.gainer ?? (call.decision === 'GOAL' ? call.team : null);
    if (call.decision === 'GOAL') {
      const kind = call.own_goal ? ' (own goal)' : '';
      return `${words(call.decision)}${kind} · ${this.names[gainer]} ${call.score.blue} : ${call.score.yellow}`;
    }
    return words(call.decision) + (gainer ? ` for ${this.names[gainer]}` : '');
  }

  // "robot 2, pass by robot 1"; "" for an own goal, and where the record does not say.
  scorers(call) {
    if (call.decision !== 'GOAL' || !call.scorer || call.own_goal) return '';
    return `robot ${call.scorer.robot}` + (call.assist ? `, pass by robot ${call.assist.robot}` : '');
  }

  get goals() { return this.calls.filter((call) => call.decision === 'GOAL'); }

  // Places the marks between the ends of the time line.
  spread(firstTick, lastTick) {
    const length = Math.max(lastTick - firstTick, 1);
    this.calls.forEach((call, i) => {
      this.marks.children[i].hidden = call.tick < firstTick;
      this.marks.children[i].style.left = `${(100 * (call.tick - firstTick)) / length}%`;
    });
  }

  show(tick) {
    let now = this.calls.length - 1;
    while (now >= 0 && this.calls[now].tick > tick) --now;
    const call = this.calls[now];
    const isFresh = call !== undefined && tick - call.tick < bannerTicks;
    this.banner.hidden = !isFresh;
    if (now === this.shown) return;
    this.rows[this.shown]?.removeAttribute('aria-current');
    this.shown = now;
    const row = this.rows[now];
    if (!row) return;
    row.setAttribute('aria-current', 'true');
    this.list.scrollTop = row.offsetTop - this.list.clientHeight / 2;
    this.banner.textContent = this.title(call);
    this.banner.className = `${this.colour(call)}${call.decision === 'GOAL' ? ' goal' : ''}`;
  }

  // Returns the tick of the call before or after the given tick.
  neighbour(tick, direction) {
    const found = direction < 0
      ? this.calls.findLast((call) => call.tick < tick)
      : this.calls.find((call) => call.tick > tick);
    return found?.tick;
  }
}
