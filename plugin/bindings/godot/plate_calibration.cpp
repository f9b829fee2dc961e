// The calibration of the node's user.
#include "plate_node.h"

namespace hrt_godot {

Value PlateNode::begin_calibration(const Value* arguments) {
  hrt_calibration_config config = hrt_calibration_config_init();
  config.goal_direction_deg = to_real(arguments[0]);
  return create_calibration(config);
}

Value PlateNode::begin_calibration_within(const Value* arguments) {
  hrt_calibration_config config = hrt_calibration_config_init();
  config.goal_direction_deg = to_real(arguments[0]);
  config.lower_plate_deg = to_real(arguments[1]);
  config.upper_plate_deg = to_real(arguments[2]);
  config.enough_weight_width = to_real(arguments[3]);
  return create_calibration(config);
}

Value PlateNode::create_calibration(const hrt_calibration_config& config) {
  hrt_calibration calibration{};
  if (!configure() || !ok(hrt_calibration_create(session_, &config, &calibration)))
    return to_godot_error(result_);
  if (calibration_.value) hrt_calibration_destroy(calibration_);
  calibration_ = calibration;
  if (user_.struct_size) before_ = user_;
  user_ = {};
  return int64_t{0};
}

Value PlateNode::get_next_angle(const Value*) {
  double orientation_deg = 0.0;
  uint32_t enough = 0;
  if (!ok(hrt_calibration_next_angle(calibration_, &orientation_deg, &enough))) return Record{};
  return Record{{"plate_orientation_deg", orientation_deg}, {"enough", int64_t{enough}}};
}

Value PlateNode::begin_trial(const Value* arguments) {
  refused_.reset();
  ok(hrt_calibration_begin_trial(calibration_, to_real(arguments[0])));
  return to_godot_error(result_);
}

Value PlateNode::add_trial_sample(const Value* arguments) {
  hrt_sample sample;
  if (finger_sample(arguments, sample)) {
    result_ = hrt_calibration_add_sample(calibration_, &sample);
    if (result_ != HRT_OK) report_sample(reason_of(result_), hrt_last_error());
  }
  return to_godot_error(result_);
}

Value PlateNode::end_trial(const Value*) {
  ok(hrt_calibration_end_trial(calibration_, 1));
  return to_godot_error(result_);
}

Value PlateNode::cancel_trial(const Value*) {
  ok(hrt_calibration_end_trial(calibration_, 0));
  return to_godot_error(result_);
}

Value PlateNode::solve_calibration(const Value*) {
  hrt_calibration_result user = hrt_calibration_result_init();
  if (!ok(hrt_calibration_solve(calibration_, &user))) return Record{};
  user_ = user;
  return to_record(&user_, calibration_fields);
}

Value PlateNode::get_slide(const Value* arguments) {
  hrt_calibration_slide slide = hrt_calibration_slide_init();
  const int64_t number = to_int(arguments[0]);
  const uint32_t wanted = number >= 0 && number < UINT32_MAX ? static_cast<uint32_t>(number) : UINT32_MAX;
  if (!ok(hrt_calibration_get_residual(calibration_, wanted, &slide))) return Record{};
  return to_record(&slide, slide_fields);
}

Value PlateNode::apply_calibration(const Value*) {
  if (!is_fitted(user_.struct_size,
                 "apply_calibration: no calibration is solved; call solve_calibration() first"))
    return to_godot_error(result_);
  if (configure() && ok(hrt_calibration_apply(session_, &user_))) take_changes();
  return to_godot_error(result_);
}

Value PlateNode::compare_calibrations(const Value*) {
  if (!user_.struct_size || !before_.struct_size) {
    engine_.push_error("compare_calibrations: it needs two calibrations of this node that were solved");
    return Record{};
  }
  hrt_calibration_comparison comparison = hrt_calibration_comparison_init();
  if (!ok(hrt_calibration_compare(&before_, &user_, &comparison))) return Record{};
  return to_record(&comparison, comparison_fields);
}

Value PlateNode::end_calibration(const Value*) {
  if (ok(hrt_calibration_destroy(calibration_))) calibration_ = {};
  return to_godot_error(result_);
}

}  // namespace hrt_godot
