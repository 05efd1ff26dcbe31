"""The desk: a server for a page on which a variant is typed.  `serving/` talks to the browser, `answering/` computes."""
