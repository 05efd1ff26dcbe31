"""What a table was before cells were misprinted or put right: a search (`restored`), its `guesses`, and what rows make."""
