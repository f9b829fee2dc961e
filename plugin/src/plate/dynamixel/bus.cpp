#include "plugin/src/plate/dynamixel/bus.h"

#include "plugin/include/plate_driver/plate_failure.h"

namespace hrt::plate::dynamixel {
namespace {

using namespace std::chrono_literals;

constexpr auto silence_limit = 500ms;
constexpr auto wait_step = 5ms;  // interval between two reads of the serial line
constexpr int max_tries = 10;
// Round trips are measured only for answers with at most this number of parameter bytes: a longer answer takes more
// time than the answer to a command, which has none.
constexpr std::size_t max_timed = 4;

// Returns the number of parameter bytes in the answer to `request`, if the answer has no error.
std::size_t size_of_answer(const Packet& request) {
  constexpr std::size_t model_and_firmware = 3;
  if (request.instruction == Instruction::ping) return model_and_firmware;
  return request.instruction == Instruction::read ? static_cast<std::size_t>(number_at(request.parameters, 2, 2)) : 0;
}

}  // namespace

Packet Bus::read_request(Entry entry) const {
  return {.id = id_,
          .instruction = Instruction::read,
          .parameters = little_endian(entry.address, 2) + little_endian(entry.size, 2)};
}

Packet Bus::write_request(Entry entry, std::int64_t value) const {
  return {.id = id_,
          .instruction = Instruction::write,
          .parameters = little_endian(entry.address, 2) + little_endian(value, entry.size)};
}

std::optional<Packet> Bus::try_once(const Packet& request) {
  send(request);
  while (awaits_answer()) {
    line_->wait(wait_step);
    if (std::optional<Packet> found = answer()) return found;
  }
  discard_late_answer();
  return std::nullopt;
}

Packet Bus::transact(const Packet& request) {
  for (int i = 0; i < max_tries; ++i) {
    const std::optional<Packet> found = try_once(request);
    if (!found) continue;
    const StatusError error = found->status_error();
    if (error == StatusError::none) return *found;
    if (error != StatusError::crc) throw PlateFailure(Fault::protocol, describe(request, error));
    count_refusal();
  }
  throw PlateFailure(Fault::silent, "does not answer; check its cable and supply, and open the plate again");
}

std::int64_t Bus::read(Entry entry) { return number_at(transact(read_request(entry)).parameters, 0, entry.size); }

void Bus::send(const Packet& request) {
  request_ = request;
  asked_ = line_->now();
  is_answered_ = false;
  if (!silent_since_) silent_since_ = asked_;
  ++sequence_;
  if (size_of_answer(request) <= max_timed) round_trips_.sent(asked_, sequence_);
  line_->send(encode(request));
}

// Skips instructions, which some adapters echo to the host, and the answers of other servos.
std::optional<Packet> Bus::answer() {
  std::string bytes;
  line_->receive(bytes);
  reader_.append(bytes);
  while (std::optional<Packet> packet = reader_.next()) {
    if (packet->instruction != Instruction::status || packet->id != id_) continue;
    if (is_answered_) continue;
    if (packet->status_error() == StatusError::none && packet->parameters.size() != size_of_answer(request_)) continue;
    is_answered_ = true;
    silent_since_.reset();
    round_trips_.echoed(line_->now(), sequence_);
    return packet;
  }
  return std::nullopt;
}

bool Bus::has_missed_answer() {
  if (is_answered_ || awaits_answer()) return false;
  abandon_request();
  return true;
}

// Drops a partial packet. If its length field is damaged, it would otherwise take the next answers for its parameters.
void Bus::abandon_request() {
  is_answered_ = true;
  reader_.drop_partial();
}

void Bus::check_silence() const {
  if (silent_since_ && line_->now() - *silent_since_ > silence_limit) throw PlateFailure(Fault::silent, silent_text);
}

// Waits, and drops an answer that arrives late. It would otherwise be taken for the answer to the next request.
void Bus::discard_late_answer() {
  abandon_request();
  for (const auto end = line_->now() + answer_limit; line_->now() < end;) {
    line_->wait(wait_step);
    answer();
  }
}

std::string Bus::describe(const Packet& request, StatusError error) {
  const std::string reason =
      std::string(": ") + name_of(error) + ". Switch the servo's supply off and on, and open the plate again";
  if (request.instruction == Instruction::ping) return "refuses a ping" + reason;
  const std::string address = std::to_string(number_at(request.parameters, 0, 2));
  return (request.instruction == Instruction::read ? "refuses a read of address " : "refuses a write to address ") +
         address + reason;
}

}  // namespace hrt::plate::dynamixel
