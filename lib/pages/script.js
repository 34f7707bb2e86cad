"use strict";
// Everything a page can do without a script is there without it; this adds choices and motion.
(function () {
  const all = (selector, root) => Array.from((root || document).querySelectorAll(selector));
  const calm = window.matchMedia("(prefers-reduced-motion: reduce)");

  // What only works with a script is hidden until now.
  for (const one of all(".script")) {
    one.hidden = false;
  }

  // Light, dark, or as the system has it.
  const theme = document.getElementById("theme");
  theme.addEventListener("change", () => {
    if (theme.value !== "auto") {
      document.documentElement.dataset.theme = theme.value;
    } else {
      delete document.documentElement.dataset.theme;
    }
  });

  // One of several cases or gears at a time.
  for (const chooser of all(".chooser")) {
    const panels = all("section.panel", chooser);
    const show = (id) => {
      for (const panel of panels) {
        panel.hidden = panel.id !== id;
      }
    };
    const radios = all("input[type=radio]", chooser);
    if (radios.length === 0) {
      continue;  // a single case needs no choice
    }
    for (const radio of radios) {
      radio.addEventListener("change", () => show(radio.value));
    }
    const choose = (id) => {
      const radio = radios.find((one) => one.value === id) || radios.find((one) => one.checked);
      radio.checked = true;
      show(radio.value);
    };
    const target = () => {
      const panel = panels.find((one) => "#" + one.id === location.hash);
      if (panel) {
        choose(panel.id);
        panel.scrollIntoView();
      }
    };
    choose("");
    target();
    window.addEventListener("hashchange", target);
  }

  // Motion: bodies of the drawing are put to the poses of a step.
  const moved = (pose, k, X, Y) => {
    const [u, v, angle] = pose;
    const c = Math.cos(angle);
    const s = Math.sin(angle);
    const e = X * (1 - c) - Y * s + k * u;
    const f = Y * (1 - c) + X * s - k * v;
    return "matrix(" + [c, -s, s, c, e, f].map((x) => +x.toFixed(6)).join(" ") + ")";
  };

  for (const motion of all(".motion[data-poses]")) {
    const data = JSON.parse(document.getElementById(motion.dataset.poses).textContent);
    const slider = motion.querySelector("input[type=range]");
    const button = motion.querySelector("button");
    const output = motion.querySelector("output");
    const frame = motion.querySelector("[data-scale]");
    const scale = ["scale", "x0", "y0"].map((name) => Number(frame.dataset[name]));
    const groups = data.bodies.map((body) => all('[data-body="' + body + '"]', frame));
    const frames = all("[data-frame]", frame);
    const drawn = all('[data-layer="still"],[data-layer="names"],[data-layer="forces"],[data-layer="drives"],' +
                      '[data-layer="velocities"],[data-cable],[data-wrap]', frame)
      .filter((one) => !one.closest("[data-frame]"));
    const markers = all("[data-cursor]", motion);

    const show = (step) => {
      const poses = data.poses[step];
      const isDrawn = step === data.drawn;
      groups.forEach((list, b) => {
        for (const group of list) {
          if (isDrawn) {
            group.removeAttribute("transform");
          } else {
            group.setAttribute("transform", moved(poses.slice(3 * b, 3 * b + 3), ...scale));
          }
        }
      });
      frames.forEach((one, k) => {
        if (k === step && !isDrawn) {
          one.removeAttribute("display");
        } else {
          one.setAttribute("display", "none");
        }
      });
      for (const one of drawn) {
        one.style.visibility = isDrawn ? "" : "hidden";
      }
      for (const one of markers) {
        const from = Number(one.dataset.from);
        one.setAttribute("x", from + (Number(one.dataset.to) - from) * step / (data.poses.length - 1));
      }
      slider.value = step;
      slider.setAttribute("aria-valuetext", data.labels[step]);
      output.textContent = data.labels[step];
    };

    let timer = 0;
    let sense = 1;
    const stop = () => {
      window.clearInterval(timer);
      timer = 0;
      button.textContent = "Play";
    };
    const play = () => {
      button.textContent = "Pause";
      timer = window.setInterval(() => {
        const last = data.poses.length - 1;
        let next = Number(slider.value) + sense;
        if (next > last || next < 0) {
          sense = data.closed && next > last ? 1 : -sense;
          next = data.closed && next > last ? 0 : Number(slider.value) + sense;
        }
        show(Math.min(last, Math.max(0, next)));
      }, 50);
    };
    button.addEventListener("click", () => (timer ? stop() : play()));
    slider.addEventListener("input", () => {
      stop();
      show(Number(slider.value));
    });
    calm.addEventListener("change", () => calm.matches && stop());
    window.addEventListener("beforeprint", stop);
    show(Number(slider.value));
    if (!calm.matches && motion.dataset.autoplay !== undefined) {
      play();
    }
  }

  // Files within the page.
  for (const button of all("button[data-save]")) {
    button.addEventListener("click", () => {
      const stored = document.getElementById(button.dataset.save);
      const isJson = stored.dataset.kind === "json";
      const text = isJson ? stored.textContent : JSON.parse(stored.textContent);
      const link = document.createElement("a");
      link.href = URL.createObjectURL(new Blob([text], {type: button.dataset.type}));
      link.download = button.dataset.name;
      link.click();
      window.setTimeout(() => URL.revokeObjectURL(link.href), 1000);
    });
  }

  window.addEventListener("beforeprint", () => {
    for (const one of all("details:not([open])")) {
      one.open = true;
    }
  });
})();
