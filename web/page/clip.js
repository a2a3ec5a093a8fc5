// SPDX-License-Identifier: MIT
//
// Saves seconds of a leg as a video: plays them in a canvas that the browser records (WebM).

const width = 960;  // px of the video
const rate = 30;  // frames a second
const background = '#1d2a24';

export const canRecord = () => typeof MediaRecorder === 'function'
  && typeof HTMLCanvasElement.prototype.captureStream === 'function';

// Draws moments of a leg into a canvas: the same shapes and colours as the picture of the page.
export class Painter {
  constructor(svg) {
    const [x, y, w, h] = svg.getAttribute('viewBox').split(' ').map(Number);
    this.box = { x, y, w, h };
    this.scale = width / w;
    this.head = 48;
    this.canvas = document.createElement('canvas');
    this.canvas.width = width;
    this.canvas.height = Math.round(h * this.scale / 2) * 2 + this.head;
    this.context = this.canvas.getContext('2d');
    const path = (selector) => new Path2D(svg.querySelector(selector).getAttribute('d'));
    this.paths = Object.fromEntries(['ground', 'lines', 'spots'].map((name) => [name, path(`.${name}`)]));
    this.goals = { left: path('.goal.left'), right: path('.goal.right') };
    this.side = Number(svg.querySelector('.robot rect').getAttribute('width'));
    this.radius = Number(svg.querySelector('.ball').getAttribute('r'));
  }

  paint(scene, { leftTeam, text, names }) {
    const c = this.context;
    c.setTransform(1, 0, 0, 1, 0, 0);
    c.fillStyle = background;
    c.fillRect(0, 0, this.canvas.width, this.canvas.height);
    this.writeHead(text, names);
    c.setTransform(this.scale, 0, 0, this.scale, -this.box.x * this.scale, this.head - this.box.y * this.scale);
    const fill = (path, colour) => { c.fillStyle = colour; c.fill(path); };
    fill(this.paths.ground, '#2c7a57');
    const colours = { blue: '#3d8bff99', yellow: '#ffd52e99' };
    fill(this.goals.left, colours[leftTeam]);
    fill(this.goals.right, colours[leftTeam === 'blue' ? 'yellow' : 'blue']);
    c.lineWidth = 1.6 / this.scale;
    c.strokeStyle = '#ffffffbf';
    c.stroke(this.paths.lines);
    fill(this.paths.spots, '#ffffffbf');
    scene.robots.forEach((robot, i) => this.paintRobot(robot, i, scene.robots.length / 2));
    c.beginPath();
    c.arc(scene.ball.x, scene.ball.y, this.radius, 0, 2 * Math.PI);
    c.fillStyle = '#ff7a1a';
    c.fill();
  }

  writeHead(text, names) {
    const c = this.context;
    const middle = this.canvas.width / 2;
    c.font = '700 24px system-ui, sans-serif';
    c.textBaseline = 'middle';
    c.textAlign = 'center';
    c.fillStyle = '#fff';
    c.fillText(text, middle, this.head / 2);
    const room = middle - c.measureText(text).width / 2 - 40;
    c.textAlign = 'right';
    c.fillStyle = '#9cc4ff';
    c.fillText(names.blue, middle - c.measureText(text).width / 2 - 20, this.head / 2, room);
    c.textAlign = 'left';
    c.fillStyle = '#ffe88a';
    c.fillText(names.yellow, middle + c.measureText(text).width / 2 + 20, this.head / 2, room);
  }

  paintRobot({ x, y, degrees }, i, perTeam) {
    const c = this.context;
    const isBlue = i < perTeam;
    c.save();
    c.translate(x, y);
    c.save();
    c.rotate(degrees * Math.PI / 180);
    c.fillStyle = isBlue ? '#1f6fe0' : '#ffd52e';
    c.fillRect(-this.side / 2, -this.side / 2, this.side, this.side);
    c.fillStyle = isBlue ? '#fff' : '#3b3100';
    c.fillRect(0.3 * this.side, -0.36 * this.side, 0.13 * this.side, 0.72 * this.side);
    c.restore();
    c.font = `700 ${this.side / 2}px system-ui, sans-serif`;
    c.textAlign = 'center';
    c.textBaseline = 'middle';
    c.fillStyle = isBlue ? '#fff' : '#2b2400';
    c.fillText(String(i % perTeam), 0, 0);
    c.restore();
  }
}

// Records the seconds from `from` to `to` at their own speed. `paint(time)` draws a moment.
// Resolves to a Blob.
export function record(canvas, from, to, paint) {
  return new Promise((resolve, reject) => {
    const stream = canvas.captureStream(rate);
    const recorder = new MediaRecorder(stream, { mimeType: 'video/webm', videoBitsPerSecond: 4_000_000 });
    const parts = [];
    recorder.addEventListener('dataavailable', ({ data }) => parts.push(data));
    recorder.addEventListener('stop', () => resolve(new Blob(parts, { type: 'video/webm' })));
    recorder.addEventListener('error', () => reject(new Error('the browser could not record')));
    paint(from);
    recorder.start();
    const begin = performance.now();
    const frame = () => {
      const time = from + (performance.now() - begin) / 1000;
      paint(Math.min(time, to));
      if (time < to) requestAnimationFrame(frame);
      else recorder.stop();
    };
    requestAnimationFrame(frame);
  });
}
