"use strict";
// Everything a page can do without a script is there without it; the scripts add choices, motion
// and values. This one stands first and has what the others use.
const all = (selector, root) => Array.from((root || document).querySelectorAll(selector));
const stored = (id) => JSON.parse(document.getElementById(id).textContent);
const SVG = "http://www.w3.org/2000/svg";

// An element with attributes, and within another; of a picture where that is one.
const make = (name, attributes, parent) => {
  const one = parent instanceof SVGElement || name === "svg" ? document.createElementNS(SVG, name)
                                                             : document.createElement(name);
  for (const [key, value] of Object.entries(attributes || {})) {
    one.setAttribute(key, value);
  }
  if (parent) {
    parent.append(one);
  }
  return one;
};

const amount = (value, unit) => (unit ? value + " " + unit : String(value));

const save = (blob, name) => {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  window.setTimeout(() => URL.revokeObjectURL(link.href), 1000);
};

// What only works with a script is hidden until now.
for (const one of all(".script")) {
  one.hidden = false;
}

// Light, dark, or as the system has it.
{
  const theme = document.getElementById("theme");
  theme.addEventListener("change", () => {
    if (theme.value !== "auto") {
      document.documentElement.dataset.theme = theme.value;
    } else {
      delete document.documentElement.dataset.theme;
    }
  });
}

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

// Files within the page.
for (const button of all("button[data-save]")) {
  button.addEventListener("click", () => {
    const file = document.getElementById(button.dataset.save);
    const text = file.dataset.kind === "json" ? file.textContent : JSON.parse(file.textContent);
    save(new Blob([text], {type: button.dataset.type}), button.dataset.name);
  });
}

window.addEventListener("beforeprint", () => {
  for (const one of all("details:not([open])")) {
    one.open = true;
  }
});
