"""The registered tests of a study, for `analyse` and `power`. Needs python3-pandas and python3-statsmodels."""
import functools
import itertools
import math
import warnings

import numpy
import scipy.optimize
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


def above(values):
    """One-sided p of a mean of at most 0, by Student's t; of each column, if there are several."""
    return scipy.stats.ttest_1samp(values, 0, alternative="greater").pvalue


def equivalence(differences, margin):
    """p of a mean that is `margin` or more away from 0: the larger one of two one-sided tests."""
    return numpy.maximum(above(numpy.asarray(differences) + margin), above(margin - numpy.asarray(differences)))


def population(estimates, errors):
    """Mean of people and their standard deviation, each with its 95 % interval, of estimates whose standard errors are known.

    Q-profile: the scatter is where the weighted squares about their mean are as large as expected; its interval is where their logarithm is
    within 1.96 standard errors of that, which follow from the estimates' kurtosis (Bonett 2006): by chi-squared the interval is too wide for
    people of bounded weights, and too narrow for skewed ones. The mean's interval is Student's (Knapp, Hartung)."""
    estimates, squares, n = numpy.asarray(estimates), numpy.square(errors), len(estimates)

    def about_mean(scatter):
        weights = 1 / (squares + scatter**2)
        mean = numpy.sum(weights * estimates) / numpy.sum(weights)
        return mean, numpy.sum(weights * (estimates - mean) ** 2), numpy.sum(weights)

    largest = 100 * (numpy.ptp(estimates) + max(errors))

    def at(q):
        if about_mean(largest)[1] > q:
            return float("inf")
        return scipy.optimize.brentq(lambda s: about_mean(s)[1] - q, 0, largest) if about_mean(0)[1] > q else 0.0

    scatter = at(n - 1)
    mean, weighted, weight = about_mean(scatter)
    parts = (estimates - mean) / numpy.sqrt(squares + scatter**2)
    middle = scipy.stats.trim_mean(parts, min(0.5 / max(1, n - 4) ** 0.5, (n - 1) / (2 * n)))
    kurtosis = n * numpy.sum((parts - middle) ** 4) / numpy.sum((parts - numpy.mean(parts)) ** 2) ** 2
    small = n / (n - 1.96)
    error = small * numpy.sqrt(max(0.0, kurtosis - (n - 3) / n) / (n - 1))
    low, high = (at((n - 1) / small * numpy.exp(sign * 1.96 * error)) for sign in (1, -1))
    half = scipy.stats.t.ppf(0.975, n - 1) * numpy.sqrt(max(1.0, weighted / (n - 1)) / weight)
    return (mean, mean - half, mean + half), (scatter, low, high)


def mixed_model(trials, measure, reference):
    """Estimate, interval and p of each condition against the reference: random intercepts and slopes of people. No p (nan) if the
    fit does not converge."""
    data = trials.rename(columns={measure: "value"})
    formula = f"value ~ C(condition, Treatment({reference!r}))"
    with warnings.catch_warnings(record=True) as found:
        warnings.simplefilter("always")
        fit = statsmodels.formula.api.mixedlm(formula, data, groups="participant", re_formula="~condition").fit()
    sound = fit.converged and not any("not positive definite" in str(each.message) for each in found)
    # By Student's t of people less one: by the normal distribution a dozen people find too much.
    t = scipy.stats.t(data.participant.nunique() - 1)
    names = {name.split("[T.")[1][:-1]: name for name in fit.fe_params.index if "[T." in name}
    rows = {condition: (fit.params[name], fit.bse[name]) for condition, name in names.items()}
    return {condition: (value, value - t.ppf(0.975) * error, value + t.ppf(0.975) * error, 2 * t.sf(abs(value) / error) if sound else math.nan)
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
    return {"measure": "abs_miss_deg", "test": "sign_flip", "alpha": 0.05, "margin": 1.0, "reference": study["conditions"][-1]["name"],
            **study.get("analysis", {})}


def counted(trials):
    """The reaches that count."""
    return trials[(trials.kind == "reaches") & (trials.is_catch == 0) & (trials.end == "counted")]


def means_of(trials, measure):
    """A row of each participant, a column of each condition."""
    return trials.groupby(["participant", "condition"])[measure].mean().unstack()


def compare(trials, analysis, seed):
    """A row of each condition: (condition, estimate, low, high, p, Holm's p, p of a difference beyond the margin)."""
    measure, reference = analysis["measure"], analysis["reference"]
    conditions = sorted(set(trials.condition) - {reference})
    means = means_of(trials, measure)
    differences = {condition: (means[condition] - means[reference]).dropna() for condition in conditions}
    if analysis["test"] == "mixed_model":
        found = mixed_model(trials, measure, reference)
    else:
        found = {condition: (*interval(values), sign_flip(values, seed)) for condition, values in differences.items()}
    adjusted = holm({condition: found[condition][3] for condition in conditions})
    return [(condition, *found[condition], adjusted[condition], float(equivalence(differences[condition], analysis["margin"])))
            for condition in conditions]
