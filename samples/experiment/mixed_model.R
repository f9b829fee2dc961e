# Fits mixed models to studies by lmerTest (lme4 with Satterthwaite's degrees of freedom).
#
# Reads CSV from standard input: study, participant, condition (0: the reference), pair, value. Prints CSV with a row for each study and
# condition except the reference. Fixed effects: condition, pair and their interaction; contrasts of pairs sum to 0, so the effect of a
# condition is the mean over pairs. Random effects of participants: intercept, condition, and each contrast between pairs, with its own
# variance in each condition, since a participant's bias raises the misses on one side and lowers those on the other side. The residual
# has a variance in each condition, by weights from repeated trials, if each condition has some.
# If no optimiser converges, the model is reduced in the order of `models`. The column `model` names the model that was fitted.
suppressMessages(library(lmerTest))
trials <- read.csv(file("stdin"))

fit_of <- function(formula, data) {
  for (optimizer in c("nloptwrap", "bobyqa", "Nelder_Mead")) {
    # A singular fit (such as a variance of zero) is accepted; a fit that has not converged is not.
    control <- lmerControl(optimizer, check.conv.singular = "ignore")
    found <- tryCatch(lmer(formula, data, weights = weight, control = control), error = function(e) NULL)
    if (!is.null(found) && length(found@optinfo$conv$lme4) == 0 && found@optinfo$conv$opt == 0) return(found)
  }
}

rows_of <- function(data) {
  data$condition <- factor(data$condition)
  cell <- paste(data$participant, data$condition, data$pair)
  squares <- tapply((data$value - ave(data$value, cell))^2, data$condition, sum)
  freedom <- tapply(cell, data$condition, function(names) length(names) - length(unique(names)))
  data$weight <- if (all(freedom > 0 & squares > 0)) (freedom / squares)[data$condition] else 1
  slopes <- data.frame(model.matrix(~condition, data)[, -1, drop = FALSE])
  sides <- data.frame(row.names = row.names(data))
  fixed <- "value ~ condition"
  if (length(unique(data$pair)) > 1) {
    fixed <- "value ~ condition * pair"
    data$pair <- C(factor(data$pair), contr.sum)
    for (level in levels(data$condition)) {
      contrast <- (data$condition == level) * model.matrix(~pair, data)[, -1, drop = FALSE]
      sides[paste0("side", level, "_", seq_len(ncol(contrast)))] <- contrast
    }
  }
  terms_of <- function(columns) if (ncol(columns) > 0) paste0("(0 + ", names(columns), " | participant)")
  models <- list("intercept, condition and pair" = c("(condition | participant)", terms_of(sides)),
                 "intercept, condition and pair, uncorrelated" = c("(1 | participant)", terms_of(slopes), terms_of(sides)),
                 "intercept and condition" = "(condition | participant)", "intercept" = "(1 | participant)")
  data <- cbind(data, slopes, sides)
  for (name in names(models)) {
    fit <- fit_of(as.formula(paste(c(fixed, models[[name]]), collapse = " + ")), data)
    if (is.null(fit)) next
    found <- coef(summary(fit))[names(slopes), , drop = FALSE]
    if (!all(is.finite(found))) next
    return(data.frame(study = data$study[1], condition = levels(data$condition)[-1], estimate = found[, 1], error = found[, 2],
                      df = found[, 3], p = found[, 5], model = paste0(name, if (isSingular(fit)) ", singular")))
  }
  data.frame(study = data$study[1], condition = levels(data$condition)[-1], estimate = NA, error = NA, df = NA, p = NA, model = "none converged")
}

write.csv(do.call(rbind, lapply(split(trials, trials$study), rows_of)), row.names = FALSE, na = "")
