#include "samples/study/cli/part.h"

#include <charconv>
#include <optional>

#include "samples/study/cli/arguments.h"

namespace hrt::study {
namespace {

constexpr std::uint64_t max_parts = 1'000'000;

std::optional<Part> parse_part(const std::string& text) {
  Part part;
  const char* const end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, part.number);
  if (first.ec != std::errc() || first.ptr == end || *first.ptr != '/') return std::nullopt;
  const auto second = std::from_chars(first.ptr + 1, end, part.count);
  if (second.ec != std::errc() || second.ptr != end) return std::nullopt;
  if (part.number < 1 || part.number > part.count || part.count > max_parts) return std::nullopt;
  return part;
}

}  // namespace

std::string part_words(const std::string& rows) {
  return "\n--part i/n does the i-th of n shares of the " + rows +
         R"(, with the numbers of the whole.
Part 1 alone has the header: 'cat' of all parts in order is the whole. A part that was stopped leaves no
file: do it again. samples/study/cluster/part is for clusters and many machines.
)";
}

void add_part(CLI::App& command, Part* part) {
  add_value(command, "--part", "i/n, whole numbers with 1 <= i <= n <= " + std::to_string(max_parts), "1/1",
            "Which part of how many to do.", [part](const std::string& text) {
              const std::optional<Part> parsed = parse_part(text);
              if (parsed) *part = *parsed;
              return parsed.has_value();
            });
}

}  // namespace hrt::study
