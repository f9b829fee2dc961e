// The only system, a head-mounted display: its properties, blend modes and views.
#include <cstdio>

#include "samples/mock_runtime/abi/structure.h"
#include "samples/mock_runtime/api/instance.h"

namespace hrt::mock {

void require_system(XrSystemId system) {
  require(system == the_system, XR_ERROR_SYSTEM_INVALID, "systemId is {}; must be {}, which xrGetSystem returns",
          system, the_system);
}

void require_view_configuration(XrViewConfigurationType type) {
  require(type == XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO, XR_ERROR_VIEW_CONFIGURATION_TYPE_UNSUPPORTED,
          "view configuration {} is not supported; must be XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO", name_of(type));
}

void xrGetSystem(Instance&, const XrSystemGetInfo* info, XrSystemId* system) {
  require(info->formFactor == XR_FORM_FACTOR_HEAD_MOUNTED_DISPLAY, XR_ERROR_FORM_FACTOR_UNSUPPORTED,
          "formFactor is {}; must be XR_FORM_FACTOR_HEAD_MOUNTED_DISPLAY", name_of(info->formFactor));
  *system = the_system;
}

void xrGetSystemProperties(Instance& instance, XrSystemId system, XrSystemProperties* properties) {
  require_system(system);
  properties->systemId = system;
  properties->vendorId = 0;
  std::snprintf(properties->systemName, sizeof(properties->systemName), "HRTX ridged plate, simulated");
  properties->graphicsProperties = {max_image_size, max_image_size, XR_MIN_COMPOSITION_LAYERS_SUPPORTED};
  properties->trackingProperties = {XR_TRUE, XR_TRUE};
  if (auto* hands = chained<XrSystemHandTrackingPropertiesEXT>(properties->next);
      hands != nullptr && instance.enabled(Extension::hand_tracking))
    hands->supportsHandTracking = runtime().script.hand_tracking ? XR_TRUE : XR_FALSE;
}

void xrEnumerateEnvironmentBlendModes(Instance&, XrSystemId system, XrViewConfigurationType type,
                                      std::uint32_t capacity, std::uint32_t* count, XrEnvironmentBlendMode* modes) {
  require_system(system);
  require_view_configuration(type);
  two_call(std::array{XR_ENVIRONMENT_BLEND_MODE_OPAQUE}, capacity, count, modes);
}

void xrEnumerateViewConfigurations(Instance&, XrSystemId system, std::uint32_t capacity, std::uint32_t* count,
                                   XrViewConfigurationType* types) {
  require_system(system);
  two_call(std::array{XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO}, capacity, count, types);
}

void xrGetViewConfigurationProperties(Instance&, XrSystemId system, XrViewConfigurationType type,
                                      XrViewConfigurationProperties* properties) {
  require_system(system);
  require_view_configuration(type);
  properties->viewConfigurationType = type;
  properties->fovMutable = XR_FALSE;
}

void xrEnumerateViewConfigurationViews(Instance&, XrSystemId system, XrViewConfigurationType type,
                                       std::uint32_t capacity, std::uint32_t* count, XrViewConfigurationView* views) {
  require_system(system);
  require_view_configuration(type);
  two_call(std::array{0, 1}, capacity, count, views, [](XrViewConfigurationView& view, int) {
    view.recommendedImageRectWidth = view.recommendedImageRectHeight = view_image_size;
    view.maxImageRectWidth = view.maxImageRectHeight = max_image_size;
    view.recommendedSwapchainSampleCount = 1;
    view.maxSwapchainSampleCount = 1;
  });
}

}  // namespace hrt::mock
