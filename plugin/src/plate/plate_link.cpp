#include "plugin/src/plate/plate_link.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <random>
#include <utility>

#include "plugin/include/plate_driver/plate_failure.h"

namespace hrt::plate {
namespace {

using namespace std::chrono_literals;

constexpr auto greeting_limit = 5000ms;
constexpr auto greeting_period = 200ms;  // time between two HELLOs
constexpr auto silence_limit = 500ms;
constexpr int probes = 11;  // heartbeats that measure the round trip
constexpr auto probe_limit = 100ms;

// Failure and text for each StopReason from `limit` on, in their order.
constexpr auto first_failure = static_cast<std::size_t>(StopReason::limit);
constexpr std::pair<Fault, const char*> stop_failures[] = {
    {Fault::limits, "has refused an angle beyond its limits. Open the plate again, to read its present limits"},
    {Fault::device,
     "is defective or could not store its settings. Save them again (hrt-plate set); if it fails, exchange the board"},
    {Fault::emergency, "was stopped by its emergency stop. Release the emergency stop, and open the plate again"},
    {Fault::stuck, "reports that its servo is stuck. Switch the supply off and remove the obstacle"},
    {Fault::device, "reports that its sensor turns against its servo. Exchange the settings adc_least and adc_most"},
    {Fault::restarted, "has lost its orientation. Open the plate again, and home it"},
    {Fault::device,
     "has less than 4 V at its servo's supply. Check adapter, fuse, emergency stop and the wire to pin A1"}};
static_assert(std::size(stop_failures) == static_cast<std::size_t>(StopReason::supply) - first_failure + 1);

std::uint16_t random_token() {
  std::random_device device;
  return std::uniform_int_distribution<std::uint16_t>(1, 65535)(device);
}

}  // namespace

PlateLink::PlateLink(std::unique_ptr<Line> line, Start start)
    : line_(std::move(line)), start_(start), token_(random_token()) {
  try {
    start_session();
    measure_round_trip();
    ask("INFO", [](const PlateMessage& message) { return std::holds_alternative<PlateInfo>(message); });
    run_for(greeting_period);
    expected_greetings_ = 0;
  } catch (...) {
    try_to_stop();
    throw;
  }
}

PlateLink::~PlateLink() { try_to_stop(); }

std::string PlateLink::description() const {
  return "protocol 2, firmware " + info_->firmware + ", serial number " + info_->serial;
}

DeviceLimits PlateLink::limits() const {
  const auto own = std::chrono::duration<double, std::milli>(greeting_->latency_ms);
  return {greeting_->min_deg, greeting_->max_deg,
          std::min(greeting_->speed_deg_s, watch_->speed_deg_s().value_or(greeting_->speed_deg_s)),
          std::chrono::duration_cast<std::chrono::nanoseconds>(own) + round_trip().value_or(0ns) / 2};
}

void PlateLink::start_session() {
  const Line::Time began = now();
  received_at_ = began;
  while (!greeting_) {
    const auto passed = now() - began;
    if (passed > greeting_limit && has_other_host_)
      throw PlateFailure(Fault::line, "is in use by another program. End that program");
    if (passed > greeting_limit)
      throw PlateFailure(Fault::no_answer,
                         "does not answer as a plate within 5 s; check the device name, cable and supply");
    ++expected_greetings_;
    send_body("HELLO 2");
    const Line::Time again = now() + greeting_period;
    while (!greeting_ && now() < again) {
      line_->wait(10ms);
      receive();
    }
  }
}

void PlateLink::measure_round_trip() {
  for (int i = 0; i < probes; ++i) {
    const std::size_t before = round_trips_.count();
    send_command("BEAT");
    const Line::Time give_up = now() + probe_limit;
    while (round_trips_.count() == before && now() < give_up) {
      line_->wait(10ms);
      receive();
      watch_->check(now());
    }
  }
  if (round_trips_.count() == 0)
    throw PlateFailure(Fault::protocol,
                       "does not echo sequence numbers. Install a firmware with version 2 of the line protocol");
}

void PlateLink::run_for(std::chrono::milliseconds time) {
  const Line::Time end = now() + time;
  while (now() < end) wait(10ms);
}

void PlateLink::wait(std::chrono::milliseconds limit) {
  line_->wait(limit);
  try {
    receive();
    const Line::Time time = now();
    if (time - received_at_ > silence_limit) throw PlateFailure(Fault::silent, silent_text);
    watch_->check(time);
    if (time - sent_at_ >= heartbeat_period_) send_command("BEAT");
    line_->flush();
  } catch (const PlateFailure&) {
    try_to_stop();
    throw;
  }
}

void PlateLink::turn_to(double orientation_deg) {
  const double sent_deg = std::round(orientation_deg * 100.0) / 100.0;
  if (command_deg_ == sent_deg) return;
  command_deg_ = sent_deg;
  watch_->note_command(sent_deg);
  send_command(orientation_deg_ ? "SET" : "HOME");
}

void PlateLink::stop() {
  command_deg_.reset();
  watch_->note_stop();
  send_command("STOP");
}

void PlateLink::ask(const std::string& body, const std::function<bool(const PlateMessage&)>& handler,
                    std::chrono::milliseconds limit) {
  const std::string verb = body.substr(0, body.find(' '));
  is_answered_ = false;
  handler_ = &handler;
  const Line::Time give_up = now() + limit;
  try {
    send_body(body);
    while (!is_answered_) {
      if (now() > give_up)
        throw PlateFailure(Fault::protocol,
                           "does not answer " + verb + ". Install the firmware that belongs to this driver");
      wait(10ms);
    }
  } catch (...) {
    handler_ = nullptr;
    throw;
  }
  handler_ = nullptr;
}

void PlateLink::receive() {
  std::string bytes;
  line_->receive(bytes);
  LineError error = LINE_OK;
  for (const char byte : bytes) {
    if (!line_receive(&buffer_, byte, &error) || error != LINE_OK) continue;
    if (const auto message = parse_plate_message(buffer_.text)) handle(*message);
  }
}

void PlateLink::handle(const PlateMessage& message) {
  received_at_ = now();
  if (const auto* greeting = std::get_if<PlateGreeting>(&message)) handle_greeting(*greeting);
  const auto* refused = std::get_if<PlateRefusal>(&message);
  has_other_host_ = has_other_host_ || (refused != nullptr && refused->why == "session");
  if (!greeting_) return;
  if (const auto* report = std::get_if<PlateReport>(&message)) handle_report(*report);
  if (const auto* stopped = std::get_if<PlateStopped>(&message)) handle_stop(stopped->reason);
  if (refused != nullptr) handle_refusal(*refused);
  if (const auto* info = std::get_if<PlateInfo>(&message)) info_ = *info;
  if (std::holds_alternative<PlateBooted>(message)) throw PlateFailure(Fault::restarted, restarted_text);
  if (handler_ != nullptr && !is_answered_) is_answered_ = (*handler_)(message);
}

void PlateLink::handle_greeting(const PlateGreeting& greeting) {
  if (!greeting_) {
    greeting_ = greeting;
    watch_.emplace(greeting, received_at_);
  } else if (expected_greetings_ <= 0) {
    throw PlateFailure(Fault::restarted,
                       "has sent another greeting: it was reset, or another plate answers. Open the plate again");
  }
  --expected_greetings_;
}

void PlateLink::handle_report(const PlateReport& report) {
  orientation_deg_ = report.orientation_deg;
  reported_ = received_at_;
  if (!round_trips_.echoed(received_at_, report.sequence)) throw PlateFailure(Fault::line, second_program_text);
  watch_->note_report(received_at_, report.orientation_deg);
}

void PlateLink::handle_stop(StopReason reason) {
  if (reason == StopReason::host) return;
  if (reason == StopReason::heartbeat) {
    command_deg_.reset();  // so that the next command is sent even if it equals the last one
    watch_->note_stop();
    return;
  }
  if (start_ == Start::passive && (reason == StopReason::emergency || reason == StopReason::supply)) return;
  const auto& [fault, text] = stop_failures[static_cast<std::size_t>(reason) - first_failure];
  throw PlateFailure(fault, text);
}

// A plate that sends `ERROR greeting` has restarted: it has forgotten the greeting.
void PlateLink::handle_refusal(const PlateRefusal& refusal) {
  ++refusals_;
  if (refusal.why == "session") throw PlateFailure(Fault::line, second_program_text);
  if (refusal.why == "greeting") throw PlateFailure(Fault::restarted, restarted_text);
}

void PlateLink::send_command(std::string_view word) {
  ++sequence_;
  round_trips_.sent(now(), sequence_);
  const bool turns = word == "SET" || word == "HOME";
  send_body(turns ? motion_body(*command_deg_, sequence_, word) : with_number(word, sequence_));
}

void PlateLink::send_body(std::string_view body) {
  line_->send(encode_line(with_number(body, token_)));
  sent_at_ = now();
}

// Sends STOP if the serial line still works. Otherwise the plate stops by itself, because no heartbeat arrives.
void PlateLink::try_to_stop() {
  try {
    if (greeting_) send_command("STOP");
    for (int i = 0; line_->has_unsent() && i < 10; ++i) {
      line_->wait(10ms);
      line_->flush();
    }
  } catch (const PlateFailure&) {
    return;
  }
}

DeviceMaker serial_device(const DeviceName& name) {
  name.check_options({});
  return [path = name.path](const LineOpener& open, Start start) {
    return std::make_unique<PlateLink>(open(path, 115200), start);
  };
}

}  // namespace hrt::plate
