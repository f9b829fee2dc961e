// How the calls of a set-up stand in a recording.
#pragma once

#include "plugin/src/recording/row.h"

namespace hrt::plugin {

void write(const SetupBegun& begun, hrt_result result, RecordText& out);
void write(const SetupUpdated& updated, hrt_result result, RecordText& out);
void write(const SetupFinished& finished, hrt_result result, RecordText& out);
void write(const SetupCancelled& cancelled, hrt_result result, RecordText& out);

bool is_setup_call(std::string_view call);
hrt_result read_setup_call(const Cells& cells, Record* out);

}  // namespace hrt::plugin
