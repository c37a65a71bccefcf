// The table of pits: sorted, filtered, a page at a time.

const kPageLength = 50;

const kColumns = [
  {label: 'Kind', value: (pit) => pit.shownAs, text: (pit) => pit.shownAs},
  {label: 'Vertex', value: (pit) => pit.name, text: (pit) => String(pit.name), number: true},
  {label: 'x', value: (pit) => pit.realX, text: (pit) => exact(pit.realX), number: true},
  {label: 'y', value: (pit) => pit.realY, text: (pit) => exact(pit.realY), number: true},
  {label: 'Elevation', value: (pit) => pit.realZ, text: (pit) => exact(pit.realZ), number: true},
  {label: 'Depth', value: (pit) => pit.depth, text: (pit) => (Number.isFinite(pit.depth) ? about(pit.depth, 6) : 'lowest'), number: true},
  {label: 'Size', value: (pit) => pit.vertices, text: (pit) => count(pit.vertices), number: true},
  {label: 'Reason', value: (pit) => pit.reason, text: (pit) => pit.reason || '\u2013'},
  {label: 'Needs order', value: (pit) => pit.need ?? Infinity, text: (pit) => (pit.need === null ? '\u2013' : String(pit.need)), number: true},
];

class PitTable {
  constructor(pits, state) {
    this.pits = pits;
    this.state = state;
    this.filter = 'all';
    this.column = 5;
    this.descending = true;
    this.page = 0;
    this.body = document.querySelector('#pits tbody');
    this.makeFilter();
    this.makeHead();
    this.sort();
    this.body.addEventListener('click', (event) => this.onPick(event.target.closest('tr')));
    this.body.addEventListener('keydown', (event) => this.onKey(event));
  }

  makeFilter() {
    const number = (kind) => this.pits.list.filter((pit) => kind === 'all' || pit.shownAs === kind).length;
    byId('table-filter').append(...['all', 'removed', 'remaining', 'boundary'].map((kind) =>
      element('button', {type: 'button', 'aria-pressed': String(kind === this.filter), 'data-kind': kind,
                         onclick: () => this.choose(kind)}, `${kind} `, element('span', {}, count(number(kind))))));
  }

  choose(kind) {
    this.filter = kind;
    for (const button of byId('table-filter').children) {
      button.setAttribute('aria-pressed', String(button.dataset.kind === kind));
    }
    this.sort();
  }

  makeHead() {
    document.querySelector('#pits thead').append(element('tr', {}, ...kColumns.map((column, i) =>
      element('th', {scope: 'col', class: column.number ? 'number' : ''},
              element('button', {type: 'button', onclick: () => this.sortBy(i)}, column.label)))));
  }

  sortBy(column) {
    this.descending = this.column === column ? !this.descending : kColumns[column].number === true;
    this.column = column;
    this.sort();
  }

  sort() {
    const {value} = kColumns[this.column];
    const sign = this.descending ? -1 : 1;
    this.rows = this.pits.list.filter((pit) => this.filter === 'all' || pit.shownAs === this.filter);
    this.rows.sort((p, q) => {
      const a = value(p), b = value(q);
      return a === b ? p.name - q.name : a < b ? -sign : sign;
    });
    document.querySelectorAll('#pits th').forEach((th, i) => {
      th.setAttribute('aria-sort', i !== this.column ? 'none' : this.descending ? 'descending' : 'ascending');
    });
    this.page = 0;
    this.show();
  }

  show() {
    const shown = this.rows.slice(this.page * kPageLength, (this.page + 1) * kPageLength);
    this.body.replaceChildren(...shown.map((pit, i) => {
      const tr = element('tr', {tabindex: i === 0 ? 0 : -1}, ...kColumns.map((column, j) =>
        element('td', {class: column.number ? 'number' : ''},
                ...(j === 0 ? [element('i', {class: `dot ${pit.shownAs}`})] : []), column.text(pit))));
      tr.pit = pit;
      return tr;
    }));
    const pages = Math.max(1, Math.ceil(this.rows.length / kPageLength));
    const turn = (by) => () => {
      this.page += by;
      this.show();
    };
    byId('pager').replaceChildren(...(pages === 1 ? [] : [
      element('button', {type: 'button', disabled: this.page === 0, onclick: turn(-1)}, 'Previous'),
      element('span', {}, `page ${count(this.page + 1)} of ${count(pages)}`),
      element('button', {type: 'button', disabled: this.page + 1 >= pages, onclick: turn(1)}, 'Next')]));
    this.mark();
  }

  onPick(tr) {
    if (tr) this.state.choose(tr.pit, {fly: true});
  }

  onKey(event) {
    const tr = event.target.closest('tr');
    const to = {ArrowDown: tr?.nextElementSibling, ArrowUp: tr?.previousElementSibling}[event.key];
    if (to) {
      event.preventDefault();
      to.focus();
    } else if (event.key === 'Enter' || event.key === ' ') {
      event.preventDefault();
      this.onPick(tr);
    }
  }

  // The row of the chosen pit is marked.
  mark() {
    for (const tr of this.body.children) {
      const chosen = tr.pit === this.state.chosen;
      tr.classList.toggle('chosen', chosen);
      if (chosen) tr.setAttribute('aria-current', 'true');
      else tr.removeAttribute('aria-current');
    }
  }
}
