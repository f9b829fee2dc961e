/*
 * The part of GDExtension that this binding uses: the C interface of Godot 4.4 and later, whose functions are
 * looked up by name.
 *
 * Engine values are opaque bytes with the sizes of 64-bit builds with single precision, such as the official
 * builds; a Vector3 is 3 floats, a Transform3D 12.
 */
#pragma once

#include <cstddef>
#include <cstdint>

#if defined(_WIN32)
#define GDE_EXPORT __declspec(dllexport)
#else
#define GDE_EXPORT __attribute__((visibility("default")))
#endif

/* Numbers of Godot's Variant.Type; value.h has those of the types that methods pass. */
enum { GDE_STRING = 4, GDE_STRING_NAME = 21, GDE_OBJECT = 24, GDE_PACKED_STRING_ARRAY = 34 };

template <int variant_type, size_t size>
struct gde_opaque {
  alignas(8) uint8_t bytes[size];
};
typedef gde_opaque<0, 24> gde_variant;
typedef gde_opaque<GDE_STRING, 8> gde_string;
typedef gde_opaque<GDE_STRING_NAME, 8> gde_string_name;

extern "C" {

typedef void gde_object;
typedef void gde_library;
typedef uint8_t gde_bool;
typedef const gde_string_name* gde_name;

typedef struct {
  int32_t error, argument, expected;
} gde_call_error;

enum { GDE_USAGE_DEFAULT = 6, GDE_USAGE_VARIANT = 6 | 1 << 17 };
/* A property, an argument or a return value. */
typedef struct {
  int32_t type;
  gde_name name, class_name;
  uint32_t hint;
  const gde_string* hint_string;
  uint32_t usage;
} gde_property;

/* Arguments are variants; *out_return is an initialised variant. */
typedef void (*gde_call)(void* method, void* instance, const gde_variant* const* arguments, int64_t argument_count,
                         gde_variant* out_return, gde_call_error* out_error);
/* Arguments are values of the registered types; *out_return is an initialised value. */
typedef void (*gde_ptrcall)(void* method, void* instance, const void* const* arguments, void* out_return);

enum { GDE_METHOD_NORMAL = 1 };
typedef struct {
  gde_name name;
  void* method;
  gde_call call;
  gde_ptrcall ptrcall;
  uint32_t flags;
  gde_bool has_return_value;
  gde_property* return_value;
  int32_t return_value_metadata;
  uint32_t argument_count;
  gde_property* arguments;
  int32_t* argument_metadata;
  uint32_t default_argument_count;
  void** default_arguments;
} gde_method;

/* A virtual function of the engine that a class overrides; arguments and *out_return are as in gde_ptrcall. */
typedef void (*gde_virtual)(void* instance, const void* const* arguments, void* out_return);

/* Description of a class. This binding leaves the functions of type gde_unused null. */
typedef void (*gde_unused)(void);
typedef struct {
  gde_bool is_virtual, is_abstract, is_exposed, is_runtime;
  const gde_string* icon_path;
  gde_unused set, get, get_property_list, free_property_list, property_can_revert, property_get_revert;
  gde_unused validate_property, notification, to_string, reference, unreference;
  gde_object* (*create_instance)(void* class_data, gde_bool notify_postinitialize);
  void (*free_instance)(void* class_data, void* instance);
  gde_unused recreate_instance;
  gde_virtual (*get_virtual)(void* class_data, gde_name name, uint32_t hash);
  gde_unused get_virtual_call_data, call_virtual_with_data, get_rid;
  void* class_data;
} gde_class;

enum { GDE_LEVEL_SCENE = 2, GDE_LEVEL_EDITOR = 3 };
typedef struct {
  int32_t minimum_level;
  void* data;
  void (*initialize)(void* data, int32_t level);
  void (*deinitialize)(void* data, int32_t level);
} gde_initialization;

typedef void (*gde_function)(void);
typedef gde_function (*gde_get_proc_address)(const char* name);

typedef void (*gde_variant_from_type)(gde_variant* out, const void* value);
typedef void (*gde_type_from_variant)(void* out, const gde_variant* variant);
typedef void (*gde_constructor)(void* out, const void* const* arguments);
typedef void (*gde_destructor)(void* value);

/* X(result, name, arguments...) for each function of the engine, which is looked up by that name. */
#define GDE_FUNCTIONS(X)                                                                                              \
  X(void, print_error, const char* text, const char* function, const char* file, int32_t line, gde_bool notify)       \
  X(void, print_warning, const char* text, const char* function, const char* file, int32_t line, gde_bool notify)     \
  X(void, variant_new_nil, gde_variant* out)                                                                          \
  X(void, variant_destroy, gde_variant* self)                                                                         \
  X(int32_t, variant_get_type, const gde_variant* self)                                                               \
  X(void, variant_call, gde_variant* self, gde_name method, const gde_variant* const* arguments, int64_t count,       \
    gde_variant* out_return, gde_call_error* out_error)                                                               \
  X(gde_variant_from_type, get_variant_from_type_constructor, int32_t type)                                           \
  X(gde_type_from_variant, get_variant_to_type_constructor, int32_t type)                                             \
  X(gde_constructor, variant_get_ptr_constructor, int32_t type, int32_t index)                                        \
  /* Returns null for a type without a destructor. */                                                                 \
  X(gde_destructor, variant_get_ptr_destructor, int32_t type)                                                         \
  X(void, string_new_with_utf8_chars, gde_string* out, const char* text)                                              \
  X(void, string_name_new_with_utf8_chars, gde_string_name* out, const char* text)                                    \
  /* Returns the number of bytes; writes no zero after them. */                                                       \
  X(int64_t, string_to_utf8_chars, const gde_string* self, char* out_text, int64_t capacity)                          \
  X(gde_variant*, dictionary_operator_index, void* dictionary, const gde_variant* key)                                \
  X(gde_object*, global_get_singleton, gde_name name)                                                                 \
  X(void, object_set_instance, gde_object* object, gde_name class_name, void* instance)                               \
  X(gde_object*, classdb_construct_object2, gde_name class_name)                                                      \
  X(void, classdb_register_extension_class5, gde_library* library, gde_name name, gde_name parent,                    \
    const gde_class* info)                                                                                            \
  X(void, classdb_register_extension_class_integer_constant, gde_library* library, gde_name class_name,               \
    gde_name enumeration, gde_name name, int64_t value, gde_bool is_bitfield)                                         \
  X(void, classdb_register_extension_class_method, gde_library* library, gde_name class_name, const gde_method* info) \
  X(void, classdb_register_extension_class_property, gde_library* library, gde_name class_name,                       \
    const gde_property* info, gde_name setter, gde_name getter)                                                       \
  /* Properties that are registered afterwards are shown in the group. */                                             \
  X(void, classdb_register_extension_class_property_group, gde_library* library, gde_name class_name,                 \
    const gde_string* group, const gde_string* prefix)                                                                \
  X(void, classdb_register_extension_class_signal, gde_library* library, gde_name class_name, gde_name name,          \
    const gde_property* arguments, int64_t argument_count)                                                            \
  X(void, classdb_unregister_extension_class, gde_library* library, gde_name name)                                    \
  /* For a call at GDE_LEVEL_EDITOR, which the engine initialises only in the editor. */                              \
  X(void, editor_help_load_xml_from_utf8_chars, const char* xml)

}  // extern "C"
