// Every pair of faults, at every phase of a plate's life: how far it moves before the first command, how fast
// it turns, and what is reported. As a table: hrt_plate_driver_tests --gtest_filter='PlateFaults*'
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "plugin/src/plate/plate_failure.h"
#include "plugin/src/plate/plate_link.h"
#include "tests/plugin/plate/twin_board.h"
#include "tests/samples/text.h"

namespace hrt::plate {
namespace {

using namespace std::chrono_literals;

constexpr double speed_limit_deg_s = 200.0;  // the firmware's, which a finger feels
constexpr auto window = 100ms;               // over which speed is taken: pulses come every 20 ms

class UnpluggedLine : public TwinLine {
 public:
  using TwinLine::TwinLine;
  void receive(std::string& bytes) override {
    check();
    TwinLine::receive(bytes);
  }
  void send(std::string_view bytes) override {
    check();
    TwinLine::send(bytes);
  }
  bool is_unplugged = false;

 private:
  void check() const {
    if (is_unplugged) throw PlateFailure(Fault::unplugged, "is unplugged");
  }
};

// A plate, its host, and what happens to them.
struct Scene {
  TwinBoard board{{.place_deg = 20.0}};
  UnpluggedLine* line = nullptr;
  std::unique_ptr<PlateLink> link;
  std::mt19937 random{5};
  std::set<std::string> reported;
  double before_first_set_deg = 0.0, max_deg_s = 0.0;
  bool is_set = false, is_unplugged = false;

  // Serves the link, or lets time pass without one; a link that failed is opened anew.
  void run(std::chrono::milliseconds time) {
    for (const auto end = board.now() + time; board.now() < end;) {
      const double from_deg = board.orientation_deg();
      const auto from = board.now();
      while (board.now() < from + window) {
        try {
          if (link)
            link->wait(5ms);
          else
            board.run_for(5ms);
        } catch (const PlateFailure& failure) {
          reported.insert(failure.what());
          link.reset();
        }
      }
      const double seconds = std::chrono::duration<double>(board.now() - from).count();
      max_deg_s = std::max(max_deg_s, std::abs(board.orientation_deg() - from_deg) / seconds);
      if (!is_set)
        before_first_set_deg = std::max(before_first_set_deg, std::abs(board.orientation_deg() - 20.0));
    }
  }
  void open() {
    board.take_output();  // what came before is lost
    auto made = std::make_unique<UnpluggedLine>(board);
    line = made.get();
    line->is_unplugged = is_unplugged;
    try {
      link = std::make_unique<PlateLink>(std::move(made));
    } catch (const PlateFailure& failure) {
      reported.insert(failure.what());
      line = nullptr;
    }
  }
  void set(double orientation_deg) {
    is_set = true;
    if (link) link->turn_to(orientation_deg);
  }
};

struct Kind {
  const char* name;
  void (*begin)(Scene& scene);
  std::vector<std::string> says;  ///< of which the report has one; none: it is not seen
  std::size_t first_phase = 0;    ///< in which it is seen
};
const std::vector<Kind> kinds = {
    {"unplug",
     [](Scene& s) {
       s.is_unplugged = true;
       if (s.link) s.line->is_unplugged = true;
     },
     {"is unplugged"}},
    {"power loss",
     [](Scene& s) {
       s.board.restart();
       s.board.servo.supply = 0.0;
     },
     {"has restarted", "is stuck"},
     1},
    {"reset", [](Scene& s) { s.board.restart(); }, {"has restarted"}, 1},
    {"emergency", [](Scene& s) { s.board.press(true); }, {"emergency stop"}},
    {"second host", [](Scene& s) { s.board.say("SET -060.00 40000"); }, {"another program"}, 1},
    {"garbage",
     [](Scene& s) {
       std::string noise(200, '\0');
       for (char& byte : noise) byte = static_cast<char>(s.random());
       s.board.hear(noise, s.board.now());
       s.board.send(noise);
     },
     {}},
    {"silence", [](Scene& s) { s.board.fall_silent(); }, {"not answer", "not been heard", "not reported"}},
    {"stuck", [](Scene& s) { s.board.servo.is_jammed = true; }, {"is stuck"}},
    {"stall", [](Scene& s) { s.board.servo.supply = 0.3; }, {}},
};

constexpr std::array phases = {"open", "idle", "move", "hold", "close"};

void play(Scene& scene, std::size_t phase, const Kind& first, const Kind& second) {
  const auto strike = [&](std::size_t now) {
    if (now != phase) return;
    first.begin(scene);
    scene.run(40ms);
    second.begin(scene);
  };
  if (phase == 0) {  // in the middle of the greeting
    scene.board.say("HELLO 2");
    strike(0);
  }
  scene.open();
  scene.run(300ms);
  strike(1);
  scene.run(300ms);
  scene.set(80.0);
  scene.run(260ms);
  strike(2);
  scene.run(1500ms);
  strike(3);
  scene.run(300ms);
  scene.set(-60.0);
  scene.run(1500ms);
  strike(4);
  scene.link.reset();
  scene.run(600ms);
}

// `said` names `kind`, or `kind` cannot be seen in this phase; at the close nobody is left to see it.
bool is_named(const Kind& kind, std::size_t phase, const std::string& said) {
  const auto& words = kind.says;
  return std::any_of(words.begin(), words.end(), [&](const auto& word) { return has(said, word); }) ||
         words.empty() || phase < kind.first_phase || phase + 1 == phases.size();
}

TEST(PlateFaults, NoPairOfThemMovesAPlateUncommandedTooFastOrInSilence) {
  std::printf("%-12s %-12s %-6s %-14s %-10s %s\n", "fault", "and", "phase", "deg before set", "deg/s",
              "reported");
  for (std::size_t a = 0; a < kinds.size(); ++a) {
    for (std::size_t b = a; b < kinds.size(); ++b) {
      for (std::size_t phase = 0; phase < phases.size(); ++phase) {
        Scene scene;
        play(scene, phase, kinds[a], kinds[b]);
        std::string said;
        for (const std::string& what : scene.reported) said += (said.empty() ? "" : "; ") + what;
        std::printf("%-12s %-12s %-6s %14.1f %10.0f %s\n", kinds[a].name, kinds[b].name, phases[phase],
                    scene.before_first_set_deg, scene.max_deg_s, said.c_str());
        SCOPED_TRACE(std::string(kinds[a].name) + ", " + kinds[b].name + ", " + phases[phase]);
        // The second host is one that commands.
        const bool is_commanded = kinds[a].says == kinds[4].says || kinds[b].says == kinds[4].says;
        EXPECT_TRUE(is_commanded || scene.before_first_set_deg <= 2.0);
        EXPECT_LE(scene.max_deg_s, 1.1 * speed_limit_deg_s);
        EXPECT_TRUE(is_named(kinds[a], phase, said) || is_named(kinds[b], phase, said)) << said;
        EXPECT_TRUE(!said.empty() || (is_named(kinds[a], phase, "") && is_named(kinds[b], phase, "")));
      }
    }
  }
}

}  // namespace
}  // namespace hrt::plate
