// SPDX-License-Identifier: MIT
//
// Words and numbers for people. Names go into the page as text, never as markup.

export const by = (id) => document.getElementById(id);

// An element with a class and text.
export function element(tag, cssClass, text) {
  const made = document.createElement(tag);
  if (cssClass) made.className = cssClass;
  if (text !== undefined) made.textContent = text;
  return made;
}

// An element of a picture with its attributes.
export function shape(tag, attributes) {
  const made = document.createElementNS('http://www.w3.org/2000/svg', tag);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  return made;
}

// "KICK_OFF_VIOLATION" -> "Kick off violation"
export function words(name) {
  const text = name.replaceAll('_', ' ').toLowerCase();
  return text.charAt(0).toUpperCase() + text.slice(1);
}

// 83.25 -> "1:23.2"
export function minutes(seconds, digits = 1) {
  const scale = 10 ** digits;
  const whole = Math.floor(seconds * scale + 1e-6) / scale;
  const rest = (whole % 60).toFixed(digits);
  return `${Math.floor(whole / 60)}:${rest.padStart(digits > 0 ? 3 + digits : 2, '0')}`;
}
