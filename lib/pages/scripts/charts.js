// Charts: the values under the pointer or at the cursor that the keyboard moves; series are chosen.
// A chart of a motion follows its step and, pressed, leads it.
for (const figure of all("figure[data-chart]")) {
  const data = stored(figure.dataset.chart);
  const box = figure.querySelector(".picture");
  const svg = figure.querySelector("svg");
  const plot = svg.querySelector("[data-plot]");
  if (!plot) {
    continue;  // it says that there are no data
  }
  const follows = figure.dataset.follows;
  const [left, top, right, bottom] = plot.dataset.plot.split(" ").map(Number);
  const scale = (text, from, to) => {
    const [low, high, kind] = text.split(" ");
    const number = kind === "log" ? Math.log : Number;
    const [a, b] = [number(low), number(high)];
    return (value) => from + (to - from) * (number(value) - a) / (b - a);
  };
  const across = scale(plot.dataset.x, left, right);
  const up = scale(plot.dataset.y, bottom, top);
  const values = (one) => one.x || data.at;
  // Of a line, a disc or a polygon, by its attributes: boxes would be laid out anew for each.
  const middle = (shape) => {
    const number = (name) => Number(shape.getAttribute(name));
    if (shape.tagName === "line") {
      return [(number("x1") + number("x2")) / 2, number("y1")];
    }
    if (shape.tagName === "circle") {
      return [number("cx"), number("cy")];
    }
    const corners = shape.getAttribute("points").split(" ").map((one) => one.split(",").map(Number));
    return [0, 1].map((k) => corners.reduce((sum, one) => sum + one[k], 0) / corners.length);
  };
  const isSeen = (x, y) => x >= left - 1 && x <= right + 1 && y >= top - 1 && y <= bottom + 1;

  const cursor = make("g", {"data-cursor": ""}, svg);
  const series = data.series.map((one, i) => {
    const group = plot.querySelector('[data-series="' + i + '"]');
    const painted = group.querySelector("[class]");
    const ink = painted ? /ks-s-(\w+)/.exec(painted.getAttribute("class"))[1] : "ink";
    return {...one, group, ink, isShown: true, row: -1};
  });

  // The list of the series takes the place of the legend, with a value for each.
  const list = make("div", {class: "values"});
  box.after(list);
  const place = make("span", {class: "at"}, list);
  const legend = svg.querySelector("[data-legend]");
  for (const [i, one] of series.entries()) {
    const label = make(series.length > 1 ? "label" : "span", {}, list);
    if (series.length > 1) {
      const check = make("input", {type: "checkbox"}, label);
      check.checked = true;
      check.addEventListener("change", () => {
        one.isShown = check.checked;
        one.group.style.display = check.checked ? "" : "none";
        tell(at);
      });
      const sample = make("svg", {width: 26, height: 10, "aria-hidden": "true"}, label);
      const mark = legend.querySelector('[data-sample="' + i + '"]').cloneNode(true);
      sample.append(mark);
      sample.setAttribute("viewBox", middle(mark.firstElementChild).map((x, k) => x - [13, 5][k])
        .join(" ") + " 26 10");
    }
    label.append(make("span", {}), " ");
    label.querySelector("span").textContent = one.name || data.y.label;
    one.output = make("b", {}, label);
  }
  if (legend) {
    const view = svg.viewBox.baseVal;
    const height = Number(legend.dataset.legend);
    legend.style.display = "none";
    // The title, which stands above it, comes down into the view.
    const title = legend.previousElementSibling;
    if (title && title.tagName === "text") {
      title.style.translate = "0 " + height + "px";
    }
    svg.dataset.whole = [view.x, view.y, view.width, view.height].join(" ");
    svg.setAttribute("viewBox", [view.x, view.y + height, view.width, view.height - height].join(" "));
    svg.setAttribute("height", view.height);
  }

  const count = Math.max(...series.map((one) => one.y.length));
  let at = -1;     // the row that the values are of
  let kept = -1;   // the row that stays when the pointer leaves
  let isHeld = false;

  // At a row of the first series that has it; others have a value there if theirs is at the same x.
  const tell = (row) => {
    at = row;
    cursor.replaceChildren();
    const owner = series.find((one) => row >= 0 && values(one)[row] !== undefined &&
                                       values(one)[row] !== null);
    if (!owner) {
      place.textContent = "";
      series.forEach((one) => (one.output.textContent = ""));
      return;
    }
    const x = values(owner)[row];
    const words = [];
    if (data.plane) {
      place.textContent = "";
    } else {
      place.textContent = data.x.label + " " + amount(x, data.x.unit);
      words.push(place.textContent);
      make("line", {x1: across(x), x2: across(x), y1: top, y2: bottom, class: "ks-s-ink",
                    "stroke-width": 1}, cursor);
    }
    for (const one of series) {
      const own = values(one);
      const i = data.plane || own[row] === x ? row : own.indexOf(x);
      const y = one.y[i];
      const isThere = one.isShown && y !== null && y !== undefined;
      const text = !isThere ? one.isShown ? "–" : ""
                            : data.plane ? "(" + own[i] + ", " + amount(y, data.y.unit) + ")"
                                         : amount(y, data.y.unit);
      one.output.textContent = text;
      if (isThere) {
        words.push((one.name || data.y.label) + " " + text);
        if (isSeen(across(own[i]), up(y))) {
          make("circle", {cx: across(own[i]), cy: up(y), r: 3.6,
                          class: "ks-f-paper ks-s-" + one.ink, "stroke-width": 2}, cursor);
        }
      }
    }
    box.setAttribute("aria-valuenow", row);
    box.setAttribute("aria-valuetext", words.join("; "));
  };

  const lead = (row) => {
    kept = row;
    if (follows !== "none") {
      document.dispatchEvent(new CustomEvent("seek", {detail: {id: follows, row}}));
    }
    tell(row);
  };

  // The row nearest to the pointer.
  const nearest = (event) => {
    const p = new DOMPoint(event.clientX, event.clientY).matrixTransform(svg.getScreenCTM().inverse());
    let best = -1;
    let least = Infinity;
    for (const one of series.filter((each) => each.isShown)) {
      values(one).forEach((x, i) => {
        if (x === null || one.y[i] === null) {
          return;
        }
        const far = data.plane ? Math.hypot(across(x) - p.x, up(one.y[i]) - p.y)
                               : Math.abs(across(x) - p.x);
        if (far < least) {
          least = far;
          best = i;
        }
      });
    }
    return best;
  };

  box.setAttribute("role", "slider");
  box.setAttribute("aria-label", svg.getAttribute("aria-label"));
  box.setAttribute("aria-valuemin", 0);
  box.setAttribute("aria-valuemax", count - 1);
  box.setAttribute("aria-valuenow", 0);
  box.setAttribute("aria-valuetext", "no position chosen");
  box.addEventListener("pointermove", (event) => (isHeld ? lead : tell)(nearest(event)));
  box.addEventListener("pointerdown", (event) => {
    isHeld = true;
    box.setPointerCapture(event.pointerId);
    lead(nearest(event));
  });
  for (const end of ["pointerup", "pointercancel"]) {
    box.addEventListener(end, () => (isHeld = false));
  }
  box.addEventListener("pointerleave", () => !isHeld && tell(kept));
  box.addEventListener("keydown", (event) => {
    const ways = {ArrowLeft: -1, ArrowRight: 1, ArrowDown: -1, ArrowUp: 1, PageDown: -10,
                  PageUp: 10, Home: -count, End: count};
    if (event.key in ways && !event.ctrlKey && !event.altKey && !event.metaKey) {
      event.preventDefault();
      const from = at < 0 && ways[event.key] === 1 ? -1 : at;
      lead(Math.min(count - 1, Math.max(0, from + ways[event.key])));
    } else if (event.key === "Escape" && follows === "none") {
      lead(-1);
    }
  });
  document.addEventListener("step", (event) => {
    if (event.detail.id === follows) {
      kept = event.detail.row;
      tell(kept);
    }
  });
}
