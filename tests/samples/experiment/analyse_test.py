"""The registered tests on simulated studies: by hand, without an effect, with one. HRT_EXPERIMENT_STUDIES has more of them.
Then a study of two simulated people, from its design to the report.

    analyse_test.py samples/experiment PROGRAM
"""
import importlib.machinery
import importlib.util
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import warnings

import numpy
import pandas

loader = importlib.machinery.SourceFileLoader("analyse", sys.argv[1] + "/analyse")
analyse = importlib.util.module_from_spec(importlib.util.spec_from_loader("analyse", loader))
sys.dont_write_bytecode = True
loader.exec_module(analyse)
warnings.simplefilter("ignore")
STUDIES = int(os.environ.get("HRT_EXPERIMENT_STUDIES", "200"))
EFFECT = -2.0


def study(seed, effect, people, trials=10):
    """Skewed people who learn, tire and drift; two conditions in alternating order."""
    draw = numpy.random.default_rng(seed)
    rows = []
    for person in range(people):
        level, own = draw.lognormal(1, 0.6), draw.normal(0, 1)
        for place, condition in enumerate(("a", "none") if person % 2 else ("none", "a")):
            index = numpy.arange(trials) + place * trials
            course = 1.5 * numpy.exp(-index / 5) + 0.03 * index + numpy.cumsum(draw.normal(0, 0.05, trials))
            values = level + course + draw.lognormal(0, 0.7, trials) + (effect + own) * (condition == "a")
            rows += [(person, condition, value) for value in values]
    return pandas.DataFrame(rows, columns=["participant", "condition", "abs_miss_deg"])


def test_by_hand():
    # Of 8 choices of signs only + + + and - - - are as far from 0.
    assert analyse.sign_flip([1, 2, 3], 0) == 0.25
    assert analyse.sign_flip([1, -1], 0) == 1.0
    assert analyse.holm({"a": 0.01, "b": 0.04, "c": 0.03}) == {"a": 0.03, "c": 0.06, "b": 0.06}
    mean, low, high = analyse.interval([1, 2, 3])  # t of 2 degrees of freedom: 4.303; deviation 1
    assert abs(mean - 2) < 1e-12 and abs(high - 2 - 4.303 / 3**0.5) < 1e-3 and abs(high + low - 4) < 1e-9


def share(test, studies, effect, people):
    """Percent of studies in which the test finds something, and in which its interval has the effect."""
    analysis = {"measure": "abs_miss_deg", "reference": "none", "test": test}
    rows = [analyse.compare(study(seed, effect, people), analysis, seed)[0] for seed in range(studies)]
    found = 100 * numpy.mean([row[4] < 0.05 for row in rows])
    return found, 100 * numpy.mean([row[2] <= effect <= row[3] for row in rows])


def test_level_and_coverage():
    for test, studies in (("sign_flip", STUDIES), ("mixed_model", max(20, STUDIES // 10))):
        found, covered = share(test, studies, 0.0, 12)
        power, recovered = share(test, studies, EFFECT, 12)
        print(f"{test}: {studies} studies of 12 simulated people: found without an effect {found:.1f} %, with one of {EFFECT:g} "
              f"{power:.1f} %; intervals with the effect {recovered:.1f} %")
        slack = 3 * 100 * (0.05 * 0.95 / studies) ** 0.5
        assert found < 5 + slack + (4 if test == "mixed_model" else 0), found
        assert test == "mixed_model" or found > 5 - slack, found
        assert recovered > 95 - slack - (6 if test == "mixed_model" else 0), recovered
        assert power > 80, power


def test_report():
    with tempfile.TemporaryDirectory() as folder:
        study = json.loads(pathlib.Path(sys.argv[1], "example.json").read_text())
        study.update(participants=6, repeats=1, set_up="none", noticeability={"trials": 5, "condition": "people"})
        data, design = pathlib.Path(folder, "data"), pathlib.Path(folder, "study.json")
        design.write_text(json.dumps(study))
        run = lambda *words: subprocess.run(words, check=True, capture_output=True, text=True).stdout
        assert not any(name in run(sys.argv[2], "design", design) for name in ("people\n", "paper", "none"))
        run(sys.argv[2], "simulate", design, "--data", data)
        for unblinded in (False, True):
            run(sys.argv[2], "export", "--data", data, *(["--unblind"] if unblinded else []))
            run(sys.argv[1] + "/analyse", data)
            report = (data / "export/report.html").read_text()
            assert "Simulation: no person took part." in report
            assert ("Conditions are blinded" in report) != unblinded
            assert ("<td>paper</td>" in report) == unblinded
            assert (analyse.hashlib.sha256((data / "export/trials.csv").read_bytes()).hexdigest()) in report


test_by_hand()
test_level_and_coverage()
test_report()
