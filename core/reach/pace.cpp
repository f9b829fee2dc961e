#include "core/reach/pace.h"

namespace hrt {

double phase_at(double evenness, double share) {
  double low = 0.0;
  double high = 1.0;
  for (int i = 0; i < 20; ++i) {
    const double middle = 0.5 * (low + high);
    (progress(evenness, middle).share < share ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace hrt
