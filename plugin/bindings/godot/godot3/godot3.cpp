// The class HapticRetargeting for Godot 3: a NativeScript of a Spatial, through GDNative's C interface.

#include <algorithm>
#include <array>
#include <cstring>
#include <exception>
#include <new>
#include <span>

#include "../plate_node.h"
#include "gdnative.h"

namespace hrt_godot {
namespace {

const godot_core_api* core;
const godot_nativescript_api* nativescript;

/** Strings and variants of the engine's, destroyed at the end of their scope. */
class EngineString {
 public:
  explicit EngineString(const char* utf8) {
    core->string_new(&string_);
    core->string_parse_utf8(&string_, utf8);
  }
  explicit EngineString(const godot_string& owned) : string_(owned) {}
  EngineString(const EngineString&) = delete;
  EngineString& operator=(const EngineString&) = delete;
  ~EngineString() { core->string_destroy(&string_); }

  const godot_string& get() const { return string_; }
  std::string utf8() const {
    godot_char_string characters = core->string_utf8(&string_);
    std::string text = core->char_string_get_data(&characters);
    core->char_string_destroy(&characters);
    return text;
  }

 private:
  alignas(8) godot_string string_;
};

godot_variant to_variant(const Value& value);

class EngineVariant {
 public:
  explicit EngineVariant(const Value& value) : variant_(to_variant(value)) {}
  EngineVariant(const EngineVariant&) = delete;
  EngineVariant& operator=(const EngineVariant&) = delete;
  ~EngineVariant() { core->variant_destroy(&variant_); }
  const godot_variant& get() const { return variant_; }

 private:
  alignas(8) godot_variant variant_;
};

void new_vector3(godot_variant* out, const Vector3& vector) {
  const float parts[3] = {static_cast<float>(vector.x), static_cast<float>(vector.y),
                          static_cast<float>(vector.z)};
  godot_vector3 bytes;
  std::memcpy(&bytes, parts, sizeof bytes);
  core->variant_new_vector3(out, &bytes);
}

void new_entry(godot_variant* out, const Entry& entry) {
  if (const double* real = std::get_if<double>(&entry)) return core->variant_new_real(out, *real);
  if (const Vector3* vector = std::get_if<Vector3>(&entry)) return new_vector3(out, *vector);
  core->variant_new_int(out, std::get<int64_t>(entry));
}

Pose to_pose(const godot_transform& transform) {
  float m[12];
  std::memcpy(m, &transform, sizeof m);
  return {.x_axis = widen(m[0], m[3], m[6]),
          .y_axis = widen(m[1], m[4], m[7]),
          .z_axis = widen(m[2], m[5], m[8]),
          .origin = widen(m[9], m[10], m[11])};
}

godot_transform to_transform(const Pose& pose) {
  const Vector3 &x = pose.x_axis, &y = pose.y_axis, &z = pose.z_axis, &at = pose.origin;
  const double m[12] = {x.x, y.x, z.x, x.y, y.y, z.y, x.z, y.z, z.z, at.x, at.y, at.z};
  float floats[12];
  std::transform(m, m + 12, floats, [](double part) { return static_cast<float>(part); });
  godot_transform transform;
  std::memcpy(&transform, floats, sizeof transform);
  return transform;
}

void new_dictionary(godot_variant* out, const Record& record) {
  godot_dictionary dictionary;
  core->dictionary_new(&dictionary);
  for (const auto& [name, entry] : record) {
    const EngineVariant key{std::string(name)};
    godot_variant value;
    new_entry(&value, entry);
    core->dictionary_set(&dictionary, &key.get(), &value);
    core->variant_destroy(&value);
  }
  core->variant_new_dictionary(out, &dictionary);
  core->dictionary_destroy(&dictionary);
}

/** The caller destroys it. */
godot_variant to_variant(const Value& value) {
  godot_variant variant;
  switch (type_of(value)) {
    case Type::kNil:
      core->variant_new_nil(&variant);
      break;
    case Type::kBool:
      core->variant_new_bool(&variant, std::get<bool>(value));
      break;
    case Type::kInt:
      core->variant_new_int(&variant, std::get<int64_t>(value));
      break;
    case Type::kReal:
      core->variant_new_real(&variant, std::get<double>(value));
      break;
    case Type::kString: {
      const EngineString string(std::get<std::string>(value).c_str());
      core->variant_new_string(&variant, &string.get());
      break;
    }
    case Type::kVector3:
      new_vector3(&variant, std::get<Vector3>(value));
      break;
    case Type::kRecord:
      new_dictionary(&variant, std::get<Record>(value));
      break;
    case Type::kPose: {
      const godot_transform transform = to_transform(std::get<Pose>(value));
      core->variant_new_transform(&variant, &transform);
      break;
    }
  }
  return variant;
}

/** Null for a type that no method of the class takes. */
Value to_value(const godot_variant& variant) {
  switch (core->variant_get_type(&variant)) {
    case GODOT_BOOL:
      return core->variant_as_bool(&variant) != 0;
    case GODOT_INT:
      return core->variant_as_int(&variant);
    case GODOT_REAL:
      return core->variant_as_real(&variant);
    case GODOT_STRING:
      return EngineString(core->variant_as_string(&variant)).utf8();
    case GODOT_VECTOR3: {
      const godot_vector3 bytes = core->variant_as_vector3(&variant);
      float parts[3];
      std::memcpy(parts, &bytes, sizeof parts);
      return widen(parts[0], parts[1], parts[2]);
    }
    case GODOT_TRANSFORM:
      return to_pose(core->variant_as_transform(&variant));
    default:
      return {};
  }
}

godot_int variant_type(Type type) {
  constexpr godot_int types[] = {GODOT_NIL,    GODOT_BOOL,    GODOT_INT,        GODOT_REAL,
                                 GODOT_STRING, GODOT_VECTOR3, GODOT_DICTIONARY, GODOT_TRANSFORM};
  static_assert(std::size(types) == std::variant_size_v<Value>);
  return types[static_cast<size_t>(type)];
}

/** A node of a scene and what it runs. */
class Instance : public Engine {
 public:
  explicit Instance(godot_object* object) : object_(object), node_(*this) {}
  PlateNode& node() { return node_; }

  Pose node_pose() override {
    static godot_method_bind* const get_global =
        core->method_bind_get_method("Spatial", "get_global_transform");
    static godot_method_bind* const get_local = core->method_bind_get_method("Spatial", "get_transform");
    const void* no_arguments[1] = {nullptr};
    godot_transform transform;
    core->method_bind_ptrcall(is_inside_tree() ? get_global : get_local, object_, no_arguments, &transform);
    return to_pose(transform);
  }

  void move_node(const Pose& pose) override {
    static godot_method_bind* const set_global =
        core->method_bind_get_method("Spatial", "set_global_transform");
    static godot_method_bind* const set_local = core->method_bind_get_method("Spatial", "set_transform");
    const godot_transform transform = to_transform(pose);
    const void* arguments[1] = {&transform};
    core->method_bind_ptrcall(is_inside_tree() ? set_global : set_local, object_, arguments, nullptr);
  }

  void emit(const Signal& signal, const Value& argument) override {
    static godot_method_bind* const emit_signal = core->method_bind_get_method("Object", "emit_signal");
    const EngineVariant name{std::string(signal.name)};
    const EngineVariant value(argument);
    const godot_variant* arguments[2] = {&name.get(), &value.get()};
    godot_variant_call_error error{};
    godot_variant nothing = core->method_bind_call(emit_signal, object_, arguments, 2, &error);
    core->variant_destroy(&nothing);
  }

  void push_error(const char* text) override { core->print_error(text, kClassName, "godot3.cpp", __LINE__); }

 private:
  bool is_inside_tree() {
    static godot_method_bind* const method = core->method_bind_get_method("Node", "is_inside_tree");
    const void* no_arguments[1] = {nullptr};
    uint64_t inside = 0;
    core->method_bind_ptrcall(method, object_, no_arguments, &inside);
    return inside != 0;
  }

  godot_object* object_;
  PlateNode node_;
};

void* create(godot_object* object, void*) noexcept {
  return new (std::nothrow) Instance(object);
}

void destroy(godot_object*, void*, void* instance) noexcept {
  delete static_cast<Instance*>(instance);
}

godot_variant call(godot_object*, void* method, void* instance, int count,
                   godot_variant** arguments) noexcept {
  if (!instance) return to_variant({});
  try {
    std::array<Value, kArgumentsMax> values;
    const size_t size = std::min(static_cast<size_t>(count), values.size());
    for (size_t i = 0; i < size; ++i) values[i] = to_value(*arguments[i]);
    return to_variant(static_cast<Instance*>(instance)->node().call(*static_cast<const Method*>(method),
                                                                    std::span(values.data(), size)));
  } catch (const std::exception& error) {
    static_cast<Instance*>(instance)->push_error(error.what());
    return to_variant({});
  }
}

void set(godot_object*, void* property, void* instance, godot_variant* value) noexcept {
  if (!instance) return;
  try {
    static_cast<Instance*>(instance)->node().set(*static_cast<const Field*>(property), to_value(*value));
  } catch (const std::exception& error) {
    static_cast<Instance*>(instance)->push_error(error.what());
  }
}

godot_variant get(godot_object*, void* property, void* instance) noexcept {
  if (!instance) return to_variant({});
  return to_variant(static_cast<Instance*>(instance)->node().get(*static_cast<const Field*>(property)));
}

/** GDNative's method_data is not const; what it points to here is. */
template <typename T>
void* method_data(const T& data) {
  return const_cast<T*>(&data);
}

void register_property(void* library, const Field& field, const hrt_session_config& defaults) {
  const EngineString hint(field.choices ? field.choices : "");
  const EngineVariant value(get_field(&defaults, field));
  godot_property_attributes attributes{.rset_type = 0,
                                       .type = variant_type(type_of(field)),
                                       .hint = field.choices ? GODOT_HINT_ENUM : GODOT_HINT_NONE,
                                       .hint_string = hint.get(),
                                       .usage = GODOT_USAGE_DEFAULT,
                                       .default_value = value.get()};
  nativescript->register_property(library, kClassName, field.name, &attributes,
                                  {set, method_data(field), nullptr}, {get, method_data(field), nullptr});
}

void register_signal(void* library, const Signal& signal) {
  const EngineString name(signal.name);
  const EngineString argument_name(signal.argument.name);
  const EngineString no_hint("");
  const EngineVariant null{Value{}};
  godot_signal_argument argument{.name = argument_name.get(),
                                 .type = variant_type(signal.argument.type),
                                 .hint = GODOT_HINT_NONE,
                                 .hint_string = no_hint.get(),
                                 .usage = GODOT_USAGE_DEFAULT,
                                 .default_value = null.get()};
  const godot_signal description{
      .name = name.get(), .num_args = 1, .args = &argument, .num_default_args = 0, .default_args = nullptr};
  nativescript->register_signal(library, kClassName, &description);
}

}  // namespace
}  // namespace hrt_godot

using namespace hrt_godot;

extern "C" GDN_EXPORT void godot_gdnative_init(godot_init_options* options) {
  const godot_core_api& api = *options->api;
  if (api.header.type != GODOT_API_CORE || api.header.version.major != 1)
    return options->report_loading_error(options->library, "GDNative's core table is not of version 1");
  core = &api;
  for (uint32_t i = 0; i < api.num_extensions; ++i) {
    const godot_api* extension = api.extensions[i];
    if (extension->type == GODOT_API_NATIVESCRIPT && extension->version.major == 1)
      nativescript = reinterpret_cast<const godot_nativescript_api*>(extension);
  }
  if (!nativescript)
    options->report_loading_error(options->library, "this Godot is built without NativeScript 1");
}

extern "C" GDN_EXPORT void godot_gdnative_terminate(void*) {
  core = nullptr;
  nativescript = nullptr;
}

extern "C" GDN_EXPORT void godot_nativescript_init(void* library) {
  if (!nativescript) return;
  nativescript->register_class(library, kClassName, "Spatial", {create, nullptr, nullptr},
                               {destroy, nullptr, nullptr});
  for (const Method& method : methods())
    nativescript->register_method(library, kClassName, method.name, {0},
                                  {call, method_data(method), nullptr});
  const hrt_session_config defaults = hrt_session_config_init();
  for (const Field& field : config_fields) register_property(library, field, defaults);
  for (const Signal& signal : signals()) register_signal(library, signal);
}
