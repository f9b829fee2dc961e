// What is recorded, and how it stands in a file. plugin/README.md describes the format.
#pragma once

#include <cstdint>
#include <string_view>
#include <variant>

#include "core/retargeter.h"
#include "haptic_retargeting/reach.h"
#include "haptic_retargeting/target.h"
#include "plugin/src/json.h"

namespace hrt::plugin {

struct ConfigSet {
  hrt_session_config config;
};

struct TargetChanged {
  enum class Change : std::uint8_t { added, set, removed };
  Change change;
  std::uint64_t id;
  hrt_target_config config;  ///< not of a removed one
};

struct ReachBegun {
  Reach reach;  ///< as resolved from its targets
};

struct Updated {
  hrt_sample sample;
  hrt_command command;  ///< only if the call succeeded
};

struct ReachEnded {
  hrt_reach_summary summary;  ///< only if the call succeeded
};

/// One call that crossed the boundary.
struct Record {
  hrt_result result = HRT_OK;
  std::variant<ConfigSet, TargetChanged, ReachBegun, Updated, ReachEnded> call;
};

using RecordText = Text<4096>;

/// The first lines of a recording: what it is, what its columns mean, and their names.
std::string_view recording_header();

/// The line of a record, with its line feed: a comment for what configures, a row of the table for the rest.
void write_record(const Record& record, RecordText& out);

/// Comments at a place where rows were lost, and at the end.
inline constexpr std::string_view config_comment = "# config ";
inline constexpr std::string_view lost_comment = "# lost ";
inline constexpr std::string_view end_comment = "# end";

/// Reads a row of the table: what went into the call. What came out of it is not read.
hrt_result read_row(std::string_view line, Record* out);

}  // namespace hrt::plugin
