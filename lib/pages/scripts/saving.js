// Every figure as a file: as it is shown at the moment, light, for programs that know no styles.
for (const figure of all("figure")) {
  const svg = figure.querySelector(".picture svg");
  const caption = figure.querySelector("figcaption");
  if (!svg || !caption) {
    continue;
  }
  const text = () => {
    const copy = svg.cloneNode(true);
    const whole = svg.dataset.whole || svg.getAttribute("viewBox");
    const [x, y, width, height] = whole.split(" ");
    copy.setAttribute("font-family", getComputedStyle(svg).fontFamily);
    copy.setAttribute("fill", light("ink"));
    copy.setAttribute("viewBox", whole);
    copy.setAttribute("width", width);
    copy.setAttribute("height", height);
    copy.removeAttribute("data-whole");
    if (svg.classList.contains("turned")) {
      all("[data-scale] > :not([data-layer=turned])", copy).forEach((one) => one.remove());
    }
    for (const one of all("[data-legend], text:has(+ [data-legend])", copy)) {
      one.removeAttribute("style");
    }
    // What the style of the page says by classes.
    for (const one of all("*", copy)) {
      const classes = one.getAttribute("class") || "";
      for (const [, part, ink] of classes.matchAll(/ks-([fs])-(\w+)/g)) {
        one.setAttribute(part === "f" ? "fill" : "stroke", light(ink));
      }
      if (!classes.includes("ks-f") && !["text", "g", "use"].includes(one.tagName)) {
        one.setAttribute("fill", "none");
      }
      if (/\bks-r\b/.test(classes)) {
        one.setAttribute("stroke-linecap", "round");
        one.setAttribute("stroke-linejoin", "round");
      }
      if (["text", "g"].includes(one.tagName) && classes.includes("ks-s-paper")) {
        one.setAttribute("stroke-width", 3);
        one.setAttribute("stroke-linejoin", "round");
        one.setAttribute("paint-order", "stroke");
      }
    }
    const paper = make("rect", {x, y, width, height, fill: "#ffffff"}, copy);
    copy.prepend(paper);
    return new XMLSerializer().serializeToString(copy);
  };
  // The colour that the palette has for light paper: the first rule of the page.
  const light = (ink) => {
    const rule = document.styleSheets[0].cssRules[0].style;
    return rule.getPropertyValue("--ks-" + ink).trim();
  };
  const name = (end) => document.title.replace(/[^\w.-]+/g, "_").slice(0, 60) + "-" +
    figure.dataset.picture + "-" + /\d+/.exec(caption.textContent)[0] + end;
  const asSvg = () => save(new Blob([text()], {type: "image/svg+xml"}), name(".svg"));
  const asPng = () => {
    const image = new Image();
    image.onload = () => {
      const canvas = document.createElement("canvas");
      canvas.width = 2 * image.naturalWidth;
      canvas.height = 2 * image.naturalHeight;
      canvas.getContext("2d").drawImage(image, 0, 0, canvas.width, canvas.height);
      canvas.toBlob((blob) => save(blob, name(".png")), "image/png");
    };
    image.src = "data:image/svg+xml," + encodeURIComponent(text());
  };
  const buttons = make("div", {class: "save"}, figure);
  for (const [word, act] of [["SVG", asSvg], ["PNG", asPng]]) {
    const button = make("button", {type: "button", "aria-label": "Save this figure as " + word}, buttons);
    button.textContent = word;
    button.addEventListener("click", act);
  }
}
