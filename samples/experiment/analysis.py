"""The registered tests of a study, for `analyse` and `power`. Needs python3-pandas and python3-statsmodels."""
import functools
import itertools

import numpy
import scipy.stats
import statsmodels.formula.api

EXACT_PEOPLE = 14  # of whom all signs are tried
FLIPS = 20_000


@functools.lru_cache(maxsize=4)
def signs_of(n, seed):
    """Rows of signs; the first has no other sign."""
    if n <= EXACT_PEOPLE:
        return numpy.array(list(itertools.product((1.0, -1.0), repeat=n)))
    signs = numpy.random.default_rng(seed).choice((1.0, -1.0), (FLIPS, n))
    signs[0] = 1
    return signs


def sign_flip(differences, seed):
    """Two-sided p of a mean of 0, if each difference might as well have the other sign; of each column, if there are several."""
    sums = numpy.abs(signs_of(len(differences), seed) @ numpy.asarray(differences))
    return numpy.mean(sums >= sums[0] * (1 - 1e-12), axis=0)


def interval(differences):
    """Mean and its 95 % interval by Student's t."""
    mean, n = numpy.mean(differences), len(differences)
    half = scipy.stats.t.ppf(0.975, n - 1) * numpy.std(differences, ddof=1) / numpy.sqrt(n) if n > 1 else float("inf")
    return mean, mean - half, mean + half


def mixed_model(trials, measure, reference):
    """Estimate, interval and p of each condition against the reference: random intercepts and slopes of people."""
    data = trials.rename(columns={measure: "value"})
    formula = f"value ~ C(condition, Treatment({reference!r}))"
    fit = statsmodels.formula.api.mixedlm(formula, data, groups="participant", re_formula="~condition").fit()
    # By Student's t of people less one: by the normal distribution a dozen people find too much.
    t = scipy.stats.t(data.participant.nunique() - 1)
    names = {name.split("[T.")[1][:-1]: name for name in fit.fe_params.index if "[T." in name}
    rows = {condition: (fit.params[name], fit.bse[name]) for condition, name in names.items()}
    return {condition: (value, value - t.ppf(0.975) * error, value + t.ppf(0.975) * error, 2 * t.sf(abs(value) / error))
            for condition, (value, error) in rows.items()}


def holm(values):
    """Holm's p of each."""
    order, largest, adjusted = sorted(values, key=values.get), 0.0, {}
    for rank, name in enumerate(order):
        largest = max(largest, min(1.0, (len(values) - rank) * values[name]))
        adjusted[name] = largest
    return adjusted


def registered(study):
    """What a design says of its analysis, with the defaults."""
    return {"measure": "abs_miss_deg", "test": "sign_flip", "alpha": 0.05, "reference": study["conditions"][-1]["name"],
            **study.get("analysis", {})}


def counted(trials):
    """The reaches that count."""
    return trials[(trials.kind == "reaches") & (trials.is_catch == 0) & (trials.end == "counted")]


def means_of(trials, measure):
    """A row of each participant, a column of each condition."""
    return trials.groupby(["participant", "condition"])[measure].mean().unstack()


def compare(trials, analysis, seed):
    """A row of each condition: (condition, estimate, low, high, p, Holm's p)."""
    measure, reference = analysis["measure"], analysis["reference"]
    conditions = sorted(set(trials.condition) - {reference})
    if analysis["test"] == "mixed_model":
        found = mixed_model(trials, measure, reference)
    else:
        means = means_of(trials, measure)
        found = {}
        for condition in conditions:
            differences = (means[condition] - means[reference]).dropna()
            found[condition] = (*interval(differences), sign_flip(differences, seed))
    adjusted = holm({condition: found[condition][3] for condition in conditions})
    return [(condition, *found[condition], adjusted[condition]) for condition in conditions]
