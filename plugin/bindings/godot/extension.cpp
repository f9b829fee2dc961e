// The class HapticRetargeting in Godot: a Node3D, through GDExtension's C interface.

#include <algorithm>
#include <array>
#include <cstring>
#include <deque>
#include <exception>
#include <new>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gdextension.h"
#include "plate_node.h"

namespace hrt_godot {
namespace {

/** The engine's functions. */
struct Interface {
#define DECLARE(result, name, arguments) result(*name) arguments;
  GDE_FUNCTIONS(DECLARE)
#undef DECLARE
};
Interface engine;
gde_library* library;

/** Null, or the name of a function that this engine lacks. */
const char* load_interface(gde_get_proc_address get_proc_address) {
  // Godot 4.4 has the same under the number of its own.
  const auto load = [&](const std::string_view name) {
    const gde_function found = get_proc_address(name.data());
    return found || name != "classdb_register_extension_class5" ? found
                                                                : get_proc_address("classdb_register_extension_class4");
  };
#define LOAD(result, name, arguments)                                 \
  engine.name = reinterpret_cast<decltype(engine.name)>(load(#name)); \
  if (!engine.name) return #name;
  GDE_FUNCTIONS(LOAD)
#undef LOAD
  return nullptr;
}

/** A text of the engine's, destroyed at the end of its scope. */
template <typename Text, auto make, int32_t type>
class EngineText {
 public:
  explicit EngineText(const char* utf8) { (engine.*make)(&text_, utf8); }
  EngineText(const EngineText&) = delete;
  EngineText& operator=(const EngineText&) = delete;
  ~EngineText() { engine.variant_get_ptr_destructor(type)(&text_); }
  const Text& get() const { return text_; }

 private:
  Text text_;
};
using EngineString = EngineText<gde_string, &Interface::string_new_with_utf8_chars, GDE_STRING>;
using EngineName = EngineText<gde_string_name, &Interface::string_name_new_with_utf8_chars, GDE_STRING_NAME>;

std::string to_utf8(const gde_string& string) {
  std::string text(static_cast<size_t>(engine.string_to_utf8_chars(&string, nullptr, 0)), '\0');
  engine.string_to_utf8_chars(&string, text.data(), static_cast<int64_t>(text.size()));
  return text;
}

std::string to_utf8(const gde_string_name& name) {
  const void* const arguments[] = {&name};
  gde_string string;
  engine.variant_get_ptr_constructor(GDE_STRING, GDE_STRING_OF_STRING_NAME)(&string, arguments);
  std::string text = to_utf8(string);
  engine.variant_get_ptr_destructor(GDE_STRING)(&string);
  return text;
}

Vector3 widen(float x, float y, float z) {
  return {static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
}

/** A variant of a value of the engine's. */
void new_variant(gde_variant* out, int32_t type, const void* value) {
  engine.get_variant_from_type_constructor(type)(out, value);
}

template <typename T>
T from_variant(const gde_variant& variant, int32_t type) {
  T value;
  engine.get_variant_to_type_constructor(type)(&value, &variant);
  return value;
}

struct EngineVector3 {
  float x, y, z;
};
EngineVector3 narrow(const Vector3& vector) {
  return {static_cast<float>(vector.x), static_cast<float>(vector.y), static_cast<float>(vector.z)};
}

/** The rows of the basis, and the origin. */
struct EngineTransform {
  float m[12];
};
Pose to_pose(const EngineTransform& transform) {
  const float(&m)[12] = transform.m;
  return {.x_axis = widen(m[0], m[3], m[6]),
          .y_axis = widen(m[1], m[4], m[7]),
          .z_axis = widen(m[2], m[5], m[8]),
          .origin = widen(m[9], m[10], m[11])};
}
EngineTransform to_transform(const Pose& pose) {
  const auto [x, y, z, at] =
      std::array{narrow(pose.x_axis), narrow(pose.y_axis), narrow(pose.z_axis), narrow(pose.origin)};
  return {{x.x, y.x, z.x, x.y, y.y, z.y, x.z, y.z, z.z, at.x, at.y, at.z}};
}

int32_t variant_type(Type type) {
  constexpr int32_t types[] = {GDE_NIL,    GDE_BOOL,    GDE_INT,        GDE_FLOAT,
                               GDE_STRING, GDE_VECTOR3, GDE_DICTIONARY, GDE_TRANSFORM3D};
  static_assert(std::size(types) == std::variant_size_v<Value>);
  return types[static_cast<size_t>(type)];
}

void to_variant(gde_variant* out, const Value& value);

void fill_dictionary(gde_dictionary* dictionary, const Record& record) {
  for (const auto& [name, entry] : record) {
    gde_variant key;
    to_variant(&key, std::string(name));
    gde_variant* value = engine.dictionary_operator_index(dictionary, &key);
    engine.variant_destroy(value);
    to_variant(value, to_value(entry));
    engine.variant_destroy(&key);
  }
}

/** The caller destroys it. */
void to_variant(gde_variant* out, const Value& value) {
  const int32_t type = variant_type(type_of(value));
  std::visit(
      [&]<typename T>(const T& each) {
        if constexpr (std::is_same_v<T, std::monostate>) {
          engine.variant_new_nil(out);
        } else if constexpr (std::is_same_v<T, bool>) {
          const gde_bool byte = each;
          new_variant(out, type, &byte);
        } else if constexpr (std::is_same_v<T, std::string>) {
          new_variant(out, type, &EngineString(each.c_str()).get());
        } else if constexpr (std::is_same_v<T, Vector3>) {
          const EngineVector3 floats = narrow(each);
          new_variant(out, type, &floats);
        } else if constexpr (std::is_same_v<T, Pose>) {
          const EngineTransform transform = to_transform(each);
          new_variant(out, type, &transform);
        } else if constexpr (std::is_same_v<T, Record>) {
          gde_dictionary dictionary;
          engine.variant_get_ptr_constructor(GDE_DICTIONARY, 0)(&dictionary, nullptr);
          fill_dictionary(&dictionary, each);
          new_variant(out, type, &dictionary);
          engine.variant_get_ptr_destructor(GDE_DICTIONARY)(&dictionary);
        } else {
          new_variant(out, type, &each);
        }
      },
      value);
}

/** Null for a type that no method of the class takes. */
Value to_value(const gde_variant& variant) {
  switch (engine.variant_get_type(&variant)) {
    case GDE_BOOL:
      return from_variant<gde_bool>(variant, GDE_BOOL) != 0;
    case GDE_INT:
      return from_variant<int64_t>(variant, GDE_INT);
    case GDE_FLOAT:
      return from_variant<double>(variant, GDE_FLOAT);
    case GDE_STRING: {
      gde_string string = from_variant<gde_string>(variant, GDE_STRING);
      std::string text = to_utf8(string);
      engine.variant_get_ptr_destructor(GDE_STRING)(&string);
      return text;
    }
    case GDE_STRING_NAME: {  // such as the name of a node
      gde_string_name name = from_variant<gde_string_name>(variant, GDE_STRING_NAME);
      std::string text = to_utf8(name);
      engine.variant_get_ptr_destructor(GDE_STRING_NAME)(&name);
      return text;
    }
    case GDE_VECTOR3: {
      const EngineVector3 floats = from_variant<EngineVector3>(variant, GDE_VECTOR3);
      return widen(floats.x, floats.y, floats.z);
    }
    case GDE_TRANSFORM3D:
      return to_pose(from_variant<EngineTransform>(variant, GDE_TRANSFORM3D));
    default:
      return {};
  }
}

/** Calls a method of the engine's, of two arguments at most. */
Value call_on(gde_variant& self, const char* method, std::initializer_list<Value> arguments) {
  const EngineName name(method);
  std::array<gde_variant, 2> variants;
  std::array<const gde_variant*, 2> pointers{&variants[0], &variants[1]};
  const size_t count = arguments.size();
  for (size_t i = 0; i < count; ++i) to_variant(&variants[i], arguments.begin()[i]);
  gde_variant result;
  gde_call_error error{};
  engine.variant_call(&self, &name.get(), pointers.data(), static_cast<int64_t>(count), &result, &error);
  const Value returned = to_value(result);
  for (size_t i = 0; i < count; ++i) engine.variant_destroy(&variants[i]);
  engine.variant_destroy(&result);
  return returned;
}

/** Object.NOTIFICATION_POSTINITIALIZE. */
constexpr int64_t kPostInitialize = 0;

/** A node of a scene and what it runs. */
class Instance : public Engine {
 public:
  explicit Instance(gde_object* object) : object_(object), node_(*this) {}
  PlateNode& node() { return node_; }

  Pose node_pose() override {
    return std::get<Pose>(call(is_inside_tree() ? "get_global_transform" : "get_transform", {}));
  }
  void move_node(const Pose& pose) override {
    call(is_inside_tree() ? "set_global_transform" : "set_transform", {pose});
  }
  void emit(const Signal& signal, const Value& argument) override {
    call("emit_signal", {std::string(signal.name), argument});
  }
  void notify(int64_t what) { call("notification", {what}); }

  void update_warnings() override { call("update_configuration_warnings", {}); }

  void push_error(const char* text) override { engine.print_error(text, kClassName, "extension.cpp", __LINE__, false); }

 private:
  bool is_inside_tree() { return std::get<bool>(call("is_inside_tree", {})); }

  Value call(const char* method, std::initializer_list<Value> arguments) {
    gde_variant self;
    new_variant(&self, GDE_OBJECT, &object_);
    const Value returned = call_on(self, method, arguments);
    engine.variant_destroy(&self);
    return returned;
  }

  gde_object* object_;
  PlateNode node_;
};

gde_object* create_instance(void*, gde_bool notify) noexcept {
  const EngineName parent("Node3D");
  const EngineName name(kClassName);
  gde_object* object = engine.classdb_construct_object2(&parent.get());
  Instance* instance = new (std::nothrow) Instance(object);
  if (!instance) return object;
  engine.object_set_instance(object, &name.get(), instance);
  if (notify) instance->notify(kPostInitialize);
  return object;
}

void free_instance(void*, void* instance) noexcept { delete static_cast<Instance*>(instance); }

/** Node._get_configuration_warnings(). */
void get_warnings(void* instance, const void* const*, void* out_return) noexcept try {
  const std::string warning = static_cast<Instance*>(instance)->node().warning();
  if (warning.empty()) return;
  gde_variant warnings;
  new_variant(&warnings, GDE_PACKED_STRING_ARRAY, out_return);
  call_on(warnings, "append", {warning});
  engine.variant_get_ptr_destructor(GDE_PACKED_STRING_ARRAY)(out_return);
  engine.get_variant_to_type_constructor(GDE_PACKED_STRING_ARRAY)(out_return, &warnings);
  engine.variant_destroy(&warnings);
} catch (const std::exception& error) {
  static_cast<Instance*>(instance)->push_error(error.what());
}

gde_virtual get_virtual(void*, const gde_string_name* name, uint32_t) noexcept {
  return to_utf8(*name) == "_get_configuration_warnings" ? get_warnings : nullptr;
}

/** What the engine calls: a method, or the setter or getter of a property. */
struct Callable {
  std::string name;
  Type returns;
  std::vector<Argument> arguments;
  const Method* method = nullptr;
  const Field* field = nullptr;

  Value operator()(PlateNode& node, std::span<const Value> values) const {
    if (method) return node.call(*method, values);
    if (arguments.empty()) return node.get(*field);
    if (values.size() == 1) node.set(*field, values[0]);
    return {};
  }
};
/** The engine keeps pointers to these. */
std::deque<Callable> callables;

void call(void* callable, void* instance, const gde_variant* const* arguments, int64_t count, gde_variant* out_return,
          gde_call_error*) noexcept {
  if (!instance) return;
  try {
    std::array<Value, kArgumentsMax> values;
    const size_t size = std::min(static_cast<size_t>(count), values.size());
    for (size_t i = 0; i < size; ++i) values[i] = to_value(*arguments[i]);
    const Value result = (*static_cast<const Callable*>(callable))(static_cast<Instance*>(instance)->node(),
                                                                   std::span(values.data(), size));
    engine.variant_destroy(out_return);
    to_variant(out_return, result);
  } catch (const std::exception& error) {
    static_cast<Instance*>(instance)->push_error(error.what());
  }
}

/** As call(), with values of the registered types, by way of variants. */
void ptrcall(void* data, void* instance, const void* const* arguments, void* out_return) noexcept {
  const Callable& callable = *static_cast<const Callable*>(data);
  std::array<gde_variant, kArgumentsMax> variants;
  std::array<const gde_variant*, kArgumentsMax> pointers;
  const size_t count = callable.arguments.size();
  for (size_t i = 0; i < count; ++i) {
    new_variant(&variants[i], variant_type(callable.arguments[i].type), arguments[i]);
    pointers[i] = &variants[i];
  }
  gde_variant result;
  engine.variant_new_nil(&result);
  call(data, instance, pointers.data(), static_cast<int64_t>(count), &result, nullptr);
  const int32_t type = variant_type(callable.returns);
  if (type != GDE_NIL && engine.variant_get_type(&result) == type) {
    if (callable.returns == Type::kString || callable.returns == Type::kRecord)
      engine.variant_get_ptr_destructor(type)(out_return);
    engine.get_variant_to_type_constructor(type)(out_return, &result);
  }
  engine.variant_destroy(&result);
  for (size_t i = 0; i < count; ++i) engine.variant_destroy(&variants[i]);
}

/** Descriptions of properties and arguments, and the strings that they point to. */
class Descriptions {
 public:
  gde_property* add(const char* name, Type type, Hint hint = Hint::kNone, const char* hint_text = "") {
    const gde_string_name* engine_name = &names_.emplace_back(name).get();
    properties_.push_back({.type = variant_type(type),
                           .name = engine_name,
                           .class_name = &names_.emplace_back("").get(),
                           .hint = static_cast<uint32_t>(hint),
                           .hint_string = &strings_.emplace_back(hint_text).get(),
                           .usage = GDE_USAGE_DEFAULT});
    return &properties_.back();
  }
  gde_property* data() { return properties_.data(); }

 private:
  std::deque<EngineName> names_;
  std::deque<EngineString> strings_;
  std::vector<gde_property> properties_;
};

void register_callable(const EngineName& class_name, Callable callable) {
  Callable& kept = callables.emplace_back(std::move(callable));
  const EngineName name(kept.name.c_str());
  Descriptions arguments, returns;
  for (const Argument& argument : kept.arguments) arguments.add(argument.name, argument.type);
  std::vector<int32_t> metadata(kept.arguments.size(), 0);
  const bool returns_value = kept.returns != Type::kNil;
  const gde_method info{.name = &name.get(),
                        .method = &kept,
                        .call = call,
                        .ptrcall = ptrcall,
                        .flags = GDE_METHOD_NORMAL,
                        .has_return_value = returns_value,
                        .return_value = returns_value ? returns.add("", kept.returns) : nullptr,
                        .return_value_metadata = 0,
                        .argument_count = static_cast<uint32_t>(kept.arguments.size()),
                        .arguments = arguments.data(),
                        .argument_metadata = metadata.data(),
                        .default_argument_count = 0,
                        .default_arguments = nullptr};
  engine.classdb_register_extension_class_method(library, &class_name.get(), &info);
}

void register_property(const EngineName& class_name, const Field& field) {
  const std::string setter = std::string("set_") + field.name;
  const std::string getter = std::string("get_") + field.name;
  register_callable(class_name, {setter, Type::kNil, {{"value", field.type}}, nullptr, &field});
  register_callable(class_name, {getter, field.type, {}, nullptr, &field});
  Descriptions property;
  const EngineName setter_name(setter.c_str());
  const EngineName getter_name(getter.c_str());
  engine.classdb_register_extension_class_property(library, &class_name.get(),
                                                   property.add(field.name, field.type, field.hint, field.hint_text),
                                                   &setter_name.get(), &getter_name.get());
}

void register_properties(const EngineName& class_name, std::span<const Field> fields) {
  const EngineString no_prefix("");
  std::string_view group;
  for (const Field& field : fields) {
    if (field.group != group) {
      group = field.group;
      const EngineString name(field.group);
      engine.classdb_register_extension_class_property_group(library, &class_name.get(), &name.get(), &no_prefix.get());
    }
    register_property(class_name, field);
  }
}

void register_constant(const EngineName& class_name, const Constant& constant) {
  const EngineName name(constant.name);
  const EngineName enumeration(constant.enumeration);
  engine.classdb_register_extension_class_integer_constant(library, &class_name.get(), &enumeration.get(), &name.get(),
                                                           constant.value, constant.is_flag);
}

void register_signal(const EngineName& class_name, const Signal& signal) {
  const EngineName name(signal.name);
  Descriptions argument;
  engine.classdb_register_extension_class_signal(library, &class_name.get(), &name.get(),
                                                 argument.add(signal.argument.name, signal.argument.type), 1);
}

void initialize(void*, int32_t level) noexcept {
  if (level == GDE_LEVEL_EDITOR) engine.editor_help_load_xml_from_utf8_chars(class_reference);
  if (level != GDE_LEVEL_SCENE) return;
  const EngineName name(kClassName);
  const EngineName parent("Node3D");
  gde_class info{};
  info.is_exposed = true;
  info.create_instance = create_instance;
  info.free_instance = free_instance;
  info.get_virtual = get_virtual;
  engine.classdb_register_extension_class5(library, &name.get(), &parent.get(), &info);
  for (const Method& method : methods())
    register_callable(name, {method.name, method.returns, method.arguments, &method, nullptr});
  register_properties(name, config_fields);
  register_properties(name, setup_fields);
  for (const Signal& signal : kSignals) register_signal(name, signal);
  for (const Constant& constant : constants) register_constant(name, constant);
}

void deinitialize(void*, int32_t level) noexcept {
  if (level != GDE_LEVEL_SCENE) return;
  const EngineName name(kClassName);
  engine.classdb_unregister_extension_class(library, &name.get());
  callables.clear();
}

}  // namespace
}  // namespace hrt_godot

using namespace hrt_godot;

extern "C" GDE_EXPORT gde_bool haptic_retargeting_init(gde_get_proc_address get_proc_address, gde_library* own_library,
                                                       gde_initialization* out_initialization) {
  if (const char* missing = load_interface(get_proc_address)) {
    if (engine.print_error) {
      const std::string text = std::string("this Godot lacks ") + missing + "; Godot 4.4 or later has it";
      engine.print_error(text.c_str(), kClassName, "extension.cpp", __LINE__, true);
    }
    return false;
  }
  library = own_library;
  *out_initialization = {
      .minimum_level = GDE_LEVEL_SCENE, .data = nullptr, .initialize = initialize, .deinitialize = deinitialize};
  return true;
}
