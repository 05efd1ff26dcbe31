"""What a student and an instructor read about graded work: one small page each, without scripts."""
