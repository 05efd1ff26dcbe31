"""What share of the draws is feasible, and lies in the band, for the ranges of the catalogue.

python -m tests.assigning.shares            # 1000 draws each; the figures stand in the first lines of the files
"""

import re
from collections import Counter

import coursework
from coursework.assigning.accept import Acceptance
from coursework.assigning.judge import judge
from coursework.assigning.ranges import Lots
from coursework.assigning.variants import load_ranges
from coursework.words.data_folders import folder

STREAM = "measured"  # not the pilot's: the share is of draws as students get them
TOLD = re.compile(r"^# Of 1000 draws (?P<feasible>[\d.]+) % are feasible, (?P<banded>[\d.]+) % lie in the band as well\.$", re.M)


def names():
    return sorted(path.stem for path in (folder("variants") / "ranges").glob("*.toml"))


def told(name):
    """Return the two shares (%) that the file tells."""
    text = (folder("variants") / "ranges" / f"{name}.toml").read_text(encoding="utf-8")
    found = TOLD.search(text)
    assert found, f"{name}: the file does not tell its shares"
    return float(found["feasible"]), float(found["banded"])


def measured(name, count, first=0):
    """Return the verdicts on `count` draws, and which of them lie in the band."""
    model = coursework.compile_model(name)
    lots = Lots(model.variant, load_ranges(name, model.variant), "0")
    acceptance = Acceptance(model, lots)
    draws = [lots.draw(STREAM, number) for number in range(first, first + count)]
    columns = {path[1]: [draw[path] for draw in draws] for path in draws[0] if path[0] != "time"}
    verdicts = judge(model, model.data(columns), lots.ranges.limits)
    difficulty = lots.ranges.difficulty
    ends = {key: (centre / (1 + difficulty.band) ** 0.5, centre * (1 + difficulty.band) ** 0.5)
            for key, centre in acceptance.centre.numbers.items()}  # fmt: skip
    banded = [
        not one.refused and all(ends[key][0] <= one.numbers[key] <= ends[key][1] for key in difficulty.numbers)
        for one in verdicts
    ]
    return verdicts, banded


def main():
    for name in names():
        verdicts, banded = measured(name, 1000)
        feasible = sum(not one.refused for one in verdicts) / 10
        print(f"{name}: # Of 1000 draws {feasible:g} % are feasible, {sum(banded) / 10:g} % lie in the band as well.")
        print("    ", dict(Counter(one.refused for one in verdicts)), flush=True)


if __name__ == "__main__":
    main()
