#include <memory>
#include <stdexcept>
#include <string>
#include <system_error>

#include "generated/plate_fields.h"
#include "haptic_retargeting/plate.h"
#include "plugin/src/abi/checks.h"
#include "plugin/src/abi/entry.h"
#include "plugin/src/plate/plate_driver.h"

using namespace hrt::plugin;
using hrt::plate::PlateDriver;

// Applications are compiled with this layout. A later version may only append fields to a struct.
static_assert(sizeof(hrt_plate_options) == 16);
static_assert(sizeof(hrt_plate_report) == 480);
static_assert(offsetof(hrt_plate_report, description) == 96);

namespace {

constexpr std::size_t max_plates = 16;
constexpr std::uint8_t plates_kind = 'p';
constexpr std::size_t max_name = 1024;

using Plates = HandleTable<PlateDriver, max_plates, plates_kind>;
Plates plates("plate");

hrt_result read_options(const hrt_plate_options* given, hrt_plate_options* options) {
  HRT_RETURN_IF_FAILED(read_configuration("options", given, options));
  return check_fields(*options);
}

// Returns "/dev/ttyUSB0" for "dynamixel:/dev/ttyUSB0?id=1".
std::string path_of(std::string_view device) {
  const std::string_view rest = device.substr(device.find(':') + 1);
  return std::string(rest.substr(0, rest.find('?')));
}

hrt_result check_process(const PlateDriver& driver) {
  if (!driver.is_inherited()) return HRT_OK;
  return fail(
      HRT_ERROR_WRONG_STATE,
      "the plate was opened by the parent of this process, before the fork; close the plate here and open it again");
}

hrt_result check_ready(const PlateDriver& driver) {
  HRT_RETURN_IF_FAILED(check_process(driver));
  const hrt_plate_report report = driver.report();
  if (report.state == HRT_PLATE_STATE_READY) return HRT_OK;
  if (report.state == HRT_PLATE_STATE_OPENING)
    return fail(HRT_ERROR_WRONG_STATE, "the plate is being opened; wait until its state is READY");
  return fail(HRT_ERROR_WRONG_STATE, std::string_view(report.message));
}

hrt_result check_homed(const PlateDriver& driver) {
  if (driver.homes() || (driver.report().flags & HRT_PLATE_REPORT_UNHOMED) == 0) return HRT_OK;
  return fail(HRT_ERROR_WRONG_STATE,
              "the plate orientation is unknown (not homed); open the plate with hrt_plate_options::homing "
              "HRT_PLATE_HOMING_SLOW, and keep fingers off while the plate is homed");
}

}  // namespace

hrt_result hrt_plate_open(const char* device, const hrt_plate_options* options, hrt_plate* out_plate) noexcept {
  return guarded("hrt_plate_open", [&]() -> hrt_result {
    if (!device) return fail_of_null("device");
    if (!out_plate) return fail_of_null("out_plate");
    const std::string_view name(device);
    if (name.size() > max_name)
      return fail(HRT_ERROR_OUT_OF_RANGE, "device has ", name.size(), " bytes; allowed: at most ", max_name);
    hrt_plate_options checked;
    HRT_RETURN_IF_FAILED(read_options(options, &checked));
    hrt::plate::DeviceMaker maker;
    std::optional<hrt::plate::PlateFile> file;
    try {
      if (hrt::plate::is_plate_file(name)) file = hrt::plate::read_plate_file(device);
      maker = hrt::plate::device_named(file ? file->device : name);
    } catch (const std::invalid_argument& wrong) {
      return fail(HRT_ERROR_OUT_OF_RANGE, wrong.what());
    } catch (const std::system_error& error) {
      return fail(HRT_ERROR_SYSTEM, error.what(), "; check its name and its permissions");
    }
    const std::string path = path_of(file ? file->device : name);
    auto driver =
        std::make_unique<PlateDriver>(std::move(maker), hrt::plate::open_serial_line, path, std::move(file), checked);
    const std::uint64_t handle = plates.insert(std::move(driver));
    if (handle == 0)
      return fail(HRT_ERROR_LIMIT_REACHED, "there are ", max_plates, " plates, the maximum; close one first");
    out_plate->value = handle;
    return HRT_OK;
  });
}

hrt_result hrt_plate_set(hrt_plate plate, double orientation_deg) noexcept {
  return plates.with("hrt_plate_set", plate.value, [&](PlateDriver& driver) -> hrt_result {
    HRT_RETURN_IF_FAILED(check_value("orientation_deg", Fields<hrt_sample>::plate_orientation_deg, orientation_deg));
    HRT_RETURN_IF_FAILED(check_ready(driver));
    HRT_RETURN_IF_FAILED(check_homed(driver));
    driver.set(orientation_deg);
    return HRT_OK;
  });
}

hrt_result hrt_plate_stop(hrt_plate plate) noexcept {
  return plates.with("hrt_plate_stop", plate.value, [&](PlateDriver& driver) -> hrt_result {
    HRT_RETURN_IF_FAILED(check_ready(driver));
    driver.stop();
    return HRT_OK;
  });
}

hrt_result hrt_plate_get(hrt_plate plate, hrt_plate_report* out_report) noexcept {
  return plates.with("hrt_plate_get", plate.value, [&](const PlateDriver& driver) -> hrt_result {
    HRT_RETURN_IF_FAILED(check_output("out_report", out_report));
    HRT_RETURN_IF_FAILED(check_process(driver));
    write_struct(driver.report(), out_report);
    return HRT_OK;
  });
}

hrt_result hrt_plate_close(hrt_plate plate) noexcept {
  if (plate.value == 0) return HRT_OK;
  return plates.destroy("hrt_plate_close", plate.value);
}

const char* hrt_plate_last_error() noexcept { return thread_error.text.c_str(); }
