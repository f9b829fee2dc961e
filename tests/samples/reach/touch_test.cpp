// A touch frame as the tracker of the fingertip. umockdev emulates the device.
#include <gtest/gtest.h>
#include <linux/input.h>
#include <umockdev.h>

#include <atomic>
#include <cstring>
#include <deque>
#include <fstream>
#include <mutex>
#include <thread>

#include "samples/app/base/exit_code.h"
#include "samples/app/emulator/pseudo_terminal.h"
#include "samples/app/finger/touch_frame.h"
#include "samples/app/text/format.h"
#include "tests/samples/reach/program.h"

namespace hrt::app {
namespace {

constexpr std::int64_t ms = 1'000'000;
constexpr const char* path = "/dev/input/event7";
const std::string name = std::string("evdev:") + path;

// A touch frame that this process and its children see: 400 x 300 steps of half a millimetre, two slots.
struct EmulatedFrame {
  std::map<unsigned, input_absinfo> axes{{ABS_MT_SLOT, {0, 0, 1, 0, 0, 0}},
                                         {ABS_MT_TRACKING_ID, {0, 0, 65535, 0, 0, 0}},
                                         {ABS_MT_POSITION_X, {0, 0, 400, 0, 0, 2}},
                                         {ABS_MT_POSITION_Y, {0, 0, 300, 0, 0, 2}}};
  std::map<int, std::array<int, 2>> state{{ABS_MT_TRACKING_ID, {-1, -1}}};  // values of the axes, by slot
  std::atomic<int> error = 0, clock = -1;  // error of all calls except open(); clock that the program has set
  std::deque<input_event> events;
  std::mutex mutex;  // the handler has its own thread
  UMockdevTestbed* bed = umockdev_testbed_new();
  UMockdevIoctlBase* handler = umockdev_ioctl_base_new();

  EmulatedFrame() {
    umockdev_testbed_add_from_string(bed, "P: /devices/frame\nN: input/event7\nE: SUBSYSTEM=input\n", nullptr);
    g_signal_connect(handler, "handle-ioctl", G_CALLBACK(answer), this);
    g_signal_connect(handler, "handle-read", G_CALLBACK(read), this);
    umockdev_testbed_attach_ioctl(bed, path, handler, nullptr);
  }
  ~EmulatedFrame() {
    umockdev_testbed_detach_ioctl(bed, path, nullptr);
    g_object_unref(handler);
    g_object_unref(bed);
  }
  // A negative id reports that the contact was lifted.
  void report(std::int64_t time_ns, int slot, int id, int x, int y, bool is_dropped = false) {
    const std::lock_guard lock(mutex);
    const auto add = [&](std::uint16_t type, std::uint16_t code, int value) {
      events.push_back({{time_ns / 1'000'000'000, time_ns % 1'000'000'000 / 1000}, type, code, value});
    };
    const std::map<std::uint16_t, int> now{{ABS_MT_TRACKING_ID, id}, {ABS_MT_POSITION_X, x}, {ABS_MT_POSITION_Y, y}};
    add(EV_ABS, ABS_MT_SLOT, slot);
    for (const auto& [code, value] : now)
      if (std::exchange(state[code].at(static_cast<std::size_t>(slot)), value) != value) add(EV_ABS, code, value);
    if (is_dropped) events.clear();
    add(EV_SYN, is_dropped ? SYN_DROPPED : SYN_REPORT, 0);
  }
  static gboolean read(UMockdevIoctlBase*, UMockdevIoctlClient* client, EmulatedFrame* frame) {
    const std::lock_guard lock(frame->mutex);
    const bool has_event = frame->error == 0 && !frame->events.empty();
    if (has_event) {
      std::memcpy(umockdev_ioctl_client_get_arg(client)->data, &frame->events.front(), sizeof(input_event));
      frame->events.pop_front();
    }
    umockdev_ioctl_client_complete(client, has_event ? long{sizeof(input_event)} : -1,
                                   frame->error == 0 ? EAGAIN : +frame->error);
    return TRUE;
  }
  static gboolean answer(UMockdevIoctlBase*, UMockdevIoctlClient* client, EmulatedFrame* frame) {
    const std::lock_guard lock(frame->mutex);
    const unsigned long request = umockdev_ioctl_client_get_request(client), number = _IOC_NR(request);
    UMockdevIoctlData* argument = umockdev_ioctl_client_get_arg(client);
    if (request != EVIOCGRAB) {  // the argument of EVIOCGRAB is not an address
      auto* bytes = umockdev_ioctl_data_resolve(argument, 0, _IOC_SIZE(request), nullptr)->data;
      auto* values = reinterpret_cast<int*>(bytes);
      if (number == _IOC_NR(EVIOCGBIT(0, 0))) bytes[0] = 1U << EV_ABS;
      for (const auto& [code, axis] : frame->axes) {
        if (number == _IOC_NR(EVIOCGBIT(EV_ABS, 0))) bytes[code / 8] |= static_cast<unsigned char>(1U << code % 8);
        if (number == _IOC_NR(EVIOCGABS(code))) std::memcpy(bytes, &axis, sizeof axis);
      }
      if (number == _IOC_NR(EVIOCGMTSLOTS(0))) std::memcpy(values + 1, &frame->state[values[0]], 2 * sizeof(int));
      if (number == _IOC_NR(EVIOCSCLOCKID)) frame->clock = values[0];
    }
    umockdev_ioctl_client_complete(client, frame->error == 0 ? 0 : -1, frame->error);
    return TRUE;
  }
};

TEST(TouchFrame, LocatesTheFingerAmongContacts) {
  EmulatedFrame device;
  device.report(0, 0, 3, 200, 50);  // an object
  TouchFrame frame(name + "?width_mm=400&height_mm=300&right_mm=10&towards_mm=-20&turn_deg=90");
  const auto at = [&frame](int time_ms) {  // locate() returns the position 12 ms before its argument
    const Fingertip tip = frame.locate((time_ms + 12) * ms);
    return tip.tracked ? format("%.2f %.2f", 1e3 * tip.position_m[0], 1e3 * tip.position_m[2])
                       : std::string(tip.lifted ? "lifted" : "lost");
  };
  EXPECT_EQ(device.clock, CLOCK_MONOTONIC);
  EXPECT_TRUE(has(
      frame.description(),
      "400 x 300 mm; ignores the contact that was there at the start, 90 mm further left and 20 mm further from you "
      "than the plate's centre (lift"));
  EXPECT_EQ(at(900), "lifted");
  for (int i = 0; i <= 2; ++i) device.report((1000 + 10 * i) * ms, 1, 4, 200, 150 + 10 * i);
  EXPECT_EQ(at(1015), "25.00 -20.00");
  EXPECT_EQ(at(1400), "30.00 -20.00");  // at rest, so nothing is reported
  device.report(1510 * ms, 1, 4, 200, 190);
  EXPECT_EQ(at(1505), "49.80 -20.00");
  device.report(900'000 * ms, 1, 4, 200, 999);  // in the future, beyond the area
  EXPECT_EQ(at(1530), "118.75 -20.00");
  device.report(1550 * ms, 1, -1, 0, 0);
  device.report(1560 * ms, 0, -1, 0, 0);
  device.report(1570 * ms, 0, 5, 201, 51);  // the object after a dropout
  EXPECT_EQ(at(1570), "lifted");
  device.report(1600 * ms, 1, 6, 260, 150);
  EXPECT_EQ(at(1600), "10.00 -80.00");
  device.report(1700 * ms, 1, -1, 0, 0, true);
  device.report(1700 * ms, 0, 7, 200, 150, true);  // SYN_DROPPED: the contact is read from the kernel's state
  EXPECT_EQ(at(1730), "10.00 -20.00");
}

TEST(TouchFrame, ErrorsNameTheMistakeAndTheRemedy) {
  const auto expect_refused = [](const std::string& text, ExitCode code, const std::string& why) {
    try {
      TouchFrame frame(text);
      ADD_FAILURE() << text;
    } catch (const Failure& failure) {
      EXPECT_EQ(failure.code(), code);
      EXPECT_TRUE(has(failure.what(), why));
    }
  };
  expect_refused("evdev:event7", ExitCode::usage, "\"evdev:event7\" is not evdev:PATH");
  for (const std::string wrong : {"width_mm", "width_mm=nan", "width_mm=1e9", "depth_mm=3"})
    expect_refused(name + "?" + wrong, ExitCode::usage, "\"" + wrong + "\" is not NAME=NUMBER");
  expect_refused("evdev:/dev/null", ExitCode::tracker, "/dev/input/by-id");
  EmulatedFrame device;
  device.error = EACCES;
  expect_refused(name, ExitCode::tracker, "Join the group input");
  device.error = 0;
  device.axes[ABS_MT_POSITION_Y].resolution = 0;
  expect_refused(name, ExitCode::tracker, "height_mm=H");
  device.axes.erase(ABS_MT_SLOT);
  expect_refused(name, ExitCode::tracker, "is not a multitouch device");
}

// In real time: one reach, and half of another.
TEST(TouchFrame, TracksReachesUntilItIsUnplugged) {
  const std::string folder = reach::scratch_folder();
  std::ofstream(folder + "/study.json") << R"({"title": "t", "participants": 2, "repeats": 2, "practice_trials": 0,
    "set_up": "none", "conditions": [{"name": "a", "controller": "people"}, {"name": "b", "controller": "none"}],
    "pairs": [{"name": "left", "virtual_deg": 6, "real_deg": 0}]})";
  std::ofstream(folder + "/script.json") << R"({"clock": "real-time"})";
  const std::vector<std::string> programs[] = {
      {HRT_REACH_PROGRAM, reach::desk, "--person", "--target", "bottle", "--repeat", "2"},
      {HRT_EXPERIMENT_PROGRAM, "run", folder + "/study.json", "--participant", "1", "--data", folder, "--scene",
       reach::desk}};
  for (std::vector<std::string> words : programs) {
    EmulatedFrame device;
    const auto touch = [&](int id, int towards_mm) {
      const auto now = std::chrono::steady_clock::now().time_since_epoch();
      device.report(now / std::chrono::nanoseconds(1), 0, id, 200, 150 + 2 * towards_mm);
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    };
    words.insert(words.end(), {"--plate", "servo", "--finger", name});
    const plate::Pty terminal(80);
    terminal.type("y");  // consent
    const Process program(words,
                          {"XR_RUNTIME_JSON=" HRT_MOCK_MANIFEST, "HRT_MOCK_SCRIPT=" + folder + "/script.json",
                           "LD_PRELOAD=" HRT_UMOCKDEV_PRELOAD, format("UMOCKDEV_DIR=%s", std::getenv("UMOCKDEV_DIR"))},
                          -1, terminal.descriptor());
    for (std::size_t made = 0; made < 2; ++made) {
      for (int i = 0; i < 3000 && occurrences(program.err(), "Put your index finger") <= made; ++i) touch(-1, 0);
      for (int i = -90; i <= (made == 0 ? 100 : 50); ++i) touch(1, 50 - std::max(0, i));
    }
    device.error = ENODEV;
    const Outcome outcome = program.wait();
    EXPECT_TRUE(has(outcome.err, "/dev/input/event7 is gone (No such device): plug it in and start again"));
    const bool is_study = words[0] == HRT_EXPERIMENT_PROGRAM;
    EXPECT_EQ(outcome.exit_code, is_study ? 1 : 14);
    const std::string made = is_study ? read_file(folder + "/sub-01/ses-01/journal.jsonl") : outcome.out;
    EXPECT_EQ(occurrences(made, is_study ? "\"event\":\"reach\"" : " reached"), 1U) << made << outcome.err;
  }
}

}  // namespace
}  // namespace hrt::app
