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

  // Forces of tails on heads as arrows: the longest of the motion is 70 px.
  const forces = data.forces || [];
  const layer = make("g", {"data-layer": "acting"}, frame);
  const sizeOf = (at) => (at ? Math.hypot(at[2], at[3]) : 0);
  const largest = (list) => Math.max(...list.map((one) => Math.max(...one.at.map(sizeOf))));
  let chosen = [];
  const arrows = (step) => {
    layer.replaceChildren();
    const most = largest(chosen);
    let words = "";
    for (const one of chosen) {
      const at = one.at[step];
      const size = sizeOf(at);
      if (size <= 1e-6 * most) {
        continue;
      }
      const length = 70 * size / most;
      const [x, y] = [X + k * at[0], Y - k * at[1]];
      const [c, s] = [at[2] / size, -at[3] / size];
      const head = Math.min(9, length);
      const [a, b] = [x + length * c, y + length * s];
      const [g, h] = [a - head * c, b - head * s];
      const half = 0.36 * head;
      make("line", {x1: x, y1: y, x2: g, y2: h, class: "ks-s-vermilion", "stroke-width": 2}, layer);
      make("polygon", {points: [a, b, g - half * s, h + half * c, g + half * s, h - half * c].join(" "),
                       class: "ks-f-vermilion"}, layer);
      words = ", " + one.name + " " + amount(Number(size.toPrecision(4)), one.unit);
    }
    return chosen.length > 1 ? ", longest of all " + amount(Number(most.toPrecision(4)), chosen[0].unit)
                             : words;
  };
  if (forces.length > 0) {
    const label = make("label", {}, controls);
    label.append("Force ");
    const choice = make("select", {"data-force": ""}, label);
    for (const [value, text] of [["", "none"], ["all", "of all couplings"],
                                 ...forces.map((one, i) => [i, "in " + one.name])]) {
      make("option", {value}, choice).textContent = text;
    }
    choice.addEventListener("change", () => {
      chosen = choice.value === "all" ? forces : choice.value === "" ? [] : [forces[choice.value]];
      show(step());
    });
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
    const words = data.labels[to] + arrows(to);
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
