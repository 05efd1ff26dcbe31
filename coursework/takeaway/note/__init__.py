"""The report as a document that a student can edit: Word, OpenDocument or LaTeX, by pandoc."""
