// What this browser keeps: texts not saved yet, and on `serve` all work.
// Where it keeps nothing, `keeps` says so before the first change.

const HEAD = "coursework.";

/** @param {string} key */
export function kept(key) {
  try {
    return JSON.parse(localStorage.getItem(HEAD + key) ?? "null");
  } catch {
    return null;
  }
}

/**
 * Returns false where nothing could be kept: a private window, a full disk.
 * @param {string} key
 * @param {unknown} value
 */
export function keep(key, value) {
  try {
    if (value === null) localStorage.removeItem(HEAD + key);
    else localStorage.setItem(HEAD + key, JSON.stringify(value));
    return true;
  } catch {
    return false;
  }
}

export function keeps() {
  const works = keep("try", 1);
  return keep("try", null) && works;
}

/** @param {string} head */
export function keptNames(head) {
  try {
    return Object.keys(localStorage)
      .filter((key) => key.startsWith(HEAD + head))
      .map((key) => key.slice((HEAD + head).length))
      .sort();
  } catch {
    return [];
  }
}

export function forgetAll() {
  for (const name of keptNames("")) keep(name, null);
  try {
    sessionStorage.clear();
  } catch {
    // Nothing was kept there either.
  }
}
