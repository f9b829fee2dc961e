// What is recorded, and how it stands in a file. plugin/README.md describes the format.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/reach/reach.h"
#include "haptic_retargeting/reach.h"
#include "haptic_retargeting/setup.h"
#include "haptic_retargeting/target.h"
#include "plugin/src/recording/json.h"

namespace hrt::plugin {

struct ConfigSet {
  hrt_session_config config;
};

/// Targets have the numbers that Targets::number() gives them: the same in every run, and small enough for
/// any reader of tables.
struct TargetChanged {
  enum class Change : std::uint8_t { added, set, removed };
  Change change;
  std::uint64_t number;
  hrt_target_config config;  ///< not of a removed one
};

/// Where the plate stands before anything happens.
struct PlateStands {
  double orientation_deg;
};

struct ReachBegun {
  std::uint32_t flags;
  double plate_orientation_deg;  ///< if flags say that it is given
  std::uint64_t real_number;     ///< 0: none of this session's targets
  std::uint64_t virtual_number;
  double duration_s;
  Reach reach;  ///< what targets and configuration make of it; only if the call succeeded
};

struct Retargeted {
  std::uint64_t real_number;  ///< as of ReachBegun
  std::uint64_t virtual_number;
  Reach reach;  ///< as seen from where the finger is; only if the call succeeded
};

struct Touched {
  hrt_contact contact;
};

struct ReachCancelled {};

struct Updated {
  hrt_sample sample;
  hrt_command command;         ///< only if the call succeeded
  std::optional<Reach> reach;  ///< of the call in which a reach that awaited the finger has started there
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

/// A call of which an argument was null or had a size that is none: nothing of it was read.
struct Refused {
  enum class Argument : std::uint8_t { config, sample, out_command, out_summary, contact };
  Argument argument;
  std::uint32_t struct_size;  ///< as given, unless it was null
};

/// One call that crossed the boundary.
struct Record {
  hrt_result result = HRT_OK;
  std::variant<ConfigSet, TargetChanged, PlateStands, ReachBegun, Updated, Retargeted, Touched, ReachCancelled,
               ReachEnded, Refused, SetupBegun, SetupUpdated, SetupFinished, SetupCancelled>
      call;
};

using RecordText = Text<8192>;

/// The first line of a recording.
inline constexpr std::string_view recording_begin = "# haptic retargeting recording, version 4\n";

/// The lines before the first record: what it is, what its columns mean, and their names.
std::string recording_header();

/// The line of a record, with its line feed: a comment for what configures, a row of the table for the rest.
void write_record(const Record& record, RecordText& out);

/// What comments begin with.
inline constexpr std::string_view config_comment = "# config ";
inline constexpr std::string_view target_comment = "# target ";
inline constexpr std::string_view plate_comment = "# plate ";
inline constexpr std::string_view setup_comment = "# setup ";
inline constexpr std::string_view lost_comment = "# lost ";
inline constexpr std::string_view end_comment = "# end ";

/// The last line: a checksum of all before it.
void write_end(std::uint64_t checksum, RecordText& out);

/// Fails unless the line has the names of all columns, in their order.
hrt_result check_column_names(std::string_view line);

/// Reads the inputs and the result of a row; outputs are not read.
hrt_result read_row(std::string_view line, Record* out);

/// Whether all cells of two rows are equal, numbers by their bits.
bool is_same_row(std::string_view row, std::string_view other);

/// Reads the rest of a comment about a target, the plate or a set-up. Checked except for what depends on
/// others.
hrt_result read_target_changed(std::string_view rest, TargetChanged* out);
hrt_result read_plate_stands(std::string_view rest, PlateStands* out);
hrt_result read_setup_begun(std::string_view rest, SetupBegun* out);

}  // namespace hrt::plugin
