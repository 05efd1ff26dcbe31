// What goes between the desk's shell, its server and the frame of the page.

/** A place in a text, counted from 1; the end is the first letter behind it. */
export interface Span { line: number; column: number; end_line: number; end_column: number }
/** What shall stand at a place of a text. */
export interface Edit extends Span { text: string }
export interface Fault { code: string; line: number | null; column: number | null; sentence: string; mend: Edit | null }
export interface Remark { line: number | null; column: number | null; sentence: string }
/** What the geometry says of an equation of the text. */
export interface Verdict { line: number; right: boolean | null; sentence: string }
/** A number of Table 1 or a start value, in the unit of the text. */
export interface Datum {
  name: string; kind: "given" | "start"; title: string; symbol: string; value: number; unit: string; digits: number;
  low: number; high: number; step: number; text: string; place: Span | null;
}
export interface Answer {
  faults: Fault[]; summary: string | null; page: string | null; remarks?: Remark[]; data?: Datum[];
  equations?: Verdict[]; later?: string[];
}
export interface Ask {
  text: string; language: string; name?: string; scheme?: string; step?: string; tables?: Record<string, string>;
  study?: boolean;
}
export interface Policy { equations: boolean; exact: boolean }
export interface Config {
  root: string; mode: "edit" | "serve"; name: string; text: string; etag: string | null; language: string;
  languages: [string, string][]; schemes: [string, string][]; formats: string[]; policy: Policy; writable: boolean;
  folder?: string; nonce: string; version: string; words: Record<string, string>;
}
/** A text as it is kept: `etag` names the version. */
export interface Kept { text: string; etag: string }
export interface Entry { name: string; etag: string; deleted: boolean }
/** Where texts are kept: a folder behind the server, or this browser. */
export interface Works {
  list(): Promise<Entry[]>;
  read(name: string): Promise<Kept | null>;
  /** Writes over the version `etag`, null for a new text; what stands there instead comes back as a conflict. */
  write(name: string, text: string, etag: string | null): Promise<{ etag: string } | { theirs: Kept | null }>;
  rename(name: string, other: string): Promise<void>;
  duplicate(name: string, other: string): Promise<void>;
  remove(name: string, etag: string): Promise<void>;
  restore(name: string): Promise<void>;
  zip(): Promise<Blob>;
  unzip(file: Blob): Promise<{ written: string[]; skipped: { name: string; sentence: string }[] }>;
  /** Calls when another program or window changed a text. */
  watch(changed: (entries: { name: string; etag: string }[]) => void): void;
  tables(): Record<string, string> | undefined;
  keepTables(tables: Record<string, string>): void;
}
export interface CatalogueEntry { name: string; title: string; teaches: string; links: number; groups: string[]; svg: string }
export interface Piece { kind: string; title: string; svg: string; asks: { key: string; means: string }[] }
export interface Key { name: string; means: string }
/** A table of a text, once or `many` times; `named` where a person chooses its keys.  Without keys it is a key at the top. */
export interface Section extends Key { keys: Key[]; lines: string[]; many: boolean; named: boolean }
export interface Keys {
  sections: Section[]; functions: string[]; units: string[]; quantities: Key[]; schemes: Key[]; kinds: Key[]
}
/** What the frame tells the shell; nothing in it is trusted. */
export type Told =
  | { kind: "ready" } | { kind: "shown"; id: number } | { kind: "later" }
  | { kind: "drag"; joint: string; place: [number, number]; free: boolean; first: boolean }
  | { kind: "key"; key: "save" | "undo" | "redo" | "leave" };
/** A joint of Figure 1 in the frame: its place in the mechanism (m), and how many mm of the drawing 1 m is. */
export interface Joint { joint: string; at: [number, number]; mm: number; svg: SVGSVGElement; ring: SVGCircleElement }
/** A joint while it is dragged: the sheet as it was when the hand took it. */
export interface Held {
  name: string; origin: number[]; mm: number; box: number[]; width: number; height: number; moved: boolean;
  matrix: DOMMatrix;
}
/** A fault where it is in the editor now. */
export interface PlacedFault {
  from: number; to: number; line: number; column: number; sentence: string; missing: boolean; nowhere: boolean;
  mend: { from: number; to: number; insert: string } | null;
}
/** The controls of one datum. */
export interface DatumRow {
  row: HTMLElement; slider: HTMLInputElement; field: HTMLInputElement; unit: HTMLElement; datum: Datum
}
/** What the bar says; `fresh` where nothing is saved under the name yet. */
export interface State {
  unreachable: string | null; faults: number; missing: boolean; computing: boolean; file: "saved" | "changed" | "conflict"; fresh: boolean;
}
