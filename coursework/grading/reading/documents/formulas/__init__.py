"""Native equations of Word, OpenDocument and HTML as lines of text."""
