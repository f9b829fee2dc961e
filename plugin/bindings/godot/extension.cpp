// The class HapticRetargeting in Godot: a Node3D, through GDExtension's C interface.

#include <algorithm>
#include <array>
#include <deque>
#include <exception>
#include <functional>
#include <new>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gdextension.h"
#include "plate_node.h"

namespace hrt_godot {
namespace {

struct Interface {
#define DECLARE(result, name, ...) result (*name)(__VA_ARGS__);
  GDE_FUNCTIONS(DECLARE)
#undef DECLARE
};
Interface engine;
gde_library* library;

/** Fills `engine`. Returns null, or the name of the first function that this version of Godot lacks. */
const char* load_interface(gde_get_proc_address get_proc_address) {
  // In Godot 4.4, classdb_register_extension_class5 has the name classdb_register_extension_class4.
  const auto load = [&](const std::string_view name) {
    const gde_function found = get_proc_address(name.data());
    return found || name != "classdb_register_extension_class5" ? found
                                                                : get_proc_address("classdb_register_extension_class4");
  };
#define LOAD(result, name, ...)                                       \
  engine.name = reinterpret_cast<decltype(engine.name)>(load(#name)); \
  if (!engine.name) return #name;
  GDE_FUNCTIONS(LOAD)
#undef LOAD
  return nullptr;
}

constexpr int32_t number(Type type) { return static_cast<int32_t>(type); }

void destroy(int32_t type, void* value) {
  if (const gde_destructor destructor = engine.variant_get_ptr_destructor(type)) destructor(value);
}

/** A string of the engine, destroyed at the end of its scope. */
template <typename Text, auto make, int32_t type>
class EngineText {
 public:
  explicit EngineText(const char* utf8) { (engine.*make)(&text_, utf8); }
  EngineText(const EngineText&) = delete;
  EngineText& operator=(const EngineText&) = delete;
  ~EngineText() { destroy(type, &text_); }
  const Text* get() const { return &text_; }

 private:
  Text text_;
};
using EngineString = EngineText<gde_string, &Interface::string_new_with_utf8_chars, GDE_STRING>;
using EngineName = EngineText<gde_string_name, &Interface::string_name_new_with_utf8_chars, GDE_STRING_NAME>;

void assign(gde_variant* variant, const Value& value);

class Variant {
 public:
  Variant() { engine.variant_new_nil(&variant_); }
  Variant(int32_t type, const void* value) { engine.get_variant_from_type_constructor(type)(&variant_, value); }
  explicit Variant(const Value& value) : Variant() { assign(&variant_, value); }
  Variant(const Variant&) = delete;
  Variant& operator=(const Variant&) = delete;
  ~Variant() { engine.variant_destroy(&variant_); }
  gde_variant* get() { return &variant_; }

 private:
  gde_variant variant_;
};

/** Memory layout of the engine's transform: the rows of the basis, and the origin. */
struct EngineTransform {
  Eigen::Matrix<float, 3, 3, Eigen::RowMajor> basis;
  Eigen::Vector3f origin;
};
/** Memory for an engine value of any type that methods pass. */
struct EngineValue {
  alignas(8) std::byte bytes[sizeof(EngineTransform)];
};

template <typename T>
const T& as(const void* value) {
  return *static_cast<const T*>(value);
}

Value from_variant(const gde_variant* variant);

/** Converts an engine value. Returns null for a type that no method of the class accepts. */
Value decode(Type type, const void* value) {
  if (type == Type::kBool) return as<gde_bool>(value) != 0;
  if (type == Type::kInt) return as<int64_t>(value);
  if (type == Type::kReal) return as<double>(value);
  if (type == Type::kTime) return from_variant(static_cast<const gde_variant*>(value));
  if (type == Type::kVector3) return Vector3(as<Eigen::Vector3f>(value).cast<double>());
  if (type == Type::kPose) {
    const auto& [basis, origin] = as<EngineTransform>(value);
    return Pose{basis.cast<double>(), origin.cast<double>()};
  }
  if (type != Type::kString) return {};
  const auto& string = as<gde_string>(value);
  std::string text(static_cast<size_t>(engine.string_to_utf8_chars(&string, nullptr, 0)), '\0');
  engine.string_to_utf8_chars(&string, text.data(), static_cast<int64_t>(text.size()));
  return text;
}

/** Constructs an engine value, which the caller destroys. Does nothing if `value` is null. */
void encode(const Value& value, void* out) {
  std::visit(
      [&]<typename T>(const T& each) {
        if constexpr (std::is_same_v<T, std::string>) {
          engine.string_new_with_utf8_chars(static_cast<gde_string*>(out), each.c_str());
        } else if constexpr (std::is_same_v<T, Vector3>) {
          new (out) Eigen::Vector3f(each.template cast<float>());
        } else if constexpr (std::is_same_v<T, Pose>) {
          new (out) EngineTransform{each.basis.template cast<float>(), each.origin.template cast<float>()};
        } else if constexpr (std::is_same_v<T, Record>) {
          engine.variant_get_ptr_constructor(number(Type::kRecord), 0)(out, nullptr);
          for (const auto& [key, entry] : each)
            assign(engine.dictionary_operator_index(out, Variant(GDE_STRING, EngineString(key).get()).get()), entry);
        } else if constexpr (!std::is_same_v<T, std::monostate>) {
          new (out) T(each);
        }
      },
      value);
}

void assign(gde_variant* variant, const Value& value) {
  engine.variant_destroy(variant);
  const int32_t type = number(type_of(value));
  if (type == number(Type::kNil)) return engine.variant_new_nil(variant);
  EngineValue storage;
  encode(value, &storage);
  engine.get_variant_from_type_constructor(type)(variant, &storage);
  destroy(type, &storage);
}

/** Converts a variant. Returns null for a type that no method of the class accepts. */
Value from_variant(const gde_variant* variant) {
  Type type{engine.variant_get_type(variant)};
  if (type == Type{GDE_STRING_NAME}) type = Type::kString;  // for example the name of a node
  if (type == Type::kNil || std::ranges::find(kTypes, type, &TypeName::type) == std::end(kTypes)) return {};
  EngineValue storage;
  engine.get_variant_to_type_constructor(number(type))(&storage, variant);
  Value value = decode(type, &storage);
  destroy(number(type), &storage);
  return value;
}

Value call_on(Variant& self, const char* method, std::initializer_list<const gde_variant*> arguments) {
  const EngineName name(method);
  Variant result;
  gde_call_error error;
  engine.variant_call(self.get(), name.get(), arguments.begin(), std::ssize(arguments), result.get(), &error);
  return from_variant(result.get());
}

constexpr int64_t kNotificationPostInitialize = 0;

/** A node of a scene, with the PlateNode that implements it. */
class Instance : public Engine {
 public:
  explicit Instance(gde_object* object) : object_(object), node_(*this) {}
  PlateNode& node() { return node_; }

  Pose node_pose() override {
    return std::get<Pose>(call(is_inside_tree() ? "get_global_transform" : "get_transform"));
  }
  void move_node(const Pose& pose) override {
    call(is_inside_tree() ? "set_global_transform" : "set_transform", {Variant(pose).get()});
  }
  void emit(const Signal& signal, const Value& argument) override {
    call("emit_signal", {Variant(signal.name).get(), Variant(argument).get()});
  }
  void notify(int64_t what) { call("notification", {Variant(what).get()}); }

  void update_warnings() override { call("update_configuration_warnings"); }

  std::string system_path(std::string path) override {
    if (!path.starts_with("res://") && !path.starts_with("user://")) return path;
    gde_object* settings = engine.global_get_singleton(EngineName("ProjectSettings").get());
    Variant self(GDE_OBJECT, &settings);
    return std::get<std::string>(call_on(self, "globalize_path", {Variant(Value(path)).get()}));
  }

  void push_error(const char* text) override { engine.print_error(text, kClassName, "extension.cpp", __LINE__, false); }
  void push_warning(const char* text) override {
    engine.print_warning(text, kClassName, "extension.cpp", __LINE__, false);
  }

 private:
  bool is_inside_tree() { return std::get<bool>(call("is_inside_tree")); }

  Value call(const char* method, std::initializer_list<const gde_variant*> arguments = {}) {
    Variant self(GDE_OBJECT, &object_);
    return call_on(self, method, arguments);
  }

  gde_object* object_;
  PlateNode node_;
};

gde_object* create_instance(void*, gde_bool notify) noexcept {
  gde_object* object = engine.classdb_construct_object2(EngineName("Node3D").get());
  Instance* instance = new (std::nothrow) Instance(object);
  if (!instance) return object;
  engine.object_set_instance(object, EngineName(kClassName).get(), instance);
  if (notify) instance->notify(kNotificationPostInitialize);
  return object;
}

void free_instance(void*, void* instance) noexcept { delete static_cast<Instance*>(instance); }

/** Implements Godot's virtual method Node._get_configuration_warnings(). */
void get_warnings(void* instance, const void* const*, void* out_return) noexcept try {
  const std::string warning = static_cast<Instance*>(instance)->node().warning();
  if (warning.empty()) return;
  Variant warnings(GDE_PACKED_STRING_ARRAY, out_return);
  call_on(warnings, "append", {Variant(warning).get()});
  destroy(GDE_PACKED_STRING_ARRAY, out_return);
  engine.get_variant_to_type_constructor(GDE_PACKED_STRING_ARRAY)(out_return, warnings.get());
} catch (const std::exception& error) {
  static_cast<Instance*>(instance)->push_error(error.what());
}

gde_virtual get_virtual(void*, gde_name name, uint32_t) noexcept {
  const Value text = from_variant(Variant(GDE_STRING_NAME, name).get());
  return std::get<std::string>(text) == "_get_configuration_warnings" ? get_warnings : nullptr;
}

/** A function that the engine calls: a method, or the setter or getter of a property. */
struct Callable {
  std::string name;
  Type returns;
  std::vector<Argument> arguments;
  std::function<Value(PlateNode& node, std::span<const Value> values)> function;
};
/** All callables. The engine keeps pointers to the elements, so they must not move. */
std::deque<Callable> callables;

/** Runs a callable. If it throws, shows the exception and returns null. `argument(i)` returns argument i. */
Value run(const Callable& callable, void* instance, size_t count, auto argument) noexcept try {
  if (!instance) return {};
  std::array<Value, kArgumentsMax> values;
  count = std::min(count, values.size());
  for (size_t i = 0; i < count; ++i) values[i] = argument(i);
  return callable.function(static_cast<Instance*>(instance)->node(), std::span(values).first(count));
} catch (const std::exception& error) {
  static_cast<Instance*>(instance)->push_error(error.what());
  return {};
}

void call(void* callable, void* instance, const gde_variant* const* arguments, int64_t count, gde_variant* out_return,
          gde_call_error*) noexcept {
  assign(out_return, run(as<Callable>(callable), instance, static_cast<size_t>(count),
                         [&](size_t i) { return from_variant(arguments[i]); }));
}

/** Does the same as call() with values of the registered types. */
void ptrcall(void* data, void* instance, const void* const* arguments, void* out_return) noexcept {
  const auto& callable = as<Callable>(data);
  const Value result = run(callable, instance, callable.arguments.size(),
                           [&](size_t i) { return decode(callable.arguments[i].type, arguments[i]); });
  if (callable.returns == Type::kNil || type_of(result) != callable.returns) return;
  destroy(number(callable.returns), out_return);
  encode(result, out_return);
}

/** Registers the class. Owns the names and texts to which the descriptions for the engine point. */
class Registration {
 public:
  void add_class() {
    const gde_class info{.is_exposed = true,
                         .create_instance = create_instance,
                         .free_instance = free_instance,
                         .get_virtual = get_virtual};
    engine.classdb_register_extension_class5(library, class_, name("Node3D"), &info);
  }

  void add_method(Callable callable) {
    Callable& kept = callables.emplace_back(std::move(callable));
    std::vector<gde_property> arguments;
    for (const Argument& argument : kept.arguments) arguments.push_back(describe(argument.name, argument.type));
    std::vector<int32_t> metadata(arguments.size(), 0);
    gde_property returned = describe("", kept.returns);
    const bool returns_value = kept.returns != Type::kNil;
    const gde_method info{.name = name(kept.name.c_str()),
                          .method = &kept,
                          .call = call,
                          .ptrcall = ptrcall,
                          .flags = GDE_METHOD_NORMAL,
                          .has_return_value = returns_value,
                          .return_value = returns_value ? &returned : nullptr,
                          .argument_count = static_cast<uint32_t>(arguments.size()),
                          .arguments = arguments.data(),
                          .argument_metadata = metadata.data()};
    engine.classdb_register_extension_class_method(library, class_, &info);
  }

  void add_property(const Property& property) {
    if (property.group != group_)
      engine.classdb_register_extension_class_property_group(library, class_, text(property.group), text(""));
    group_ = property.group;
    const Type type = type_of(property.get(defaults_));
    const std::string setter = std::string("set_") + property.name, getter = std::string("get_") + property.name;
    add_method({setter, Type::kNil, {{"value", type}}, [&property](PlateNode& node, std::span<const Value> values) {
                  if (values.size() == 1) node.set(property, values[0]);
                  return Value();
                }});
    add_method({getter, type, {}, [&property](PlateNode& node, auto) { return node.get(property); }});
    const gde_property info = describe(property.name, type, property.hint, property.hint_text);
    engine.classdb_register_extension_class_property(library, class_, &info, name(setter.c_str()),
                                                     name(getter.c_str()));
  }

  void add_signal(const Signal& signal) {
    const gde_property argument = describe(signal.argument.name, signal.argument.type);
    engine.classdb_register_extension_class_signal(library, class_, name(signal.name), &argument, 1);
  }

  void add_constant(const Constant& constant) {
    engine.classdb_register_extension_class_integer_constant(library, class_, name(constant.enumeration),
                                                             name(constant.name), constant.value, constant.is_flag);
  }

 private:
  gde_name name(const char* utf8) { return names_.emplace_back(utf8).get(); }
  const gde_string* text(const char* utf8) { return texts_.emplace_back(utf8).get(); }
  gde_property describe(const char* own_name, Type type, Hint hint = Hint::kNone, const char* hint_text = "") {
    return {.type = number(type == Type::kTime ? Type::kNil : type),
            .name = name(own_name),
            .class_name = name(""),
            .hint = static_cast<uint32_t>(hint),
            .hint_string = text(hint_text),
            .usage = type == Type::kTime ? GDE_USAGE_VARIANT : GDE_USAGE_DEFAULT};
  }

  std::deque<EngineName> names_;
  std::deque<EngineString> texts_;
  gde_name class_ = name(kClassName);
  Properties defaults_;
  std::string_view group_;
};

void initialize(void*, int32_t level) noexcept {
  if (level == GDE_LEVEL_EDITOR) engine.editor_help_load_xml_from_utf8_chars(class_reference);
  if (level != GDE_LEVEL_SCENE) return;
  Registration registration;
  registration.add_class();
  for (const Method& method : methods)
    registration.add_method(
        {method.name, method.returns, method.arguments,
         [&method](PlateNode& node, std::span<const Value> values) { return node.call(method, values); }});
  for (const Property& property : properties) registration.add_property(property);
  for (const Signal& signal : kSignals) registration.add_signal(signal);
  for (const Constant& constant : constants) registration.add_constant(constant);
}

void deinitialize(void*, int32_t level) noexcept {
  if (level != GDE_LEVEL_SCENE) return;
  engine.classdb_unregister_extension_class(library, EngineName(kClassName).get());
  callables.clear();
}

}  // namespace
}  // namespace hrt_godot

using namespace hrt_godot;

extern "C" GDE_EXPORT gde_bool haptic_retargeting_init(gde_get_proc_address get_proc_address, gde_library* own_library,
                                                       gde_initialization* out_initialization) {
  if (const char* missing = load_interface(get_proc_address)) {
    if (engine.print_error) {
      const std::string text = std::string("this version of Godot lacks ") + missing + "; use Godot 4.4 or later";
      engine.print_error(text.c_str(), kClassName, "extension.cpp", __LINE__, true);
    }
    return false;
  }
  library = own_library;
  *out_initialization = {
      .minimum_level = GDE_LEVEL_SCENE, .data = nullptr, .initialize = initialize, .deinitialize = deinitialize};
  return true;
}
