"""Checks the preregistered tests on small data whose results are derived by hand, on simulated studies with and without an effect (HRT_EXPERIMENT_STUDIES
sets their number), and on complete studies of simulated people, from the design to the report.

    analyse_test.py samples/experiment PROGRAM [statistics] [studies]    default: both
"""
import hashlib
import importlib.machinery
import importlib.util
import io
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

import numpy
import pandas
import scipy.stats

sys.dont_write_bytecode = True
sys.path.insert(0, sys.argv[1])
import analysis
loader = importlib.machinery.SourceFileLoader("power", sys.argv[1] + "/power")
power = importlib.util.module_from_spec(importlib.util.spec_from_loader("power", loader))
loader.exec_module(power)
STUDIES = int(os.environ.get("HRT_EXPERIMENT_STUDIES", "200"))
EFFECT = -2.0


def study(seed, effect, people, trials=10):
    """Returns trials of people with skewed misses, learning, fatigue and drift, under two conditions in alternating order."""
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
    # Only + + + and - - -, of the 8 choices of signs, have a mean as far from 0.
    assert analysis.sign_flip([1.0, 2.0, 3.0], 0) == 0.25
    assert analysis.sign_flip([1.0, -1.0], 0) == 1.0
    assert analysis.holm({"a": 0.01, "b": 0.04, "c": 0.03}) == {"a": 0.03, "c": 0.06, "b": 0.06}
    assert str(analysis.holm({"a": float("nan"), "b": 0.01, "c": 0.03})) == "{'b': 0.03, 'c': 0.06, 'a': nan}"  # nan still counts as a third test
    _, low, high = analysis.student([1, 2, 3])  # t with 2 degrees of freedom: 4.303; SD 1
    assert abs(high - 2 - 4.303 / 3**0.5) < 1e-3 and abs(high + low - 4) < 1e-9
    # One-sided: t = 3.464; t with 2 degrees of freedom at 5 %: 2.920. Of the 8 choices of signs, only + + + has a mean as high.
    p, low, high = analysis.student([1, 2, 3], direction="greater")
    assert abs(p - 0.0371) < 1e-3 and abs(low - 2 + 2.920 / 3**0.5) < 1e-3 and high == numpy.inf
    assert analysis.sign_flip([1.0, 2.0, 3.0], 0, direction="greater") == 0.125 and analysis.sign_flip([1.0, 2.0, 3.0], 0, direction="less") == 1
    # If three people of five have the same value, Student's t is not determined; if two of four do, it is.
    assert numpy.isnan(analysis.student([1, 1, 1, 0, 2])).all() and analysis.student([1, 1, 0, 2])[0] > 0


def tested(effect, people):
    """Returns the rows of the studies, and the percentage of rows whose interval contains the effect."""
    plan = {"measure": "abs_miss_deg", "reference": "none", "test": "t", "margin": 1, "alpha": 0.05}
    rows = pandas.concat([analysis.compare(study(seed, effect, people), plan, seed) for seed in range(STUDIES)])
    return rows, 100 * numpy.mean((rows.low <= effect) & (effect <= rows.high))


def test_level_and_coverage():
    (without, covered), (with_effect, recovered) = tested(0.0, 12), tested(EFFECT, 12)
    for test in ("t", "sign_flip"):  # with a single comparison, Holm's p is that of the test
        found, strength = (100 * numpy.mean(rows[test] < 0.05) for rows in (without, with_effect))
        print(f"{test}: {STUDIES} studies of 12 simulated people: significant without an effect in {found:.1f} %, with an effect of {EFFECT:g} in "
              f"{strength:.1f} %; intervals contain the effect in {recovered:.1f} %")
        slack = 3 * 100 * (0.05 * 0.95 / STUDIES) ** 0.5
        assert 5 - slack < found < 5 + slack and 95 - slack < recovered < 95 + slack and strength > 80, (found, recovered, strength)
    assert 95 - slack < covered < 95 + slack, covered


def test_outcomes():
    """By hand: percent within, variable error about the mean of each pair, d' and criterion by the log-linear rule. By scipy: below_margin."""
    rows = [(1, "a", "l", 0, 1.0, "yes"), (1, "a", "l", 0, 3.0, "no"), (1, "a", "r", 0, -1.0, "yes"), (1, "a", "r", 0, -1.0, "yes"),
            (1, "a", "l", 1, 0.0, "no"), (1, "a", "l", 1, 0.0, "no")]
    trials = pandas.DataFrame(rows, columns=["participant", "condition", "pair", "is_catch", "miss_deg", "answer"]).assign(kind="reaches", end="counted")
    trials["abs_miss_deg"] = abs(trials.miss_deg)
    plan = {"within_deg": 1.5, "noticed": "yes", "reference": "none", "test": "t", "alpha": 0.05, "margin": 1.0}
    z = scipy.stats.norm.ppf
    for measure, value in {"percent_within": 75.0, "variable_error_deg": 1.0, "abs_miss_deg": 1.5, "miss_deg": 0.5,
                           "d_prime": z(3.5 / 5) - z(0.5 / 3), "criterion": -(z(3.5 / 5) + z(0.5 / 3)) / 2}.items():
        assert abs(analysis.outcomes(trials, {**plan, "measure": measure}).a[1] - value) < 1e-12, measure
    values = {"a": [0.1, -0.2, 0.3, 0.2], "none": [4.0, 5.0, 6.0, 5.5]}
    people = pandas.DataFrame([(i, name, value) for name, column in values.items() for i, value in enumerate(column)],
                              columns=["participant", "condition", "miss_deg"])
    found = analysis.compare(people, {**plan, "measure": "miss_deg", "hypothesis": "below_margin"}, 1)
    one_sided = max(scipy.stats.ttest_1samp(values["a"], side * 1.0, alternative=way).pvalue for side, way in ((1, "less"), (-1, "greater")))
    assert abs(found.equivalence.a - one_sided) < 1e-12 and abs(found.holm.a - 2 * one_sided) < 1e-12 and found.holm.none > 0.9, found
    low, high = scipy.stats.ttest_1samp(values["a"], 0).confidence_interval(1 - 2 * 0.05 / 2)  # two conditions
    assert abs(found.low.a - low) < 1e-12 and abs(found.high.a - high) < 1e-12, found
    same = analysis.compare(people.assign(miss_deg=people.miss_deg * (people.condition == "a")), {**plan, "measure": "miss_deg", "hypothesis": "equivalence"}, 1)
    assert list(same.index) == ["a"] and same.holm.a < 0.05, same


def test_participants():
    """By hand: excluded participants. Welch's test of two levels agrees with scipy's."""
    study = {"conditions": [{"name": "a"}, {"name": "none"}], "question": "Bent?", "exclusions": {"max_missing_share": 0.25, "max_false_alarms": 0.5}}
    row = lambda person, is_catch, end, answer: {"participant": person, "kind": "reaches", "is_catch": is_catch, "end": end, "answer": answer}
    trials = pandas.DataFrame([row(1, 0, "counted", "no")] * 3 + [row(1, 0, "missing", None), row(1, 1, "counted", "no")]
                              + [row(2, 0, "open", None), row(2, 1, "counted", "no")] + [row(3, 1, "counted", "yes"), row(3, 0, "counted", "yes")])
    assert dict(analysis.excluded(study, trials)) == {2: "50%, above max_missing_share (25%)", 3: "100%, above max_false_alarms (50%)"}
    draw = numpy.random.default_rng(3)
    trials = pandas.DataFrame([(i, "lr"[i % 2], condition, draw.normal(i % 2, 1 + i % 2)) for i in range(12) for condition in ("a", "none")],
                              columns=["participant", "level", "condition", "miss_deg"])
    found = analysis.by_level(trials, {"measure": "miss_deg", "reference": "none"})
    wide = trials.pivot(index="participant", columns="condition", values="miss_deg")
    gap = wide.a - wide.none
    assert abs(found.p.a - scipy.stats.ttest_ind(gap[::2], gap[1::2], equal_var=False).pvalue) < 1e-9 and abs(found.l.a - gap[::2].mean()) < 1e-12, found


def test_threshold():
    """By hand: ends 4° and 8° from the virtual target, so the delivered bend is 6°; a threshold of 12° is twice that."""
    trials = pandas.DataFrame({"participant": 1, "condition": ["a", "a", "b"], "real_deg": 0, "virtual_deg": [6, -6, 6], "miss_deg": [2.0, 2.0, 9.0],
                               "kind": "reaches", "is_catch": 0, "end": "counted"})
    people = pandas.DataFrame({"participant": [1, 2], "threshold_deg": [12.0, 5.0]})
    ratios = analysis.threshold_ratios(trials, people, {"noticeability": {"condition": "a"}})
    assert dict(ratios) == {1: numpy.log(2)}, ratios


def test_psychometric():
    """The fit recovers a threshold of 8 and a slope of 2; answers that do not depend on the bend determine no threshold."""
    draw = numpy.random.default_rng(1)
    bends = draw.uniform(1, 20, 4000)
    answers = lambda right: pandas.DataFrame({"bend_deg": bends, "is_right": (draw.uniform(size=4000) < right).astype(float)})
    (threshold, slope), fit, _, _ = analysis.psychometric(answers(0.5 + 0.48 * (1 - numpy.exp(-((bends / 8) ** 2)))))
    assert abs(threshold - 8) < 0.5 and abs(slope - 2) < 0.3 and fit > 0.01, (threshold, slope, fit)
    assert analysis.psychometric(answers(0.5 + 0.4 * (numpy.abs(bends - 10) < 3)))[1] < 1e-6
    assert numpy.isnan(analysis.psychometric(answers(numpy.full(4000, 0.55)))[0]).all()  # no threshold within the delivered bends


def few_trials(every):
    """Returns trials of 8 people, 3 conditions with different scatter, 2 pairs, 3 repeats, without each `every`-th trial (0: all trials)."""
    draw = numpy.random.RandomState(5)
    own = draw.normal(0, [1.0, 0.8, 0.6], (8, 3)).cumsum(axis=1)
    rows = [(i, "cab"[c], "lr"[k % 2], 2 * c + own[i, c] + draw.normal(0, 0.4 + 0.4 * c) + 0.5 * (k % 2))
            for i in range(8) for c in range(3) for k in range(6)]
    trials = pandas.DataFrame(rows, columns=["participant", "condition", "pair", "abs_miss_deg"])
    return trials.drop(index=range(0, len(rows), every)) if every else trials


def test_mixed_model():
    """Compares with a fit of the same model by nlme 3.1: lme with pdBlocked(pdSymm, pdIdent ...) and varIdent by condition."""
    fit = analysis.mixed_models([few_trials(7)], "abs_miss_deg", "c")[0]
    nlme = {"a": (2.018984, 0.310147), "b": (4.097882, 0.397902)}
    for condition, (estimate, error) in nlme.items():
        assert abs(fit.estimate[condition] / estimate - 1) < 1e-3 and abs(fit.error[condition] / error - 1) < 1e-3, fit
    # Values of lme4 1.1-31 with lmerTest 3.1-3.
    assert numpy.allclose(fit.df, [6.9666, 6.9724], rtol=1e-2) and numpy.allclose(fit.p, [3.39e-4, 1.8e-5], rtol=2e-2), fit
    one_sided = analysis.mixed_models([few_trials(7)], "abs_miss_deg", "c", "greater")[0]  # both estimates are above 0
    assert numpy.allclose(2 * one_sided.p, fit.p), one_sided
    # With balanced data, the mixed model agrees with the paired t test of people's means.
    balanced = few_trials(0)
    fit, means = analysis.mixed_models([balanced], "abs_miss_deg", "c")[0], analysis.means_of(balanced, "abs_miss_deg")
    for condition in "ab":
        t = scipy.stats.ttest_rel(means[condition], means.c)
        assert abs(fit.p[condition] / t.pvalue - 1) < 0.02 and abs(fit.df[condition] - 7) < 0.02, (fit, t)
    # One trial per participant and condition cannot distinguish correlated slopes from residuals, so the model is reduced. Constants cannot be fitted.
    single = balanced.groupby(["participant", "condition"]).head(1)
    constant = balanced.assign(abs_miss_deg=1.0)
    reduced, none = analysis.mixed_models([single, constant], "abs_miss_deg", "c")
    assert set(reduced.model) <= {"intercept, condition and pair, uncorrelated", "intercept"} and reduced.p.notna().all(), reduced.model
    assert none.p.isna().all() and set(none.model) == {"none converged"}, none
    plan = {"measure": "abs_miss_deg", "reference": "c", "test": "mixed_model", "margin": 1, "alpha": 0.05}
    assert analysis.compare(constant, plan, 1).holm.isna().all()


def test_own_data():
    """Tests false positive rates and coverages of the tests and outcomes that can be preregistered, in studies drawn from simulated people."""
    reach = {"virtual_deg": 6, "real_deg": 0}
    design = {"title": "own data", "participants": 12, "question": "Bent?", "catch_share": 0.5, "practice_trials": 0, "repeats": 4, "set_up": "none",
              "pairs": [{"name": "left", **reach}, {"name": "right", **reach, "virtual_deg": -6}],
              "conditions": [{"name": name, "controller": name} for name in ("people", "paper", "none")]}
    trials, _ = power.simulated(sys.argv[2], design, 36, 1)
    plan = {"measure": "abs_miss_deg", "reference": "none"}
    fits = analysis.mixed_models(power.studies_of(trials, plan, "people", 0.0, 12, STUDIES, 1), "abs_miss_deg", "none")
    p = numpy.array([fit.p["people"] for fit in fits])
    found = {"mixed_model": 100 * numpy.mean(p < 0.05)}
    assert not numpy.isnan(p).any()
    for test in ("t", "sign_flip"):
        found[test] = power.share_found(trials, {**plan, "test": test, "alpha": 0.05}, "people", 0.0, 12, 10 * STUDIES, 1)
    print(f"own data, {STUDIES} studies (t and sign flip: ten times as many) of 12 of 36 simulated people, false positives: "
          + ", ".join(f"{test} {share:.1f} %" for test, share in found.items()))
    slack = 3 * 100 * (0.05 * 0.95 / STUDIES) ** 0.5
    assert all(5 - slack < share < 5 + slack for share in found.values()), found
    for measure in ("abs_miss_deg", "miss_deg", "miss_mm", "variable_error_deg", "d_prime", "criterion"):
        means = analysis.outcomes(trials, {**plan, "measure": measure, "noticed": "yes"})
        values, margin = (means.people - means.none).dropna(), (means.people - means.none).std()
        columns = power.drawn(values, 0.0, 12, 50 * STUDIES, 1)
        low, high = scipy.stats.ttest_1samp(columns, 0).confidence_interval(0.95)
        same = 100 * numpy.mean(analysis.equivalence(columns + margin, margin) < 0.05)
        level, covered = 100 * numpy.mean(scipy.stats.ttest_1samp(columns, 0).pvalue < 0.05), 100 * numpy.mean((low <= 0) & (0 <= high))
        print(f"own data, {50 * STUDIES} studies of 12: {measure}, false positives {level:.1f} %, of equivalence {same:.1f} %, coverage {covered:.1f} %")
        assert 4 < level < 6.5 and 92.5 < covered < 97 and same < 8.5, (measure, level, same, covered)
    for condition, within in (("people", 1.5), ("people", 5), ("paper", 1.5), ("paper", 3), ("paper", 5)):  # shares of 0 to 100 %
        shares = {**plan, "measure": "percent_within", "within_deg": within, "test": "sign_flip", "alpha": 0.05}
        found = power.share_found(trials, shares, condition, 0.0, 12, 10 * STUDIES, 1)
        columns = power.drawn(analysis.contrasts(analysis.outcomes(trials, shares), shares)[condition], 0.0, 12, 10 * STUDIES, 1)
        ends = numpy.array([analysis.student(column)[1:] for column in columns.T])
        ends = ends[~numpy.isnan(ends[:, 0])]
        covered = 100 * numpy.mean((ends[:, 0] <= 0) & (0 <= ends[:, 1]))
        print(f"own data, {10 * STUDIES} studies of 12: {condition}, percent within {within}°, false positives {found:.1f} %, "
              f"interval determined in {len(ends) / STUDIES * 10:.0f} %, coverage {covered:.1f} %")
        assert found < 6.5 and (len(ends) < STUDIES or covered > 93), (within, found, covered)


# Distributions with mean 0 and SD 1.
KINDS = {
    "uniform": lambda draw: draw.uniform(-(3**0.5), 3**0.5, 12),
    "normal": lambda draw: draw.normal(0, 1, 12),
    "of two groups": lambda draw: draw.choice((-0.8, 0.8), 12) + draw.normal(0, 0.6, 12),
    "skewed": lambda draw: (draw.lognormal(0, 0.3, 12) - 1.04603) / 0.32100,
}


def test_population():
    """Tactile weights with the errors of 16 to 40 slides: coverage of the mean, and the mean variance of people."""
    studies = 5 * STUDIES
    for kind, people in KINDS.items():
        covered = variances = 0
        for seed in range(studies):
            draw = numpy.random.default_rng(seed)
            errors = draw.uniform(0.005, 0.02, 12)
            _, low, high, sd = analysis.population(draw.normal(0.2 + 0.03 * people(draw), errors), errors)
            covered += low <= 0.2 <= high
            variances += sd**2
        mean, scatter = 100 * covered / studies, (variances / studies) ** 0.5
        print(f"tactile weight, {kind}: {studies} studies of 12: intervals contain the mean in {mean:.1f} %; SD of people {scatter:.4f}, true 0.03")
        assert 93 < mean < 97 and abs(scatter / 0.03 - 1) < 0.05, (kind, mean, scatter)


def test_whole_studies():
    """Studies of twelve simulated people with set-up, reaches and export: coverage of the effect and of the mean tactile weight.

    HRT_EXPERIMENT_SET_UPS: number of studies for each distribution of weights [1]. Their mean effect is taken as the true one."""
    studies = int(os.environ.get("HRT_EXPERIMENT_SET_UPS", "1"))
    reach = {"virtual_deg": 6, "real_deg": 0}
    study = {"title": "recovery", "participants": 12, "practice_trials": 0, "repeats": 2, "pairs": [{"name": "left", **reach}],
             "conditions": [{"name": name, "controller": name} for name in ("people", "none")]}
    for kind in ("uniform", "normal", "skewed"):
        effects, found = [], []
        for seed in range(1, studies + 1):
            trials, people = power.simulated(sys.argv[2], {**study, "simulated": {"weights": kind}}, 12, seed)
            means = analysis.means_of(analysis.counted(trials), "abs_miss_deg")
            effects.append(means.people - means.none)
            errors = (people.tactile_weight_high - people.tactile_weight_low) / (2 * 1.96)
            found.append((analysis.student(effects[-1]), analysis.population(people.tactile_weight, errors)[:3]))
        true = (numpy.mean(numpy.concatenate(effects)), 0.21)
        hits = [sum(low <= value <= high for (_, low, high) in each) for value, each in zip(true, zip(*found))]
        print(f"{studies} simulated studies of 12 {kind} people: intervals contain the effect, {true[0]:.2f}°, in {100 * hits[0] / studies:.1f} %, "
              f"the mean tactile weight in {100 * hits[1] / studies:.1f} %")
        slack = 2 * (0.05 * 0.95 * studies) ** 0.5
        assert all(0.93 * studies - slack <= hit <= 0.97 * studies + slack for hit in hits), (kind, hits)


def paired(people, sd):
    """Returns trials of people whose differences are equally spaced quantiles of a normal distribution."""
    differences = sd * scipy.stats.norm.ppf((numpy.arange(people) + 0.5) / people)
    return pandas.DataFrame([(i, condition, value) for i, d in enumerate(differences) for condition, value in (("a", d), ("none", 0.0))],
                            columns=["participant", "condition", "abs_miss_deg"])


def test_power():
    plan = {"measure": "abs_miss_deg", "reference": "none", "test": "sign_flip", "alpha": 0.05, "margin": 1}
    found = lambda effect, people, test="sign_flip", way="two-sided": power.share_found(
        paired(2000, 2.0), {**plan, "test": test, "direction": way}, "a", effect, people, 2000, 1)
    assert found(-9, 5) == 0  # 2 of 32 choices of signs have a mean as far from 0, so p is at least 0.0625
    # Compares with the noncentral t distribution, for normal differences with an SD of 2.
    for effect, people in ((0, 12), (-1, 12), (-1, 32), (-2, 12)):
        t, shift = scipy.stats.t.ppf(0.975, people - 1), effect / 2 * people**0.5
        exact = 100 * (scipy.stats.nct.cdf(-t, people - 1, shift) + (scipy.stats.nct.sf(t, people - 1, shift) if shift else 0.025))
        for test in ("t", "sign_flip"):
            assert abs(found(effect, people, test) - exact) < 3, (effect, people, test, found(effect, people, test), exact)
            one_sided = 100 * scipy.stats.nct.cdf(scipy.stats.t.ppf(0.05, people - 1), people - 1, shift) if shift else 5
            assert abs(found(effect, people, test, "less") - one_sided) < 3, (effect, people, test, one_sided)
    # Percentages keep their bounds for any mean.
    shares = power.drawn([100.0] * 9 + [50.0], 19.0, 12, 4000, 1, is_share=True)
    assert abs(shares.mean() - 19) < 1.5 and set(abs(shares.ravel())) == {50, 100}, shares.mean()
    # Two one-sided t tests: compares the power at and within the margin with the noncentral t distribution.
    values = paired(2000, 1.0).query("condition == 'a'").abs_miss_deg
    share = lambda mean, people: 100 * numpy.mean(analysis.equivalence(power.drawn(values, mean, people, 4000, 1), 1.0) < 0.05)
    for mean, people in ((1, 12), (-1, 40), (0, 12), (0.5, 40)):
        t, shift = scipy.stats.t.ppf(0.95, people - 1), people**0.5
        exact = 100 * (1 - scipy.stats.nct.cdf(t, people - 1, (1 - mean) * shift) - scipy.stats.nct.cdf(t, people - 1, (1 + mean) * shift))
        assert abs(share(mean, people) - exact) < 1.5, (mean, people, share(mean, people), exact)
    assert analysis.equivalence([1.0, 2.0, 3.0], 1.0) > 0.5 and abs(analysis.above([1.0, 2.0, 3.0]) - 0.0371) < 1e-3  # t = 3.464


def power_of_a_design(design):
    printed = subprocess.run([sys.argv[1] + "/power", design, "--program", sys.argv[2], "--pool", "6", "--people", "6,12", "--studies", "200",
                              "--effect", "0,4"], check=True, capture_output=True, text=True).stdout
    assert printed.startswith("SIMULATION: no person took part. 6 simulated people; t of abs_miss_deg, 2 tests at alpha 0.05 / 2"), printed
    assert printed.count(" minus none: mean ") == 2 and len(printed.splitlines()) == 1 + 2 * (5 + 6) + 8 + 2, printed
    assert printed.endswith(hashlib.sha256(design.read_bytes()).hexdigest() + "\n"), printed
    rows = [line.split() for line in printed.splitlines()]
    levels = [float(share) for row in rows if row and row[0] == "1" and row[-1] == "%" for share in row[3:-1]]
    # The rows of margin 1 and ratio 1 have false positive rates, nominally 2.5 and 5 %. Three SDs over 200 studies are at most 4.6 %; skewed data add to this.
    assert len(levels) == 2 * 3 and max(levels) < 5 + 6, printed


def test_report():
    with tempfile.TemporaryDirectory() as folder:
        study = json.loads(pathlib.Path(sys.argv[1], "example.json").read_text())
        study.update(participants=6, repeats=1, set_up="none", noticeability={"trials": 5, "condition": "people"})
        study["analysis"]["test"] = "t"
        data, design = pathlib.Path(folder, "data"), pathlib.Path(folder, "study.json")
        design.write_text(json.dumps(study))
        run = lambda *words: subprocess.run(words, check=True, capture_output=True, text=True).stdout
        assert not any(name in run(sys.argv[2], "design", design) for name in ("people\n", "paper", "none"))
        power_of_a_design(design)
        run(sys.argv[2], "simulate", design, "--data", data)
        for unblinded in (False, True):
            run(sys.argv[2], "export", "--data", data, *(["--unblind"] if unblinded else []))
            run(sys.argv[1] + "/analyse", data)
            test_bids(data, {"practice"} | ({"people", "paper", "none"} if unblinded else {"A", "B", "C", "noticeability"}))
            report = (data / "export/report.html").read_text()
            assert "Simulation: no person took part." in report
            assert ("Conditions are blinded" in report) != unblinded
            assert ("<td>paper</td>" in report) == unblinded and ("Preregistered test: t test" in report) == unblinded
            assert "% of catch trials" in report, report
            assert (hashlib.sha256((data / "export/trials.csv").read_bytes()).hexdigest()) in report


def test_a_whole_study():
    """A study with three conditions, two levels and eight participants, from the design to the report, in a locale without UTF-8. Names are not
    ASCII or look like numbers or missing values; the design has a byte order mark and CRLF. Results agree with scipy and lme4 on the exported table."""
    names = ["NA", "papier 論文 😀", "0"]
    study = {"title": "Führung \u2028 <b>", "participants": 8, "practice_trials": 2, "repeats": 4, "max_run": 9, "set_up": "none", "order": "random_in_blocks", "rounds": 2,
             "conditions": [{"name": name, "controller": kind} for name, kind in zip(names, ("people", "paper", "none"))],
             "pairs": [{"name": "links", "virtual_deg": 6, "real_deg": 0}], "between": {"factor": "Hand", "levels": ["rechts", "links"]},
             "catch_share": 0.2, "question": "Wurde etwas umgelenkt?", "answers": ["N/A", "nein"], "noticeability": {"trials": 10, "condition": names[1], "control": names[0], "runs": 2},
             "questionnaires": [{"name": "Person", "when": "before", "answers": "text", "items": ["Alter", "Händigkeit"]},
                                {"name": "Anstrengung", "when": "block", "high": 20, "items": ["Mühe"]}],
             "exclusions": {"max_false_alarms": 0.9}, "analysis": {"measure": "abs_miss_deg", "reference": names[2]}}
    with tempfile.TemporaryDirectory() as folder:
        data, design = pathlib.Path(folder, "dätä"), pathlib.Path(folder, "study.json")
        design.write_bytes(b"\xef\xbb\xbf" + json.dumps(study, ensure_ascii=False, indent=1).replace("\n", "\r\n").encode())
        run = lambda *words: subprocess.run(words, check=True, capture_output=True, text=True, encoding="utf-8",
                                            env={**os.environ, "LC_ALL": "C", "PYTHONUTF8": "0"}).stdout
        assert "abs_miss_deg` of each condition differs from that of 0, in either direction." in run(sys.argv[2], "preregister", design)
        for words in ([sys.argv[2], "simulate", design, "--data", data], [sys.argv[2], "simulate", design, "--data", f"{folder}/one", "--threads", "1"],
                      ["diff", "-r", data, f"{folder}/one"],  # the same bytes for any number of processes
                      [sys.argv[2], "export", "--data", data, "--unblind"], [sys.argv[1] + "/analyse", data], [sys.argv[1] + "/bids", data]):
            run(*words)
        report = (data / "export/report.html").read_text(encoding="utf-8")
        assert all(f"<th>{name}</th>" in report for name in names) and "Führung \u2028 &lt;b&gt;" in report
        events = (data / "export/bids/sub-01/ses-01/motion/sub-01_ses-01_task-reach_events.tsv").read_text(encoding="utf-8")
        assert all(f"\t{name}\t" in events for name in names), events
        answers = pandas.read_csv(data / "export/questionnaires.csv")
        assert len(answers) == 8 * (2 + 2) and set(answers.when) == {"before", "block 1", "block 2"} and "By Hand" in report, answers
        # The reach without a gap runs under the controller `people`, which rotates the plate at least as much as `paper`.
        still, bent = (float(re.search(f"{name} a gap (\\d+)°", report)[1]) for name in ("without", "with"))
        assert still >= bent > 20 and f"bend in condition {names[1]}: " in report, (still, bent)
        every = analysis.read_table(data / "export/trials.csv")
        assert set(every.answer[every.kind == "reaches"].dropna()) <= {"N/A", "nein"}
        trials = every[(every.kind == "reaches") & (every.is_catch == 0) & (every.end == "counted")]
        plan = analysis.registered(study)
        found = analysis.compare(every, plan, 1)
        mixed = analysis.compare(every, {**plan, "test": "mixed_model"}, 1)
        means = trials.groupby(["condition", "participant"]).abs_miss_deg.mean()
        script = ("suppressMessages(library(lmerTest)); d <- read.csv(file('stdin')); d$condition <- factor(d$condition);"
                  "m <- lmer(value ~ condition + (condition | participant), d, weights = weight);"
                  "write.csv(coef(summary(m))[2:3, c(1, 2, 5)])")
        spread = 1 / trials.abs_miss_deg.groupby([trials.condition, trials.participant]).var().groupby("condition").mean()
        table = pandas.DataFrame({"condition": trials.condition.map([names[2], *names[:2]].index), "participant": trials.participant, "value": trials.abs_miss_deg,
                                  "weight": trials.condition.map(spread)})
        fitted = subprocess.run(["Rscript", "-e", script], input=table.to_csv(index=False), capture_output=True, text=True, check=True).stdout
        fitted = pandas.read_csv(io.StringIO(fitted), index_col=0).values
        for i, name in enumerate(names[:2]):
            p = scipy.stats.ttest_rel(means[name], means[names[2]]).pvalue
            assert abs(found.t[name] / p - 1) < 1e-3 and f"<td>{found.estimate[name]:.3g}</td>" in report, (found, p)
            assert abs(mixed.estimate[name] / fitted[i][0] - 1) < 1e-3 and abs(mixed.mixed_model[name] - fitted[i][2]) < max(2e-2 * fitted[i][2], 1e-4), (mixed, fitted)
        if os.environ.get("HRT_EXPERIMENT_REPORT"):  # for inspection
            shutil.copy(data / "export/report.html", os.environ["HRT_EXPERIMENT_REPORT"])
        # A session without a processed sample has no motion; a last line that is cut within a character is skipped.
        with open(data / "sub-01/ses-01/journal.jsonl", "ab") as journal:
            journal.write("é".encode()[:1])
        for file in (data / "sub-01/ses-01/recordings").glob("*.csv"):
            lines = file.read_text(encoding="utf-8").splitlines(True)
            file.write_text("".join(line for line in lines if not line.startswith("update,")), encoding="utf-8")
        shutil.rmtree(data / "export/bids")
        run(sys.argv[1] + "/bids", data)
        assert {each.name for each in (data / "export/bids").glob("sub-*")} == {f"sub-{i:02}" for i in range(2, 9)}
        (data / "export/people.csv").write_text("nothing\n")
        broken = subprocess.run([sys.argv[1] + "/analyse", data], capture_output=True, text=True, check=False)
        assert broken.returncode == 1 and broken.stderr.startswith("analyse: ") and broken.stderr.count("\n") == 1, broken.stderr


def bids_validator():
    """Returns the script of npm's bids-validator, which is downloaded once; None without npm or its registry."""
    cache = pathlib.Path.home() / ".cache/haptic_retargeting/bids-validator"
    program = cache / "package/bin/bids-validator"
    if not program.exists() and shutil.which("npm"):
        cache.mkdir(parents=True, exist_ok=True)
        subprocess.run("npm pack --silent bids-validator@1.15.0 >&2 && tar xf bids-validator-1.15.0.tgz", shell=True, cwd=cache, check=False)
    return program if program.exists() else None


def test_bids(data, conditions):
    """Checks rules of BIDS 1.9 for motion, and runs bids-validator if npm can install it."""
    subprocess.run([sys.argv[1] + "/bids", data], check=True, capture_output=True)
    bids, trials = data / "export/bids", pandas.read_csv(data / "export/trials.csv")
    table = lambda name, header=0: pandas.read_csv(f"{bids}/sub-02/ses-01/motion/sub-02_ses-01_task-reach_{name}.tsv", sep="\t", header=header)
    events, channels, motion = table("events"), table("tracksys-plate_channels"), table("tracksys-plate_motion", None)
    assert list(channels.columns[:5]) == ["name", "component", "type", "tracked_point", "units"] and len(channels) == len(motion.columns)
    time = motion[list(channels.type).index("LATENCY")]
    assert time[0] == 0 and (time.diff()[1:] > 0).all() and list(events.columns[:3]) == ["onset", "duration", "trial_type"]
    # Every sample belongs to one reach, and every trial has a reach.
    assert (sum(time.between(row.onset - 1e-6, row.onset + row.duration + 1e-6).astype(int) for row in events.itertuples()) == 1).all()
    assert len(events.dropna(subset="block").groupby(["block", "trial"])) == sum(trials.participant == 2)
    assert set(events.trial_type[events.block.notna()]) == conditions, events.trial_type
    assert {"opened", "rest", "end"} <= set(events.trial_type[events.block.isna()]), events.trial_type
    answers = pandas.read_csv(bids / "phenotype/questionnaire1.tsv", sep="\t")
    assert {"participant_id", "session_id", "before_item_1", "after_item_6"} <= set(answers) and len(answers) == len(set(trials.participant)), answers
    scans = pandas.read_csv(bids / "sub-02/ses-01/sub-02_ses-01_scans.tsv", sep="\t")
    assert (bids / "sub-02/ses-01" / scans.filename[0]).exists(), scans
    about = json.loads((bids / "sub-02/ses-01/motion/sub-02_ses-01_task-reach_tracksys-plate_motion.json").read_text(encoding="utf-8"))
    assert about["SoftwareVersions"].startswith("haptic_retargeting 0."), about
    if validator := bids_validator():
        found = json.loads(subprocess.run(["node", validator, "--json", bids], capture_output=True, check=False).stdout)
        assert not found["issues"]["errors"], found["issues"]["errors"]
    print("BIDS checked by bids-validator" if validator else "BIDS checked without bids-validator, which npm could not install")


TESTS = {"statistics": (test_by_hand, test_participants, test_threshold, test_psychometric, test_outcomes, test_level_and_coverage, test_mixed_model,
                        test_own_data, test_population),
         "studies": (test_whole_studies, test_power, test_a_whole_study, test_report)}
for group in sys.argv[3:] or TESTS:
    for test in TESTS[group]:
        test()
