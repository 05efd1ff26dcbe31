// What the desk uses of CodeMirror 6, and nothing else: esbuild leaves out what no name here leads to.
export { autocompletion } from "@codemirror/autocomplete";
export { defaultKeymap, history, historyKeymap, insertNewline, redo, undo } from "@codemirror/commands";
export { StreamLanguage, bracketMatching, syntaxHighlighting } from "@codemirror/language";
export { lintKeymap, setDiagnostics } from "@codemirror/lint";
export { MergeView } from "@codemirror/merge";
export { highlightSelectionMatches, search, searchKeymap } from "@codemirror/search";
export {
  ChangeSet, Compartment, EditorState, RangeSet, RangeValue, StateEffect, StateField, Transaction,
} from "@codemirror/state";
export {
  Decoration, EditorView, WidgetType, drawSelection, highlightActiveLine, highlightActiveLineGutter, highlightSpecialChars,
  keymap, lineNumbers,
} from "@codemirror/view";
export { classHighlighter } from "@lezer/highlight";
