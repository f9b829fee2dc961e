// A touch frame as the tracker of the fingertip. umockdev emulates the device.
#include <gtest/gtest.h>
#include <linux/input.h>
#include <umockdev.h>

#include <atomic>
#include <cstring>
#include <deque>
#include <mutex>
#include <thread>

#include "samples/app/base/exit_code.h"
#include "samples/app/finger/touch_frame.h"
#include "samples/app/text/format.h"
#include "tests/samples/reach/program.h"

namespace hrt::app {
namespace {

constexpr std::int64_t ms = 1'000'000;
constexpr const char* path = "/dev/input/event7";
const std::string name = std::string("evdev:") + path;

// For this process and its children: 400 x 300 steps of half a millimetre, two slots.
struct EmulatedFrame {
  std::map<unsigned, input_absinfo> axes{{ABS_MT_SLOT, {0, 0, 1, 0, 0, 0}},
                                         {ABS_MT_TRACKING_ID, {0, 0, 65535, 0, 0, 0}},
                                         {ABS_MT_POSITION_X, {0, 0, 400, 0, 0, 2}},
                                         {ABS_MT_POSITION_Y, {0, 0, 300, 0, 0, 2}}};
  std::map<int, std::array<int, 2>> state{{ABS_MT_TRACKING_ID, {-1, -1}}};  // of the slots
  std::atomic<int> error = 0, clock = -1;                                   // of all calls but open()
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
  void add(std::int64_t time_ns, std::uint16_t type, std::uint16_t code, int value) {
    events.push_back({{time_ns / 1'000'000'000, time_ns % 1'000'000'000 / 1000}, type, code, value});
  }
  // A negative id: lifted.
  void report(std::int64_t time_ns, int slot, int id, int x, int y, bool is_dropped = false) {
    const std::lock_guard lock(mutex);
    add(time_ns, EV_ABS, ABS_MT_SLOT, slot);
    for (const auto& [code, value] :
         std::map<std::uint16_t, int>{{ABS_MT_TRACKING_ID, id}, {ABS_MT_POSITION_X, x}, {ABS_MT_POSITION_Y, y}})
      if (std::exchange(state[code].at(static_cast<std::size_t>(slot)), value) != value)
        add(time_ns, EV_ABS, code, value);
    if (is_dropped) events.clear();
    add(time_ns, EV_SYN, is_dropped ? SYN_DROPPED : SYN_REPORT, 0);
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
    if (request != EVIOCGRAB) {  // whose argument is no address
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
  const auto at = [&frame](int time_ms) {  // by the delay for resampling
    const Fingertip tip = frame.at((time_ms + 12) * ms);
    return tip.tracked  ? format("%.2f %.2f", 1e3 * tip.position_m[0], 1e3 * tip.position_m[2])
           : tip.lifted ? "lifted"
                        : "lost";
  };
  EXPECT_EQ(device.clock, CLOCK_MONOTONIC);
  EXPECT_TRUE(has(frame.description(), "400 x 300 mm; an object -90 mm right of the centre and 20 mm beyond"));
  EXPECT_EQ(at(900), "lifted");
  for (int i = 0; i <= 2; ++i) device.report((1000 + 10 * i) * ms, 1, 4, 200, 150 + 10 * i);
  EXPECT_EQ(at(1015), "25.00 -20.00");
  EXPECT_EQ(at(1400), "30.00 -20.00");  // at rest, so nothing is reported
  device.report(1510 * ms, 1, 4, 200, 190);
  EXPECT_EQ(at(1505), "45.00 -20.00");
  device.report(900'000 * ms, 1, 4, 200, 999);  // in the future, beyond the area
  EXPECT_EQ(at(1530), "94.00 -20.00");
  device.report(1550 * ms, 1, -1, 0, 0);
  device.report(1560 * ms, 0, -1, 0, 0);
  device.report(1570 * ms, 0, 5, 201, 51);  // the object after a dropout
  EXPECT_EQ(at(1570), "lifted");
  device.report(1600 * ms, 1, 6, 260, 150);
  EXPECT_EQ(at(1600), "10.00 -80.00");
  device.report(1700 * ms, 1, -1, 0, 0, true);
  device.report(1700 * ms, 0, 7, 200, 150, true);  // known from the kernel's state alone
  EXPECT_EQ(at(1730), "10.00 -20.00");
}

TEST(TouchFrame, SaysWhatIsWrongAndWhatToDo) {
  const auto refusal = [](const std::string& text) -> std::string {
    try {
      TouchFrame frame(text);
      return "none";
    } catch (const Failure& failure) {
      return std::to_string(static_cast<int>(failure.code())) + failure.what();
    }
  };
  EXPECT_TRUE(has(refusal("evdev:event7"), {"2--finger", "evdev:/dev/input"}));
  for (const std::string wrong : {"width_mm", "width_mm=nan", "width_mm=1e9", "depth_mm=3"})
    EXPECT_TRUE(has(refusal(name + "?" + wrong), "2--finger: \"" + wrong + "\" is not NAME=NUMBER"));
  EXPECT_TRUE(has(refusal("evdev:/dev/null"), {"14the touch frame", "it is no input device"}));
  EmulatedFrame device;
  device.error = EACCES;
  EXPECT_TRUE(has(refusal(name), {"14the touch frame", "Join the group input"}));
  device.error = 0;
  device.axes[ABS_MT_POSITION_Y].resolution = 0;
  EXPECT_TRUE(has(refusal(name), {"14the touch frame", "?height_mm=..."}));
  device.axes.erase(ABS_MT_SLOT);
  EXPECT_TRUE(has(refusal(name), {"14the touch frame", "is not a multitouch device"}));
}

// By hrt-reach in real time.
TEST(TouchFrame, LeadsAReachUntilItIsUnplugged) {
  EmulatedFrame device;
  const auto touch = [&](int id, int towards_mm) {
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    device.report(now / std::chrono::nanoseconds(1), 0, id, 200, 150 + 2 * towards_mm);
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  };
  auto environment = reach::scripted_environment(R"({"clock": "real-time"})");
  environment.insert({{"LD_PRELOAD", HRT_UMOCKDEV_PRELOAD}, {"UMOCKDEV_DIR", std::getenv("UMOCKDEV_DIR")}});
  const reach::Program program(reach::person_and({"--repeat", "2", "--finger", name}), environment);
  for (std::size_t made = 0; made < 2; ++made) {
    for (int i = 0; i < 3000 && occurrences(program.err(), "Put your index finger") <= made; ++i) touch(-1, 0);
    for (int i = -90; i <= (made == 0 ? 100 : 50); ++i) touch(1, 50 - std::max(0, i));
  }
  device.error = ENODEV;
  const Outcome outcome = expect_exit(14, program.wait());
  reach::expect_said(outcome, {"/dev/input/event7 is gone", "plug it in and start again"});
  const std::vector<reach::Row> rows = reach::rows_of(outcome);
  ASSERT_EQ(rows.size(), 1U) << outcome.out << outcome.err;
  EXPECT_TRUE(rows[0].reached);
  EXPECT_EQ(rows[0].lost, 0);
}

}  // namespace
}  // namespace hrt::app
