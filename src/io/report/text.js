// Numbers and elements. Text from the report always becomes text nodes, never markup.

// element('p', {class: 'note'}, 'text', child, ...)
function element(name, attributes = {}, ...children) {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) {
    if (key.startsWith('on')) made.addEventListener(key.slice(2), value);
    else if (value !== false && value !== null) made.setAttribute(key, value === true ? '' : value);
  }
  made.append(...children.filter((child) => child !== null));
  return made;
}

function byId(id) {
  return document.getElementById(id);
}

// The number with all its digits, as JavaScript reads it back.
function exact(value) {
  return value === null ? '\u2013' : String(value);
}

const kGrouping = new Intl.NumberFormat('en', {maximumFractionDigits: 0});

// A count, in groups of three.
function count(value) {
  return kGrouping.format(value).replace(/,/g, '\u202f');
}

// About so many significant digits, for reading.
function about(value, digits = 4) {
  if (value === null || !Number.isFinite(value)) return '\u221e';
  const size = Math.abs(value);
  if (size !== 0 && (size < 1e-4 || size >= 1e9)) return value.toPrecision(digits).replace('e+', 'e');
  const decimals = size === 0 ? 0 : Math.max(0, Math.min(8, digits - 1 - Math.floor(Math.log10(size))));
  return new Intl.NumberFormat('en', {maximumFractionDigits: decimals}).format(value).replace(/,/g, '\u202f');
}

function percent(part, whole) {
  return whole === 0 ? '0\u202f%' : `${Math.round((100 * part) / whole)}\u202f%`;
}

function plural(number, one, many) {
  return `${count(number)} ${number === 1 ? one : many}`;
}

// The last part of a path.
function baseName(path) {
  const parts = path.split('/');
  return parts[parts.length - 1] || path;
}
