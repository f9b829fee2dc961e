#include "core/tracker/recent_places.h"

#include <algorithm>

namespace hrt {
namespace {

// Positions that come faster than this are averaged: a finger moves by less than 2 mm meanwhile.
constexpr double min_spacing_s = 0.004;

}  // namespace

bool RecentPlaces::add(double time_s, const PlatePoint& position) {
  if (count_ > 0 && time_s - (*this)[0].time_s < min_spacing_s) {
    ++merged_;
    PlatePoint& last = places_[static_cast<std::size_t>(last_)].position;
    last.right_mm += (position.right_mm - last.right_mm) / merged_;
    last.away_mm += (position.away_mm - last.away_mm) / merged_;
    return false;
  }
  last_ = (last_ + 1) % capacity;
  places_[static_cast<std::size_t>(last_)] = {time_s, position};
  count_ = std::min(count_ + 1, capacity);
  merged_ = 1;
  return true;
}

PlatePoint RecentPlaces::mean_of_last(int places) const {
  PlatePoint mean{0.0, 0.0};
  for (int i = 0; i < places; ++i) {
    mean.right_mm += (*this)[i].position.right_mm / places;
    mean.away_mm += (*this)[i].position.away_mm / places;
  }
  return mean;
}

}  // namespace hrt
