// What may be the name of a text: a file of this name can be written on every system.

const DEVICE = /^(?:con|prn|aux|nul|(?:com|lpt)\d)$/i;

/** Letters, digits, _ and -, and no device of Windows. @param {string} name */
export const isName = (name) => /^[\p{L}\p{N}_-]{1,60}$/u.test(name) && !DEVICE.test(name.normalize("NFKC"));
