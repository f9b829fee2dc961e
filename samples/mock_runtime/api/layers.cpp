// Composition layers: specification, "Compositing". Projections and quads, with or without depth.
#include "samples/mock_runtime/abi/two_call.h"
#include "samples/mock_runtime/api/space.h"
#include "samples/mock_runtime/api/swapchain.h"
#include "samples/mock_runtime/graphics/compose.h"

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
    const auto* depth = chained<const XrCompositionLayerDepthInfoKHR>(view.next);
    if (depth == nullptr || !session.instance().enabled(Extension::layer_depth)) continue;
    require(depth->minDepth >= 0.0F && depth->maxDepth <= 1.0F && depth->minDepth <= depth->maxDepth,
            XR_ERROR_VALIDATION_FAILURE, "minDepth and maxDepth are from 0 to 1");
    require_image(depth->subImage, session);
  }
}

void require_quad(const XrCompositionLayerQuad& layer, const Session& session) {
  checked_pose(layer.pose);
  require(layer.eyeVisibility >= XR_EYE_VISIBILITY_BOTH && layer.eyeVisibility <= XR_EYE_VISIBILITY_RIGHT,
          XR_ERROR_VALIDATION_FAILURE, "no such eyeVisibility");
  require_image(layer.subImage, session);
}

Picture read_image(const XrSwapchainSubImage& image) {
  const auto& swapchain = runtime().registry.get<Swapchain>(image.swapchain);
  return swapchain.images->read(*swapchain.released, image.imageRect, image.imageArrayIndex);
}

std::optional<Pose> in_world(XrSpace space, const XrPosef& pose, XrTime time) {
  const auto origin = runtime().registry.get<Space>(space).in_world(time);
  return origin ? std::optional(*origin * checked_pose(pose)) : std::nullopt;
}

std::optional<Camera> camera_of(const XrCompositionLayerProjection& layer, std::uint32_t eye, XrTime time) {
  const XrCompositionLayerProjectionView& view = layer.views[eye];
  const auto pose = in_world(layer.space, view.pose, time);
  if (!pose) return std::nullopt;
  const XrExtent2Di& size = view.subImage.imageRect.extent;
  return Camera{*pose, view.fov, static_cast<std::uint32_t>(size.width), static_cast<std::uint32_t>(size.height)};
}

// That of the first projection; without one, where the eye is.
Camera camera_of(const XrFrameEndInfo& info, Session& session, std::uint32_t eye) {
  for (std::uint32_t i = 0; i < info.layerCount; ++i)
    if (info.layers[i]->type == XR_TYPE_COMPOSITION_LAYER_PROJECTION)
      if (const auto camera = camera_of(as_projection(*info.layers[i]), eye, info.displayTime)) return *camera;
  return {eye_in_world(session, eye, info.displayTime), field_of_view, view_image_size, view_image_size};
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
    const auto& space = runtime().registry.get<Space>(layer->space);
    require(space.parent() == &session, XR_ERROR_VALIDATION_FAILURE, "the space of a layer is of another session");
    if (session.graphics == nullptr) continue;
    if (projects)
      require_projection(as_projection(*layer), session);
    else
      require_quad(as_quad(*layer), session);
  }
}

Picture picture_of_eye(const XrFrameEndInfo& info, Session& session, std::uint32_t eye) {
  const Camera camera = camera_of(info, session, eye);
  Picture picture(camera.width, camera.height);
  for (std::size_t i = 3; i < picture.rgba.size(); i += 4) picture.rgba[i] = 255;
  for (std::uint32_t i = 0; session.graphics != nullptr && i < info.layerCount; ++i) {
    const XrCompositionLayerBaseHeader& layer = *info.layers[i];
    if (layer.type == XR_TYPE_COMPOSITION_LAYER_PROJECTION) {
      const auto of = camera_of(as_projection(layer), eye, info.displayTime);
      const XrSwapchainSubImage& image = as_projection(layer).views[eye].subImage;
      if (of) draw_projection(picture, camera, read_image(image), *of, layer.layerFlags);
      continue;
    }
    const XrCompositionLayerQuad& quad = as_quad(layer);
    const XrEyeVisibility other = eye == 0 ? XR_EYE_VISIBILITY_RIGHT : XR_EYE_VISIBILITY_LEFT;
    const auto pose = in_world(quad.space, quad.pose, info.displayTime);
    if (!pose || quad.eyeVisibility == other) continue;
    draw_quad(picture, camera, read_image(quad.subImage), *pose, quad.size, quad.layerFlags);
  }
  return picture;
}

}  // namespace hrt::mock
