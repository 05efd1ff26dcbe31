"""Word processor documents, notebooks, JSON, Markdown and PDF -> the tables and lines of text in them."""
