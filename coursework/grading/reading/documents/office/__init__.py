"""The files of word processors, Word, OpenDocument and RTF, element by element -> a document."""
