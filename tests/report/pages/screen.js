// What a person or a screen reader would complain about on the page that is open; each function returns sentences.
// Enters: a document.  Leaves: `judge` with `layout()`, `lines()`, `access()`, `contrast()`, `focus()`;
// `moving()` counts instead: words of the moving part that stand on something, in its first position and in seven later ones.
const shown = (element) => element.checkVisibility() && element.getBoundingClientRect().width > 0;
const name = (element) => {
  const home = element.closest("[id]");
  const own = element.tagName.toLowerCase() + (element.getAttribute("class") ? `.${element.getAttribute("class").trim()}` : "");
  return `${home ? `#${home.id} ` : ""}${own}`;
};
const spoken = (element) => (element.getAttribute("aria-label") || element.textContent).trim();
const scrolls = (element) => ["auto", "scroll"].includes(getComputedStyle(element).overflowX);

function layout() {
  const found = [];
  const width = innerWidth;
  if (document.documentElement.scrollWidth > width) found.push(`the page is ${document.documentElement.scrollWidth} px wide`);
  for (const element of document.body.querySelectorAll("*")) {
    if (element.closest("svg") && element.tagName !== "svg") continue;
    let home = element.parentElement;
    while (home && !scrolls(home)) home = home.parentElement;
    if (!home && shown(element) && element.getBoundingClientRect().right > width + 0.5) found.push(`wider than the window: ${name(element)}`);
  }
  for (const box of document.body.querySelectorAll("*")) {
    const goesOn = scrolls(box) && shown(box) && box.scrollWidth > box.clientWidth + 1;
    if (goesOn && getComputedStyle(box).backgroundImage === "none") found.push(`goes on unseen: ${name(box)}`);
  }
  for (const svg of document.querySelectorAll("svg")) {
    if (!shown(svg) || svg.closest(".formula")) continue;
    svg.closest(".drawing > div[tabindex]")?.focus({ preventScroll: true }); // enlarged, as it is read
    const sheet = svg.getBoundingClientRect();
    const words = [...svg.querySelectorAll("text")].map((text) => [text, text.getBoundingClientRect()]).filter(([, box]) => box.width);
    for (const [text, box] of words) {
      const scale = Math.hypot(text.getScreenCTM().a, text.getScreenCTM().b);
      // Words have 12 px in a graph, 11 in a drawing, what is set lower 70 % of that.
      const usual = svg.closest(".panel, .panels, #tangent, .strip") ? 12 : 11;
      for (const part of [text, ...text.querySelectorAll("tspan")]) {
        const pixels = parseFloat(getComputedStyle(part).fontSize) * scale;
        const least = part.hasAttribute("dy") && part !== text ? 0.7 * usual : usual;
        if (part.textContent.trim() && pixels < least - 0.05) found.push(`${pixels.toFixed(1)} px: ${name(svg)} "${part.textContent}"`);
      }
      const out = Math.max(sheet.left - box.left, box.right - sheet.right, sheet.top - box.top, box.bottom - sheet.bottom);
      if (out > 1) found.push(`cut off by ${out.toFixed(1)} px: ${name(svg)} "${text.textContent}"`);
    }
    words.forEach(([text, a], place) => {
      for (const [other, b] of words.slice(place + 1)) {
        const across = Math.min(a.right, b.right) - Math.max(a.left, b.left);
        const down = Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top);
        // A box is as high as its line: that of digits is free above and below.
        if (across > 1 && down > 0.25 * Math.min(a.height, b.height)) {
          found.push(`one on the other: ${name(svg)} "${text.textContent}" "${other.textContent}"`);
        }
      }
    });
  }
  document.activeElement.blur();
  return found;
}

// No line ends in a number with its unit, in a short equality or sum, a quotient, a word with a hyphen or behind a label of a number.
const UNITS = "(?:rad|m|mm|s|ms|рад|м|мм|с)(?:/(?:rad|s|рад|с))?[²2]?|%";
const TOGETHER = new RegExp(`(?<=\\d)\\s(?=(?:${UNITS})(?![\\p{L}\\d]))|(?<=[\\p{L}\\d)²])\\s(?==\\s)|(?<=\\p{L}/)(?=\\p{L})|(?<=\\b\\p{L}{1,14}:)\\s(?=[−\\d])|(?<=\\b[Rr]ow)\\s(?=\\d)|(?<=\\s[+−·])\\s(?=[\\p{L}\\d(])|(?<=(?<![\\p{L}-])\\p{L}{2,12}-)(?=\\p{L}{2,12}(?![\\p{L}-]))|(?<=(?<![\\S])\\S{1,6}\\s=)\\s(?=[^\\s=]{1,6}(?:[.,]?$|[.,]?\\s(?![=+−·])))`, "gu");
function lines() {
  const found = [];
  const inline = (element) => getComputedStyle(element).display === "inline";
  for (const block of document.body.querySelectorAll("*")) {
    if (inline(block) || block.closest("svg, script, style, table:not(:has(.words))") || !shown(block)) continue;
    const places = [];
    const collect = (at) => {
      for (const child of at.childNodes) {
        if (child.nodeType === Node.TEXT_NODE) for (let k = 0; k < child.length; k++) places.push([child, k]);
        else if (child.nodeType === Node.ELEMENT_NODE && inline(child)) collect(child);
      }
    };
    collect(block);
    const text = places.map(([node, k]) => node.data[k]).join("");
    const box = (place) => {
      const range = document.createRange();
      range.setStart(...places[place]);
      range.setEnd(places[place][0], places[place][1] + 1);
      return range.getBoundingClientRect();
    };
    for (const match of text.matchAll(TOGETHER)) {
      const before = match.index - 1, behind = match.index + match[0].length;
      if (behind >= text.length) continue;
      // Subscripts lie lower, but never to the left of what they belong to.
      if (box(behind).left < box(before).left) found.push(`${name(block)}: ${text.slice(Math.max(0, before - 15), before + 1)} | ${text.slice(behind, behind + 12)}`);
    }
  }
  return found;
}

function access() {
  const found = [];
  const all = (selector) => [...document.querySelectorAll(selector)];
  if (!document.documentElement.lang) found.push("the page has no language");
  if (!document.title.trim()) found.push("the page has no title");
  if (all("main").length !== 1 || all("h1").length !== 1) found.push("not one main and one h1");
  all("nav, aside, section").filter((one) => !one.getAttribute("aria-label") && !one.querySelector("h2")).forEach((one) => found.push(`no name: ${name(one)}`));
  const levels = all("h1, h2, h3, h4").filter(shown).map((one) => Number(one.tagName[1]));
  levels.forEach((level, place) => level > (levels[place - 1] ?? 0) + 1 && found.push(`h${level} behind h${levels[place - 1] ?? 0}`));
  const ids = all("[id]").map((one) => one.id);
  ids.filter((id, place) => ids.indexOf(id) !== place).forEach((id) => found.push(`twice: #${id}`));
  for (const picture of all("svg, img").filter(shown)) {
    const home = picture.closest('[role="img"], [role="math"]');
    const hidden = picture.closest('[aria-hidden="true"]') && !picture.closest(".formula");
    if (!hidden && !(home && home.getAttribute("aria-label")) && !picture.alt) found.push(`a picture without words: ${name(picture)}`);
  }
  for (const table of all("table").filter(shown)) {
    if (!table.caption && !(table.getAttribute("aria-label") || "").trim()) found.push(`a table without a name: ${name(table)}`);
    if (!table.querySelector("th")) found.push(`a table without heads: ${name(table)}`);
  }
  for (const head of all("th")) {
    if (!["col", "row"].includes(head.getAttribute("scope"))) found.push(`a head without scope: ${name(head)}`);
    if (!spoken(head)) found.push(`an empty head: ${name(head)}`);
  }
  for (const link of all("a")) {
    if (!spoken(link)) found.push(`a link without text: ${name(link)}`);
    const target = link.getAttribute("href") || "";
    if (target.startsWith("#") && !document.getElementById(target.slice(1))) found.push(`a link to nothing: ${target}`);
  }
  for (const control of all("button, input, select, textarea")) {
    const label = control.tagName === "BUTTON" ? spoken(control) : control.getAttribute("aria-label") || [...(control.labels || [])].map(spoken).join("");
    if (!label.trim()) found.push(`a control without a label: ${name(control)} ${control.id}`);
  }
  for (const box of all("*").filter((one) => scrolls(one) && one.scrollWidth > one.clientWidth + 1 && shown(one))) {
    if (box.tabIndex < 0 && !box.querySelector("a, button, input, select, [tabindex]")) found.push(`moved only with a mouse: ${name(box)}`);
  }
  return found;
}

// WCAG 2.2, 1.4.3 and 1.4.11: 4.5 for text, 3 for large text and for lines that mean something.
const channel = (part) => (part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4);
const luminance = ([r, g, b]) => 0.2126 * channel(r / 255) + 0.7152 * channel(g / 255) + 0.0722 * channel(b / 255);
const parts = (colour) => (colour.match(/[\d.]+/g) || []).map(Number);
function ground(element) {
  for (let at = element; at; at = at.parentElement) {
    const colour = parts(getComputedStyle(at).backgroundColor);
    if (colour.length === 3 || colour[3] === 1) return colour;
  }
  return [255, 255, 255];
}
function ratio(colour, element) {
  const [light, dark] = [luminance(parts(colour)), luminance(ground(element))].sort((a, b) => b - a);
  return (light + 0.05) / (dark + 0.05);
}
function contrast() {
  const found = new Set();
  const ask = (element, colour, least) => {
    const is = ratio(colour, element);
    if (is < least) found.add(`${is.toFixed(2)} instead of ${least}: ${name(element)}`);
  };
  const walk = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  while (walk.nextNode()) {
    const element = walk.currentNode.parentElement;
    if (!walk.currentNode.data.trim() || element.closest("script, style, defs") || !shown(element) || element.disabled) continue;
    const style = getComputedStyle(element);
    const size = parseFloat(style.fontSize);
    const large = size >= 24 || (size >= 18.66 && Number(style.fontWeight) >= 700);
    ask(element, element.closest("svg") ? style.fill : style.color, large ? 3 : 4.5);
  }
  for (const line of document.querySelectorAll(".panel :is(.exact, .rows, .axis, .stop), .formula svg")) {
    if (!shown(line)) continue;
    const style = getComputedStyle(line);
    ask(line, line.tagName === "svg" ? style.fill : style.stroke, 3);
  }
  for (const bar of document.querySelectorAll(".formula svg [stroke]")) {
    if (shown(bar.closest("svg"))) ask(bar, getComputedStyle(bar).stroke, 3);
  }
  return [...found];
}

// Whatever the keyboard reaches shows that it has been reached.
function focus() {
  const found = [];
  for (const element of document.querySelectorAll("a, button, input, select, [tabindex]")) {
    if (!shown(element)) continue;
    element.focus({ focusVisible: true });
    const style = getComputedStyle(element);
    if (document.activeElement !== element) found.push(`not reached: ${name(element)}`);
    else if (style.outlineStyle === "none" || parseFloat(style.outlineWidth) < 2) found.push(`no outline: ${name(element)}`);
  }
  return found;
}

// The letters of a word without their accents and tails; a link, rim, rail or joint is looked at every 1.5 units.
function letters(text) {
  const { x, width } = text.getBBox(), base = Number(text.getAttribute("y")) + Number(text.getAttribute("dy"));
  return [x + 1, base - 0.68 * parseFloat(getComputedStyle(text).fontSize), x + width - 1, base];
}
// Each part of a path is measured alone and once: on a long path the way to a point is walked anew for every point.
const ink = new Map();
function inked(path) {
  return (path.getAttribute("d") || "").split(/(?=M)/).filter(Boolean).flatMap((part) => {
    if (!ink.has(part)) {
      const alone = document.createElementNS("http://www.w3.org/2000/svg", "path");
      alone.setAttribute("d", part);
      const long = alone.getTotalLength(), count = Math.ceil(long / 1.5);
      ink.set(part, Array.from({ length: count && count + 1 }, (_, k) => alone.getPointAtLength((k * long) / count)));
    }
    return ink.get(part);
  });
}
function standing(field) {
  const words = [...field.querySelectorAll(".live-words > text")].filter((text) => text.textContent), boxes = words.map(letters);
  const drawn = [...field.querySelectorAll(":is(.live-body, .live-ground, .live-pins) path:not(.live-hatch)")].flatMap(inked);
  const met = (own, [left, top, right, bottom] = own) =>
    drawn.some(({ x, y }) => x > left && x < right && y > top && y < bottom) ||
    boxes.some((box) => box !== own && Math.min(right, box[2]) > Math.max(left, box[0]) && Math.min(bottom, box[3]) > Math.max(top, box[1]));
  return { words: words.length, on: words.filter((_, k) => met(boxes[k])).map((text) => text.textContent) };
}
async function moving() {
  const scrub = document.querySelector("#scrub"), field = document.querySelector("#live-field");
  const found = { start: [], later: 0, looked: 0 };
  await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
  for (let k = 0; k < 8; k++) {
    scrub.value = (scrub.max * k) / 8;
    scrub.dispatchEvent(new Event("input", { bubbles: true }));
    const { words, on } = standing(field);
    if (k) found.looked += words, (found.later += on.length);
    else found.start = on;
  }
  return found;
}

window.judge = { layout, lines, access, contrast, focus, standing, moving };
