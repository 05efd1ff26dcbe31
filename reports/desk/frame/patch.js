// The report replaced part by part: what did not change stays as it is, the place on the screen and the laboratory too.
// Enters: the HTML of a whole page.  Leaves: `patch`.  The nonce lets the page's own script run, and no other.
const nonce = document.currentScript?.nonce ?? "";

/** The parts of a page by name: head, title, contents and each section, in order.
 * @param {Document} page */
const partsOf = (page) => {
  /** @type {Map<string, {into: string, element: Element}>} */
  const parts = new Map();
  for (const element of page.body.children) {
    if (element.matches("main"))
      for (const one of element.children)
        if (!one.matches("script")) parts.set(one.id || one.localName, { into: "main", element: one });
    if (!element.matches("main, script"))
      parts.set(element.id || element.getAttribute("class") || element.localName, { into: "body", element });
  }
  return parts;
};

/** What is read: the part a third down the window, and how far above the window it begins; null at the head of the page. */
const topmost = () => {
  if (!scrollY) return null;
  for (const element of document.querySelectorAll("body > .top, main > *")) {
    const { top, bottom } = element.getBoundingClientRect();
    if (bottom > innerHeight / 3 && element.id) return { id: element.id, top };
  }
  return null;
};

/** @type {Map<string, string>} */
let sources = new Map();
let style = "",
  script = "";

/** The page's script has the window's clocks and events from here: when the next page comes they stand still for it.
 * @param {AbortSignal} over
 * @param {(() => void)[]} furnish What waits until the page is there. */
const lent = (over, furnish) => ({
  setTimeout: (/** @type {() => void} */ act, /** @type {number} */ wait) => setTimeout(() => over.aborted || act(), wait),
  setInterval: (/** @type {() => void} */ act, /** @type {number} */ wait) => setInterval(() => over.aborted || act(), wait),
  requestAnimationFrame: (/** @type {FrameRequestCallback} */ act) =>
    requestAnimationFrame((stamp) => over.aborted || act(stamp)),
  addEventListener: (/** @type {string} */ kind, /** @type {() => void} */ act) =>
    kind === "DOMContentLoaded" ? furnish.push(act) : addEventListener(kind, act, { signal: over }),
});
let running = new AbortController();
/** @param {Document} page */
const runScript = (page) => {
  running.abort();
  running = new AbortController();
  const data = page.querySelector("script#coursework"),
    code = page.querySelector("script:not([type])");
  for (const old of document.querySelectorAll("script[data-page]")) old.remove();
  document.documentElement.classList.remove("live-on");
  if (!data || !code) return;
  /** @type {(() => void)[]} */
  const furnish = [];
  const numbers = Object.assign(document.createElement("script"), {
    type: "application/json",
    id: "coursework",
    textContent: data.textContent,
  });
  const names = Object.keys(lent(running.signal, furnish)).join(", ");
  const moving = Object.assign(document.createElement("script"), {
    nonce,
    textContent: `(({ ${names} }) => { ${code.textContent}\n})(lent);`,
  });
  for (const one of [numbers, moving]) one.dataset.page = "";
  Object.assign(window, { lent: lent(running.signal, furnish) });
  document.body.append(numbers, moving);
  Reflect.deleteProperty(window, "lent");
  for (const act of furnish) act();
};

/** Show a page; returns the names of the parts that were made anew.
 * @param {string} html
 * @param {string[]} later Sections that are headings yet: what stands of them from before stays, pale. */
const patch = (html, later) => {
  const page = new DOMParser().parseFromString(html, "text/html");
  const parts = partsOf(page),
    at = topmost(),
    code = [...page.querySelectorAll("script")].map((one) => one.textContent).join("\n");
  const text = [...page.querySelectorAll("style")].map((one) => one.textContent).join("\n");
  if (text !== style) {
    style = text;
    const place = document.getElementById("report-style");
    if (place) place.textContent = text;
  }
  // In another language nothing stays, not even what waits to be looked at.
  const spoken = document.documentElement.lang === page.documentElement.lang;
  document.documentElement.lang = page.documentElement.lang;
  document.title = page.title;
  // The script reaches into all parts: where it changed none of them stays.
  const alive = code !== script,
    before = sources;
  if (alive) laboratory.keep();
  sources = new Map();
  const main = document.querySelector("main") ?? document.body.appendChild(document.createElement("main"));
  const made = [];
  /** @type {Record<string, Element | null>} */
  const behind = { main: null, body: null };
  for (const [name, { into, element }] of parts) {
    const source = element.outerHTML,
      parent = into === "main" ? main : document.body;
    const waits = later.includes(name);
    sources.set(name, waits ? "" : source);
    let old = standing.get(name);
    if (!old || !spoken || (!waits && (alive || before.get(name) !== source))) {
      made.push(name);
      const fresh = document.importNode(element, true);
      if (old?.parentElement === parent) old.replaceWith(fresh);
      standing.set(name, (old = fresh));
    }
    if (waits && old instanceof HTMLElement) old.dataset.later = "";
    const last = behind[into],
      next = last ? last.nextElementSibling : parent.firstElementChild;
    if (next !== old) parent.insertBefore(old, next);
    behind[into] = old;
  }
  for (const [name, element] of standing) if (!parts.has(name)) element.remove(), standing.delete(name);
  if (main.previousElementSibling !== behind.body) behind.body?.after(main);
  if (alive) {
    script = code;
    runScript(page);
    laboratory.restore();
  }
  const place = at && document.getElementById(at.id);
  if (place && at) scrollBy({ top: place.getBoundingClientRect().top - at.top, behavior: "instant" });
  return made;
};
/** What stands on the page by the name of its part.
 * @type {Map<string, Element>} */
const standing = new Map();
/** Leave nothing of a page: the next is of another text. */
const forget = () => {
  running.abort();
  script = "";
  for (const element of standing.values()) element.remove();
  standing.clear();
  scrollTo(0, 0);
};
