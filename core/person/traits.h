// What a person brings to each reach: one row a trait. Its number in the C interface is HRT_PERSON_ and its
// name.
#pragma once

namespace hrt {

struct PersonTrait {
  enum Index {
    weight,    ///< w of the illusion
    curve,     ///< b of the illusion
    gain,      ///< k
    bias,      ///< d
    habit,     ///< c
    evenness,  ///< a
    heading,   ///< share of the goal's direction in which they set out
    log_rate,  ///< rho, natural logarithm of one over the duration in seconds
    fading,    ///< f of the illusion
    scatter,   ///< of the bias from reach to reach, standard deviation
    count
  };
};

/// Every number but the ranges was tuned on simulated people (core/person/README.md).
struct Trait {
  const char* name;
  const char* unit;
  double min, max;  ///< a belief's mean lies there
  double mean, sd;  ///< of an unknown person
  double change;    ///< deviation by which it may have changed from one reach to the next
};

// Mean and deviation of weight and curve are in deviations of a linear illusion's weight, which the host
// gives: the weight's mean above that weight. The bias's mean is the host's too.
inline constexpr Trait person_traits[PersonTrait::count] = {
    {"weight", "", 0.01, 0.6, 0.9, 1.7, 0.008},     //
    {"curve", "", -0.1, 0.5, 1.1, 1.6, 0.03},       //
    {"gain", "1/s", 3.0, 20.0, 14.0, 4.0, 0.7},     //
    {"bias", "deg", -90.0, 90.0, 0.0, 1.5, 0.5},    //
    {"habit", "deg", -45.0, 45.0, 0.0, 2.0, 0.4},   //
    {"evenness", "", 0.0, 1.0, 0.05, 0.35, 0.05},   //
    {"heading", "", -2.0, 2.0, 0.2, 0.45, 0.1},     //
    {"log_rate", "", -3.0, 2.4, -0.65, 0.55, 0.1},  //
    {"fading", "", -0.2, 1.0, 0.05, 0.6, 0.02},     //
    {"scatter", "deg", 0.0, 10.0, 1.2, 0.8, 0.1},
};

}  // namespace hrt
