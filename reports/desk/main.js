// The desk: one text, one page, and what goes between them.  Enters: the configuration in the page, the server's answers.

import { ChangeSet, redo, undo } from "./editor/codemirror.js";
import { commandsIn } from "./commands.js";
import { compared } from "./dialogs/conflict.js";
import { askLine, confirmed, refusedName } from "./dialogs/dialog.js";
import { found } from "./elements.js";
import { noticesIn } from "./notices.js";
import { pageIn } from "./page/page.js";
import { printed } from "./page/print.js";
import { postAtOnce, speakIn, standBehind } from "./requests.js";
import { settingsIn } from "./settings.js";
import { stateIn } from "./state.js";
import { completing } from "./text/completion.js";
import { dataIn, places } from "./text/data.js";
import { draggingIn } from "./text/dragging.js";
import { MOVE, editorIn } from "./text/editor.js";
import { isMissing, showFaults, told } from "./text/faults.js";
import { showVerdicts, verdicts } from "./text/verdicts.js";
import { followWords, say, speak, spoken } from "./words.js";
import { asking } from "./work/asking.js";
import { browserWorks } from "./work/browser.js";
import { folderWorks } from "./work/folder.js";
import { savingIn } from "./work/saving.js";
import { keep, keeps, kept } from "./work/store.js";

/** @import { Answer, Ask, Config } from "./types" */

const config = /** @type {Config} */ (JSON.parse(found("desk-config", HTMLScriptElement).textContent ?? ""));
standBehind(config.root);
speakIn(config.language);
speak(config.words);

const state = stateIn(found("desk-state", HTMLOutputElement)),
  notices = noticesIn(found("desk-notices", HTMLElement));
const works = config.mode === "edit" ? folderWorks() : browserWorks();
const frame = found("desk-page", HTMLIFrameElement),
  faults = found("desk-faults", HTMLElement);
const settings = settingsIn(config, () => ask());

const view = editorIn(found("desk-text", HTMLElement), {
  nonce: config.nonce,
  extensions: [places, ...verdicts, completing(() => `/api/keys?language=${settings.language}`)],
  save: () => void saving.save(),
  changed(update) {
    since = since.compose(update.changes);
    study = false;
    data.mind();
    saving.changed();
    state.set({ computing: true });
    // A hand or the desk itself is answered at once; whoever types has the next letter in mind.
    if (update.transactions.some((one) => BY_HAND.some((kind) => one.isUserEvent(kind)))) asks.moved();
    else asks.typed();
  },
});
const BY_HAND = [MOVE, "input.desk", "input.mend"];
const text = () => view.state.doc.toString();

// What was asked about, what was changed in it since, and the page whose showing is waited for.
let doc = view.state.doc,
  since = ChangeSet.empty(doc.length),
  study = false,
  showing = 0;

const asks = asking({
  body() {
    doc = view.state.doc;
    since = ChangeSet.empty(doc.length);
    return { text: doc.toString(), ...given(), study };
  },
  began: () => state.set({ computing: true }),
  lost(sentence) {
    state.set({ unreachable: sentence ?? "", computing: false });
    keepHere();
  },
  answered,
});
/** What goes beside a text in every question: its name, how it shall be computed, the tables of this browser. */
function given() {
  const tables = works.tables(),
    { name } = saving;
  return { ...settings.given(), ...(name && { name }), ...(tables && { tables }) };
}
/** Ask at once: something was moved or chosen. */
function ask() {
  state.set({ computing: true });
  asks.moved();
}

/**
 * What the page is an answer to, where sections of it are headings yet.
 * @type {Ask | null}
 */
let lacking = null;

/** The page with all its sections. */
const whole = () => (lacking && postAtOnce("/api/page", { ...lacking, study: true })?.page) || page.html;

/**
 * @param {Answer} answer
 * @param {Ask} asked
 */
function answered(answer, asked) {
  showFaults(view, faults, answer, doc, since);
  showVerdicts(view, answer.equations ?? [], doc, since);
  if (!answer.faults.length) data.show(answer.data ?? [], doc, since);
  state.set({ unreachable: null, faults: answer.faults.length, missing: answer.faults.every(isMissing) });
  if (answer.page !== null) {
    lacking = answer.later?.length ? asked : null;
    showing = page.show(answer.page, answer.later ?? []);
  } else settle();
  const first = answer.faults[0],
    pale = found("desk-pale", HTMLElement);
  const held = Boolean(first) && !page.html && !answer.faults.every(isMissing);
  frame.classList.toggle("pale", Boolean(first));
  pale.hidden = !first || !(page.html || held);
  pale.textContent = first ? say(held ? "held" : "pale", { sentence: told(first) }) : "";
  found("desk-welcome", HTMLElement).hidden = Boolean(page.html) || held;
  frame.classList.toggle("empty", !page.html);
  keepHere();
}

/** Where all work is in this browser nobody has to save it. */
function keepHere() {
  if (config.mode === "serve" && text()) void saving.save();
}

/** The page stands; the desk rests unless the text is another one by now. */
function settle() {
  state.set({ computing: asks.busy || hand.busy || !since.empty });
}

const page = pageIn(frame, spoken, {
  shown: (id) => id === showing && settle(),
  later() {
    if (study) return;
    study = true;
    ask();
  },
  key(key) {
    if (key === "save") void saving.save();
    else if (key === "undo") undo(view);
    else if (key === "redo") redo(view);
    else if (key === "leave") view.focus();
  },
  drag: (move) => hand.to(move),
});
const hand = draggingIn(view, {
  given,
  refuse: (sentence) => page.refuse(sentence),
  began: () => state.set({ computing: true }),
  ended: settle,
});
const data = dataIn(found("desk-data", HTMLElement), view);
const saving = savingIn({
  works,
  view,
  state,
  notices,
  named(name) {
    if (name) keep("last", name);
    found("desk-name", HTMLElement).textContent = name || say("unnamed");
    document.title = `${name || say("unnamed")} · ${say("title")}`;
  },
  // Page and sliders of the text before say nothing of this one.
  began() {
    asks.drop();
    page.clear();
    lacking = null;
    frame.classList.add("empty");
    found("desk-pale", HTMLElement).hidden = true;
    data.show([], view.state.doc, since);
  },
  again: ask,
  sure: () => confirmed(say("state_changed"), say("keeps_nothing"), say("leave")),
  askName: (name) => askLine({ title: say("save"), label: say("name"), value: name, verb: say("save"), refuses: refusedName }),
  compare: (theirs, own) => compared(saving.name, own, theirs.text, config.nonce),
});

followWords(() => page.speak());
printed(found("desk-print", HTMLElement), config.nonce, whole);
// Where all parts stand one below the other, the way to the page is short.
if (matchMedia("(max-width: 1099px)").matches) found("desk-data", HTMLDetailsElement).open = false;
if (!keeps()) notices.show("keeps", say("keeps_nothing"));
if (config.mode === "edit" && !config.writable) notices.show("folder", say("not_writable", { folder: config.folder ?? "" }));
commandsIn({ config, works, view, settings, saving, notices, given });
// On `serve` nobody has opened anything: the work of last time, else an empty text under a name.
const name = config.name || (config.mode === "serve" ? String(kept("last") ?? "mine") : "");
const there = config.mode === "serve" && !config.text ? await works.read(name) : null;
saving.begin(name, there?.text ?? config.text, there?.etag ?? config.etag);
