// Set-up in one loop: requests touches, rests and slides from the user, detects their completion, and stores the data
// for the fits (setup_fit.h).
#pragma once

#include <array>

#include "core/plate/registration.h"
#include "core/setup/guided_slides.h"
#include "core/setup/mark_touches.h"
#include "core/setup/setup_progress.h"
#include "core/setup/slide_store.h"
#include "core/setup/slide_watch.h"

namespace hrt {

struct SetupConfig {
  static constexpr int max_marks = 8;

  std::uint32_t parts = 0;  ///< SetupPart flags of the parts to do
  /// True: skips a part if the samples lack a field that it requires.
  bool only_possible = false;
  /// Marks in plate coordinates. The first mark is also touched to determine the fingertip's offset.
  std::array<Eigen::Vector3d, max_marks> marks_mm;
  int mark_count = 0;  ///< 3 to max_marks
  int touches_per_mark = 1;
  int check_mark = 0;
  RegistrationConfig registration;
  PlatePoint start;
  std::array<PlatePoint, GuidedSlides::max_objects> guides;  ///< ends of the guides, at the objects
  int guide_count = 0;
  double slide_distance_mm = 100.0;  ///< length of a slide straight ahead
  double lower_plate_deg = -75.0;
  double upper_plate_deg = 75.0;
  double enough_weight_width =
      0.04;             ///< a calibration ends when the 95 % interval of the tactile weight is this narrow
  int max_slides = 40;  ///< at least `first_slides`
  double plate_orientation_deg = 0.0;
};

/// Slides before the first fit, and further slides before each later one.
inline constexpr int first_slides = 16;
inline constexpr int more_slides = 8;

/// Fingertip, registration and guides are dropped after max_rejected_fits rejected fits. Guides are also dropped after
/// max_failed_slides failed attempts at the slides to one object; calibration and retest after that number of
/// successive rejected slides.
inline constexpr int max_rejected_fits = 3;
inline constexpr int max_failed_slides = 6;

/// Allocates at construction only; the time of update() is bounded.
class Setup {
 public:
  explicit Setup(const SetupConfig& config);

  /// Times of samples must not decrease.
  void update(const SetupSample& sample);
  SetupStep step() const;

  const SetupConfig& config() const { return config_; }
  /// SetupPart flags of the pending parts; the lowest one is in progress.
  std::uint32_t left() const { return left_; }
  SetupPart part() const;
  /// True if the current part has all its data or no room for more, or if no part is pending.
  bool finish_is_due() const;
  /// True if the sample has the fields that the current part requires.
  bool can_show(const SetupSample& sample) const;

  /// Ends the current part, and begins the next one.
  void close();
  /// Ends the current part without a result, and drops the parts that need its result.
  void drop(SetupProblem problem, std::string_view reason);
  /// Calibration and retest: requests more slides. Other parts: repeats the part, or drops it after max_rejected_fits
  /// rejected fits.
  void repeat(SetupProblem problem, std::string_view reason);
  std::uint32_t dropped() const { return dropped_; }
  /// The last dropped part. Requires dropped() != 0.
  SetupDrop last_drop() const;
  /// True if no more slides can be requested.
  bool slides_are_full() const;

  const MarkTouches& touches() const { return touches_; }
  const GuidedSlides& guided() const { return guided_; }
  const SlideStore& slides() const { return *slides_; }

 private:
  /// A text of fixed capacity; longer texts are truncated.
  class Reason {
   public:
    void set(std::string_view text) { size_ = text.copy(text_.data(), text_.size()); }
    std::string_view view() const { return {text_.data(), size_}; }

   private:
    std::array<char, 160> text_{};
    std::size_t size_ = 0;
  };

  void begin_part();
  void next_slide();
  void slide(const SetupSample& sample);
  Observed observed() const;
  int done() const;
  bool has_part(std::uint32_t parts) const { return (part() & parts) != 0; }
  void describe_slide(SetupStep* step) const;
  void describe_guide(SetupStep* step) const;

  SetupConfig config_;
  std::uint32_t left_;
  SetupProblem problem_ = SetupProblem::none;
  MarkTouches touches_;
  GuidedSlides guided_;
  SlideWatch watch_;
  std::optional<SlideStore> slides_;
  SetupProgress progress_;
  int rejected_ = 0;  // rejected fits of the current part
  Reason reason_;     // reason of the last rejected fit
  std::uint32_t dropped_ = 0;
  struct Dropped {
    SetupPart part = setup_calibration;
    SetupProblem problem = SetupProblem::none;
    Observed observed;
    Reason reason;
  };
  Dropped last_drop_;
  int wanted_slides_ = first_slides;
  double plate_orientation_deg_;
};

/// Returns the plate angle of slide `i`: -1 is the lower end of the configured range, 1 is the upper end. Sides
/// alternate; no angle repeats within the first `first_slides` slides.
double planned_share(int i);

/// Number of touches for the fingertip's offset: of one mark, each with another orientation of the finger.
inline constexpr int finger_attitudes = 6;

}  // namespace hrt
