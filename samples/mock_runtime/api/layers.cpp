// Composition layers: specification, "Compositing". Projections and quads.
#include "samples/mock_runtime/abi/two_call.h"
#include "samples/mock_runtime/api/space.h"
#include "samples/mock_runtime/api/swapchain.h"

namespace hrt::mock {
namespace {

const XrCompositionLayerProjection& as_projection(const XrCompositionLayerBaseHeader& layer) {
  return reinterpret_cast<const XrCompositionLayerProjection&>(layer);
}
const XrCompositionLayerQuad& as_quad(const XrCompositionLayerBaseHeader& layer) {
  return reinterpret_cast<const XrCompositionLayerQuad&>(layer);
}

void require_image(const XrSwapchainSubImage& image, const Session& session) {
  const auto& swapchain = runtime().registry.get<Swapchain>(image.swapchain);
  require(swapchain.parent() == &session, XR_ERROR_VALIDATION_FAILURE,
          "the swapchain of a layer is of another session");
  require(swapchain.released.has_value(), XR_ERROR_LAYER_INVALID, "no image of a layer's swapchain has been released");
  const XrRect2Di& part = image.imageRect;
  const auto inside = [](std::int32_t offset, std::int32_t extent, std::uint32_t size) {
    return offset >= 0 && extent > 0 && std::int64_t{offset} + extent <= std::int64_t{size};
  };
  require(inside(part.offset.x, part.extent.width, swapchain.info.width) &&
              inside(part.offset.y, part.extent.height, swapchain.info.height),
          XR_ERROR_SWAPCHAIN_RECT_INVALID, "imageRect is not within the images");
  require(image.imageArrayIndex < swapchain.info.arraySize, XR_ERROR_VALIDATION_FAILURE,
          "imageArrayIndex is not below arraySize");
}

void require_projection(const XrCompositionLayerProjection& layer, const Session& session) {
  require(layer.viewCount == 2 && layer.views != nullptr, XR_ERROR_VALIDATION_FAILURE,
          "a projection layer has two views");
  for (std::uint32_t i = 0; i < 2; ++i) {
    const XrCompositionLayerProjectionView& view = layer.views[i];
    require_struct(&view);
    checked_pose(view.pose);
    require_image(view.subImage, session);
  }
}

void require_quad(const XrCompositionLayerQuad& layer, const Session& session) {
  checked_pose(layer.pose);
  require(layer.eyeVisibility >= XR_EYE_VISIBILITY_BOTH && layer.eyeVisibility <= XR_EYE_VISIBILITY_RIGHT,
          XR_ERROR_VALIDATION_FAILURE, "no such eyeVisibility");
  require_image(layer.subImage, session);
}

}  // namespace

void require_layers(const XrFrameEndInfo& info, const Session& session) {
  require(info.layerCount <= XR_MIN_COMPOSITION_LAYERS_SUPPORTED, XR_ERROR_LAYER_LIMIT_EXCEEDED, "too many layers");
  require(info.layerCount == 0 || info.layers != nullptr, XR_ERROR_LAYER_INVALID, "layers is null");
  for (std::uint32_t i = 0; i < info.layerCount; ++i) {
    const XrCompositionLayerBaseHeader* layer = info.layers[i];
    require(layer != nullptr, XR_ERROR_LAYER_INVALID, "a layer is null");
    const bool projects = layer->type == XR_TYPE_COMPOSITION_LAYER_PROJECTION;
    require(projects || layer->type == XR_TYPE_COMPOSITION_LAYER_QUAD, XR_ERROR_LAYER_INVALID,
            "layers are projections and quads");
    space_of(session, layer->space);
    if (session.graphics == nullptr) continue;
    if (projects)
      require_projection(as_projection(*layer), session);
    else
      require_quad(as_quad(*layer), session);
  }
}

Picture picture_of_eye(const XrFrameEndInfo& info, std::uint32_t eye) {
  Picture picture(view_image_size, view_image_size);
  for (std::uint32_t i = 0; i < info.layerCount; ++i) {
    if (info.layers[i]->type != XR_TYPE_COMPOSITION_LAYER_PROJECTION) continue;
    const XrSwapchainSubImage& image = as_projection(*info.layers[i]).views[eye].subImage;
    const auto& swapchain = runtime().registry.get<Swapchain>(image.swapchain);
    picture = swapchain.images->read(*swapchain.released, image.imageRect, image.imageArrayIndex);
    break;
  }
  for (std::size_t alpha = 3; alpha < picture.rgba.size(); alpha += 4) picture.rgba[alpha] = 255;
  return picture;
}

}  // namespace hrt::mock
