#include "core/person/person_estimator.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/person/person_model.h"

namespace hrt {
namespace {

using X = PersonState;

constexpr double motion_mm = 100.0;

// Returns the log of a motion of one second over a plate without effect. The direction at the fraction s of the path is
// bend_deg * cos(2 pi s), with which the finger returns to the line.
MotionLog motion(double bend_deg, int rate_hz = 100) {
  PersonFilter filter(unknown_person(), 0.0, motion_mm, {.white_mm = 0.2, .correlated_mm = 0.2});
  filter.begin(0.0, 0.02, 0.1);
  MotionLog log;
  log.begin(filter, 0.0);
  PlatePoint finger;
  double covered = 0.0;
  for (int i = 1; i <= rate_hz; ++i) {
    const double share = progress(0.0, static_cast<double>(i) / rate_hz).share;
    const double direction_deg = bend_deg * std::cos(3.14159265358979 * (share + covered));
    finger.right_mm -= motion_mm * (share - covered) * std::sin(direction_deg * 0.0174532925199433);
    finger.away_mm += motion_mm * (share - covered) * std::cos(direction_deg * 0.0174532925199433);
    covered = share;
    log.add(static_cast<double>(i) / rate_hz, finger, direction_deg);
  }
  return log;
}

double learnt_log_wander(const MotionLog& log) { return log.belief(unknown_person()).mean(X::log_wander); }

TEST(MotionLog, NoPositions_LeaveTheEstimateUnchanged) {
  const PersonBelief prior = unknown_person();
  const PersonBelief learnt = MotionLog{}.belief(prior);
  EXPECT_EQ(learnt.mean, prior.mean);
  EXPECT_EQ(learnt.covariance, prior.covariance);
}

TEST(MotionLog, AnInterruptedMotion_UpdatesTheWanderOnly) {
  MotionLog log = motion(0.0);
  const int count = log.count();
  log.close();
  log.add(2.0, {}, 0.0);
  EXPECT_EQ(log.count(), count);
  const PersonBelief prior = unknown_person();
  const PersonBelief learnt = log.belief(prior);
  EXPECT_LT(learnt.mean(X::log_wander), prior.mean(X::log_wander));
  EXPECT_LT(learnt.covariance(X::log_wander, X::log_wander), prior.covariance(X::log_wander, X::log_wander));
  EXPECT_EQ(learnt.mean.head<X::log_wander>(), prior.mean.head<X::log_wander>());
}

TEST(MotionLog, AHighRate_StillCoversTheWholeMotion) {
  const MotionLog log = motion(10.0, 1000);
  EXPECT_GE(log.count(), MotionLog::capacity / 2);
  EXPECT_NEAR(learnt_log_wander(log), learnt_log_wander(motion(10.0, 100)), 0.3);
}

}  // namespace
}  // namespace hrt
