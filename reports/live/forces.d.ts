// The shapes of what acts on the links, for whoever checks their types: nothing of this is sent.
/** What acts: how many bodies and joints there are, each unknown with its two bodies, its joint and its kind. */
type Loads = {
  bodies: number;
  places: number;
  size: number;
  more?: number;
  unknowns: [string, number, number, number, number][];
  arrows: [string, ...number[]][];
  drives: string[];
  free: number[];
  others: number[];
  held: number;
};

/** What acts on the links at the position that was asked for last; `kind` 0: along x, 1: along y, 2: a couple, more: a guide. */
interface Acts {
  on(t: number, q: Float64Array, d: any): boolean;
  reactions(): number[];
  way(kind: number): Float64Array | number[];
  place(at: number): Point;
  arm(at: number, centre: number, x: number, y: number): number;
  readonly kinetic: number;
  readonly energy: number;
}
/** A force that is drawn at a place (m): x, y and its size in N. */
type Arrow = { name: string; at: Point; x: number; y: number; size: number };
interface Forces {
  kept: Map<Rows, Float64Array[]>;
  largest: number;
  long: number;
  scale: number;
  layer?: any;
  at(true_: boolean, t: number): boolean;
  columns(rows: Rows): Float64Array[];
  arrows(): Arrow[];
  clear(px: number, py: number, dx: number, dy: number, half: number, taken: number[][]): number[];
  taken(place: Place): number[][];
  draw(t: number, place: Place | null): void;
  tell(first: Arrow[], energy: number, t: number, found?: number[]): void;
  renew(): void;
}
