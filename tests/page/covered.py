"""Scripts that find texts of pictures which cover others or are covered, by the boxes of a browser."""

# A function of the picture of a figure: how many texts it has, and which of them are covered. What
# counts of a text are its letters, without descenders and the room above them; it covers another, or
# is covered by what is painted full or as a line, or stands so near to the next in its row that both
# read as one. What is drawn in the grey of a grid is meant to lie behind, and the cursor of a chart
# moves.
COVERED = """
const piecesOf = (shape) => {  // of its outline, straight, as pairs of points
  const number = (name) => Number(shape.getAttribute(name) ?? 0);
  const pieces = [];
  const ring = (points) => points.forEach((p, i) => pieces.push([points.at(i - 1), p]));
  if (shape.tagName === 'line') {
    pieces.push([[number('x1'), number('y1')], [number('x2'), number('y2')]]);
  } else if (shape.tagName === 'rect') {
    const [x, y, w, h] = ['x', 'y', 'width', 'height'].map(number);
    ring([[x, y], [x + w, y], [x + w, y + h], [x, y + h]]);
  } else if (shape.tagName === 'circle') {
    const [x, y, r] = ['cx', 'cy', 'r'].map(number);
    ring([...Array(96).keys()].map((i) => i * Math.PI / 48)
      .map((angle) => [x + r * Math.cos(angle), y + r * Math.sin(angle)]));
  } else if (shape.tagName === 'polygon') {
    const n = (shape.getAttribute('points').match(/-?[\\d.]+/g) ?? []).map(Number);
    ring(Array.from({length: n.length / 2}, (_, i) => [n[2 * i], n[2 * i + 1]]));
  } else {
    let [x, y, beginX, beginY] = [0, 0, 0, 0];
    const go = (toX, toY, isDrawn) => {
      if (isDrawn) pieces.push([[x, y], [toX, toY]]);
      [x, y] = [toX, toY];
    };
    for (const [, letter, rest] of shape.getAttribute('d').matchAll(/([A-Za-z])([^A-Za-z]*)/g)) {
      const n = (rest.match(/-?\\d*\\.?\\d+/g) ?? []).map(Number);
      const isBy = letter === letter.toLowerCase();
      const moves = 'Mm'.includes(letter);
      if ('Zz'.includes(letter)) go(beginX, beginY, true);
      else if ('Hh'.includes(letter)) n.forEach((to) => go(isBy ? x + to : to, y, true));
      else if ('Vv'.includes(letter)) n.forEach((to) => go(x, isBy ? y + to : to, true));
      else if ('MmLl'.includes(letter)) {
        for (let i = 0; i < n.length; i += 2) {
          go(n[i] + (isBy ? x : 0), n[i + 1] + (isBy ? y : 0), i > 0 || !moves);
          if (i === 0 && moves) [beginX, beginY] = [x, y];
        }
      } else throw new Error('a path with ' + letter);
    }
  }
  return pieces;
};
const runsThrough = ([a, b], box) => {
  let [from, to] = [0, 1];
  for (const [start, step, low, high] of [[a[0], b[0] - a[0], box.left, box.right],
                                          [a[1], b[1] - a[1], box.top, box.bottom]]) {
    if (step === 0) {
      if (start <= low || start >= high) return false;
      continue;
    }
    const ends = [(low - start) / step, (high - start) / step];
    from = Math.max(from, Math.min(...ends));
    to = Math.min(to, Math.max(...ends));
  }
  return to > from;
};
const coveredOf = (svg) => {
  const back = svg.getScreenCTM().inverse();
  const placesOf = new Map();  // of elements that stand alike
  const placeOf = (one) => {
    const frame = one.hasAttribute('transform') ? one : one.parentElement;
    if (!placesOf.has(frame)) {
      const m = back.multiply(one.getScreenCTM());
      placesOf.set(frame, ([x, y]) => [m.a * x + m.c * y + m.e, m.b * x + m.d * y + m.f]);
    }
    return placesOf.get(frame);
  };
  const seen = (names) => [...svg.querySelectorAll(names)]
    .filter((one) => !one.closest('[display=none], [data-cursor]'));
  const texts = seen('text').map((one) => {
    const box = one.getBBox();
    const base = Number(one.getAttribute('y'));
    const top = base - 0.66 * Number(one.closest('[font-size]').getAttribute('font-size'));
    const corners = [[box.x + 1, top], [box.x + box.width - 1, base]].map(placeOf(one));
    const [x, y] = [corners.map((p) => p[0]), corners.map((p) => p[1])];
    return {text: one.textContent, left: Math.min(...x), right: Math.max(...x),
            top: Math.min(...y), bottom: Math.max(...y)};
  });
  const found = [];
  texts.forEach((a, i) => texts.slice(0, i).forEach((b) => {
    const gap = 3;  // [px] side by side
    if (a.left < b.right + gap && b.left < a.right + gap && a.top < b.bottom && b.top < a.bottom)
      found.push(a.text + ' and ' + b.text);
  }));
  for (const shape of seen('line, path, polygon, circle, rect')) {
    const kind = shape.getAttribute('class') ?? '';
    if (!/ks-s-(?!grid)|ks-f-(?!grid|paper|tint)/.test(kind)) continue;
    const pieces = piecesOf(shape).map((piece) => piece.map(placeOf(shape)));
    for (const text of texts) {
      if (pieces.some((piece) => runsThrough(piece, text)))
        found.push(text.text + ' and ' + shape.tagName + ' ' + kind);
    }
  }
  return [texts.length, found];
};
"""

# Of one of the figures of a picture that are shown.
COVERED_IN_ONE = COVERED + """
const figures = [...document.querySelectorAll('figure')].filter((one) =>
  one.dataset.picture === arguments[0] && one.getClientRects().length);
return coveredOf(figures.at(arguments[1]).querySelector('.picture svg'));
"""

# Of all figures that are shown: how many there are, and the captions of those with covered texts.
COVERED_IN_ALL = COVERED + """
const found = [...document.querySelectorAll('figure')]
  .filter((one) => one.getClientRects().length && one.querySelector('.picture svg'))
  .map((one) => [one.querySelector('figcaption')?.textContent,
                 coveredOf(one.querySelector('.picture svg'))[1]]);
return [found.length, found.filter((one) => one[1].length)];
"""
