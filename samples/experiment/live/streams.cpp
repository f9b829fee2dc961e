#include "samples/experiment/live/streams.h"

#include <dlfcn.h>

#include <algorithm>
#include <iterator>
#include <limits>

#include "samples/members.h"

namespace hrt::experiment {
namespace {

constexpr const char* channels[] = {"x_m", "y_m", "z_m", "qx", "qy", "qz", "qw", "felt_deg", "plate_deg"};
constexpr std::int32_t buffered_s = 360;  // liblsl's own default
constexpr std::size_t longest_text = 100;
constexpr double now = 0.0;  // as liblsl has it
constexpr std::int32_t at_once = 1;

}  // namespace

void* LabStreams::find(const char* function) const {
  void* const found = dlsym(library_, function);
  if (found == nullptr) throw Refusal(std::string("--lsl: liblsl has no ") + function);
  return found;
}

// Of liblsl's C interface, whose parameters have just these types.
template <typename Result, typename... Arguments>
Result LabStreams::call(const char* function, Arguments... arguments) const {
  return reinterpret_cast<Result (*)(Arguments...)>(find(function))(arguments...);
}

LabStreams::LabStreams(const std::string& source) {
  for (const char* name : {"liblsl.so.2", "liblsl.so"})
    if (library_ == nullptr) library_ = dlopen(name, RTLD_NOW | RTLD_LOCAL);
  if (library_ == nullptr) throw Refusal("--lsl: there is no liblsl.so");
  destroy_ = reinterpret_cast<void (*)(void*)>(find("lsl_destroy_outlet"));
  finger_ = outlet("HapticRetargeting", "MoCap", source);
  events_ = outlet("HapticRetargetingEvents", "Markers", source);
}

LabStreams::~LabStreams() {
  destroy_(finger_);
  destroy_(events_);
}

void* LabStreams::outlet(const char* name, const char* type, const std::string& source) const {
  constexpr int floats = 1, texts = 3;
  const bool is_finger = type == std::string("MoCap");
  const auto count = static_cast<std::int32_t>(is_finger ? std::size(channels) : 1);
  void* const info = call<void*>("lsl_create_streaminfo", name, type, count, 0.0, is_finger ? floats : texts,
                                 (source + " " + type).c_str());
  void* const about = call<void*>("lsl_append_child", call<void*>("lsl_get_desc", info), "channels");
  for (std::int32_t i = 0; is_finger && i < count; ++i)
    call<void*>("lsl_append_child_value", call<void*>("lsl_append_child", about, "channel"), "label", channels[i]);
  void* const made = call<void*>("lsl_create_outlet", info, std::int32_t{0}, buffered_s);
  call<void>("lsl_destroy_streaminfo", info);
  return made;
}

void LabStreams::frame(const reach::Fingertip& tip, std::optional<double> felt_deg,
                       std::optional<double> plate_deg) const {
  float values[std::size(channels)];
  std::fill(std::begin(values), std::end(values), std::numeric_limits<float>::quiet_NaN());
  if (tip.tracked) std::copy(tip.position_m.begin(), tip.position_m.end(), values);
  if (tip.tracked && tip.rotation) std::copy(tip.rotation->begin(), tip.rotation->end(), values + 3);
  if (felt_deg) values[7] = static_cast<float>(*felt_deg);
  if (plate_deg) values[8] = static_cast<float>(*plate_deg);
  call<std::int32_t>("lsl_push_sample_ftp", finger_, static_cast<const float*>(values), now, at_once);
}

void LabStreams::mark(const Event& event) const {
  nlohmann::json marker{{"number", event.number}, {"event", event.name}};
  for (const auto& [name, value] : event.data.items())
    if (!value.is_structured() && (!value.is_string() || value.get_ref<const std::string&>().size() <= longest_text))
      marker[name] = value;
  const std::string text = marker.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  const char* sample = text.c_str();
  call<std::int32_t>("lsl_push_sample_strtp", events_, &sample, now, at_once);
}

}  // namespace hrt::experiment
