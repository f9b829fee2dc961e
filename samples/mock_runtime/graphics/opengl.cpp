// Swapchains of the application's own OpenGL context under X11.
#include <GL/glcorearb.h>
#include <dlfcn.h>

#include <array>
#include <string>

#include "samples/mock_runtime/abi/two_call.h"
#include "samples/mock_runtime/graphics/device.h"

namespace hrt::mock {
namespace {

// clang-format off
#define HRT_GLX_FUNCTIONS(X)                                     \
  X(glXGetCurrentContext, GLXContext, ())                        \
  X(glXGetCurrentDisplay, Display*, ())                          \
  X(glXGetCurrentDrawable, GLXDrawable, ())                      \
  X(glXMakeCurrent, int, (Display*, GLXDrawable, GLXContext))
#define HRT_GL_FUNCTIONS(X)                                                                           \
  X(glBindBuffer, BINDBUFFER) X(glBindFramebuffer, BINDFRAMEBUFFER) X(glBindTexture, BINDTEXTURE)     \
  X(glDeleteFramebuffers, DELETEFRAMEBUFFERS) X(glDeleteTextures, DELETETEXTURES)                     \
  X(glFramebufferTexture2D, FRAMEBUFFERTEXTURE2D) X(glFramebufferTextureLayer, FRAMEBUFFERTEXTURELAYER) \
  X(glGenFramebuffers, GENFRAMEBUFFERS) X(glGenTextures, GENTEXTURES) X(glGetError, GETERROR)         \
  X(glGetIntegerv, GETINTEGERV) X(glPixelStorei, PIXELSTOREI) X(glReadPixels, READPIXELS)             \
  X(glTexStorage2D, TEXSTORAGE2D) X(glTexStorage3D, TEXSTORAGE3D)
// clang-format on

struct OpenGlFormat {
  GLenum format;
  bool is_depth;
  PixelKind kind;  // of colours
};
constexpr std::array opengl_formats{
    OpenGlFormat{GL_SRGB8_ALPHA8, false, PixelKind::rgba_srgb},
    OpenGlFormat{GL_RGBA16F, false, PixelKind::half_linear},
    OpenGlFormat{GL_RGBA8, false, PixelKind::rgba_linear},
    OpenGlFormat{GL_DEPTH_COMPONENT32F, true, {}},
    OpenGlFormat{GL_DEPTH_COMPONENT16, true, {}},
    OpenGlFormat{GL_DEPTH24_STENCIL8, true, {}},
    OpenGlFormat{GL_DEPTH32F_STENCIL8, true, {}},
};

class OpenGlDevice : public GraphicsDevice, public std::enable_shared_from_this<OpenGlDevice> {
 public:
  explicit OpenGlDevice(const XrGraphicsBindingOpenGLXlibKHR& of) : binding(of) {
    using GetAddress = void (*(*)(const GLubyte*))();
    void* library = dlopen("libGL.so.1", RTLD_NOW | RTLD_NOLOAD);
    if (library == nullptr) library = dlopen("libGLX.so.0", RTLD_NOW | RTLD_NOLOAD);
    require(library != nullptr, XR_ERROR_GRAPHICS_DEVICE_INVALID, "the process has no OpenGL library");
    const auto get = reinterpret_cast<GetAddress>(dlsym(library, "glXGetProcAddressARB"));
    dlclose(library);
    const auto fetch = [&](auto& function, const char* name) {
      using Function = std::remove_reference_t<decltype(function)>;
      function = get == nullptr ? nullptr : reinterpret_cast<Function>(get(reinterpret_cast<const GLubyte*>(name)));
      if (function == nullptr) throw Error{XR_ERROR_GRAPHICS_DEVICE_INVALID, std::string("no ") + name};
    };
#define HRT_GLX_FETCH(name, returned, arguments) fetch(name, #name);
    HRT_GLX_FUNCTIONS(HRT_GLX_FETCH)
#undef HRT_GLX_FETCH
#define HRT_GL_FETCH(name, type) fetch(name, #name);
    HRT_GL_FUNCTIONS(HRT_GL_FETCH)
#undef HRT_GL_FETCH
  }

  std::vector<std::int64_t> formats() const override {
    std::vector<std::int64_t> all;
    for (const OpenGlFormat& each : opengl_formats) all.push_back(each.format);
    return all;
  }
  std::unique_ptr<SwapchainImages> create_images(const XrSwapchainCreateInfo& info, std::uint32_t count) override;

  int number(GLenum name) const {
    GLint value = 0;
    glGetIntegerv(name, &value);
    return value;
  }

#define HRT_GLX_MEMBER(name, returned, arguments) returned(*name) arguments = nullptr;
  HRT_GLX_FUNCTIONS(HRT_GLX_MEMBER)
#undef HRT_GLX_MEMBER
#define HRT_GL_MEMBER(name, type) PFNGL##type##PROC name = nullptr;
  HRT_GL_FUNCTIONS(HRT_GL_MEMBER)
#undef HRT_GL_MEMBER
  XrGraphicsBindingOpenGLXlibKHR binding;
};

// The session's context is current for a while, and then again what was before.
class CurrentContext {
 public:
  explicit CurrentContext(const OpenGlDevice& device)
      : device_(device),
        display_(device.glXGetCurrentDisplay()),
        drawable_(device.glXGetCurrentDrawable()),
        context_(device.glXGetCurrentContext()),
        changes_(context_ != device.binding.glxContext) {
    const XrGraphicsBindingOpenGLXlibKHR& ours = device.binding;
    if (changes_)
      require(device.glXMakeCurrent(ours.xDisplay, ours.glxDrawable, ours.glxContext) != 0, XR_ERROR_RUNTIME_FAILURE,
              "the application's OpenGL context cannot be made current");
  }
  ~CurrentContext() {
    if (!changes_) return;
    device_.glXMakeCurrent(display_ != nullptr ? display_ : device_.binding.xDisplay, drawable_, context_);
  }
  CurrentContext(const CurrentContext&) = delete;
  CurrentContext& operator=(const CurrentContext&) = delete;

 private:
  const OpenGlDevice& device_;
  Display* display_;
  GLXDrawable drawable_;
  GLXContext context_;
  bool changes_;
};

// What reading pixels depends on, set to what it needs, and then again as it was.
class ReadState {
 public:
  explicit ReadState(const OpenGlDevice& gl) : gl_(gl) {
    for (std::size_t i = 0; i < stores.size(); ++i) {
      stored_[i] = gl.number(stores[i]);
      gl.glPixelStorei(stores[i], stores[i] == GL_PACK_ALIGNMENT ? 1 : 0);
    }
    gl.glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  }
  ~ReadState() {
    for (std::size_t i = 0; i < stores.size(); ++i) gl_.glPixelStorei(stores[i], stored_[i]);
    gl_.glBindBuffer(GL_PIXEL_PACK_BUFFER, static_cast<GLuint>(buffer_));
    gl_.glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(read_));
  }
  ReadState(const ReadState&) = delete;
  ReadState& operator=(const ReadState&) = delete;

 private:
  static constexpr std::array<GLenum, 6> stores{GL_PACK_ALIGNMENT,   GL_PACK_ROW_LENGTH, GL_PACK_SKIP_ROWS,
                                                GL_PACK_SKIP_PIXELS, GL_PACK_SWAP_BYTES, GL_PACK_LSB_FIRST};
  const OpenGlDevice& gl_;
  std::array<int, stores.size()> stored_{};
  int buffer_ = gl_.number(GL_PIXEL_PACK_BUFFER_BINDING);
  int read_ = gl_.number(GL_READ_FRAMEBUFFER_BINDING);
};

class OpenGlImages : public SwapchainImages {
 public:
  OpenGlImages(std::shared_ptr<const OpenGlDevice> device, const XrSwapchainCreateInfo& info, std::uint32_t count)
      : gl_(std::move(device)),
        info_(info),
        kind_(std::find_if(opengl_formats.begin(), opengl_formats.end(),
                           [&](const OpenGlFormat& each) { return each.format == info.format; })
                  ->kind),
        names_(count) {
    const CurrentContext current(*gl_);
    while (gl_->glGetError() != GL_NO_ERROR) continue;  // the application's
    const bool array = info.arraySize > 1;
    const GLenum target = array ? GL_TEXTURE_2D_ARRAY : GL_TEXTURE_2D;
    const int bound = gl_->number(array ? GL_TEXTURE_BINDING_2D_ARRAY : GL_TEXTURE_BINDING_2D);
    gl_->glGenTextures(static_cast<GLsizei>(count), names_.data());
    const auto format = static_cast<GLenum>(info.format);
    const auto width = static_cast<GLsizei>(info.width), height = static_cast<GLsizei>(info.height);
    const auto layers = static_cast<GLsizei>(info.arraySize), mips = static_cast<GLsizei>(info.mipCount);
    for (const GLuint name : names_) {
      gl_->glBindTexture(target, name);
      if (array)
        gl_->glTexStorage3D(target, mips, format, width, height, layers);
      else
        gl_->glTexStorage2D(target, mips, format, width, height);
    }
    gl_->glBindTexture(target, static_cast<GLuint>(bound));
    const GLenum error = gl_->glGetError();
    if (error == GL_NO_ERROR) return;
    gl_->glDeleteTextures(static_cast<GLsizei>(count), names_.data());
    throw Error{error == GL_OUT_OF_MEMORY ? XR_ERROR_OUT_OF_MEMORY : XR_ERROR_FEATURE_UNSUPPORTED,
                "the context has no textures of this format with these mips and layers"};
  }
  ~OpenGlImages() override {
    try {
      const CurrentContext current(*gl_);
      gl_->glDeleteTextures(static_cast<GLsizei>(names_.size()), names_.data());
    } catch (const Error&) {
      // The context is gone, and its textures with it.
    }
  }
  OpenGlImages(const OpenGlImages&) = delete;
  OpenGlImages& operator=(const OpenGlImages&) = delete;

  void enumerate(std::uint32_t capacity, std::uint32_t* count, XrSwapchainImageBaseHeader* images) override {
    two_call(names_, capacity, count, reinterpret_cast<XrSwapchainImageOpenGLKHR*>(images),
             [](XrSwapchainImageOpenGLKHR& to, GLuint name) { to.image = name; });
  }
  void prepare(std::uint32_t) override {}

  Picture read(std::uint32_t index, const XrRect2Di& part, std::uint32_t layer) override {
    const CurrentContext current(*gl_);
    const ReadState state(*gl_);
    const int width = part.extent.width, height = part.extent.height;
    GLuint frame = 0;
    gl_->glGenFramebuffers(1, &frame);
    gl_->glBindFramebuffer(GL_READ_FRAMEBUFFER, frame);
    if (info_.arraySize > 1)
      gl_->glFramebufferTextureLayer(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, names_[index], 0,
                                     static_cast<GLint>(layer));
    else
      gl_->glFramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, names_[index], 0);
    Picture picture(static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height));
    const std::size_t row = std::size_t{bytes_of(kind_)} * picture.width;
    std::vector<std::uint8_t> pixels(row * picture.height);
    gl_->glReadPixels(part.offset.x, part.offset.y, width, height, GL_RGBA,
                      kind_ == PixelKind::half_linear ? GL_HALF_FLOAT : GL_UNSIGNED_BYTE, pixels.data());
    gl_->glDeleteFramebuffers(1, &frame);
    for (std::uint32_t y = 0; y < picture.height; ++y)  // the bottom row is first
      convert_pixels(kind_, &pixels[row * (picture.height - 1 - y)], picture.width, picture.at(0, y));
    return picture;
  }

 private:
  std::shared_ptr<const OpenGlDevice> gl_;
  XrSwapchainCreateInfo info_;
  PixelKind kind_;
  std::vector<GLuint> names_;
};

std::unique_ptr<SwapchainImages> OpenGlDevice::create_images(const XrSwapchainCreateInfo& info, std::uint32_t count) {
  return std::make_unique<OpenGlImages>(shared_from_this(), info, count);
}

}  // namespace

std::shared_ptr<GraphicsDevice> make_opengl_device(const XrGraphicsBindingOpenGLXlibKHR& binding) {
  require(binding.xDisplay != nullptr && binding.glxContext != nullptr, XR_ERROR_GRAPHICS_DEVICE_INVALID,
          "xDisplay and glxContext must be there");
  return std::make_shared<OpenGlDevice>(binding);
}

}  // namespace hrt::mock
