#include "plugin/include/plate_driver/dynamixel_packet.h"

#include <algorithm>
#include <array>

#include "plugin/include/plate_driver/crc16.h"

namespace hrt::plate::dynamixel {
namespace {

using namespace std::string_view_literals;

constexpr std::string_view header = "\xFF\xFF\xFD\x00"sv;
constexpr std::string_view pattern = "\xFF\xFF\xFD"sv;  // within a packet, encode() inserts another FD after it
constexpr std::size_t before_instruction = 7;           // bytes of header, id and length
constexpr std::size_t crc_size = 2;
constexpr std::size_t min_length = 3;  // one byte for the instruction, two for the CRC

std::uint8_t byte_at(std::string_view bytes, std::size_t at) { return static_cast<std::uint8_t>(bytes[at]); }

std::string stuffed(std::string_view plain) {
  std::string bytes;
  for (const char byte : plain) {
    bytes += byte;
    if (bytes.ends_with(pattern)) bytes += '\xFD';
  }
  return bytes;
}

// Removes the byte stuffing. Returns nullopt if `pattern` occurs without the inserted FD.
std::optional<std::string> unstuffed(std::string_view bytes) {
  std::string plain;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    plain += bytes[i];
    if (!plain.ends_with(pattern)) continue;
    if (i + 1 == bytes.size() || bytes[i + 1] != '\xFD') return std::nullopt;
    ++i;
  }
  return plain;
}

std::optional<Packet> decoded(std::string_view bytes) {
  const std::size_t crc_at = bytes.size() - crc_size;
  if (little_endian(crc16_umts(bytes.data(), crc_at), 2) != bytes.substr(crc_at)) return std::nullopt;
  const auto content = unstuffed(bytes.substr(before_instruction, crc_at - before_instruction));
  if (!content) return std::nullopt;
  Packet packet{.id = byte_at(bytes, 4), .instruction = byte_at(*content, 0)};
  const std::size_t fixed = packet.instruction == status ? 2 : 1;
  if (content->size() < fixed) return std::nullopt;
  if (packet.instruction == status) packet.error = byte_at(*content, 1);
  packet.parameters = content->substr(fixed);
  return packet;
}

}  // namespace

const char* name_of(StatusError error) {
  static constexpr std::array names = {"no error",         "result fail",       "instruction error", "CRC error",
                                       "data range error", "data length error", "data limit error",  "access error"};
  const auto number = static_cast<std::size_t>(error);
  return number < names.size() ? names[number] : "unknown error";
}

std::string encode(const Packet& packet) {
  std::string content(1, static_cast<char>(packet.instruction));
  if (packet.instruction == status) content += static_cast<char>(packet.error);
  content = stuffed(content + packet.parameters);
  std::string bytes(header);
  bytes += static_cast<char>(packet.id);
  bytes += little_endian(static_cast<std::int64_t>(content.size() + crc_size), 2);
  bytes += content;
  return bytes + little_endian(crc16_umts(bytes.data(), bytes.size()), 2);
}

std::string little_endian(std::int64_t value, int count) {
  std::string bytes;
  for (int i = 0; i < count; ++i) bytes += static_cast<char>((static_cast<std::uint64_t>(value) >> (8 * i)) & 0xFFU);
  return bytes;
}

// The number is in two's complement: the highest bit of its last byte is the sign.
std::int64_t number_at(std::string_view bytes, std::size_t at, int count) {
  std::uint64_t value = 0;
  for (int i = count - 1; i >= 0; --i) value = value << 8 | byte_at(bytes, at + static_cast<std::size_t>(i));
  const std::uint64_t sign = std::uint64_t{1} << (8 * count - 1);
  return static_cast<std::int64_t>((value ^ sign) - sign);
}

void PacketReader::drop_partial() {
  if (bytes_.size() < header.size()) return;
  ++damaged_;
  bytes_.erase(0, 1);
}

std::optional<Packet> PacketReader::next() {
  for (;;) {
    const std::size_t at = bytes_.find(header);
    if (at == std::string::npos) {  // the last bytes may be the start of a header
      bytes_.erase(0, bytes_.size() - std::min(bytes_.size(), header.size() - 1));
      return std::nullopt;
    }
    bytes_.erase(0, at);
    if (bytes_.size() < before_instruction) return std::nullopt;
    const std::size_t length = byte_at(bytes_, 5) | std::size_t{byte_at(bytes_, 6)} << 8;
    const bool possible = length >= min_length && length <= max_length;
    if (possible && bytes_.size() < before_instruction + length) return std::nullopt;
    if (possible) {
      const std::size_t size = before_instruction + length;
      if (auto packet = decoded(std::string_view(bytes_).substr(0, size))) {
        bytes_.erase(0, size);
        return packet;
      }
    }
    ++damaged_;
    bytes_.erase(0, 1);
  }
}

}  // namespace hrt::plate::dynamixel
