"""The version of the package, to be recorded beside a result.

Enters: nothing.  Leaves: a text.  Used by `scene_run.py` and `grading/batch/`; a user asks `coursework.__version__`.
"""

VERSION = "1.0.0"
