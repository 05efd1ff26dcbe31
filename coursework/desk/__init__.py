"""The desk: a server that answers in the browser while a variant is typed.  `serving/` talks, `answering/` computes beside it."""
