// Spatial drawings are turned by dragging and by the arrow keys: then they are drawn anew, as rods,
// axes and symbols. The drawing of the page comes back with the key Home or a double click.
for (const holder of all("script[id$=-scene]")) {
  const scene = JSON.parse(holder.textContent);
  const figure = holder.closest("figure");
  const box = figure.querySelector(".picture");
  const svg = figure.querySelector(".picture svg");
  const frame = svg.querySelector("[data-scale]");
  const numbers = (name) => frame.dataset[name].split(" ").map(Number);
  const [[drawn], right, up] = ["scale", "right", "up"].map(numbers);
  const triples = (list) => Array.from({length: list.length / 3}, (_, i) => list.slice(3 * i, 3 * i + 3));
  const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
  const add = (a, b, share) => a.map((x, i) => x + share * b[i]);
  const unit = (a) => a.map((x) => x / (Math.hypot(...a) || 1));

  // The middle of the mechanism is that of the picture, which has room for it from every side.
  const points = scene.steps.flatMap((one) => one.bodies.flatMap(triples));
  const range = [0, 1, 2].map((i) => points.map((p) => p[i]));
  const middle = range.map((list) => (Math.min(...list) + Math.max(...list)) / 2);
  const view = svg.viewBox.baseVal;
  const seat = [view.x + view.width / 2, view.y + view.height / 2];
  const reach = Math.max(...points.map((p) => Math.hypot(...add(p, middle, -1))));
  const k = Math.min(drawn, 0.46 * Math.min(view.width, view.height) / reach);
  const out = cross(right, up);
  const first = [Math.atan2(out[1], out[0]), Math.asin(out[2])];
  let [azimuth, elevation] = first;
  let step = 0;
  const layer = make("g", {"data-layer": "turned"}, frame);

  const draw = () => {
    const [c, s] = [Math.cos(azimuth), Math.sin(azimuth)];
    const r = [-s, c, 0];
    const o = [Math.cos(elevation) * c, Math.cos(elevation) * s, Math.sin(elevation)];
    const u = cross(o, r);
    const at = (p) => {
      const d = add(p, middle, -1);
      return [seat[0] + k * dot(r, d), seat[1] - k * dot(u, d)];
    };
    frame.view = {at, along: (v) => [dot(r, v), -dot(u, v)]};
    const text = (list) => list.map((p) => at(p).map((x) => x.toFixed(1)).join(",")).join(" ");
    // Of that many pixels where it lies in the picture.
    const line = (from, to, attributes) => {
      const [a, b] = [at(from), at(to)];
      make("line", {x1: a[0], y1: a[1], x2: b[0], y2: b[1], ...attributes}, layer);
    };
    const now = scene.steps[Math.min(step, scene.steps.length - 1)];
    layer.replaceChildren();
    for (const one of scene.paths) {
      make("polyline", {points: text(triples(one.points)), class: "ks-s-" + one.ink, "stroke-width": 1.4}, layer);
    }
    for (const wheel of now.wheels) {
      const [centre, axis] = triples(wheel.at);
      const one = unit(cross(axis, Math.abs(axis[2]) < 0.9 ? [0, 0, 1] : [1, 0, 0]));
      const other = cross(axis, one);
      const rim = Array.from({length: 40}, (_, i) => add(add(centre, one, wheel.radius * Math.cos(i * Math.PI / 20)),
                                                         other, wheel.radius * Math.sin(i * Math.PI / 20)));
      const ink = scene.bodies[wheel.body].ink;
      make("polygon", {points: text(rim), class: "ks-f-" + ink + " ks-s-" + ink, "fill-opacity": 0.1}, layer);
    }
    const depth = (list) => list.reduce((sum, p) => sum + dot(o, p), 0) / list.length;
    const rods = now.bodies.map((list, b) => ({b, list: triples(list)})).filter((one) => one.b > 0 && one.list.length > 1);
    for (const {b, list} of rods.sort((one, other) => depth(one.list) - depth(other.list))) {
      const ink = scene.bodies[b].ink;
      make("polygon", {points: text(list), class: "ks-f-" + ink + " ks-s-" + ink, "fill-opacity": 0.16,
                       "stroke-opacity": 0.45, "stroke-width": 7, "stroke-linejoin": "round"}, layer);
    }
    for (const p of triples(now.bodies[0])) {
      const [x, y] = at(p);
      make("path", {d: "M" + x + "," + y + "v17m-13,0h26", class: "ks-s-ink", "stroke-width": 1.4}, layer);
    }
    for (const ends of now.cables) {
      line(...triples(ends), {class: "ks-s-brown", "stroke-width": 2.2});
    }
    now.couplings.forEach((list, e) => {
      if (!list) {
        return;
      }
      const [p, ...axes] = triples(list);
      const symbol = scene.couplings[e].symbol;
      const along = (axis, pixels, attributes) =>
        line(add(p, axis, -pixels / k), add(p, axis, pixels / k), attributes);
      const [x, y] = at(p);
      if (symbol === "ball") {
        make("circle", {cx: x, cy: y, r: 7, class: "ks-f-paper ks-s-ink", "stroke-width": 1.5}, layer);
        make("circle", {cx: x, cy: y, r: 3.2, class: "ks-f-ink"}, layer);
      } else if (symbol === "cross") {
        make("circle", {cx: x, cy: y, r: 8, class: "ks-f-paper ks-s-ink"}, layer);
        axes.forEach((axis) => along(axis, 15, {class: "ks-s-ink", "stroke-width": 2.2}));
      } else if (axes.length > 0) {
        const half = symbol === "hinge" ? 8 : 13;
        along(axes[0], half + 18, {class: "ks-s-soft", "stroke-dasharray": "7 2 1.5 2"});
        along(axes[0], half, {class: "ks-s-ink", "stroke-width": 12, "stroke-linecap": symbol === "box" ? "square" : "round"});
        along(axes[0], half, {class: "ks-s-paper", "stroke-width": 9, "stroke-linecap": symbol === "box" ? "square" : "round"});
      } else {
        make("rect", {x: x - 4, y: y - 4, width: 8, height: 8, class: "ks-f-paper ks-s-ink"}, layer);
      }
      make("text", {x: x + 11, y: y - 8, "font-size": 12, "font-style": "italic", class: "ks-f-ink ks-s-paper"},
           layer).textContent = scene.couplings[e].name;
    });
    // The axes of the world, in the lower left corner.
    const corner = [view.x + 45, view.y + view.height - 45];
    for (const [i, name] of ["x", "y", "z"].entries()) {
      const [a, b] = [30 * r[i], -30 * u[i]];
      make("line", {x1: corner[0], y1: corner[1], x2: corner[0] + a, y2: corner[1] + b, class: "ks-s-soft"}, layer);
      make("text", {x: corner[0] + 1.3 * a - 3, y: corner[1] + 1.3 * b + 4, "font-size": 11, class: "ks-f-soft"},
           layer).textContent = name;
    }
  };

  const turn = (across, upwards) => {
    azimuth -= across;
    elevation = Math.min(Math.PI / 2, Math.max(-Math.PI / 2, elevation + upwards));
    svg.classList.add("turned");
    draw();
    frame.dispatchEvent(new Event("viewed"));
  };
  const back = () => {
    [azimuth, elevation] = first;
    svg.classList.remove("turned");
    layer.replaceChildren();
    delete frame.view;
    frame.dispatchEvent(new Event("viewed"));
  };

  let held = null;
  box.addEventListener("pointerdown", (event) => {
    held = [event.clientX, event.clientY];
    box.setPointerCapture(event.pointerId);
  });
  box.addEventListener("pointermove", (event) => {
    if (held) {
      turn((event.clientX - held[0]) * 0.01, (event.clientY - held[1]) * 0.01);
      held = [event.clientX, event.clientY];
    }
  });
  for (const end of ["pointerup", "pointercancel"]) {
    box.addEventListener(end, () => (held = null));
  }
  box.addEventListener("dblclick", back);
  box.addEventListener("keydown", (event) => {
    const ways = {ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, -0.1], ArrowDown: [0, 0.1]};
    if (event.key in ways && !event.ctrlKey && !event.altKey && !event.metaKey) {
      event.preventDefault();
      turn(...ways[event.key]);
    } else if (event.key === "Home") {
      event.preventDefault();
      back();
    }
  });
  box.classList.add("turns");
  const hint = make("div", {class: "hint"}, figure);
  hint.textContent = "Drag it, or use the arrow keys, to turn it; Home turns it back.";
  document.addEventListener("step", (event) => {
    if (event.detail.id === figure.dataset.motion) {
      step = event.detail.step;
      if (svg.classList.contains("turned")) {
        draw();
      }
    }
  });
}
