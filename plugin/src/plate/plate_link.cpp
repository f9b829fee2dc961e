#include "plugin/src/plate/plate_link.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "plugin/include/plate_driver/plate_failure.h"

namespace hrt::plate {
namespace {

using namespace std::chrono_literals;

constexpr auto greeting_limit = 5000ms;
constexpr auto greeting_period = 200ms;
constexpr auto silence_limit = 500ms;
constexpr int probes = 11;
constexpr auto probe_limit = 100ms;

std::uint16_t any_session() {
  std::random_device device;
  return std::uniform_int_distribution<std::uint16_t>(1, 65535)(device);
}

}  // namespace

PlateLink::PlateLink(std::unique_ptr<Line> line, Start start)
    : line_(std::move(line)), start_(start), session_(any_session()) {
  try {
    greet();
    measure_line();
    ask("INFO", [](const PlateMessage& message) { return std::holds_alternative<PlateInfo>(message); });
    serve_for(greeting_period);
    unanswered_hellos_ = 0;
  } catch (...) {
    stop_if_heard();
    throw;
  }
}

PlateLink::~PlateLink() { stop_if_heard(); }

std::string PlateLink::description() const {
  return "protocol 2, firmware " + info_->firmware + ", serial number " + info_->serial;
}

DeviceLimits PlateLink::limits() const {
  const auto own = std::chrono::duration<double, std::milli>(greeting_->latency_ms);
  return {greeting_->min_deg, greeting_->max_deg,
          std::min(greeting_->speed_deg_s, watch_->speed_deg_s().value_or(greeting_->speed_deg_s)),
          std::chrono::duration_cast<std::chrono::nanoseconds>(own) + round_trip().value_or(0ns) / 2};
}

void PlateLink::greet() {
  const Line::Time began = now();
  heard_ = began;
  while (!greeting_) {
    const auto passed = now() - began;
    if (passed > greeting_limit && is_taken_)
      throw PlateFailure(Fault::line, "is in use by another program. Close that program");
    if (passed > greeting_limit)
      throw PlateFailure(Fault::no_answer, "does not answer as a plate within 5 s; check device, cable and supply");
    ++unanswered_hellos_;
    say("HELLO 2");
    const Line::Time again = now() + greeting_period;
    while (!greeting_ && now() < again) {
      line_->wait(10ms);
      listen();
    }
  }
}

void PlateLink::measure_line() {
  for (int i = 0; i < probes; ++i) {
    const std::size_t before = round_trips_.count();
    drive("BEAT");
    const Line::Time give_up = now() + probe_limit;
    while (round_trips_.count() == before && now() < give_up) {
      line_->wait(10ms);
      listen();
      watch_->check(now());
    }
  }
  if (round_trips_.count() == 0)
    throw PlateFailure(Fault::protocol, "does not echo sequence numbers; install a firmware with line protocol 2");
}

void PlateLink::serve_for(std::chrono::milliseconds time) {
  const Line::Time end = now() + time;
  while (now() < end) wait(10ms);
}

void PlateLink::service() {
  try {
    listen();
    const Line::Time time = now();
    if (time - heard_ > silence_limit) throw PlateFailure(Fault::silent, silent_text);
    watch_->check(time);
    if (time - said_ >= beat_period_) drive("BEAT");
    line_->flush();
  } catch (const PlateFailure&) {
    stop_if_heard();
    throw;
  }
}

void PlateLink::wait(std::chrono::milliseconds limit) {
  line_->wait(limit);
  service();
}

void PlateLink::turn_to(double orientation_deg) {
  const double sent_deg = std::round(orientation_deg * 100.0) / 100.0;
  if (command_deg_ == sent_deg) return;
  command_deg_ = sent_deg;
  watch_->commanded(sent_deg);
  drive(orientation_deg_ ? "SET" : "HOME");
}

void PlateLink::stop() {
  command_deg_.reset();
  watch_->stopped();
  drive("STOP");
}

void PlateLink::ask(const std::string& body, const std::function<bool(const PlateMessage&)>& take,
                    std::chrono::milliseconds limit) {
  const std::string verb = body.substr(0, body.find(' '));
  answered_ = false;
  asked_ = &take;
  const Line::Time give_up = now() + limit;
  try {
    say(body);
    while (!answered_) {
      if (now() > give_up) throw PlateFailure(Fault::protocol, "does not answer " + verb + "; check its firmware");
      wait(10ms);
    }
  } catch (...) {
    asked_ = nullptr;
    throw;
  }
  asked_ = nullptr;
}

void PlateLink::listen() {
  std::string bytes;
  line_->receive(bytes);
  for (const char byte : bytes) {
    const std::optional<std::string_view> line = reader_.take(byte);
    if (!line) continue;
    const std::optional<std::string_view> body = decode_line(*line);
    if (!body) continue;
    if (const auto message = parse_plate_message(*body)) take(*message);
  }
}

void PlateLink::take(const PlateMessage& message) {
  heard_ = now();
  if (const auto* greeting = std::get_if<PlateGreeting>(&message)) take_greeting(*greeting);
  const auto* refused = std::get_if<PlateRefusal>(&message);
  is_taken_ = is_taken_ || (refused != nullptr && refused->why == "session");
  if (!greeting_) return;
  if (const auto* report = std::get_if<PlateReport>(&message)) take_report(*report);
  if (const auto* stopped = std::get_if<PlateStopped>(&message)) take_stop(stopped->reason);
  if (refused != nullptr) take_refusal(*refused);
  if (const auto* info = std::get_if<PlateInfo>(&message)) info_ = *info;
  if (std::holds_alternative<PlateBooted>(message)) throw PlateFailure(Fault::restarted, restarted_text);
  if (asked_ != nullptr && !answered_) answered_ = (*asked_)(message);
}

void PlateLink::take_greeting(const PlateGreeting& greeting) {
  if (!greeting_) {
    greeting_ = greeting;
    watch_.emplace(greeting, heard_);
  } else if (unanswered_hellos_ <= 0) {
    throw PlateFailure(Fault::restarted,
                       "has announced itself again: it was reset, or another plate answers. Open it again");
  }
  --unanswered_hellos_;
}

void PlateLink::take_report(const PlateReport& report) {
  orientation_deg_ = report.orientation_deg;
  reported_ = heard_;
  if (!round_trips_.echoed(heard_, report.sequence)) throw PlateFailure(Fault::line, second_program_text);
  watch_->reported(heard_, report.orientation_deg);
}

void PlateLink::take_stop(StopReason reason) {
  switch (reason) {
    case StopReason::host:
      break;
    case StopReason::heartbeat:
      command_deg_.reset();  // so that the next command is sent, also if it is equal
      watch_->stopped();
      break;
    case StopReason::limit:
      throw PlateFailure(Fault::limits, "refused an angle beyond its limits. Open it again to read its limits");
    case StopReason::fault:
      throw PlateFailure(Fault::device, "reports that it is defective. Test it with hrt-plate show");
    case StopReason::emergency:
      if (start_ == Start::quiet) break;
      throw PlateFailure(Fault::emergency, "was stopped by its emergency stop. Release it, and open the plate again");
    case StopReason::stuck:
      throw PlateFailure(Fault::stuck, "reports that its servo is stuck. Switch it off, and remove the obstacle");
    case StopReason::sensor:
      throw PlateFailure(Fault::device,
                         "reports that its sensor runs against its servo. Exchange adc_least and adc_most");
    case StopReason::unhomed:
      throw PlateFailure(Fault::restarted, "no longer knows its orientation. Open it again, and home it");
    case StopReason::supply:
      if (start_ == Start::quiet) break;
      throw PlateFailure(
          Fault::device,
          "has less than 4 V at its servo's supply. Check adapter, fuse, emergency stop and the wire to A1");
  }
}

// Counts refused lines, since some are damaged in transmission. A plate that does not know its host has restarted.
void PlateLink::take_refusal(const PlateRefusal& refusal) {
  ++refusals_;
  if (refusal.why == "session") throw PlateFailure(Fault::line, second_program_text);
  if (refusal.why == "greeting") throw PlateFailure(Fault::restarted, restarted_text);
}

void PlateLink::drive(std::string_view word) {
  ++sequence_;
  round_trips_.sent(now(), sequence_);
  const bool turns = word == "SET" || word == "HOME";
  say(turns ? set_body(*command_deg_, sequence_, word) : beat_body(word, sequence_));
}

void PlateLink::say(std::string_view body) {
  line_->send(encode_line(beat_body(body, session_)));
  said_ = now();
}

// Tries to stop the plate; without a heartbeat it stops by itself.
void PlateLink::stop_if_heard() {
  try {
    if (greeting_) drive("STOP");
    for (int i = 0; line_->has_unsent() && i < 10; ++i) {
      line_->wait(10ms);
      line_->flush();
    }
  } catch (const PlateFailure&) {
    return;
  }
}

DeviceMaker serial_device(const DeviceName& name) {
  name.allow({});
  return [path = name.path](const LineOpener& open, Start start) {
    return std::make_unique<PlateLink>(open(path, 115200), start);
  };
}

}  // namespace hrt::plate
