"""Readers of a study's files, and its preregistered tests. Needs python3-statsmodels and, for mixed models, r-cran-lmertest."""
import io
import json
import math
import pathlib
import subprocess
import sys

import numpy
import pandas
import scipy.optimize
import scipy.stats
from statsmodels.stats.meta_analysis import combine_effects
from statsmodels.stats.oneway import anova_oneway

FLIPS = 20_000  # maximum number of sign assignments in a sign flip test: all of them for up to 14 participants
LAPSES = 0.02  # lapse rate of the psychometric function


# Columns that are read as text, even if the text looks like a number.
NAMES = ["subject", "level", "kind", "condition", "pair", "end", "reason", "library", "questionnaire", "when", "text", "event", "details"]


def read_study(file):
    return json.loads(file.read_text(encoding="utf-8-sig"))


def read_table(file):
    """Reads a table of hrt-experiment export. In the columns of NAMES, "NA", "null", "0" and "True" are text. Empty fields are nan."""
    names = NAMES + (["answer"] if file.name in ("trials.csv", "questionnaires.csv") else [])
    return pandas.read_csv(file, encoding="utf-8", dtype={name: str for name in names}, keep_default_na=False, na_values=[""])


def run_main(main):
    """Runs `main`; an error of the input ends the program with one line, without a traceback."""
    try:
        main()
    except (OSError, ValueError) as error:
        sys.exit(f"{pathlib.Path(sys.argv[0]).name}: {str(error).splitlines()[0]}")
    except (KeyError, AttributeError) as error:
        column = error.args[0] if isinstance(error, KeyError) else error.name
        sys.exit(f"{pathlib.Path(sys.argv[0]).name}: the tables lack '{column}'; export the data with this version of hrt-experiment")


def sign_flip(differences, seed, flips=FLIPS, direction="two-sided"):
    """Returns p of the sign flip test that the mean of the differences is 0, for each column."""
    mean = lambda values, axis: numpy.mean(values, axis=axis)
    return scipy.stats.permutation_test((numpy.asarray(differences, float),), mean, permutation_type="samples", vectorized=True, batch=50,
                                        n_resamples=flips, axis=0, random_state=seed, alternative=direction).pvalue


def student(values, level=0.95, direction="two-sided"):
    """Returns p of Student's t test that the mean is 0, and the ends of the confidence interval of the mean; one end is infinite if there is a
    direction. p is nan for fewer than two values, and if more than half of them are equal, such as 0 or 100 %, which makes the test invalid."""
    if len(values) < 2:
        return math.nan, -math.inf, math.inf
    if pandas.Series(values).round(9).value_counts().iloc[0] > max(1, len(values) / 2):
        return math.nan, math.nan, math.nan
    found = scipy.stats.ttest_1samp(values, 0, alternative=direction)
    return found.pvalue, *found.confidence_interval(level)


def above(values):
    """Returns p of the one-sided t test that the mean is at most 0, for each column."""
    return scipy.stats.ttest_1samp(values, 0, alternative="greater").pvalue


def equivalence(differences, margin):
    """Returns p of the test that the absolute value of the mean is at least `margin`: the larger p of two one-sided tests."""
    return numpy.maximum(above(numpy.asarray(differences) + margin), above(margin - numpy.asarray(differences)))


def population(estimates, errors):
    """Returns the mean over people, the ends of its 95 % interval, and the SD of people, from estimates with known standard errors (Paule and
    Mandel 1982)."""
    found = combine_effects(numpy.asarray(estimates), numpy.square(errors), method_re="iterated", use_t=True)
    return found.mean_effect_re, *found.conf_int()[1], found.tau2**0.5


def mixed_models(studies, measure, reference, direction="two-sided"):
    """Fits a mixed model by lmerTest to the trials of each study. Returns a table for each, by condition: estimate, error, df, p (nan: no model
    converged) and the fitted model."""
    conditions = sorted({name for trials in studies for name in trials.condition} - {reference})
    codes = {reference: 0, **{name: i + 1 for i, name in enumerate(conditions)}}
    pairs = {name: i for i, name in enumerate(sorted({name for trials in studies for name in trials.pair}))}
    data = pandas.concat([pandas.DataFrame({"study": i, "participant": trials.participant, "condition": trials.condition.map(codes), "pair": trials.pair.map(pairs),
                                            "value": trials[measure]}) for i, trials in enumerate(studies)])
    try:
        done = subprocess.run(["Rscript", pathlib.Path(__file__).with_name("mixed_model.R")], input=data.dropna().to_csv(index=False), text=True,
                              encoding="utf-8", capture_output=True)
    except FileNotFoundError:
        sys.exit("a mixed model needs R: install r-cran-lmertest (cmake/install_packages experiment does)")
    if done.returncode != 0:
        sys.exit(f"R failed on the mixed model: {(done.stderr.strip() or 'no message').splitlines()[-1]}; check that r-cran-lmertest is installed (cmake/install_packages experiment does)")
    rows = pandas.read_csv(io.StringIO(done.stdout))
    rows.condition = rows.condition.map({code: name for name, code in codes.items()})
    if direction != "two-sided":
        rows.p = scipy.stats.t.cdf(rows.estimate / rows.error * (1 if direction == "less" else -1), rows.df)
    return [rows[rows.study == i].set_index("condition") for i in range(len(studies))]


def holm(values):
    """Corrects p values by Holm's method. A p value that is not determined (nan) stays nan, and still counts among the tests."""
    order, largest, adjusted = sorted(values, key=lambda name: (math.isnan(values[name]), values[name])), 0.0, {}
    for rank, name in enumerate(order):
        largest = max(largest, min(1.0, (len(values) - rank) * values[name])) if not math.isnan(values[name]) else math.nan
        adjusted[name] = largest
    return adjusted


def registered(study):
    """Returns the preregistered analysis of a design, with defaults."""
    return {"measure": "abs_miss_deg", "test": "t", "hypothesis": "difference", "direction": "two-sided", "alpha": 0.05, "margin": 1.0, "within_deg": 1.5,
            "reference": study["conditions"][-1]["name"], "noticed": study.get("answers", ["yes"])[0], **study.get("analysis", {})}


def counted(trials):
    """Returns the valid trials of the blocks of reaches, without catch trials."""
    return trials[(trials.kind == "reaches") & (trials.is_catch == 0) & (trials.end == "counted")]


def means_of(trials, measure):
    """Returns the mean of `measure` for each participant (row) and condition (column)."""
    return trials.groupby(["participant", "condition"])[measure].mean().unstack()


def noticed_share(trials, noticed):
    """Returns the fraction of answers `noticed` in reaches (first index 0) and in catch trials (1), for each participant and condition. By the
    log-linear rule (Hautus 1995), half an answer is added to both alternatives, so that no fraction is 0 or 1."""
    answered = trials[(trials.kind == "reaches") & (trials.end == "counted") & trials.answer.notna()]
    groups = (answered.answer == noticed).groupby([answered.is_catch, answered.participant, answered.condition])
    return (groups.sum() + 0.5) / (groups.size() + 1)


def outcomes(trials, plan):
    """Returns the preregistered outcome of each participant (row) and condition (column). `trials`: all exported trials, or the valid ones only."""
    reaches, measure = counted(trials) if "kind" in trials else trials, plan["measure"]
    groups = reaches.groupby(["participant", "condition"])
    if measure == "percent_within":
        return means_of(reaches.assign(within=100.0 * (reaches.abs_miss_deg <= plan["within_deg"])), "within")
    if measure == "variable_error_deg":
        about = reaches.miss_deg - reaches.groupby(["participant", "condition", "pair"]).miss_deg.transform("mean")
        freedom = groups.size() - groups.pair.nunique()
        return numpy.sqrt((about**2).groupby([reaches.participant, reaches.condition]).sum() / freedom.where(freedom > 0)).unstack()
    if measure in ("d_prime", "criterion"):
        z = pandas.Series(scipy.stats.norm.ppf(share := noticed_share(trials, plan["noticed"])), share.index)
        return ((z[0] - z[1]) if measure == "d_prime" else -(z[0] + z[1]) / 2).unstack()
    return means_of(reaches, measure)


def registered_p(plan):
    """Returns the name of the column of compare() that has p of the preregistered test."""
    return plan["test"] if plan.get("hypothesis", "difference") == "difference" else "equivalence"


def contrasts(means, plan):
    """Returns the tested value of each condition, by participant: the difference from the reference, or the outcome itself for below_margin."""
    if plan.get("hypothesis") == "below_margin":
        return {condition: means[condition].dropna() for condition in means}
    return {condition: (means[condition] - means[plan["reference"]]).dropna() for condition in means.columns.drop(plan["reference"])}


def by_level(trials, plan):
    """Returns the mean at each level of the between-participants factor, and p of equal means (Welch's test), without and with Holm's correction, for
    each contrast and for the mean of all conditions."""
    means, levels = outcomes(trials, plan), trials.groupby("participant")["level"].first()
    rows = {}
    for name, values in {"mean of all": means.mean(axis=1, skipna=False).dropna(), **contrasts(means, plan)}.items():
        of = levels[values.index]
        enough = of.nunique() > 1 and of.value_counts().min() > 1
        rows[name] = {**values.groupby(of).mean(), "p": anova_oneway(values, of, use_var="unequal").pvalue if enough else math.nan}
    rows = pandas.DataFrame(rows).T
    return rows.assign(holm=pandas.Series(holm(rows.p.to_dict()), dtype=float))


def excluded(study, trials):
    """Returns the participants whom the rules of the design exclude, with the reason."""
    rules = {"max_missing_share": 0.2, "max_false_alarms": 1.0, **study.get("exclusions", {})}
    reaches = trials[trials.kind == "reaches"]
    asked = reaches[(reaches.is_catch == 1) & reaches.answer.notna()]
    shares = {"max_missing_share": (reaches.end != "counted").groupby(reaches.participant).mean(),
              "max_false_alarms": (asked.answer == registered(study)["noticed"]).groupby(asked.participant).mean()}
    return pandas.concat([of[of > rules[rule]].map(lambda share, rule=rule: f"{share:.0%}, above {rule} ({rules[rule]:.0%})") for rule, of in shares.items()]
                         ).groupby(level=0).agg("; ".join)


def psychometric(trials):
    """Fits the probability of a correct answer, a Weibull function of the delivered bend, to the answers of all participants, by maximum likelihood.
    Returns threshold (scale) and slope, p of Pearson's chi-squared test of the fit, the at most six bins of the bend on which the test is based, and the
    fitted function. Threshold and slope are nan if one is at its limit: the least or largest bend, or a slope of 0.5 or 10."""
    asked = trials[trials.is_right.notna() & (trials.bend_deg > 0)]
    share = lambda x, bend: 0.5 + (0.5 - LAPSES) * (1 - numpy.exp(-((bend / numpy.exp(x[0])) ** numpy.exp(x[1]))))
    loss = lambda x: -scipy.stats.bernoulli.logpmf(asked.is_right, share(x, asked.bend_deg)).sum()
    bounds = ((math.log(asked.bend_deg.min()), math.log(asked.bend_deg.max())), (math.log(0.5), math.log(10)))
    x = scipy.optimize.minimize(loss, (math.log(asked.bend_deg.median()), math.log(2)), method="L-BFGS-B", bounds=bounds).x
    found = numpy.exp(x) if all(low + 1e-6 < value < high - 1e-6 for value, (low, high) in zip(x, bounds)) else (math.nan, math.nan)
    groups = asked.assign(expected=share(x, asked.bend_deg)).groupby(pandas.qcut(asked.bend_deg, 6, duplicates="drop"))
    table = groups.agg(bend_deg=("bend_deg", "mean"), right=("is_right", "mean"), expected=("expected", "mean"), answers=("is_right", "size"))
    spread = table.expected * (1 - table.expected) / table.answers
    fit = scipy.stats.chi2.sf(((table.right - table.expected) ** 2 / spread).sum(), len(table) - 2) if len(table) > 2 else math.nan
    return found, fit, table, lambda bend: share(x, bend)


def threshold_ratios(trials, people, study):
    """Returns log(threshold / delivered bend) of each participant. Delivered bend: mean absolute angle between the virtual target and the end of
    reaches, in the condition of the noticeability block."""
    reaches = counted(trials)
    reaches = reaches[reaches.condition == study["noticeability"]["condition"]]
    bends = (reaches.real_deg + reaches.miss_deg - reaches.virtual_deg).abs().groupby(reaches.participant).mean()
    return numpy.log(people.groupby("participant").threshold_deg.last() / bends).dropna()


def compare(trials, plan, seed):
    """Compares each condition with the reference, or with 0 for below_margin. Returns a row for each: number of people, estimate, interval, p of
    Student's t, of the sign flip and of equivalence, and p of the preregistered test corrected by Holm's method. If that test is a mixed model,
    estimate and interval are those of the model, and the row also has its p and its name. The level of the interval is 1 - alpha / comparisons, or
    1 - 2 alpha / comparisons for equivalence."""
    differences, way = contrasts(outcomes(trials, plan), plan), plan.get("direction", "two-sided")
    level = 1 - (2 if registered_p(plan) == "equivalence" else 1) * plan["alpha"] / max(1, len(differences))
    rows = {}
    for condition, values in differences.items():
        p, low, high = student(values, level, way)
        rows[condition] = {"people": len(values), "estimate": values.mean(), "low": low, "high": high, "t": p, "sign_flip": sign_flip(values, seed, direction=way),
                           "equivalence": math.nan if math.isnan(p) else equivalence(values, plan["margin"])}
    rows = pandas.DataFrame(rows).T
    if plan["test"] == "mixed_model":
        model = mixed_models([counted(trials) if "kind" in trials else trials], plan["measure"], plan["reference"], way)[0].reindex(rows.index)
        half = scipy.stats.t.isf((1 - level) / (2 if way == "two-sided" else 1), model.df) * model.error
        rows = rows.assign(estimate=model.estimate, low=-math.inf if way == "less" else model.estimate - half,
                           high=math.inf if way == "greater" else model.estimate + half, mixed_model=model.p, model=model.model)
    return rows.assign(holm=pandas.Series(holm(rows[registered_p(plan)].to_dict()), dtype=float))
