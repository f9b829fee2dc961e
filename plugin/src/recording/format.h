// The records of a recording and their text form. plugin/PROCESS.md describes the format.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "haptic_retargeting/reach.h"
#include "haptic_retargeting/setup.h"
#include "haptic_retargeting/target.h"
#include "plugin/src/recording/json.h"

namespace hrt::plugin {

/// A reach as targets and configuration make it.
struct AimedReach {
  double real_direction_deg;
  double virtual_direction_deg;
  double real_distance_m;
  double start_right_m;
  double start_away_m;
  double plate_orientation_deg;
};

struct ConfigSet {
  hrt_session_config config;
};

/// Targets are identified by Targets::number(), which is the same in every run and small enough for any reader of
/// tables.
struct TargetChanged {
  enum class Change : std::uint8_t { added, set, removed };
  Change change;
  std::uint64_t number;
  hrt_target_config config;  ///< without meaning if it was removed
};

/// Plate orientation at the start of the recording.
struct PlateStands {
  double orientation_deg;
};

struct ReachBegun {
  std::uint32_t flags;
  double plate_orientation_deg;  ///< valid if flags has HRT_REACH_PLATE_ORIENTATION
  std::uint64_t real_number;     ///< 0: not a target of this session
  std::uint64_t virtual_number;
  double duration_s;
  AimedReach reach;  ///< derived from targets and configuration; only if the call succeeded
};

struct Retargeted {
  std::uint64_t real_number;  ///< as in ReachBegun
  std::uint64_t virtual_number;
  AimedReach reach;  ///< seen from the finger; only if the call succeeded
};

struct Touched {
  hrt_contact contact;
};

struct ReachCancelled {};

struct Updated {
  hrt_sample sample;
  hrt_command command;              ///< only if the call succeeded
  std::optional<AimedReach> reach;  ///< the reach, if it waited for the finger and started in this call
};

struct ReachEnded {
  hrt_reach_summary summary;  ///< only if the call succeeded
};

struct SetupBegun {
  std::uint32_t what;
  hrt_setup_config config;
};

struct SetupUpdated {
  hrt_sample sample;
  hrt_setup_step step;  ///< only if the call succeeded
};

struct SetupFinished {
  hrt_setup_result result;  ///< only if the call succeeded
};

struct SetupCancelled {};

/// A call that was refused because an argument was null or had a wrong struct_size.
struct Refused {
  enum class Argument : std::uint8_t { config, sample, out_command, out_summary, contact };
  Argument argument;
  std::uint32_t struct_size;  ///< given size; without meaning if the struct was null
};

/// A call of the C interface.
struct Record {
  hrt_result result = HRT_OK;
  std::variant<ConfigSet, TargetChanged, PlateStands, ReachBegun, Updated, Retargeted, Touched, ReachCancelled,
               ReachEnded, Refused, SetupBegun, SetupUpdated, SetupFinished, SetupCancelled>
      call;
};

/// A row of the table; other records are comments.
inline bool is_row(const Record& record) {
  return !std::holds_alternative<ConfigSet>(record.call) && !std::holds_alternative<TargetChanged>(record.call) &&
         !std::holds_alternative<PlateStands>(record.call) && !std::holds_alternative<SetupBegun>(record.call);
}

using RecordText = Text<8192>;

/// The first line of a recording.
inline constexpr std::string_view recording_begin = "# haptic retargeting recording, version 4\n";

/// The lines before the first record: format, explanation, names of the columns.
std::string recording_header();

/// Writes one line: a comment if the record configures something, otherwise a row of the table.
void write_record(const Record& record, RecordText& out);

/// Beginnings of comments.
inline constexpr std::string_view config_comment = "# config ";
inline constexpr std::string_view target_comment = "# target ";
inline constexpr std::string_view plate_comment = "# plate ";
inline constexpr std::string_view setup_comment = "# setup ";
inline constexpr std::string_view lost_comment = "# lost ";
inline constexpr std::string_view end_comment = "# end ";

/// Writes the last line, with the checksum of all lines before it.
void write_end(std::uint64_t checksum, RecordText& out);

/// Fails unless the line has the names of all columns, in their order.
hrt_result check_column_names(std::string_view line);

/// Reads the inputs and the result of a row; outputs are not read.
hrt_result read_row(std::string_view line, Record* out);

/// True if all cells of two rows are equal, numbers by their bits.
bool is_same_row(std::string_view row, std::string_view other);

/// Read the rest of a comment about a target, the plate or a set-up. They check everything that does not depend on
/// other lines.
hrt_result read_target_changed(std::string_view rest, TargetChanged* out);
hrt_result read_plate_stands(std::string_view rest, PlateStands* out);
hrt_result read_setup_begun(std::string_view rest, SetupBegun* out);

}  // namespace hrt::plugin
