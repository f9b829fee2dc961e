#include "samples/plate/tool/emulate.h"

#include <chrono>
#include <cmath>
#include <ostream>
#include <thread>

#include "samples/app/base/interrupt.h"
#include "samples/app/emulator/pty_device.h"
#include "samples/app/text/format.h"

namespace hrt::plate {
namespace {

using namespace std::chrono_literals;

// Presses or releases the emergency stop, which cuts the servo's supply. A hobby servo's board detects the press.
void press(HobbyPlate& plate, bool pressed) {
  plate.press_emergency_stop(pressed);
  plate.servo.supply = pressed ? 0.0 : 1.0;
}
void press(EmulatedDynamixel& servo, bool pressed) {
  servo.restart();
  servo.is_silent = pressed;
}
void jam(HobbyPlate& plate, bool jammed) { plate.servo.is_jammed = jammed; }
void jam(EmulatedDynamixel& servo, bool jammed) { servo.motor.is_jammed = jammed; }

template <class Emulated>
void run(PtyDevice<Emulated>& plate, const char* kind, const char* protocol, const Emulation& emulation,
         const std::function<Input()>& read, std::ostream& out) {
  app::note_interrupts();
  const PtyLink link("--link", emulation.link, plate.device());
  out << "SIMULATION of a plate with " << kind << ". No servo and no board is connected. The device name is\n    "
      << protocol << ":" << (emulation.link.empty() ? plate.device() : emulation.link.string())
      << "\nPress Enter to show the angle on the scale; e, then Enter, to press or release the emergency stop; j, then "
         "Enter, to jam or free the servo.\nCtrl-C ends the simulation."
      << std::endl;
  const auto reported_deg = [&] { return plate.with([](Emulated& emulated) { return emulated.orientation_deg(); }); };
  bool pressed = false, jammed = false;
  for (bool reads = true; !app::is_interrupted(); std::this_thread::sleep_for(20ms)) {
    const Input entry = reads ? read() : Input{};
    reads = !entry.ended;
    if (!entry.line) continue;
    if (*entry.line == "e") {
      plate.with([&](Emulated& emulated) { press(emulated, pressed = !pressed); });
    } else if (*entry.line == "j") {
      plate.with([&](Emulated& emulated) { jam(emulated, jammed = !jammed); });
    }
    out << format("the scale shows %+.0f", reported_deg()) << (pressed ? "; the emergency stop is pressed" : "")
        << (jammed ? "; the servo is jammed" : "") << std::endl;
  }
}

}  // namespace

void emulate(const Emulation& emulation, const std::function<Input()>& read, std::ostream& out) {
  if (emulation.plate == "xl330") {
    PtyDevice<EmulatedDynamixel> plate(std::uint8_t{1}, 1190);
    plate.with(
        [](EmulatedDynamixel& servo) { servo.set(6, 1, 0); });  // firmware 0 marks the simulation: no real servo has it
    run(plate, "an XL330-M077", "dynamixel", emulation, read, out);
    return;
  }
  const bool is_new = emulation.plate == "hobby-new";
  PtyDevice<HobbyPlate> plate(HobbyPlate::Traits{.settings = is_new ? settings_default() : commissioned(),
                                                 .firmware = PLATE_FIRMWARE_VERSION "-emulated"});
  run(plate, is_new ? "a hobby servo, not commissioned" : "a hobby servo", "serial", emulation, read, out);
}

}  // namespace hrt::plate
