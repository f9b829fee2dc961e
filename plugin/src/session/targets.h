// The targets of one session.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "core/plate/plate_frame.h"
#include "haptic_retargeting/target.h"
#include "scene/plate_coordinates.h"

namespace hrt::plugin {

/// Targets by id. Ids come from one counter for the whole process: they are never given out twice, and
/// a greater one was added later.
class Targets {
 public:
  Targets();
  hrt_result add(const hrt_target_config& checked_config, std::uint64_t* out_id);
  hrt_result set(std::uint64_t id, const hrt_target_config& checked_config);
  hrt_result remove(std::uint64_t id);
  /// Both are targets of the session.
  void set_served_by(std::uint64_t virtual_id, std::uint64_t real_id) {
    by_id_.at(virtual_id).served_by.value = real_id;
  }

  /// Null if there is none.
  const hrt_target_config* find(std::uint64_t id) const;
  /// 0 if there is none.
  std::uint64_t find(std::string_view name) const;

  const std::map<std::uint64_t, hrt_target_config>& all() const { return by_id_; }
  std::size_t real_count() const { return real_count_; }
  std::size_t virtual_count() const { return by_id_.size() - real_count_; }

  /// A number that stands for one of these targets' ids in recordings: from 1 in a process of one session.
  std::uint64_t number(std::uint64_t id) const { return id - before_first_; }
  /// The number of a target; 0 if there is no such target.
  std::uint64_t number_or_zero(hrt_target target) const { return find(target.value) ? number(target.value) : 0; }

 private:
  std::map<std::uint64_t, hrt_target_config> by_id_;
  std::map<std::string, std::uint64_t, std::less<>> by_name_;
  std::size_t real_count_ = 0;
  std::uint64_t before_first_;  // the last id that was given out before
};

/// Fails naming the first field that is out of its range by itself. Clears what follows the name's zero.
hrt_result check_target_fields(hrt_target_config* config);

/// The same, and fails too if the target is too near to where the session's reaches start.
hrt_result check_target_config(const hrt_session_config& session_config, hrt_target_config* config);

/// A target seen from the start of a reach, in the plane of the plate.
struct TargetView {
  double direction_deg;  ///< in (-180, 180]; 0 at the start itself
  double distance_mm;    ///< >= 0
  bool at_start;         ///< nearer than min_distance_m: the direction is undetermined
};
TargetView view_from(const PlatePoint& start, const hrt_session_config& config, const hrt_target_config& target);

/// The same from where the session's reaches start.
TargetView view(const hrt_session_config& config, const hrt_target_config& target);

/// The targets of a reach.
struct Pair {
  hrt_target_config real;
  hrt_target_config virtual_target;
};

/// Finds a target of the wanted role (0: of either), or fails naming `argument`.
hrt_result find_target(const Targets& targets, const char* argument, hrt_target target, std::uint32_t role,
                       const hrt_target_config** out_config);

/// Copies a real and a virtual target, or fails naming `real_target` or `virtual_target`.
hrt_result find_pair(const Targets& targets, hrt_target real_target, hrt_target virtual_target, Pair* out);

}  // namespace hrt::plugin
