// SPDX-License-Identifier: MIT
//
// The referee's calls: a list to click, marks on the time line, and a banner at the moment of a call.
import { element, minutes, words } from './text.js';

const bannerTicks = 60;  // time for which a banner is shown

export class Calls {
  // `names`: the teams' names by colour. `jump(tick)` moves the player to that tick. `score`: that
  // with which the leg started.
  constructor(list, marks, banner, names, jump, score = { blue: 0, yellow: 0 }) {
    Object.assign(this, { list, marks, banner, jump });
    // A team that plays against itself is told apart by its colours.
    this.names = names.blue === names.yellow
      ? { blue: `${names.blue} (blue)`, yellow: `${names.yellow} (yellow)` } : names;
    list.replaceChildren();  // the page has the calls as text, for readers without scripts
    this.calls = [];
    this.score = { ...score };  // after the calls so far
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
      element('span', 'what', this.title(call)), element('span', 'why', this.why(call)));
    button.addEventListener('click', () => this.jump(call.tick));
    row.append(button);
    this.list.append(row);
    this.rows.push(row);
    const mark = element('button', `${call.decision === 'GOAL' ? 'goal' : 'call'} ${colour}`);
    mark.title = `${minutes(call.clock, 0)} ${this.title(call)} – ${this.why(call)}`;
    mark.tabIndex = -1;  // keyboard users reach the calls through the list
    mark.setAttribute('aria-hidden', 'true');
    mark.addEventListener('click', () => this.jump(call.tick));
    this.marks.append(mark);
  }

  // A leg that a team lost by itself ends with a call that says why.
  addFaults(result, tick, clock) {
    for (const { team, code, text } of result.faults ?? []) {
      const both = result.faults.length > 1;
      const gainer = both ? null : { blue: 'yellow', yellow: 'blue' }[team];
      this.add({ tick, clock, decision: 'FORFEIT', team, gainer, offender: team, reason: `${code}: ${text}` });
    }
  }

  // Colours follow the team that gains.
  colour(call) { return call.gainer ?? 'nobody'; }

  robot({ team, robot }) { return `${this.names[team]} ${robot}`; }

  // "Goal for striker, 2 : 1 – own goal of chaser 0", "Penalty kick for striker".
  title(call) {
    const gainer = this.names[call.gainer];
    switch (call.decision) {
      case 'GOAL': {
        const scorer = call.scorer ? ` – ${call.own_goal ? 'own goal of ' : ''}${this.robot(call.scorer)}` : '';
        const assist = call.assist ? `, assist ${this.robot(call.assist)}` : '';
        const kind = call.kind && call.kind !== 'open_play' ? ` (${words(call.kind).toLowerCase()})` : '';
        return `Goal for ${gainer}, ${call.score.blue} : ${call.score.yellow}${scorer}${assist}${kind}`;
      }
      case 'MATCH_END': return gainer ? `Match end, ${gainer} wins` : 'Match end';
      case 'ATTEMPT_END': return gainer ? `Attempt end, goal for ${gainer}` : 'Attempt end, no goal';
      case 'FORFEIT': return gainer ? `Forfeit, ${gainer} wins` : 'Forfeit';
      case 'NONE': return 'Noted';
      default: return words(call.decision) + (gainer ? ` for ${gainer}` : '');
    }
  }

  // The reason with the names of the teams: "chaser 2 pushed striker 1 0.11 m".
  why(call) {
    const reason = call.reason.replace(/\b(?:the )?(blue|yellow)( robot| team| goal)?\b/g, (all, colour, what) => (
      what === ' goal' ? `${this.names[colour]}'s goal` : this.names[colour]));
    const offender = this.names[call.offender];
    return offender && !reason.includes(offender) ? `${offender}: ${reason}` : reason;
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
    const now = this.calls.findLastIndex((one) => one.tick <= tick);
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
    const isWhole = call.decision === 'GOAL';  // its title names the scorer
    this.banner.textContent = isWhole ? this.title(call) : `${this.title(call)} – ${this.why(call)}`;
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
