"""Native equations of Word, OpenDocument and HTML -> lines of text."""
