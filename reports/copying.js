// Quiet buttons that put a formula (LaTeX), a table (TSV) or a figure (SVG and PNG) on the clipboard; nothing is fetched.
// Enters: the finished page, what its buttons say in main[data-copy].  LaTeX is written once, in Python, for whoever takes it
// along; here it is not made again from what is read aloud.  A section is one stop of the keyboard, arrows go on from there.
const { copy, copied } = document.querySelector("main")?.dataset ?? {};

// By an event of the page's own, which asks nobody's permission.
/** @param {string} text */
const put = (text) => {
  /** @param {ClipboardEvent} event */
  const answer = (event) => {
    event.preventDefault();
    event.clipboardData?.setData("text/plain", text);
  };
  document.addEventListener("copy", answer, { once: true });
  document.execCommand("copy");
};

// A cell as a spreadsheet reads it.
/** @param {Element} cell */
const plain = ({ textContent }) => {
  const text = (textContent ?? "").replace(/\s+/g, " ").trim().replaceAll("−", "-").replace(/^▸\s/, "");
  return text.replace(/^(-?[\d.,]+)·10(-?\d+)$/, "$1E$2");
};

/** @param {Element} element @param {Record<string, unknown>} given */
const give = (element, given) => {
  for (const [name, value] of Object.entries(given)) element.setAttribute(name, `${value}`);
};

// The drawings of a figure as one, graphs in two columns, in the millimetres and the colours of paper.
/** @param {Element} figure */
const drawn = (figure) => {
  const made = (/** @type {string} */ name) => document.createElementNS("http://www.w3.org/2000/svg", name);
  const whole = made("svg");
  let [x, y, wide, high] = [0, 0, 0, 0];
  for (const svg of figure.querySelectorAll("[role=img] > svg")) {
    const [, , width = 0, height = 0] = (svg.getAttribute("viewBox") ?? "").split(" ").map(Number);
    const one = document.importNode(svg, true);
    for (const unfit of one.querySelectorAll(".screen")) unfit.remove();
    const place = whole.appendChild(made("g"));
    give(place, { transform: `translate(${x} ${y})` });
    give(one, { width, height });
    place.append(one);
    wide = Math.max(wide, x + width);
    high = Math.max(high, y + height);
    [x, y] = x ? [0, high + 2] : [width + 6, y];
  }
  give(whole, { width: `${wide}mm`, height: `${high}mm`, viewBox: `0 0 ${wide} ${high}` });
  return new XMLSerializer().serializeToString(whole);
};

/** @param {string} source @returns {Promise<Blob>} */
const painted = async (source) => {
  const [image, canvas] = [new Image(), document.createElement("canvas")];
  image.src = `data:image/svg+xml,${encodeURIComponent(source)}`;
  await image.decode();
  const width = (canvas.width = 3 * image.width);
  const height = (canvas.height = 3 * image.height);
  const paper = canvas.getContext("2d");
  if (!paper) throw Error();
  paper.fillStyle = "#fff";
  paper.fillRect(0, 0, width, height);
  paper.drawImage(image, 0, 0, width, height);
  return new Promise((made, failed) => canvas.toBlob((blob) => (blob ? made(blob) : failed())));
};

/** @type {Record<string, (home: Element) => string>} */
const kinds = {
  LaTeX: (home) => [...home.querySelectorAll("[data-tex]")].map((one) => one.getAttribute("data-tex")).join("\n"),
  TSV: (home) => [...home.querySelectorAll("tr")].map((row) => [...row.children].map(plain).join("\t")).join("\n"),
  "SVG, PNG": drawn,
};
for (const section of document.querySelectorAll("main > section:not(#live)")) {
  /** @type {HTMLButtonElement[]} */
  const all = [];
  for (const home of section.querySelectorAll(".line, .flow, figure")) {
    const name = home.querySelector("[role=img]") ? "SVG, PNG" : home.matches("figure") ? "TSV" : "LaTeX";
    const place = all.length;
    const button = document.createElement("button");
    all.push(button);
    home.append(button);
    give(button, { class: "copy", title: `${copy}: ${name}`, tabindex: place ? -1 : 0, "aria-live": "polite" });
    button.textContent = name;
    button.onclick = async () => {
      const text = kinds[name]?.(home) ?? "";
      try {
        if (name !== "SVG, PNG") throw Error();
        const picture = { "image/png": painted(text), "text/plain": new Blob([text], { type: "text/plain" }) };
        await navigator.clipboard.write([new ClipboardItem(picture)]);
      } catch {
        put(text);
      }
      button.textContent = `✓ ${copied}`;
      setTimeout(() => (button.textContent = name), 2000);
    };
    button.onkeydown = (event) => {
      const way = /^Arrow(Down|Right)/.test(event.key) ? 1 : /^Arrow/.test(event.key) ? -1 : 0;
      const next = all[place + way];
      if (!way || !next) return;
      event.preventDefault();
      button.tabIndex = -1;
      next.tabIndex = 0;
      next.focus();
    };
  }
}
