// Packets of Dynamixel Protocol 2.0 (ROBOTIS e-manual, "DYNAMIXEL Protocol 2.0"): encoder and decoder.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace hrt::plate::dynamixel {

enum Instruction : std::uint8_t { ping = 0x01, read = 0x02, write = 0x03, status = 0x55 };

/// Error number of a status packet, without its alert bit.
enum class StatusError : std::uint8_t {
  none,
  result_fail,
  instruction,
  crc,
  data_range,
  data_length,
  data_limit,
  access
};
/// Returns the name that the protocol gives to the error; "unknown error" for an unknown number.
const char* name_of(StatusError error);

struct Packet {
  std::uint8_t id = 0;
  std::uint8_t instruction = 0;
  std::uint8_t error = 0;  ///< error of a status packet: StatusError, and the alert bit
  std::string parameters;  ///< without the byte stuffing of the protocol

  static constexpr std::uint8_t alert = 0x80;  ///< the servo has a hardware error
  bool is_alert() const { return (error & alert) != 0; }
  StatusError status_error() const { return static_cast<StatusError>(error & ~alert); }
};

/// Returns the bytes of a packet, with header, byte stuffing and CRC.
std::string encode(const Packet& packet);

/// Converts a signed number to `count` bytes, least significant byte first; number_at() converts it back.
std::string little_endian(std::int64_t value, int count);
std::int64_t number_at(std::string_view bytes, std::size_t at, int count);

/// Splits a stream of bytes into packets, in bounded memory. Skips bytes between packets. After a damaged packet,
/// searches for the next one from the second byte of the damaged one on.
class PacketReader {
 public:
  static constexpr std::size_t max_length = 250;  ///< a packet with a greater length field counts as damaged

  void append(std::string_view bytes) { bytes_ += bytes; }
  /// Returns the next complete packet; nullopt if more bytes are needed.
  std::optional<Packet> next();
  /// Drops an incomplete packet. Call it when the time limit for the rest of the packet has passed.
  void drop_partial();
  /// Number of packets so far with a wrong length or CRC, or dropped by drop_partial().
  std::uint64_t damaged() const { return damaged_; }

 private:
  std::string bytes_;
  std::uint64_t damaged_ = 0;
};

}  // namespace hrt::plate::dynamixel
