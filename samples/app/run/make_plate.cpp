#include "samples/app/run/make_plate.h"

#include <chrono>
#include <cmath>
#include <utility>

#include "samples/app/base/exit_code.h"
#include "samples/app/plate/device_plate.h"
#include "samples/app/plate/simulated_servo.h"
#include "samples/app/text/format.h"

namespace hrt::app {
namespace {

class RuntimePlate : public Plate {
 public:
  explicit RuntimePlate(Simulation& simulation) : simulation_(simulation) {}

  void command(XrTime time, double orientation_deg) override {
    // Selects the equivalent orientation nearest to the present one, within the runtime's limits of +-360 degrees.
    const double half_turns = std::round((simulation_.plate_orientation_deg(time) - orientation_deg) / 180.0);
    const double nearest_deg = orientation_deg + 180.0 * half_turns;
    const bool is_within = std::abs(nearest_deg) <= 360.0;
    simulation_.set_plate_orientation(is_within ? nearest_deg : nearest_deg - std::copysign(180.0, nearest_deg));
  }
  std::optional<double> orientation_deg(XrTime time) override { return simulation_.plate_orientation_deg(time); }
  void stop(XrTime time) override { simulation_.set_plate_orientation(simulation_.plate_orientation_deg(time)); }

 private:
  Simulation& simulation_;
};

// A plate outside the runtime. Copies its orientation to the simulation in every frame, for the simulated user.
class FollowedPlate : public Plate {
 public:
  FollowedPlate(std::unique_ptr<Plate> plate, Simulation& simulation)
      : plate_(std::move(plate)), simulation_(simulation) {}

  std::string description() const override { return plate_->description(); }
  const hrt_plate_report* report() const override { return plate_->report(); }
  void service(XrTime time) override {
    plate_->service(time);
    if (const std::optional<double> orientation_deg = plate_->orientation_deg(time))
      simulation_.set_plate_orientation(*orientation_deg);
  }
  void command(XrTime time, double orientation_deg) override { plate_->command(time, orientation_deg); }
  std::optional<double> orientation_deg(XrTime time) override { return plate_->orientation_deg(time); }
  void stop(XrTime time) override { plate_->stop(time); }

 private:
  std::unique_ptr<Plate> plate_;
  Simulation& simulation_;
};

// A runtime with a faster clock, such as the manual clock of the mock runtime, would not wait for a device.
void require_real_time(XrHeadlessSession& session, const std::string& runtime_name) {
  constexpr int frames = 10;
  const XrTime first = session.next_frame();
  const auto began = std::chrono::steady_clock::now();
  XrTime last = first;
  for (int i = 0; i < frames; ++i) last = session.next_frame();
  const double passed_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  const double frames_s = static_cast<double>(last - first) * 1e-9;
  if (frames_s <= 2.0 * passed_s + 0.02) return;
  throw Failure(ExitCode::plate, "a plate on a serial line turns in real time, but the clock of the OpenXR runtime " +
                                     runtime_name + format(" advanced by %.3f s in %.3f s", frames_s, passed_s) +
                                     "; select a runtime with a real-time clock [mock runtime: hrtx-run --script FILE "
                                     "with {\"clock\": \"real-time\"}]");
}

std::unique_ptr<Plate> make_chosen(const PlateChoice& choice, Simulation* simulation, XrHeadlessSession& session,
                                   const std::string& runtime_name) {
  switch (choice.kind) {
    case PlateChoice::Kind::servo:
      return std::make_unique<SimulatedServo>(choice.servo_speed_deg_per_s);
    case PlateChoice::Kind::device:
      require_real_time(session, runtime_name);
      return std::make_unique<DevicePlate>(choice.name);
    case PlateChoice::Kind::runtime:
      break;
  }
  if (simulation == nullptr)
    throw Failure(ExitCode::plate, "the OpenXR runtime " + runtime_name +
                                       " does not simulate a plate; select another plate (--plate servo, or a device)");
  return std::make_unique<RuntimePlate>(*simulation);
}

}  // namespace

std::unique_ptr<Plate> make_plate(const PlateChoice& choice, Simulation* simulation, XrHeadlessSession& session,
                                  const std::string& runtime_name) {
  std::unique_ptr<Plate> plate = make_chosen(choice, simulation, session, runtime_name);
  if (simulation == nullptr || choice.kind == PlateChoice::Kind::runtime) return plate;
  return std::make_unique<FollowedPlate>(std::move(plate), *simulation);
}

}  // namespace hrt::app
