#include "engine_double.h"

#include <dlfcn.h>

#include <cstring>
#include <stdexcept>

namespace godot4_double {
namespace {

Engine* current;

/** Engine values of 8 bytes, and variants, hold a pointer to what they stand for, which is counted. */
template <typename T>
void emplace(void* out, T value) {
  const T* held = new T(std::move(value));
  std::memcpy(out, &held, sizeof held);
  ++current->live_values;
}

template <typename T>
T* held(const void* value) {
  T* pointer;
  std::memcpy(&pointer, value, sizeof pointer);
  return pointer;
}

template <typename T>
void release(void* value) {
  delete held<T>(value);
  std::memset(value, 0xDD, sizeof(void*));
  --current->live_values;
}

const std::string& text(const gde_string_name* name) {
  return *held<std::string>(name);
}
const std::string& text(const gde_string* string) {
  return *held<std::string>(string);
}

int32_t type_of(const Any& any) {
  constexpr int32_t kTypes[] = {GDE_NIL,     GDE_BOOL,        GDE_INT,    GDE_FLOAT,      GDE_STRING,
                                GDE_VECTOR3, GDE_TRANSFORM3D, GDE_OBJECT, GDE_DICTIONARY, GDE_STRING_NAME};
  return kTypes[any.index()];
}

/** What a value of a type is in memory. */
Any read(int32_t type, const void* value) {
  switch (type) {
    case GDE_BOOL:
      return *static_cast<const gde_bool*>(value) != 0;
    case GDE_INT:
      return *static_cast<const int64_t*>(value);
    case GDE_FLOAT:
      return *static_cast<const double*>(value);
    case GDE_STRING:
      return *held<std::string>(value);
    case GDE_STRING_NAME:
      return StringName{*held<std::string>(value)};
    case GDE_VECTOR3:
      return *static_cast<const Vector3*>(value);
    case GDE_TRANSFORM3D:
      return *static_cast<const Transform3D*>(value);
    case GDE_OBJECT:
      return *static_cast<Object* const*>(value);
    case GDE_DICTIONARY:
      return *held<Dictionary>(value);
    default:
      throw std::logic_error("a value of type " + std::to_string(type));
  }
}

void write(void* out, const Any& any) {
  switch (type_of(any)) {
    case GDE_BOOL:
      *static_cast<gde_bool*>(out) = std::get<bool>(any);
      break;
    case GDE_INT:
      *static_cast<int64_t*>(out) = std::get<int64_t>(any);
      break;
    case GDE_FLOAT:
      *static_cast<double*>(out) = std::get<double>(any);
      break;
    case GDE_STRING:
      emplace(out, std::get<std::string>(any));
      break;
    case GDE_STRING_NAME:
      emplace(out, std::get<StringName>(any).text);
      break;
    case GDE_VECTOR3:
      *static_cast<Vector3*>(out) = std::get<Vector3>(any);
      break;
    case GDE_TRANSFORM3D:
      *static_cast<Transform3D*>(out) = std::get<Transform3D>(any);
      break;
    case GDE_OBJECT:
      *static_cast<Object**>(out) = std::get<Object*>(any);
      break;
    case GDE_DICTIONARY:
      emplace(out, std::get<Dictionary>(any));
      break;
    default:
      break;
  }
}

void destroy(int32_t type, void* value) {
  if (type == GDE_STRING || type == GDE_STRING_NAME) release<std::string>(value);
  if (type == GDE_DICTIONARY) release<Dictionary>(value);
}

Property describe(const gde_property& info) {
  text(info.class_name);  // must be there
  return {info.type, text(info.name), text(info.hint_string), info.hint, info.usage};
}

template <int32_t type>
void variant_from_type(gde_variant* out, const void* value) {
  emplace(out, read(type, value));
}

template <int32_t type>
void type_from_variant(void* out, const gde_variant* variant) {
  const Any& any = *held<Any>(variant);
  if (type_of(any) != type) throw std::logic_error("a variant is read as of another type");
  write(out, any);
}

/** One instance of a template of functions for each type. */
#define FOR_EACH_TYPE(type, function)                                        \
  switch (type) {                                                            \
    case GDE_BOOL:                                                           \
      return function<GDE_BOOL>;                                             \
    case GDE_INT:                                                            \
      return function<GDE_INT>;                                              \
    case GDE_FLOAT:                                                          \
      return function<GDE_FLOAT>;                                            \
    case GDE_STRING:                                                         \
      return function<GDE_STRING>;                                           \
    case GDE_STRING_NAME:                                                    \
      return function<GDE_STRING_NAME>;                                      \
    case GDE_VECTOR3:                                                        \
      return function<GDE_VECTOR3>;                                          \
    case GDE_TRANSFORM3D:                                                    \
      return function<GDE_TRANSFORM3D>;                                      \
    case GDE_OBJECT:                                                         \
      return function<GDE_OBJECT>;                                           \
    case GDE_DICTIONARY:                                                     \
      return function<GDE_DICTIONARY>;                                       \
    default:                                                                 \
      throw std::logic_error("no function of type " + std::to_string(type)); \
  }

gde_variant_from_type get_variant_from_type_constructor(int32_t type){
    FOR_EACH_TYPE(type, variant_from_type)} gde_type_from_variant
    get_variant_to_type_constructor(int32_t type){FOR_EACH_TYPE(type, type_from_variant)}

gde_constructor variant_get_ptr_constructor(int32_t type, int32_t index) {
  if (type == GDE_STRING && index == GDE_STRING_OF_STRING_NAME)
    return [](void* out, const void* const* arguments) { emplace(out, *held<std::string>(arguments[0])); };
  if (type != GDE_DICTIONARY || index != 0) throw std::logic_error("a constructor that the double lacks");
  return [](void* out, const void* const*) { emplace(out, std::make_shared<DictionaryData>()); };
}

gde_destructor variant_get_ptr_destructor(int32_t type) {
  if (type == GDE_STRING || type == GDE_STRING_NAME) return release<std::string>;
  if (type == GDE_DICTIONARY) return release<Dictionary>;
  throw std::logic_error("a destructor of a type that has none");
}

void print_error(const char* text, const char*, const char*, int32_t, gde_bool) {
  current->errors.emplace_back(text);
}

void variant_new_nil(gde_variant* out) {
  emplace(out, Any());
}
void variant_new_copy(gde_variant* out, const gde_variant* from) {
  emplace(out, *held<Any>(from));
}
void variant_destroy(gde_variant* self) {
  release<Any>(self);
}
int32_t variant_get_type(const gde_variant* self) {
  return type_of(*held<Any>(self));
}

/** The methods of a Node3D that the extension calls. */
void variant_call(gde_variant* self, const gde_string_name* name, const gde_variant* const* arguments,
                  int64_t argument_count, gde_variant* out_return, gde_call_error* out_error) {
  Object& object = *std::get<Object*>(*held<Any>(self));
  const std::string& method = text(name);
  *out_error = {};
  if (method == "is_inside_tree") return emplace(out_return, Any(object.inside_tree));
  if (method == "get_global_transform" && !object.inside_tree) throw std::logic_error("not in the tree");
  if (method == "get_global_transform" || method == "get_transform")
    return emplace(out_return, Any(object.transform));
  if (method == "set_global_transform" && !object.inside_tree) throw std::logic_error("not in the tree");
  if (method == "set_global_transform" || method == "set_transform") {
    if (argument_count != 1) throw std::logic_error("the arguments of " + method);
    object.transform = std::get<Transform3D>(*held<Any>(arguments[0]));
    return emplace(out_return, Any());
  }
  if (method != "emit_signal" || argument_count != 2) throw std::logic_error("a call of " + method);
  const std::string& signal = std::get<std::string>(*held<Any>(arguments[0]));
  const Any& argument = *held<Any>(arguments[1]);
  if (current->classes.at(object.class_name).signals.at(signal).at(0).type != type_of(argument))
    throw std::logic_error(signal + " is emitted with another type");
  object.emitted.emplace_back(signal, argument);
  emplace(out_return, Any(int64_t{0}));
}

void string_new_with_utf8_chars(gde_string* out, const char* text) {
  emplace(out, std::string(text));
}
void string_name_new_with_utf8_chars(gde_string_name* out, const char* text) {
  emplace(out, std::string(text));
}

int64_t string_to_utf8_chars(const gde_string* self, char* out_text, int64_t capacity) {
  const std::string& string = text(self);
  if (out_text) string.copy(out_text, static_cast<size_t>(capacity));
  return static_cast<int64_t>(string.size());
}

gde_variant* dictionary_operator_index(gde_dictionary* self, const gde_variant* key) {
  auto& values = (*held<Dictionary>(self))->values;
  const auto [at, added] = values.try_emplace(std::get<std::string>(*held<Any>(key)));
  if (added) variant_new_nil(&at->second);
  return &at->second;
}

gde_object* classdb_construct_object(const gde_string_name* class_name) {
  if (text(class_name) != "Node3D") throw std::logic_error("an object of " + text(class_name));
  return new Object;
}

void object_set_instance(gde_object* object, const gde_string_name* class_name, void* instance) {
  static_cast<Object*>(object)->class_name = text(class_name);
  static_cast<Object*>(object)->instance = instance;
}

void classdb_register_extension_class2(gde_library*, const gde_string_name* name,
                                       const gde_string_name* parent, const gde_class2* info) {
  Class& registered = current->classes[text(name)];
  registered.parent = text(parent);
  registered.info = *info;
}

void classdb_register_extension_class_method(gde_library*, const gde_string_name* class_name,
                                             const gde_method* info) {
  Method method{.info = *info};
  if (info->has_return_value) method.return_type = describe(*info->return_value).type;
  for (uint32_t i = 0; i < info->argument_count; ++i)
    method.arguments.push_back(describe(info->arguments[i]));
  if (!current->classes.at(text(class_name)).methods.emplace(text(info->name), method).second)
    throw std::logic_error(text(info->name) + " is registered twice");
}

void classdb_register_extension_class_property(gde_library*, const gde_string_name* class_name,
                                               const gde_property* info, const gde_string_name* setter,
                                               const gde_string_name* getter) {
  Class& registered = current->classes.at(text(class_name));
  const Property property = describe(*info);
  const Method& set = registered.methods.at(text(setter));
  const Method& get = registered.methods.at(text(getter));
  if (set.arguments.size() != 1 || set.arguments[0].type != property.type || !get.arguments.empty() ||
      get.return_type != property.type)
    throw std::logic_error(property.name + " has accessors of another type");
  registered.properties[property.name] = property;
  registered.accessors[property.name] = {text(setter), text(getter)};
}

void classdb_register_extension_class_signal(gde_library*, const gde_string_name* class_name,
                                             const gde_string_name* name, const gde_property* arguments,
                                             int64_t argument_count) {
  auto& signal = current->classes.at(text(class_name)).signals[text(name)];
  for (int64_t i = 0; i < argument_count; ++i) signal.push_back(describe(arguments[i]));
}

void classdb_register_extension_class_integer_constant(gde_library*, const gde_string_name* class_name,
                                                       const gde_string_name* enumeration,
                                                       const gde_string_name* name, int64_t value, gde_bool) {
  if (!current->classes.at(text(class_name))
           .constants.try_emplace(text(name), text(enumeration), value)
           .second)
    throw std::logic_error(text(name) + " is registered twice");
}

void classdb_unregister_extension_class(gde_library*, const gde_string_name* name) {
  if (!current->classes.erase(text(name))) throw std::logic_error("a class that is not registered");
}

gde_function get_proc_address(const char* name) {
  if (current->lacking == name) return nullptr;
#define FIND(function)                              \
  if (std::strcmp(name, #function) == 0) {          \
    gde_fn_##function* const address = function;    \
    return reinterpret_cast<gde_function>(address); \
  }
  GDE_FUNCTIONS(FIND)
#undef FIND
  return nullptr;
}

}  // namespace

DictionaryData::~DictionaryData() {
  for (auto& [key, value] : values) variant_destroy(&value);
}

Any DictionaryData::at(const std::string& key) const {
  return *held<Any>(&values.at(key));
}

Engine::Engine() {
  current = this;
}

Engine::~Engine() {
  if (library_) dlclose(library_);
}

bool Engine::load(const std::string& path) {
  library_ = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!library_) throw std::runtime_error(dlerror());
  using Entry = gde_bool(gde_get_proc_address, gde_library*, gde_initialization*);
  auto* entry = reinterpret_cast<Entry*>(dlsym(library_, "haptic_retargeting_init"));
  if (!entry) throw std::runtime_error(dlerror());
  if (!entry(get_proc_address, this, &initialization_)) return false;
  for (int32_t level = initialization_.minimum_level; level < 4; ++level)
    initialization_.initialize(initialization_.data, level);
  return true;
}

void Engine::unload() {
  for (int32_t level = 3; level >= initialization_.minimum_level; --level)
    initialization_.deinitialize(initialization_.data, level);
}

Object* Engine::create(const std::string& class_name) {
  const gde_class2& info = classes.at(class_name).info;
  return static_cast<Object*>(info.create_instance(info.class_data));
}

void Engine::free(Object* object) {
  const gde_class2& info = classes.at(object->class_name).info;
  info.free_instance(info.class_data, object->instance);
  delete object;
}

Any Engine::call(Object* object, const std::string& name, const std::vector<Any>& arguments) {
  const Method& method = classes.at(object->class_name).methods.at(name);
  std::vector<gde_variant> variants(arguments.size());
  std::vector<const gde_variant*> pointers;
  for (size_t i = 0; i < arguments.size(); ++i) {
    emplace(&variants[i], arguments[i]);
    pointers.push_back(&variants[i]);
  }
  gde_variant returned;
  variant_new_nil(&returned);
  gde_call_error error{};
  method.info.call(method.info.method, object->instance, pointers.data(),
                   static_cast<int64_t>(pointers.size()), &returned, &error);
  Any result = *held<Any>(&returned);
  variant_destroy(&returned);
  for (gde_variant& variant : variants) variant_destroy(&variant);
  return result;
}

Any Engine::ptrcall(Object* object, const std::string& name, const std::vector<Any>& arguments) {
  const Method& method = classes.at(object->class_name).methods.at(name);
  struct alignas(8) Slot {
    uint8_t bytes[48];
  };
  std::vector<Slot> slots(arguments.size());
  std::vector<const void*> pointers;
  for (size_t i = 0; i < arguments.size(); ++i) {
    if (type_of(arguments[i]) != method.arguments.at(i).type) throw std::logic_error("an argument's type");
    write(&slots[i], arguments[i]);
    pointers.push_back(&slots[i]);
  }
  const int32_t type = method.return_type;
  Slot returned{};
  if (type == GDE_STRING) write(&returned, std::string());
  if (type == GDE_DICTIONARY) write(&returned, std::make_shared<DictionaryData>());
  method.info.ptrcall(method.info.method, object->instance, pointers.data(),
                      type == GDE_NIL ? nullptr : &returned);
  Any result;
  if (type != GDE_NIL) result = read(type, &returned);
  destroy(type, &returned);
  for (size_t i = 0; i < arguments.size(); ++i) destroy(type_of(arguments[i]), &slots[i]);
  return result;
}

void Engine::set(Object* object, const std::string& property, const Any& value) {
  call(object, classes.at(object->class_name).accessors.at(property).first, {value});
}

Any Engine::get(Object* object, const std::string& property) {
  return call(object, classes.at(object->class_name).accessors.at(property).second, {});
}

}  // namespace godot4_double
