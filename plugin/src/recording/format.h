// The records of a recording, and their conversion to text and back. plugin/PROCESS.md describes the format.
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

/// Geometry of a reach, seen from its start or, after a retarget, as Retargeter::retarget() returns it.
struct ReachGeometry {
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

/// A target was added, set or removed. Targets are identified by Targets::number().
struct TargetChanged {
  enum class Change : std::uint8_t { added, set, removed };
  Change change;
  std::uint64_t number;
  hrt_target_config config;  ///< unspecified if the target was removed
};

struct InitialPlateOrientation {
  double orientation_deg;
};

struct ReachBegun {
  std::uint32_t flags;
  double plate_orientation_deg;  ///< valid if flags has HRT_REACH_PLATE_ORIENTATION
  std::uint64_t real_number;     ///< Targets::number() of the real target; 0: not a target of this session
  std::uint64_t virtual_number;
  double duration_s;
  ReachGeometry reach;  ///< valid if the call succeeded
};

struct Retargeted {
  std::uint64_t real_number;  ///< as in ReachBegun
  std::uint64_t virtual_number;
  ReachGeometry reach;  ///< valid if the call succeeded
};

struct Touched {
  hrt_contact contact;
};

struct ReachCancelled {};

struct Updated {
  hrt_sample sample;
  hrt_command command;                 ///< valid if the call succeeded
  std::optional<ReachGeometry> reach;  ///< set if the reach waited for the finger and started in this call
};

struct ReachEnded {
  hrt_reach_summary summary;  ///< valid if the call succeeded
};

struct SetupBegun {
  std::uint32_t what;
  hrt_setup_config config;
};

struct SetupUpdated {
  hrt_sample sample;
  hrt_setup_step step;  ///< valid if the call succeeded
};

struct SetupFinished {
  hrt_setup_result result;  ///< valid if the call succeeded
};

struct SetupCancelled {};

/// A call of the C interface with its result, or a part of the state at the beginning of the recording.
struct Record {
  hrt_result result = HRT_OK;
  std::variant<ConfigSet, TargetChanged, InitialPlateOrientation, ReachBegun, Updated, Retargeted, Touched,
               ReachCancelled, ReachEnded, SetupBegun, SetupUpdated, SetupFinished, SetupCancelled>
      call;
};

/// True if the record is a row of the table; other records are comments.
inline bool is_row(const Record& record) {
  return !std::holds_alternative<ConfigSet>(record.call) && !std::holds_alternative<TargetChanged>(record.call) &&
         !std::holds_alternative<InitialPlateOrientation>(record.call) &&
         !std::holds_alternative<SetupBegun>(record.call);
}

using RecordText = JsonText;

inline constexpr std::string_view recording_begin = "# haptic retargeting recording, version 4\n";

/// Returns the lines before the first record: format, explanation, names of the columns.
std::string recording_header();

void write_record(const Record& record, RecordText& out);

inline constexpr std::string_view config_comment = "# config ";
inline constexpr std::string_view target_comment = "# target ";
inline constexpr std::string_view plate_comment = "# plate ";
inline constexpr std::string_view setup_comment = "# setup ";
inline constexpr std::string_view lost_comment = "# lost ";
inline constexpr std::string_view end_comment = "# end ";

/// Writes the last line, with the checksum of all lines before it.
void write_end(std::uint64_t checksum, RecordText& out);

/// Fails unless `line` has the names of the columns.
hrt_result check_column_names(std::string_view line);

/// Reads the input columns and the result of a row, not the output columns.
hrt_result read_row(std::string_view line, Record* out);

/// True if all cells of two rows are equal; doubles are compared bit by bit.
bool is_same_row(std::string_view row, std::string_view other);

/// The next three functions read a comment after its prefix. They do not check the ranges of JSON fields.
hrt_result read_target_changed(std::string_view rest, TargetChanged* out);
hrt_result read_initial_plate_orientation(std::string_view rest, InitialPlateOrientation* out);
hrt_result read_setup_begun(std::string_view rest, SetupBegun* out);

}  // namespace hrt::plugin
