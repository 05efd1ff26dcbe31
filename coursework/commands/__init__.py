"""The commands: what each does and prints, as thin layers over the library, one file per command."""

import atexit
import gc

# Nearly all objects of a run live until its end, so searching them for garbage takes a tenth of the run in vain, beginning with
# those of click.  At the end it would take as long again, although the process then gives all memory back at once.
gc.set_threshold(200_000, 50, 100)
atexit.register(gc.freeze)
