// The frame of the report hears the shell, and tells it what a person does in here.
/** @type {Record<string, string>} */
let words = {};
/** @param {string} key
 * @param {Record<string, string>} gaps */
const say = (key, gaps) => (words[key] ?? "").replace(/\{(\w+)\}/g, (_, gap) => gaps[gap] ?? "");
/** @param {import("../types").Told} message */
const tell = (message) => parent.postMessage(message, "*");

const later = new IntersectionObserver(
  (entries) => {
    if (entries.some((one) => one.isIntersecting)) tell({ kind: "later" });
  },
  { rootMargin: "300px" },
);

/** Said below Figure 1: how a joint is dragged, and why one does not follow.
 * @param {string} [refused] */
const explain = (refused) => {
  const figure = document.getElementById("mechanism");
  if (!figure) return;
  let how = document.getElementById("drag-how");
  if (!how) {
    how = Object.assign(document.createElement("p"), { id: "drag-how", className: "note" });
    const box = Object.assign(document.createElement("input"), { type: "checkbox", id: "drag-free", checked: joints.free });
    box.addEventListener("change", () => (joints.free = box.checked));
    const label = document.createElement("label");
    label.append(box, " ", document.createElement("span"));
    how.append(
      document.createElement("span"),
      " ",
      label,
      " ",
      Object.assign(document.createElement("output"), { id: "drag-why" }),
    );
    figure.append(how);
  }
  const [text, switched] = how.querySelectorAll("span");
  // A drawing of a later row has no joints to drag, and says why.
  const still = !figure.querySelector("[data-joint]");
  if (text && switched) {
    [text.textContent, switched.textContent] = [say(still ? "drag_later" : "drag_how", {}), say("drag_free", {})];
    /** @type {HTMLElement} */ (switched.parentElement).hidden = still;
  }
  const why = document.getElementById("drag-why");
  if (why) why.textContent = refused ?? "";
};

addEventListener("message", ({ source, data }) => {
  if (source !== parent) return;
  if (data.kind === "hello") tell({ kind: "ready" });
  else if (data.kind === "words") {
    words = data.words;
    explain();
  } else if (data.kind === "clear") joints.drop(), forget();
  else if (data.kind === "refused") explain(data.sentence);
  else if (data.kind === "page") {
    patch(data.html, data.later);
    explain();
    joints.prepare();
    // What is computed only when somebody looks at it.
    later.disconnect();
    for (const one of document.querySelectorAll("[data-later]")) later.observe(one);
    tell({ kind: "shown", id: data.id });
  }
});
addEventListener("keydown", (event) => {
  if (event.key === "F6") tell({ kind: "key", key: "leave" });
  else if (!(event.ctrlKey || event.metaKey) || event.altKey) return;
  else if (event.key === "s") tell({ kind: "key", key: "save" });
  else if (event.key === "z") tell({ kind: "key", key: event.shiftKey ? "redo" : "undo" });
  else if (event.key === "y") tell({ kind: "key", key: "redo" });
  else return;
  event.preventDefault();
});
// Links lead to places of the page; without this a frame without an address would load itself again.
addEventListener("click", (event) => {
  const link = event.target instanceof Element ? event.target.closest("a[href^='#']") : null;
  if (!link) return;
  event.preventDefault();
  document.getElementById((link.getAttribute("href") ?? "").slice(1))?.scrollIntoView();
});
tell({ kind: "ready" });
