// Composition layers: projections and quads ("Compositing" of the specification). Pictures show the first projection.
#include <cstdio>
#include <cstdlib>
#include <fstream>

#include "samples/mock_runtime/abi/structure.h"
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
  require_valid(swapchain.parent() == &session,
                "the swapchain of a layer belongs to another session; use one of this session");
  require(swapchain.released.has_value(), XR_ERROR_LAYER_INVALID,
          "no image of a layer's swapchain has been released; call xrReleaseSwapchainImage before xrEndFrame");
  const XrRect2Di& part = image.imageRect;
  const auto inside = [](std::int32_t offset, std::int32_t extent, std::uint32_t size) {
    return offset >= 0 && extent > 0 && std::int64_t{offset} + extent <= std::int64_t{size};
  };
  require(inside(part.offset.x, part.extent.width, swapchain.info.width) &&
              inside(part.offset.y, part.extent.height, swapchain.info.height),
          XR_ERROR_SWAPCHAIN_RECT_INVALID,
          "imageRect has offset {}, {} and extent {}, {}; must lie within {} x {} pixels", part.offset.x, part.offset.y,
          part.extent.width, part.extent.height, swapchain.info.width, swapchain.info.height);
  require_valid(image.imageArrayIndex < swapchain.info.arraySize, "imageArrayIndex is {}; must be < {}",
                image.imageArrayIndex, swapchain.info.arraySize);
}

void require_projection(const XrCompositionLayerProjection& layer, const Session& session) {
  require_valid(layer.viewCount == 2, "viewCount is {}; must be 2", layer.viewCount);
  require_pointer(layer.views, "views");
  for (std::uint32_t i = 0; i < 2; ++i) {
    const XrCompositionLayerProjectionView& view = layer.views[i];
    require_struct(&view);
    checked_pose(view.pose);
    require_image(view.subImage, session);
  }
}

void require_quad(const XrCompositionLayerQuad& layer, const Session& session) {
  checked_pose(layer.pose);
  require_valid(layer.eyeVisibility >= XR_EYE_VISIBILITY_BOTH && layer.eyeVisibility <= XR_EYE_VISIBILITY_RIGHT,
                "eyeVisibility is {}; must be from 0 (both) to 2 (right)", static_cast<int>(layer.eyeVisibility));
  require_image(layer.subImage, session);
}

}  // namespace

void require_layers(const XrFrameEndInfo& info, const Session& session) {
  require(info.layerCount <= XR_MIN_COMPOSITION_LAYERS_SUPPORTED, XR_ERROR_LAYER_LIMIT_EXCEEDED,
          "layerCount is {}; must be at most {}", info.layerCount, XR_MIN_COMPOSITION_LAYERS_SUPPORTED);
  require(info.layerCount == 0 || info.layers != nullptr, XR_ERROR_LAYER_INVALID,
          "layers is null, but layerCount is {}; pass the layers or the count 0", info.layerCount);
  for (std::uint32_t i = 0; i < info.layerCount; ++i) {
    const XrCompositionLayerBaseHeader* layer = info.layers[i];
    require(layer != nullptr, XR_ERROR_LAYER_INVALID, "layers[{}] is null; it must point to a layer", i);
    const bool projects = layer->type == XR_TYPE_COMPOSITION_LAYER_PROJECTION;
    require(projects || layer->type == XR_TYPE_COMPOSITION_LAYER_QUAD, XR_ERROR_LAYER_INVALID,
            "layers[{}] is {}; this runtime supports projections and quads", i, name_of(layer->type));
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

namespace {

constexpr std::int64_t default_interval_frames = 30;

// On an error prints the reason and returns: an application must not fail because of a full disk.
void write_files(const Picture& picture, const std::string& folder, const std::string& name, const std::string& line) {
  try {
    write_png(picture, folder + "/" + name);
    std::ofstream list(folder + "/pictures.txt", std::ios::app);
    if (!(list << line << '\n' << std::flush))
      throw Error{XR_ERROR_RUNTIME_FAILURE, folder + "/pictures.txt: cannot be written"};
  } catch (const Error& error) {
    std::fprintf(stderr, "mock runtime: HRT_MOCK_PICTURES: %s; free space, or set the variable to a writable folder\n",
                 error.why.c_str());
  }
}

bool is_due(Session& session) {
  const Script& script = runtime().script;
  const std::int64_t frame = session.frames.begun_number;
  const bool selects_frames = script.picture_interval > 0 || script.has_picture_events;
  const std::int64_t interval = selects_frames ? script.picture_interval : default_interval_frames;
  if (interval > 0 && (frame - 1) % interval == 0) return true;
  if (session.picture_from == 0 || frame < session.picture_from) return false;
  session.picture_from = 0;
  return true;
}

}  // namespace

void write_pictures(const XrFrameEndInfo& info, Session& session) {
  const char* folder = std::getenv("HRT_MOCK_PICTURES");
  if (folder == nullptr || *folder == '\0' || session.graphics == nullptr || !is_due(session)) return;
  const std::string frame = fmt::format("{:06}", session.frames.begun_number);
  for (const std::uint32_t eye : {0U, 1U}) {
    const std::string name = eye == 0 ? "left" : "right";
    const Picture picture = picture_of_eye(info, eye);
    write_files(picture, folder, frame + "_" + name + ".png",
                fmt::format("{} {} {} {}x{} {}", frame, info.displayTime, name, picture.width, picture.height,
                            hash_of(picture)));
  }
}

}  // namespace hrt::mock
