"""The report as a document that a student goes on writing in: Word, OpenDocument, LaTeX, by pandoc."""
