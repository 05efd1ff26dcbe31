// The types of codemirror.js: those of the packages that entry.js bundles.
export * from "./entry.js";
