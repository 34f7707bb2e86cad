// Motion: bodies of a drawing are put to the poses of a step. Charts of the same section follow,
// and lead, by the events `step` and `seek`, which have the id of the section and a row.
for (const motion of all(".motion[data-poses]")) {
  const calm = window.matchMedia("(prefers-reduced-motion: reduce)");
  const data = stored(motion.dataset.poses);
  const last = data.poses.length - 1;
  const id = motion.dataset.motion;
  const slider = motion.querySelector("input[type=range]");
  const button = motion.querySelector("[data-play]");
  const output = motion.querySelector("output");
  const speed = motion.querySelector("[data-speed]");
  const controls = motion.querySelector(".drive");
  const frame = motion.querySelector("[data-scale]");
  const [k, X, Y] = ["scale", "x0", "y0"].map((name) => Number(frame.dataset[name]));
  const groups = data.bodies.map((body) => all('[data-body="' + body + '"]', frame));
  const frames = all("[data-frame]", frame);
  const drawn = all('[data-layer="still"],[data-layer="names"],[data-layer="forces"],' +
                    '[data-layer="drives"],[data-layer="velocities"],' +
                    '[data-cable],[data-wrap],[data-spring]', frame)
    .filter((one) => !one.closest("[data-frame]"));

  const matrix = (u, v, angle) => {
    const c = Math.cos(angle);
    const s = Math.sin(angle);
    const e = X * (1 - c) - Y * s + k * u;
    const f = Y * (1 - c) + X * s - k * v;
    return "matrix(" + [c, -s, s, c, e, f].map((x) => +x.toFixed(6)).join(" ") + ")";
  };

  // What acts, as arrows: of those that are chosen the longest of the motion is 70 px, and couples
  // are arcs about their axes. A load ends at its point, all others begin there.
  const acting = data.acting || [];
  const [doubts, doubtOf] = data.doubts || [[], []];
  const layer = make("g", {"data-layer": "acting"}, frame);
  const dot = (a, b) => a.reduce((sum, x, i) => sum + x * b[i], 0);
  const [right, up] = frame.dataset.right ? ["right", "up"].map((name) => frame.dataset[name].split(" ").map(Number))
                                          : [[1, 0], [0, 1]];
  const along = (v) => [dot(right, v), -dot(up, v)];
  const drawnView = {along, at: (p) => [X + k * along(p)[0], Y + k * along(p)[1]]};
  const places = right.length;
  const vectorOf = (one, step) => {
    const list = one.at[step] && one.at[step].slice(0, one.axial && places === 2 ? 1 : places);
    return list && list.length === 1 ? [0, 0, ...list] : list;
  };
  const placeOf = (one, step) => one.place || one.at[step].slice(-places);
  for (const one of acting) {
    one.sizes = one.at.map((_, i) => Math.hypot(...(vectorOf(one, i) || [0])));
    one.most = Math.max(...one.sizes);
  }
  const short = (size, one) => amount(Number(size.toPrecision(4)), one.unit);
  const tip = (a, b, [c, s], head) => {
    const [g, h] = [a - head * c, b - head * s];
    const half = 0.36 * head;
    make("polygon", {points: [a, b, g - half * s, h + half * c, g + half * s, h - half * c].join(" "),
                     class: "ks-f-vermilion"}, layer);
    return [g, h];
  };
  const drawForce = (view, at, v, size, length, isLoad) => {
    const flat = view.along(v.map((x) => x / size));
    const seen = Math.hypot(...flat);
    if (length * seen < 1) {
      return;
    }
    const [c, s] = flat.map((x) => x / seen);
    const shift = isLoad ? -length * seen : 0;
    const [x, y] = [at[0] + shift * c, at[1] + shift * s];
    const [g, h] = tip(x + length * seen * c, y + length * seen * s, [c, s], Math.min(9, length * seen));
    make("line", {x1: x, y1: y, x2: g, y2: h, class: "ks-s-vermilion", "stroke-width": 2}, layer);
  };
  const drawCouple = (view, at, v, size, share) => {
    const axis = v.map((x) => x / size);
    const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
    const one = cross(axis, Math.abs(axis[0]) < 0.9 ? [1, 0, 0] : [0, 1, 0]);
    const first = one.map((x) => x / Math.hypot(...one));
    const other = cross(axis, first);
    const end = Math.PI * (0.3 + 1.3 * share);
    const rim = Array.from({length: 25}, (_, i) => {
      const [c, s] = [Math.cos(end * i / 24), Math.sin(end * i / 24)];
      const flat = view.along(first.map((x, j) => 22 * (c * x + s * other[j])).slice(0, places));
      return [at[0] + flat[0], at[1] + flat[1]];
    });
    make("polyline", {points: rim.join(" "), fill: "none", class: "ks-s-vermilion", "stroke-width": 2}, layer);
    const [[a, b], [g, h]] = [rim[24], rim[22]];
    const far = Math.hypot(a - g, b - h) || 1;
    tip(a + 3 * (a - g) / far, b + 3 * (b - h) / far, [(a - g) / far, (b - h) / far], 9);
  };
  let chosen = [];
  const drawActing = (step) => {
    const view = frame.view || drawnView;
    layer.replaceChildren();
    for (const one of chosen) {
      const most = Math.max(...chosen.filter((other) => other.axial === one.axial).map((other) => other.most));
      const size = one.sizes[step];
      if (!one.at[step] || size <= 1e-6 * most) {
        continue;
      }
      const at = view.at(placeOf(one, step));
      if (one.axial) {
        drawCouple(view, at, vectorOf(one, step), size, size / most);
      } else {
        drawForce(view, at, vectorOf(one, step), size, 70 * size / most, one.group === "load");
      }
    }
  };
  // Of one its value; of several the longest of these steps: between them it may be longer.
  const wordsOf = (step) => {
    const doubt = doubts[doubtOf[step] - 1];
    const open = chosen.filter((one) => !one.at[step]);
    const known = open.length < chosen.length;
    const words = [];
    const isOne = chosen.every((one) => one.name === chosen[0].name);
    if (isOne && known) {
      words.push(chosen[0].name + " " + chosen.filter((one) => one.at[step])
        .map((one) => short(one.sizes[step], one)).join(" and "));
    }
    for (const isAxial of !isOne && known ? [false, true] : []) {
      const list = chosen.filter((one) => one.axial === isAxial && one.most > 0);
      const longest = list.reduce((a, b) => (a && a.most >= b.most ? a : b), null);
      if (longest) {
        words.push((isAxial ? "greatest couple" : "longest") + " at these steps " +
                   short(longest.most, longest) + " (" + longest.name + ")");
      }
    }
    if (open.length > 0) {
      words.push((known && !isOne ? open.map((one) => one.name).join(" and ") + " " : "") + "undetermined here: " +
                 (doubt || "equilibrium leaves " + (open.length > 1 ? "them" : "it") + " open"));
    } else if (doubt && known) {
      words.push("but this cannot be: " + doubt);
    }
    return words.map((word) => ", " + word).join("");
  };
  if (acting.length > 0) {
    const label = make("label", {}, controls);
    label.append("Force ");
    const choice = make("select", {"data-force": ""}, label);
    const couplings = acting.filter((one) => one.group === "coupling");
    const others = acting.filter((one) => one.group !== "coupling");
    const choices = [["none", []]];
    for (const [text, list] of [["of all couplings", couplings], ["of loads and drives", others]]) {
      if (list.length > 1) {
        choices.push([text, list]);
      }
    }
    for (const one of acting) {  // a load may be a force and a couple
      const text = (one.group === "coupling" ? "in " : one.group + " ") + one.name;
      const there = choices.find((choice) => choice[0] === text);
      if (there) {
        there[1].push(one);
      } else {
        choices.push([text, [one]]);
      }
    }
    for (const [text] of choices) {
      make("option", {}, choice).textContent = text;
    }
    choice.addEventListener("change", () => {
      chosen = choices[choice.selectedIndex][1];
      show(step());
    });
    frame.addEventListener("viewed", () => drawActing(step()));
  }

  const link = make("a", {class: "step-link"}, controls);
  link.textContent = "Link to this step";

  const step = () => Number(slider.value);
  const show = (to) => {
    const poses = data.poses[to];
    const isDrawn = to === data.drawn;
    groups.forEach((list, b) => {
      for (const group of list) {
        if (isDrawn) {
          group.removeAttribute("transform");
        } else {
          group.setAttribute("transform", matrix(...poses.slice(3 * b, 3 * b + 3)));
        }
      }
    });
    frames.forEach((one, i) => {
      if (i === to && !isDrawn) {
        one.removeAttribute("display");
      } else {
        one.setAttribute("display", "none");
      }
    });
    for (const one of drawn) {
      one.style.visibility = isDrawn ? "" : "hidden";
    }
    drawActing(to);
    const words = data.labels[to] + wordsOf(to);
    slider.value = to;
    slider.setAttribute("aria-valuetext", words);
    output.textContent = words;
    link.setAttribute("href", "#" + id + "-step-" + to);
    document.dispatchEvent(new CustomEvent("step", {detail: {id, step: to, row: data.rows[to]}}));
  };

  let timer = 0;
  let sense = 1;
  const stop = () => {
    window.clearInterval(timer);
    timer = 0;
    button.textContent = "Play";
  };
  const go = (to) => {
    stop();
    show(Math.min(last, Math.max(0, to)));
  };
  // A step lasts 50 ms, and of many steps less: all take 8 s.
  const play = () => {
    button.textContent = "Pause";
    let begin = performance.now();
    timer = window.setInterval(() => {
      const pace = Math.min(50, 8000 / last) / Number(speed.value);
      const count = Math.floor((performance.now() - begin) / pace);
      if (count < 1) {
        return;
      }
      begin += count * pace;
      let next = step() + sense * Math.min(count, last);
      if (data.closed && next > last) {
        next %= last;
      } else if (next > last || next < 0) {
        sense = -sense;
        next = next < 0 ? -next : 2 * last - next;
      }
      show(next);
    }, 16);
  };

  button.addEventListener("click", () => (timer ? stop() : play()));
  slider.addEventListener("input", () => go(step()));
  for (const one of all("[data-step]", controls)) {
    one.addEventListener("click", () => go(step() + Number(one.dataset.step)));
  }
  document.addEventListener("seek", (event) => {
    if (event.detail.id === id) {
      const at = data.rows.findIndex((row) => row >= event.detail.row);
      go(at < 0 ? last : at);
    }
  });
  calm.addEventListener("change", () => calm.matches && stop());
  window.addEventListener("beforeprint", stop);

  // "#file-1-step-12" names a step.
  const target = () => {
    const mark = "#" + id + "-step-";
    const to = location.hash.startsWith(mark) ? parseInt(location.hash.slice(mark.length), 10) : NaN;
    if (to >= 0 && to <= last) {
      go(to);
      motion.scrollIntoView();
    }
    return to >= 0;
  };
  window.addEventListener("hashchange", target);
  // Charts hear of the first step, too.
  window.setTimeout(() => {
    show(step());
    if (!target() && !calm.matches && motion.dataset.autoplay !== undefined) {
      play();
    }
  });
}
