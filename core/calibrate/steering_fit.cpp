#include "core/calibrate/steering_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "core/math/distributions.h"
#include "core/math/exponential.h"
#include "core/math/least_squares.h"
#include "core/math/linear_algebra.h"
#include "core/math/trigonometry.h"
#include "core/paper/estimator.h"

namespace hrt {
namespace {

constexpr double bin_s = 0.04;
// Of how a person moves, for the weights; what differs from it widens the intervals.
constexpr double noise_deg2_per_s = 8.0;
constexpr double usual_rate_per_s = 8.0;
constexpr double usual_log_rate = 2.08;
constexpr double log_rate_deviation = 1.0;
constexpr double usual_delay_s = 0.07;
constexpr double delay_deviation_s = 0.15;
// Delays from which the fit sets out: it may settle in a local optimum.
constexpr std::array<double, 2> first_delays_s{0.02, 0.1};
// Nobody is taken to be beyond: rates of 1 to 40 /s, and a curve of a fifth to three times that at rest.
constexpr double max_log_rate = 3.7;
constexpr double max_delay_s = 0.35;
constexpr double max_start_deg = 45.0;
constexpr double min_scale = 0.2;
constexpr double max_scale = 3.0;
constexpr double start_prior_deg = 5.0;
constexpr double start_deviation_deg = 3.0;
constexpr double start_place_deviation_m = 0.0003;
constexpr double min_noise_m = 0.0003;
constexpr double min_correlation_s = 0.01;
// The values of slides over a plate at rest hold within this many of their deviations.
constexpr double rest_deviations = 1.5;
// And no better than this.
constexpr double min_rest_deviation_deg = 0.05;
constexpr double min_scale_deviation = 0.01;
// What the laws may get wrong.
constexpr double law_log_rate = 0.05;
constexpr double law_delay_s = 0.004;
// The law is tested where the turned plate is felt.
constexpr double first_tested_share = 0.2;
constexpr Eigen::Index max_tested_parts = 4;
// What the laws may get wrong of it, in units of the weights: seen on people of little noise who steer by
// one.
constexpr double allowed_mean = 0.1;
// An interval that is wider says nothing of a person.
constexpr double max_rate_ratio = 2.5;
constexpr double max_delay_width_s = 0.1;

using Vector = Eigen::VectorXd;
constexpr std::array<double, steering_parameters> derivative_step{0.02, 0.002, 0.05, 0.05, 0.05, 0.01};

struct Observed {
  const TurningSlide* slide;
  std::vector<SlideBin> bins;
  Eigen::VectorXd left_m;
  Eigen::MatrixXd whitening;  // L^-1 of the covariance L L'
};

// The slide's places in means over bin_s or more, each with a position at least.
Observed binned(const TurningSlide& slide) {
  const SlideTrack& track = slide.track;
  Observed observed{.slide = &slide, .bins = {}, .left_m = {}, .whitening = {}};
  std::vector<double> left_m;
  const auto min_steps = static_cast<std::size_t>(std::ceil(bin_s / track.step_s));
  for (std::size_t i = 0; i < track.steps.size();) {
    SlideBin bin{.begin = i, .end = i, .seen = 0.0};
    double sum_m = 0.0;
    while (bin.end < track.steps.size() && (bin.end - bin.begin < min_steps || !(bin.seen > 0.0))) {
      const SlideTrack::Step& step = track.steps[bin.end++];
      bin.seen += step.seen;
      sum_m += step.seen * step.left_m;
    }
    i = bin.end;
    if (!(bin.seen > 0.0)) break;
    observed.bins.push_back(bin);
    left_m.push_back(sum_m / bin.seen);
  }
  observed.left_m =
      Eigen::Map<const Eigen::VectorXd>(left_m.data(), static_cast<Eigen::Index>(left_m.size()));
  return observed;
}

// What a kick of one degree at each step does to the places in the bins.
Eigen::MatrixXd kicks_of(const SlideTrack& track, const std::vector<SlideBin>& bins) {
  const auto steps = static_cast<Eigen::Index>(track.steps.size());
  Eigen::MatrixXd kicks = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(bins.size()), steps);
  const double kept = exponential(-usual_rate_per_s * track.step_s);
  for (Eigen::Index j = 0; j < steps; ++j) {
    double left = 1.0;
    double here_m = 0.0;
    std::size_t bin = 0;
    for (auto i = static_cast<std::size_t>(j); i < track.steps.size(); ++i) {
      while (bin < bins.size() && i >= bins[bin].end) ++bin;
      if (bin == bins.size()) break;
      here_m += rad_per_deg * track.steps[i].advance_m * left;
      left *= kept;
      kicks(static_cast<Eigen::Index>(bin), j) +=
          here_m / static_cast<double>(bins[bin].end - bins[bin].begin);
    }
  }
  return kicks;
}

Observed observe(const TurningSlide& slide, const RestNoise& noise) {
  const SlideTrack& track = slide.track;
  Observed observed = binned(slide);
  const std::vector<SlideBin>& bins = observed.bins;
  const Eigen::MatrixXd kicks = kicks_of(track, bins);
  const Eigen::VectorXd first_kick = start_deviation_deg * kicks.col(0);
  Eigen::MatrixXd covariance = noise_deg2_per_s * track.step_s * product(kicks, kicks.transpose()) +
                               product(first_kick, first_kick.transpose());
  covariance.array() += start_place_deviation_m * start_place_deviation_m;
  const double white_m = std::max(noise.white_m.value, min_noise_m);
  const double correlated_m = noise.correlated_m.value;
  const double correlation_s = std::max(noise.correlation_s.value, min_correlation_s);
  const auto middle_s = [&](std::size_t b) {
    return 0.5 * track.step_s * static_cast<double>(bins[b].begin + bins[b].end);
  };
  for (std::size_t a = 0; a < bins.size(); ++a) {
    const auto row = static_cast<Eigen::Index>(a);
    covariance(row, row) += white_m * white_m / bins[a].seen;
    if (!(correlated_m > 0.0)) continue;
    for (std::size_t b = 0; b < bins.size(); ++b)
      covariance(row, static_cast<Eigen::Index>(b)) +=
          correlated_m * correlated_m * exponential(-std::abs(middle_s(a) - middle_s(b)) / correlation_s);
  }
  observed.whitening = whitening_of(covariance);
  return observed;
}

struct LawFit {
  Vector person;
  double misfit = std::numeric_limits<double>::infinity();  // with the prior's
  Eigen::MatrixXd covariance;
};

Vector clamped(Vector person) {
  person(steering_log_rate) = std::clamp(person(steering_log_rate), 0.0, max_log_rate);
  person(steering_delay_s) = std::clamp(person(steering_delay_s), 0.0, max_delay_s);
  person(steering_start_deg) = std::clamp(person(steering_start_deg), -max_start_deg, max_start_deg);
  person(steering_scale) = std::clamp(person(steering_scale), min_scale, max_scale);
  return person;
}

// The slides over a turning plate, and what the slides over a plate at rest say of the person.
class SteeringFitter {
 public:
  SteeringFitter(std::span<const TurningSlide> slides, const CurveFit& person, const RestNoise& noise);

  LawFit fit(SteeringLaw law) const;
  double law_p(const Vector& person, SteeringLaw law) const;

 private:
  Eigen::VectorXd residual(const Observed& observed, const Vector& person, SteeringLaw law) const {
    return product(observed.whitening,
                   observed.left_m - predicted_left_m(*observed.slide, observed.bins, curve_, person, law));
  }
  std::vector<Eigen::VectorXd> residuals(const Vector& person, SteeringLaw law) const {
    std::vector<Eigen::VectorXd> groups;
    for (const Observed& observed : observed_) groups.push_back(residual(observed, person, law));
    return groups;
  }
  std::vector<Eigen::MatrixXd> derivatives(const Vector& person, SteeringLaw law) const {
    std::vector<Eigen::MatrixXd> groups;
    for (const Observed& observed : observed_) groups.push_back(jacobian(observed, person, law));
    return groups;
  }
  Eigen::MatrixXd jacobian(const Observed& observed, const Vector& person, SteeringLaw law) const;

  IllusionCurve curve_;
  Vector prior_mean_ = Vector::Zero(steering_parameters);
  Vector prior_deviation_ = Vector::Zero(steering_parameters);
  std::vector<Observed> observed_;
};

SteeringFitter::SteeringFitter(std::span<const TurningSlide> slides, const CurveFit& person,
                               const RestNoise& noise)
    : curve_(person.person.curve) {
  const FitValue weight =
      fit_value(person, [](const SlidingPersonModel& p) { return curve_weight(p.curve); });
  const FitValue bias_deg = fit_value(person, [](const SlidingPersonModel& p) { return p.bias_deg; });
  const FitValue habit_deg = fit_value(person, [](const SlidingPersonModel& p) { return p.habit_deg; });
  const auto expect = [&](int parameter, double mean, double sd) {
    prior_mean_(parameter) = mean;
    prior_deviation_(parameter) = sd;
  };
  expect(steering_log_rate, usual_log_rate, log_rate_deviation);
  expect(steering_delay_s, usual_delay_s, delay_deviation_s);
  expect(steering_bias_deg, bias_deg.value, rest_deviations * bias_deg.deviation + min_rest_deviation_deg);
  expect(steering_habit_deg, habit_deg.value, rest_deviations * habit_deg.deviation + min_rest_deviation_deg);
  expect(steering_start_deg, person.person.start_deg, start_prior_deg);
  expect(steering_scale, 1.0,
         rest_deviations * weight.deviation / std::max(weight.value, Estimator::min_tactile_weight) +
             min_scale_deviation);
  for (const TurningSlide& slide : slides) observed_.push_back(observe(slide, noise));
}

LawFit SteeringFitter::fit(SteeringLaw law) const {
  const LeastSquares problem{.residuals = [&](const Vector& person) { return residuals(person, law); },
                             .derivatives = [&](const Vector& person) { return derivatives(person, law); },
                             .clamped = clamped,
                             .prior_mean = prior_mean_,
                             .prior_deviation = prior_deviation_};
  LawFit best;
  for (const double late_s : first_delays_s) {
    Vector first = prior_mean_;
    first(steering_delay_s) = late_s;
    const LeastSquaresFit found = descend(problem, first);
    if (best.person.size() > 0 && !(found.misfit + found.penalty < best.misfit)) continue;
    best.person = found.parameters;
    best.misfit = found.misfit + found.penalty;
  }
  best.covariance =
      jackknife_covariance(residuals(best.person, law), derivatives(best.person, law), prior_deviation_);
  best.covariance(steering_log_rate, steering_log_rate) += law_log_rate * law_log_rate;
  best.covariance(steering_delay_s, steering_delay_s) += law_delay_s * law_delay_s;
  return best;
}

Eigen::MatrixXd SteeringFitter::jacobian(const Observed& observed, const Vector& person,
                                         SteeringLaw law) const {
  Eigen::MatrixXd columns(observed.left_m.size(), static_cast<Eigen::Index>(steering_parameters));
  for (int i = 0; i < steering_parameters; ++i) {
    Vector above = person;
    Vector below = person;
    above(i) += derivative_step[static_cast<std::size_t>(i)];
    below(i) -= derivative_step[static_cast<std::size_t>(i)];
    below = clamped(below);
    columns.col(i) = (predicted_left_m(*observed.slide, observed.bins, curve_, above, law) -
                      predicted_left_m(*observed.slide, observed.bins, curve_, below, law)) /
                     (above(i) - below(i));
  }
  return product(observed.whitening, columns);
}

// The mean over all slides of the residuals in parts of the path, mirrored for plates that begin on the other
// side, is 0 if the law holds: Hotelling's test, with the scatter of the slides themselves.
double SteeringFitter::law_p(const Vector& person, SteeringLaw law) const {
  const auto slides = static_cast<Eigen::Index>(observed_.size());
  const Eigen::Index parts = std::min<Eigen::Index>(max_tested_parts, slides / 3);
  Eigen::MatrixXd means = Eigen::MatrixXd::Zero(slides, parts);
  for (Eigen::Index i = 0; i < slides; ++i) {
    const Observed& observed = observed_[static_cast<std::size_t>(i)];
    const Eigen::VectorXd off = residual(observed, person, law);
    const double side = std::copysign(1.0, observed.slide->plate_deg.front());
    Eigen::VectorXd counts = Eigen::VectorXd::Zero(parts);
    for (Eigen::Index b = 0; b < off.size(); ++b) {
      const SlideBin& bin = observed.bins[static_cast<std::size_t>(b)];
      const double share = observed.slide->track.steps[(bin.begin + bin.end) / 2].share;
      const double part = (share - first_tested_share) / (1.0 - first_tested_share);
      if (part < 0.0) continue;
      const Eigen::Index p =
          std::min<Eigen::Index>(static_cast<Eigen::Index>(part * static_cast<double>(parts)), parts - 1);
      means(i, p) += side * off(b);
      counts(p) += 1.0;
    }
    for (Eigen::Index p = 0; p < parts; ++p) means(i, p) /= std::max(counts(p), 1.0);
  }
  const Eigen::VectorXd mean = means.colwise().mean();
  const Eigen::MatrixXd scatter = means.rowwise() - mean.transpose();
  const auto n = static_cast<double>(slides);
  const auto p = static_cast<double>(parts);
  Eigen::MatrixXd covariance = product(scatter.transpose(), scatter) / (n - 1.0);
  covariance.diagonal().array() += n * allowed_mean * allowed_mean;
  const double distance = n * mean.dot(solve_symmetric(covariance, mean));
  return f_tail((n - p) / (p * (n - 1.0)) * distance, p, n - p);
}

// The median and the 95 % interval of one parameter over the laws.
Interval mixture(const std::array<LawFit, steering_laws>& fits,
                 const std::array<double, steering_laws>& probability, int parameter, double widening) {
  std::vector<NormalPart> parts;
  for (std::size_t law = 0; law < fits.size(); ++law)
    parts.push_back({probability[law], fits[law].person(parameter),
                     widening * std::sqrt(fits[law].covariance(parameter, parameter))});
  return mixture_interval(parts);
}

}  // namespace

SteeringFit fit_steering(std::span<const TurningSlide> slides, const CurveFit& person,
                         const RestNoise& noise) {
  SteeringFit steering;
  steering.slides = static_cast<int>(slides.size());
  const SteeringFitter fit(slides, person, noise);
  std::array<LawFit, steering_laws> fits;
  double min = std::numeric_limits<double>::infinity();
  for (int law = 0; law < steering_laws; ++law) {
    fits[static_cast<std::size_t>(law)] = fit.fit(static_cast<SteeringLaw>(law));
    min = std::min(min, fits[static_cast<std::size_t>(law)].misfit);
  }
  double sum = 0.0;
  for (std::size_t law = 0; law < fits.size(); ++law)
    sum += steering.probability[law] = exponential(std::max(-0.5 * (fits[law].misfit - min), -700.0));
  for (double& probability : steering.probability) probability /= sum;
  const auto likeliest = std::max_element(steering.probability.begin(), steering.probability.end());
  const auto law = static_cast<std::size_t>(likeliest - steering.probability.begin());
  steering.law_p = fit.law_p(fits[law].person, static_cast<SteeringLaw>(law));
  const double widening = student_975(static_cast<double>(slides.size()) - 2.0) / normal_975;
  const Interval log_rates = mixture(fits, steering.probability, steering_log_rate, widening);
  steering.rate_per_s = {exponential(log_rates.value), exponential(log_rates.lower),
                         exponential(log_rates.upper), true};
  steering.delay_s = mixture(fits, steering.probability, steering_delay_s, widening);
  steering.rate_per_s.known = steering.rate_per_s.upper <= max_rate_ratio * steering.rate_per_s.lower;
  steering.delay_s.known = steering.delay_s.upper - steering.delay_s.lower <= max_delay_width_s;
  return steering;
}

}  // namespace hrt
