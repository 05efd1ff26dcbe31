// The script of the live part as it was before it was packed (deflate, RFC 1951), in the place of this one and at once: no
// event of the page comes before it, and nothing is fetched.  What it is admitted by is the hash of what is unpacked.
// Enters: `packed`, base64 of blocks with codes of their own or fixed ones.  Leaves: the script, run.
const bytes = Uint8Array.from(atob(packed), (letter) => letter.charCodeAt(0));
let at = 0, kept = 0, have = 0;

/** @type {(count: number) => number} */
const bits = (count) => {
  for (; have < count; have += 8) kept |= bytes[at++] << have;
  const value = kept & ((1 << count) - 1);
  kept >>= count;
  have -= count;
  return value;
};

/** @type {(count: number, length: number) => number[]} */
const times = (count, length) => new Array(count).fill(length);

// Codes of one length are consecutive numbers in the order of their symbols, behind those of the lengths before; they come
// with their first digit in the last place.  What begins with one is looked up whole.
/** @type {(lengths: number[]) => () => number} */
const reader = (lengths) => {
  const known = new Uint16Array(1 << 15);
  for (let size = 1, code = 0; size < 16; size++, code *= 2)
    for (let symbol = 0; symbol < lengths.length; symbol++)
      if (lengths[symbol] === size) {
        let begin = 0;
        for (let k = 0; k < size; k++) begin = begin * 2 + ((code >> k) & 1);
        for (; begin < 1 << 15; begin += 1 << size) known[begin] = symbol * 16 + size;
        code++;
      }
  return () => {
    for (; have < 15; have += 8) kept |= bytes[at++] << have;
    const found = known[kept & 32767], size = found & 15;
    kept >>= size;
    have -= size;
    return found >> 4;
  };
};

const ORDER = [16, 17, 18, 0, 8, 7, 9, 6, 10, 5, 11, 4, 12, 3, 13, 2, 14, 1, 15];
/** @type {() => number[][]} */
const codes = () => {
  const letters = bits(5) + 257, distances = bits(5) + 1, count = bits(4) + 4, own = times(19, 0);
  /** @type {number[]} */
  const lengths = [];
  for (let k = 0; k < count; k++) own[ORDER[k]] = bits(3);
  const next = reader(own);
  while (lengths.length < letters + distances) {
    const symbol = next();
    if (symbol < 16) lengths.push(symbol);
    else if (symbol === 16) lengths.push(...times(3 + bits(2), lengths[lengths.length - 1]));
    else lengths.push(...times(symbol === 17 ? 3 + bits(3) : 11 + bits(7), 0));
  }
  return [lengths.slice(0, letters), lengths.slice(letters)];
};

/** @type {number[]} */
const found = [];
for (let last = 0; !last; ) {
  last = bits(1);
  const fixed = [[...times(144, 8), ...times(112, 9), ...times(24, 7), ...times(8, 8)], times(30, 5)];
  const [letter, distance] = (bits(2) === 1 ? fixed : codes()).map(reader);
  for (let symbol = letter(); symbol !== 256; symbol = letter()) {
    if (symbol < 256) {
      found.push(symbol);
      continue;
    }
    const place = symbol - 257, more = place < 8 || place > 27 ? 0 : (place >> 2) - 1;
    let left = place > 27 ? 258 : (more ? ((4 + (place & 3)) << more) : place) + 3 + bits(more);
    const way = distance(), further = way < 2 ? 0 : (way >> 1) - 1;
    const back = (way < 2 ? way : (2 + (way & 1)) << further) + 1 + bits(further);
    for (; left; left--) found.push(found[found.length - back]);
  }
}
const script = document.createElement("script");
script.textContent = new TextDecoder().decode(Uint8Array.from(found));
document.currentScript?.replaceWith(script);
