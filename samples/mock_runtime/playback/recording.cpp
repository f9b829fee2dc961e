#include "samples/mock_runtime/playback/recording.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstring>
#include <limits>
#include <string_view>

#include "samples/app/text/json_file.h"
#include "samples/mock_runtime/openxr_1_1.h"

namespace hrt::mock {

namespace {

constexpr std::uint64_t max_sessions = 10'000;
constexpr std::size_t max_joints = 64;
constexpr std::size_t max_views = 8;

template <typename Bits>
std::optional<Bits> bits_of(const Json& value) {
  if (!value.is_string()) return std::nullopt;
  const auto& text = value.get_ref<const std::string&>();
  Bits bits = 0;
  const char* end = text.data() + text.size();
  if (text.size() != 2 * sizeof bits || std::from_chars(text.data(), end, bits, 16).ptr != end) return std::nullopt;
  return bits;
}

}  // namespace

// The fields of a record, one after the other.
class Fields {
 public:
  Fields(const Json& record, std::string where) : record_(record), where_(std::move(where)) {
    if (!record.is_array()) refuse(where_, "must be an array");
  }

  const std::string& where() const { return where_; }
  bool more() const { return next_ < record_.size(); }
  void end() const {
    if (more()) refuse(where_, "has too many fields");
  }

  template <typename Integer>
  Integer whole(Integer min, Integer max) {
    const Json& value = next();
    // Beyond the signed range there are only unsigned ones.
    const bool fits = value.is_number_unsigned() ? value.get<std::uint64_t>() <= static_cast<std::uint64_t>(max)
                                                 : value.is_number_integer() && std::is_signed_v<Integer> &&
                                                       value.get<std::int64_t>() >= static_cast<std::int64_t>(min);
    if (!fits || value.get<Integer>() < min || value.get<Integer>() > max) wrong("a whole number in its range");
    return value.get<Integer>();
  }
  template <typename Integer>
  Integer whole() {
    return whole(std::numeric_limits<Integer>::min(), std::numeric_limits<Integer>::max());
  }
  /// One that the playback computes with.
  XrTime time() { return whole<XrTime>(-(XrTime{1} << 61), XrTime{1} << 61); }
  bool boolean() {
    const Json& value = next();
    if (!value.is_boolean()) wrong("true or false");
    return value.get<bool>();
  }
  std::string text() {
    const Json& value = next();
    if (!value.is_string()) wrong("a text");
    return value.get<std::string>();
  }
  double real() {
    const Json& value = next();
    if (const auto bits = bits_of<std::uint64_t>(value)) return std::bit_cast<double>(*bits);
    if (!value.is_number()) wrong("a number");
    return value.get<double>();
  }
  float single() {
    const Json& value = next();
    if (const auto bits = bits_of<std::uint32_t>(value)) return std::bit_cast<float>(*bits);
    if (!value.is_number() || std::abs(value.get<double>()) > static_cast<double>(std::numeric_limits<float>::max()))
      wrong("a number");
    return static_cast<float>(value.get<double>());
  }
  // Braces evaluate from left to right.
  XrVector3f vector() { return {single(), single(), single()}; }
  XrPosef pose() { return {{single(), single(), single(), single()}, vector()}; }
  /// An array: read(fields of it).
  template <typename Read>
  void nested(Read read) {
    Fields inner(next(), where_ + "[" + std::to_string(next_ - 1) + "]");
    read(inner);
    inner.end();
  }
  XrPosef nested_pose() {
    XrPosef result{};
    nested([&](Fields& fields) { result = fields.pose(); });
    return result;
  }

 private:
  const Json& next() {
    if (!more()) refuse(where_, "has too few fields");
    return record_[next_++];
  }
  [[noreturn]] void wrong(const char* what) const {
    refuse(where_ + "[" + std::to_string(next_ - 1) + "]", std::string("must be ") + what);
  }

  const Json& record_;
  std::string where_;
  std::size_t next_ = 0;
};

namespace {

std::size_t read_space(Fields& fields, const Recording& recording) {
  if (recording.spaces.empty()) refuse(fields.where(), "names a space before there is one");
  return fields.whole<std::size_t>(0, recording.spaces.size() - 1);
}

RecordedJoints read_joints(Fields& fields) {
  RecordedJoints joints{fields.boolean(), {}, {}};
  fields.whole<std::int32_t>();
  if (!joints.active) return joints;
  fields.nested([&](Fields& each) {
    while (each.more() && joints.locations.size() < max_joints)
      joints.locations.push_back({each.whole<XrSpaceLocationFlags>(), each.pose(), each.single()});
  });
  if (fields.more())
    fields.nested([&](Fields& each) {
      while (each.more() && joints.velocities.size() < max_joints)
        joints.velocities.push_back({each.whole<XrSpaceVelocityFlags>(), each.vector(), each.vector()});
    });
  return joints;
}

RecordedLocation read_location(Fields& fields) {
  RecordedLocation location{fields.whole<XrSpaceLocationFlags>(), fields.nested_pose(), 0, {}, {}};
  if (!fields.more()) return location;
  location.velocity_flags = fields.whole<XrSpaceVelocityFlags>();
  fields.nested([&](Fields& velocity) {
    location.linear = velocity.vector();
    location.angular = velocity.vector();
  });
  return location;
}

RecordedViews read_views(Fields& fields) {
  RecordedViews result{fields.whole<XrViewStateFlags>(), {}};
  fields.nested([&](Fields& each) {
    while (each.more() && result.views.size() < max_views)
      result.views.push_back(
          {XR_TYPE_VIEW, nullptr, each.pose(), {each.single(), each.single(), each.single(), each.single()}});
  });
  return result;
}

RecordedTruth read_truth(Fields& fields) {
  RecordedTruth truth{};
  fields.nested([&](Fields& numbers) {
    for (double& number : truth.numbers) number = numbers.real();
  });
  fields.nested([&](Fields& tip) { truth.index_tip = tip.vector(); });
  truth.done = fields.boolean();
  return truth;
}

template <typename Enum>
Enum read_enum(Fields& fields) {
  return static_cast<Enum>(fields.whole<std::int32_t>());
}

template <typename Event>
XrEventDataBuffer as_buffer(const Event& event) {
  XrEventDataBuffer buffer{};
  std::memcpy(&buffer, &event, sizeof event);
  return buffer;
}

// None for an event that this runtime does not know.
std::optional<XrEventDataBuffer> read_runtime_event(Fields& fields) {
  const std::string kind = fields.text();
  if (kind == "state")
    return as_buffer(XrEventDataSessionStateChanged{XR_TYPE_EVENT_DATA_SESSION_STATE_CHANGED, nullptr, nullptr,
                                                    read_enum<XrSessionState>(fields), fields.whole<XrTime>()});
  if (kind == "space_change")
    return as_buffer(XrEventDataReferenceSpaceChangePending{
        XR_TYPE_EVENT_DATA_REFERENCE_SPACE_CHANGE_PENDING, nullptr, nullptr, read_enum<XrReferenceSpaceType>(fields),
        fields.whole<XrTime>(), XrBool32{fields.boolean()}, fields.nested_pose()});
  if (kind == "instance_loss")
    return as_buffer(
        XrEventDataInstanceLossPending{XR_TYPE_EVENT_DATA_INSTANCE_LOSS_PENDING, nullptr, fields.whole<XrTime>()});
  if (kind != "other") refuse(fields.where(), "is an event of no known kind");
  fields.whole<std::int32_t>();
  return std::nullopt;
}

StateCall read_call_kind(Fields& fields) {
  const std::string call = fields.text();
  if (call == "begin") return StateCall::begin;
  if (call == "exit") return StateCall::exit;
  if (call != "end") refuse(fields.where(), "must name begin, exit or end");
  return StateCall::end;
}

CallFault read_failure(Fields& fields) {
  CallFault fault{};
  fault.session = fields.whole<std::uint64_t>(1, max_sessions);
  const auto function = find_function(fields.text());
  if (!function) refuse(fields.where(), "names a function that this runtime does not have");
  fault.function = *function;
  fault.call = fields.whole<std::uint64_t>(1, std::numeric_limits<std::uint64_t>::max());
  fault.count = 1;
  fault.result = static_cast<XrResult>(fields.whole<std::int32_t>(std::numeric_limits<std::int32_t>::min(), -1));
  return fault;
}

// What a record of a session adds, by its kind.
using Reader = void (*)(Fields& fields, RecordedSession& in, const Recording& names);

// A time, of what, and what was given then.
template <auto streams, auto read_key, auto read>
void keyed(Fields& fields, RecordedSession& in, const Recording& names) {
  const auto time = fields.whole<XrTime>();
  auto& stream = (in.*streams)[read_key(fields, names)];
  stream.emplace(time, read(fields));
}

constexpr auto hand_only = [](Fields& fields, const Recording&) { return fields.whole<int>(); };
constexpr auto hand_and_space = [](Fields& fields, const Recording& names) {
  return std::pair{fields.whole<int>(), read_space(fields, names)};
};
constexpr auto two_spaces = [](Fields& fields, const Recording& names) {
  return std::pair{read_space(fields, names), read_space(fields, names)};
};

constexpr std::pair<std::string_view, Reader> session_readers[] = {
    {"spaces",
     [](Fields& fields, RecordedSession& in, const Recording&) {
       auto& types = in.spaces.emplace();
       fields.nested([&](Fields& each) {
         while (each.more()) types.push_back(read_enum<XrReferenceSpaceType>(each));
       });
     }},
    {"call", [](Fields& fields, RecordedSession& in, const Recording&) { in.calls.push_back(read_call_kind(fields)); }},
    {"frame",
     [](Fields& fields, RecordedSession& in, const Recording&) {
       in.frames.push_back({fields.time(), fields.whole<XrDuration>(), fields.boolean()});
     }},
    {"converted", [](Fields& fields, RecordedSession& in, const Recording&) { in.converted.push_back(fields.time()); }},
    {"event",
     [](Fields& fields, RecordedSession& in, const Recording&) {
       RecordedEvent event{fields.whole<std::size_t>(), fields.whole<std::size_t>(), {}};
       const auto buffer = read_runtime_event(fields);
       if (!buffer) return;
       event.buffer = *buffer;
       in.events.push_back(event);
     }},
    {"plate",
     [](Fields& fields, RecordedSession& in, const Recording&) {
       const auto time = fields.whole<XrTime>();
       in.plate_deg.emplace(time, fields.real());
     }},
    {"joints", keyed<&RecordedSession::joints, hand_and_space, read_joints>},
    {"located", keyed<&RecordedSession::locations, two_spaces, read_location>},
    {"views", keyed<&RecordedSession::views, read_space, read_views>},
    {"truth", keyed<&RecordedSession::truths, hand_only, read_truth>}};

}  // namespace

RecordedSession& Recording::session(std::uint64_t number, const std::string& where) {
  if (number < 1 || number > max_sessions) refuse(where, "has no number of a session");
  if (sessions.size() < number) sessions.resize(number);
  return sessions[number - 1];
}

void Recording::add(const Json& record) {
  Fields fields(record, "playback.records[" + std::to_string(records_++) + "]");
  const std::string kind = fields.text();
  if (kind == "instance") {
    runtime = fields.text();
    version = fields.whole<XrVersion>();
    fields.nested([&](Fields& names) {
      while (names.more()) extensions.insert(names.text());
    });
  } else if (kind == "system") {
    system = fields.text();
    hand_tracking = fields.boolean();
  } else if (kind == "failed") {
    failures.push_back(read_failure(fields));
  } else if (kind == "reference_space") {
    spaces.push_back({read_enum<XrReferenceSpaceType>(fields), fields.nested_pose()});
  } else {
    const auto reader = std::find_if(std::begin(session_readers), std::end(session_readers),
                                     [&](const auto& each) { return each.first == kind; });
    if (reader == std::end(session_readers)) refuse(fields.where(), "is a record of no known kind");
    RecordedSession& in = session(fields.whole<std::uint64_t>(), fields.where());
    reader->second(fields, in, *this);
  }
  fields.end();
}

}  // namespace hrt::mock
