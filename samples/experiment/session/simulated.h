// A simulated participant and experimenter. The simulated clock advances only by the duration of their actions.
#pragma once

#include <cstdint>

#include "samples/experiment/design/draws.h"
#include "samples/experiment/session/subject.h"

namespace hrt::experiment {

class SimulatedSubject : public Subject {
 public:
  SimulatedSubject(const Design& design, unsigned participant, std::uint64_t seed);

  Now now() override { return now_; }
  void continue_after(const Now& last) override { now_ = last; }
  std::string boot() const override { return "simulated"; }
  std::string description() const override;
  void plan(hrt_session_config& config) const override;
  void say(const std::string&) override {}
  std::string note() override { return {}; }
  bool consents() override;
  void slide(hrt_session session, const hrt_setup_step& step, unsigned number, std::int64_t from_ns,
             const std::function<std::optional<hrt_setup_step>(const hrt_sample&)>& use) override;
  std::vector<nlohmann::json> fill_in(const Questionnaire& paper) override;
  void rest(double minutes) override;
  ReachOutcome reach(const ReachOrder& order) override;
  unsigned answer(const std::string& question, const std::vector<std::string>& answers,
                  const std::vector<double>& felt_deg, unsigned number) override;

  /// Advances the simulated clock.
  void pass(double seconds);

 private:
  Place place(unsigned number) const { return {seed_, participant_, 0, number, 0}; }

  const Design& design_;
  unsigned participant_;
  std::uint64_t seed_;
  hrt_person_config config_ = hrt_person_config_init();
  double threshold_deg_;  // detection threshold of the perceived-direction error
  Now now_;
};

}  // namespace hrt::experiment
