// SPDX-License-Identifier: MIT
//
// Moves the bodies of the SVG picture that is embedded in the page.

const trailSeconds = 1;

// Writes each team's name at the end that it defends.
export function nameEnds(left, names) {
  for (const [end, team] of [['left', left], ['right', left === 'blue' ? 'yellow' : 'blue']]) {
    const place = document.querySelector(`.end.${end}`);
    place.className = `end ${end} ${team}`;
    place.textContent = names[team];
  }
}

// The place of a pointer in a picture: m, y upwards.
export function placeIn(svg, { clientX, clientY }) {
  const map = svg.getScreenCTM();
  return { x: (clientX - map.e) / map.a / 1000, y: -(clientY - map.f) / map.d / 1000 };
}

export class FieldView {
  constructor(svg) {
    this.ball = svg.querySelector('.ball');
    this.trail = svg.querySelector('.trail');
    this.robots = [...svg.querySelectorAll('.robot')];
    this.goals = { left: svg.querySelector('.goal.left'), right: svg.querySelector('.goal.right') };
  }

  show(track, time, leftTeam) {
    const scene = track.at(time);
    const place = (element, { x, y }) =>
      element.setAttribute('transform', `translate(${x.toFixed(1)} ${y.toFixed(1)})`);
    place(this.ball, scene.ball);
    scene.robots.forEach((robot, i) => {
      place(this.robots[i], robot);
      this.robots[i].firstElementChild.setAttribute('transform', `rotate(${robot.degrees.toFixed(1)})`);
    });
    const runs = track.trail(time, trailSeconds);
    if (!scene.ball.stays) runs[runs.length - 1].push([scene.ball.x, scene.ball.y]);
    this.trail.setAttribute('d', runs.map((run) => 'M' + run.map((p) => p.join(' ')).join('L')).join(''));
    const rightTeam = leftTeam === 'blue' ? 'yellow' : 'blue';
    this.goals.left.setAttribute('class', `goal left ${leftTeam}`);
    this.goals.right.setAttribute('class', `goal right ${rightTeam}`);
    return scene;
  }
}
