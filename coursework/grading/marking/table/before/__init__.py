"""What a table was before cells of it were misprinted or put right: a search (`restored`), its `guesses`, what rows make."""
