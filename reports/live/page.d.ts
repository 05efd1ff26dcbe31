// What the scripts of the live page find beside each other, for whoever checks their types: nothing of this is sent.
/// <reference path="./types.d.ts" />
/// <reference path="./forces.d.ts" />

/** The numbers and words of the page, as `coursework/report/live/` writes them. */
declare const data: Data;
/** A packed script, before it is unpacked. */
declare const packed: string;
/** The generated functions of a variant: velocities and determinants, places of what is drawn, what the links close. */
declare function rates(t: number, q: ArrayLike<number>, d: any, out: Float64Array): Float64Array;
declare function places(t: number, q: ArrayLike<number>, d: any, out: Float64Array): Float64Array;
declare function closing(t: number, q: ArrayLike<number>, d: any, out: Float64Array): Float64Array;
/** Of a page with forces: what acts on the links; of one that forces move: slopes, Newton's corrections, what positions keep. */
declare function acting(t: number, q: ArrayLike<number>, u: ArrayLike<number>, d: any, out: Float64Array): Float64Array;
declare function slope(t: number, q: ArrayLike<number>, v: ArrayLike<number>, d: any, out: Float64Array): Float64Array;
declare function corrected(t: number, q: ArrayLike<number>, k: ArrayLike<number>, d: any, out: Float64Array): Float64Array;
declare function held(t: number, q: ArrayLike<number>, d: any, out: Float64Array): Float64Array;
