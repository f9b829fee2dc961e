#pragma once

#include <openxr/openxr.h>

#include <deque>

#include "samples/mock_runtime/api/actions.h"
#include "samples/mock_runtime/api/runtime.h"
#include "samples/mock_runtime/extensions.h"
#include "samples/mock_runtime/input/paths.h"
#include "samples/mock_runtime/world/clock.h"

namespace hrt::mock {

/// The only system, a head-mounted display.
inline constexpr XrSystemId the_system = 1;

/// The instance; at most one exists.
class Instance : public Object {
 public:
  static constexpr XrObjectType object_type = XR_OBJECT_TYPE_INSTANCE;

  Instance(Object* parent, Clock::Kind kind) : Object(object_type, parent), clock(kind) {}

  bool enabled(Extension extension) const { return extensions_[static_cast<std::size_t>(extension)]; }
  bool version_1_1() const { return enabled(Extension::version_1_1); }
  SourceSet sources() const { return {version_1_1(), enabled(Extension::palm_pose)}; }
  void enable(const char* name);
  void enable_version_1_1() { extensions_.set(static_cast<std::size_t>(Extension::version_1_1)); }

  template <typename Event>
  void push_event(const Event& event) {
    static_assert(sizeof(Event) <= sizeof(XrEventDataBuffer));
    XrEventDataBuffer buffer{};
    __builtin_memcpy(&buffer, &event, sizeof(event));
    events.push_back(buffer);
  }

  Clock clock;
  std::deque<XrEventDataBuffer> events;  ///< oldest first
  PathTable paths;
  SuggestedBindings suggestions;

 private:
  ExtensionSet extensions_;
};

void require_system(XrSystemId system);

}  // namespace hrt::mock
