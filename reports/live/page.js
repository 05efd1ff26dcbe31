// What every part of the page needs: elements, numbers in the reader's language, sentences with gaps.
// Enters: `data`.  Leaves: functions; text enters the page by textContent alone.
/** @type {(id: string) => PageElement} */
const byId = (id) => /** @type {PageElement} */ (document.getElementById(id));
const live = byId("live");
/** @type {(name: string, given?: Record<string, unknown>) => any} */
const element = (name, given) => Object.assign(document.createElement(name), given);
/** @type {(name: string, attributes: Attributes, into?: Element | null) => any} */
const svg = (name, attributes, into) => {
  const made = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const key in attributes) made.setAttribute(key, attributes[key]);
  if (into) into.append(made);
  return made;
};
/** @type {(text: string) => string} */
const written = (text) => text.replace("-", "−").replace(".", data.decimal);
/** @type {(number: number | string) => string} */
const raised = (number) => String(number).replace(/[-\d]/g, (sign) => "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"["-0123456789".indexOf(sign)]);
// A number with so many significant digits, in powers of ten where small or large.
/** @type {(value: number, digits: number) => string} */
const shown = (value, digits) => {
  if (!Number.isFinite(value)) return "–";
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (size >= 1e-3 && size < 1e5) {
    const exponent = Number(size.toExponential(digits - 1).split("e")[1]);
    return written(value.toFixed(Math.max(0, digits - 1 - exponent)));
  }
  const [head, power] = value.toExponential(Math.min(digits, 3) - 1).split("e");
  return `${written(head)}·10${raised(Number(power))}`;
};
// The same without zeros at the end.
/** @type {(value: number, digits: number) => string} */
const plain = (value, digits) => written(String(Number(value.toPrecision(digits))).replace(/e(.+)/, (_, power) => `·10${raised(Number(power))}`));
// What rounds to nought has no sign.
/** @type {(value: number, decimals: number) => string} */
const fixed = (value, decimals) => written(value.toFixed(decimals).replace(/^-(?=0(\.0*)?$)/, ""));
// The decimals that multiples of a step need; of a step without an end, four digits of it.
/** @type {(step: number) => number} */
const decimalsOf = (step) => {
  for (let places = 0; places <= 7; places++) if (Math.abs(Number(step.toFixed(places)) - step) <= 1e-9 * step) return places;
  return Math.max(0, 3 - Math.floor(Math.log10(step)));
};
/** @type {(key: string, values: Record<string, any>) => string} */
const say = (key, values) => data.words[key].replace(/\{(\w+)\}/g, (_, gap) => values[gap]);
/** @type {(name: string) => string} */
const label = (name) => data.labels[name] ?? name;
// Write a sentence.  Every second piece of it stands between the marks of what no line may break; the places of pieces stay,
// empty where a sentence has fewer, so that sentences told again and again make nothing.
/** @type {(place: Element, text: string) => void} */
const write = (place, text) => {
  const parts = text.split(/[\ue003\ue004]/), { childNodes } = place;
  while (childNodes.length < parts.length) place.append(childNodes.length % 2 ? element("bdi") : new Text());
  childNodes.forEach((piece, k) => {
    const part = parts[k] ?? "";
    if (piece.textContent !== part) piece.textContent = part;
  });
};
// A symbol with its subscript lowered: "φ_c", "V_Mx".
/** @type {(place: Element, text: string) => void} */
const symbolic = (place, text) => {
  const [head, low, rest] = text.split(/_([^\s,]+)/);
  place.replaceChildren();
  write(place, head);
  if (!low) return;
  /** @type {(name: string, attributes: Attributes) => any} */
  const add = (name, attributes) =>
    place instanceof SVGElement ? svg("tspan", attributes, place) : place.appendChild(element(name));
  add("sub", { dy: 4, "font-size": "75%" }).textContent = low;
  if (rest) write(add("span", { dy: -4 }), rest);
};
/** @type {(id: string, text: string, value?: string) => void} */
const tell = (id, text, value) => {
  const place = byId(id);
  write(place, text);
  if (value !== undefined) place.dataset.value = value;
};
/** @type {(value: number) => number} */
const f1 = (value) => Math.round(10 * value) / 10;
// Set an attribute where it is another than before: what is written is laid out and painted anew.
/** @type {(element: any, name: string, value: string | number) => void} */
const change = (element, name, value) => {
  const kept = (element.kept ??= {});
  if (kept[name] === value) return;
  kept[name] = value;
  element.setAttribute(name, value);
};
// What can be moved sideways, or is enlarged when reached, is a stop of the keyboard, and only while it can.
const stops = () => {
  for (const one of document.querySelectorAll(".scroll, .formula, .drawing > div, .live-scroll")) {
    const least = (parseFloat(getComputedStyle(one).getPropertyValue("--least")) || 0) * 96 / 25.4;
    if (Math.max(one.scrollWidth, least) > one.clientWidth + 1 || one.scrollHeight > one.clientHeight + 1) one.setAttribute("tabindex", "0");
    else one.removeAttribute("tabindex");
  }
};
