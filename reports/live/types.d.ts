// The shapes of what the scripts of the live page hand to each other, for whoever checks their types: nothing of this is sent.
/** Work in pieces: each tells how much was done, or FRAME. */
type Job<Found = void> = Generator<number, Found, undefined>;
type Attributes = Record<string, any>;
/** The rows of a tableau: a fraction, and (index, weight) of each slope. */
type Share = [number, number];
type Sum = { factor: Share; terms: [number, number][] };
type Scheme = { order: number; nodes: Share[]; inner: Sum[]; outer: Sum; early?: boolean };

/** The rows of one motion: positions `q`, velocities and determinants `u`; from `dead` (s) on there is none. */
interface Rows {
  n: number;
  h: number;
  q: Float64Array;
  u: Float64Array;
  dead: number | null;
  lost: boolean;
  evaluations: number;
  name?: string;
}
interface Stepper {
  sound: boolean;
  step(t: number, q: Float64Array, h: number, first: Float64Array, d: any, into: Float64Array): Float64Array;
}
/** The largest difference from the true motion: value, place of the coordinate, row from 1. */
type Worst = { value: number; place: number; row?: number };

/** A motion that was computed before has what the drawing asks for. */
type Recorded = Partial<Motion> & Pick<Motion, "h" | "count" | "grain" | "dead" | "duration" | "at" | "rate">;

/** Where everything drawn is: x, y in m, one after the other. */
type Place = Float64Array | number[];
type Point = [number, number];
type Extent = { box: number[]; rows: Place[] };
/** How far a slot reaches from its point (px), and how far beside it lies. */
type Reach = { slot: any; beside: number; low: number; high: number };

/** What is drawn piece by piece, the one that has waited longest first. */
interface Piece {
  turn: number;
  draw(): void;
}
/** A column of the motion: its rows, their step, the value in each. */
type Column = { n: number; h: number; value: (i: number) => number };

/** Does one job in slices; a new one takes the place of the one before it. */
interface Work {
  waiting: number;
  job?: Job<any>;
  begin(job: Job<any>, most?: number): void;
  later(wait: number, job: Job<any>): void;
  go(job: Job<any>, most: number): unknown;
}
/** What is tried in the laboratory; a `value` of null is that of the file. */
type Tried = { halvings: number; scheme: string; datum: string; value: number | null };

/** The two motions that are shown: the table of what is tried, and the true one.  With `true_` the latter is meant. */
interface Motion {
  d: any;
  start: any;
  h: number;
  inside: number;
  stop: number | null;
  rows: Rows;
  truth: Rows | null;
  worst: any;
  first: any;
  made: string;
  drawn: string;
  chosen: string;
  wanted: string;
  fine: Rows;
  next: Rows;
  rough: Rows;
  spare: Rows;
  timed: Rows;
  readonly cost: number;
  readonly dead: number | null;
  readonly count: number;
  readonly grain: number;
  /** The last place (m) to which positions are written down, where they are. */
  readonly finest?: number;
  readonly duration: number;
  choose(): void;
  sketch(): void;
  compute(): Job;
  again(into?: Rows, h?: number, truth?: Rows | null, scheme?: string): Job;
  at(true_: boolean, t: number): Place | null;
  rate(true_: boolean, t: number, name: string): any;
  column(true_: boolean, name: string): Column;
}

/** What the page holds in JSON; a point is told by its name. */
interface Data {
  points: string[];
  shown_points: string[];
  rings: string[];
  links: Bar[];
  wheels: Wheel[];
  tracks: Track[];
  slots: Slot[];
  racks: Slot[];
  blocks: Block[];
  rails: Rail[];
  hinges: { at: string; ground: Point }[];
  spots: number[][][];
  coordinates: string[];
  velocities: string[];
  shown: string[];
  given_order: string[];
  schemes: Record<string, Scheme>;
  words: Record<string, string>;
  labels: Record<string, string>;
  breaks: number[];
  guarded: number[];
  forces: Loads;
  [key: string]: any;
}
type Bar = { name: string; points: string[]; rate: string | null };
type Wheel = { link: string; centre: string; contact: string };
type Track = { centre: string; rim: string; inward: number };
type Line = { at: string; base: string; toward: string };
type Slot = Line & { riders: string[]; side: number };
type Block = Line & { open: boolean };
type Rail = Line & { rider: string; side: number; rolls: boolean };

/** The drawing: its layers and paths, the window, what stands still. */
interface Drawing {
  field: any;
  layers: Record<string, any>;
  paths: Record<string, any>;
  WIDE: number;
  HIGH: number;
  right: Extent;
  drawn?: string;
  samples: Place[][];
  first: Place;
  turns: Record<string, number[]>;
  scale: number;
  origin: number[];
  slots: Reach[];
  racks: Reach[];
  prepare(): void;
  refit(): void;
  extent(true_: boolean, last: number, h: number): Extent;
  x(value: number): number;
  y(value: number): number;
  room(x: number, y: number, dx: number, dy: number): number;
  put(place: Place, name: string): Point;
  ground(): void;
  outline(place: Place, true_: boolean, t: number): string;
  reach(slot: Slot): Reach;
  turned(wheel: Wheel, true_: boolean, t: number): number | null;
  draw(t: number): { right: Place | null; ghost: Place | null } | undefined;
  joints(place: Place): void;
}

/** Names of points and numbers of links, each with the points it is placed by. */
interface Words {
  all: { made: any; points: string[] }[];
  prepare(layer: any): void;
  place(place: Place): void;
}
/** What a switch adds: traces, velocities, instantaneous centres. */
interface Additions {
  on: Record<string, boolean>;
  long: number;
  renew(): void;
  draw(place: Place | null, t: number): void;
  arrow(layer: any, x: number, y: number, dx: number, dy: number): void;
  centre(layer: any, bar: Bar, place: Place, speeds: Place, t: number): void;
}
/** What has left its place: which guide, the point, how far (m). */
type Off = { guide?: string; point: string; distance: number };
/** Where the animation stands on the rest of the page. */
interface Cursors {
  panels: any[];
  tables: { rows: any[]; lit: any }[];
  find(): void;
  place(t: number, moving: boolean): void;
}

/** A small graph of one column; `range` are the ends of the true motion's, `texts` the numbers at its axis. */
interface Panel extends Piece {
  panel: any;
  name: string;
  texts: any[];
  range?: any;
  drawn?: string;
  key?: string;
  [part: string]: any;
}
interface Panels {
  all: Panel[];
  readonly seen: Panel[];
  drawn: string;
  along: string[];
  x(t: number): number;
  prepare(): void;
  draw(one: Panel): void;
  truth(one: Panel): void;
  scale(one: Panel, low: number, high: number, y: (value: number) => number): void;
}
/** A line of the table: its cells, their texts, what they hold and say. */
type TableLine = { line: any; cells: any[]; texts: any[]; values: number[]; said: string[] };
type LineGroup = Piece & { from: number };
interface Lines {
  columns: string[];
  made: TableLine[];
  groups: LineGroup[];
  count: number;
  lit: any;
  inSight: number;
  top: number;
  body?: any;
  box?: any;
  blank?: any;
  few: number;
  wanted: number;
  value: ((i: number) => number)[];
  decimals: number[];
  readonly all: LineGroup[];
  readonly seen: LineGroup[];
  prepare(): void;
  make(i: number): TableLine;
  open(): void;
  write(room: number): Job;
  spell(from: number): void;
  light(row: number, moving: boolean): void;
}
/** A table that was timed: its error (rad or m) and its time (ms). */
type Try = { scheme: string; h: number; error: number; time: number };
interface Watch {
  tries: Try[];
  schemes: Try[];
  first?: any;
  open(): void;
  later(): void;
  measure(): Job;
  compare(): Job;
  best(remake: () => Job, rounds: number): Job<number>;
  round(remake: () => Job, many: number): Job<number>;
  note(time: number): void;
  duration(time: number): string;
  draw(): void;
}
interface Laboratory {
  turn: number;
  where: string;
  prepare(): void;
  slide(): void;
  move(change: Partial<Tried>): void;
  answer(cells?: number): Job;
  draw(pieces: Piece[], many: number): void;
  tellMoved(): void;
  tellFound(): void;
  otherDatum(): string;
  amount(one: Pick<Worst, "value" | "place">): string;
  ratio(): string;
}

/** An element of the page by its id, whatever it is. */
interface PageElement extends HTMLElement {
  [part: string]: any;
  closest(wanted: string): any;
  readonly firstElementChild: any;
  readonly lastElementChild: any;
  addEventListener(kind: string, heard: (event: any) => void, options?: any): void;
}
