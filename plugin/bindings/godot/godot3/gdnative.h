/*
 * GDNative, as far as this binding uses it: the C interface of Godot 3, whose tables only ever grow, so that
 * what stands here is the same in all of 3.x. Declared here because Godot's own headers are not part of
 * the engine's packages.
 *
 * Engine values are opaque bytes, also where they are passed by value: an array of floats in their place
 * would travel in other registers. Functions that are not used are counted by their slots.
 */
#ifndef HRT_GODOT3_GDNATIVE_H
#define HRT_GODOT3_GDNATIVE_H

#include <stdint.h>

#if defined(_WIN32)
#define GDN_EXPORT __declspec(dllexport)
#else
#define GDN_EXPORT __attribute__((visibility("default")))
#endif

extern "C" {

typedef void godot_object;
typedef void godot_method_bind;
typedef uint8_t godot_bool;
typedef int32_t godot_int;

typedef struct {
  uint8_t bytes[24];
} godot_variant;
typedef struct {
  uint8_t bytes[8];
} godot_string;
typedef struct {
  uint8_t bytes[8];
} godot_char_string;
typedef struct {
  uint8_t bytes[8];
} godot_dictionary;
/* Of three floats. */
typedef struct {
  uint8_t bytes[12];
} godot_vector3;
/* Of twelve floats: the rows of the basis, and the origin. */
typedef struct {
  uint8_t bytes[48];
} godot_transform;

/* Type of a variant. */
enum {
  GODOT_NIL = 0,
  GODOT_BOOL = 1,
  GODOT_INT = 2,
  GODOT_REAL = 3,
  GODOT_STRING = 4,
  GODOT_VECTOR3 = 7,
  GODOT_TRANSFORM = 13,
  GODOT_DICTIONARY = 18
};

typedef struct {
  int32_t error;
  int32_t argument;
  int32_t expected;
} godot_variant_call_error;

typedef struct {
  uint32_t major;
  uint32_t minor;
} godot_version;

/* How every table begins. */
typedef struct godot_api {
  uint32_t type; /* GODOT_API_* */
  godot_version version;
  const struct godot_api* next;
} godot_api;

enum { GODOT_API_CORE = 0, GODOT_API_NATIVESCRIPT = 1 };

typedef void (*godot_slot)(void);

typedef struct {
  godot_api header;
  uint32_t num_extensions;
  const godot_api* const* extensions;

  godot_slot slots_0[362];
  void (*dictionary_new)(godot_dictionary* out);
  godot_slot slots_363[1];
  void (*dictionary_destroy)(godot_dictionary* self);
  godot_slot slots_365[375 - 365];
  void (*dictionary_set)(godot_dictionary* self, const godot_variant* key, const godot_variant* value);
  godot_slot slots_376[507 - 376];
  int32_t (*variant_get_type)(const godot_variant* self);
  godot_slot slots_508[1];
  void (*variant_new_nil)(godot_variant* out);
  void (*variant_new_bool)(godot_variant* out, godot_bool value);
  godot_slot slots_511[1];
  void (*variant_new_int)(godot_variant* out, int64_t value);
  void (*variant_new_real)(godot_variant* out, double value);
  void (*variant_new_string)(godot_variant* out, const godot_string* value);
  godot_slot slots_515[517 - 515];
  void (*variant_new_vector3)(godot_variant* out, const godot_vector3* value);
  godot_slot slots_518[523 - 518];
  void (*variant_new_transform)(godot_variant* out, const godot_transform* value);
  godot_slot slots_524[528 - 524];
  void (*variant_new_dictionary)(godot_variant* out, const godot_dictionary* value);
  godot_slot slots_529[537 - 529];
  godot_bool (*variant_as_bool)(const godot_variant* self);
  godot_slot slots_538[1];
  int64_t (*variant_as_int)(const godot_variant* self);
  double (*variant_as_real)(const godot_variant* self);
  godot_string (*variant_as_string)(const godot_variant* self);
  godot_slot slots_542[544 - 542];
  godot_vector3 (*variant_as_vector3)(const godot_variant* self);
  godot_slot slots_545[550 - 545];
  godot_transform (*variant_as_transform)(const godot_variant* self);
  godot_slot slots_551[570 - 551];
  void (*variant_destroy)(godot_variant* self);
  godot_slot slots_571[1];
  const char* (*char_string_get_data)(const godot_char_string* self);
  void (*char_string_destroy)(godot_char_string* self);
  void (*string_new)(godot_string* out);
  godot_slot slots_575[678 - 575];
  godot_char_string (*string_utf8)(const godot_string* self);
  godot_bool (*string_parse_utf8)(godot_string* self, const char* utf8);
  godot_slot slots_680[721 - 680];
  void (*string_destroy)(godot_string* self);
  godot_slot slots_722[732 - 722];
  godot_method_bind* (*method_bind_get_method)(const char* class_name, const char* method_name);
  void (*method_bind_ptrcall)(godot_method_bind* method, godot_object* object, const void** arguments,
                              void* out_result);
  godot_variant (*method_bind_call)(godot_method_bind* method, godot_object* object,
                                    const godot_variant** arguments, int argument_count,
                                    godot_variant_call_error* out_error);
  godot_slot slots_735[741 - 735];
  void (*print_error)(const char* text, const char* function, const char* file, int line);
} godot_core_api;

typedef struct {
  godot_bool in_editor;
  uint64_t core_api_hash;
  uint64_t editor_api_hash;
  uint64_t no_api_hash;
  godot_slot report_version_mismatch;
  void (*report_loading_error)(const godot_object* library, const char* what);
  godot_object* library;
  const godot_core_api* api;
  const godot_string* library_path;
} godot_init_options;

/* The extension in which classes are registered. Its free_func may be null. */

typedef struct {
  void* (*create)(godot_object* object, void* method_data);
  void* method_data;
  void (*free_func)(void* method_data);
} godot_create;

typedef struct {
  void (*destroy)(godot_object* object, void* method_data, void* user_data);
  void* method_data;
  void (*free_func)(void* method_data);
} godot_destroy;

typedef struct {
  int32_t rpc_type;
} godot_method_attributes;

typedef struct {
  godot_variant (*method)(godot_object* object, void* method_data, void* user_data, int argument_count,
                          godot_variant** arguments);
  void* method_data;
  void (*free_func)(void* method_data);
} godot_method;

enum { GODOT_HINT_NONE = 0, GODOT_HINT_ENUM = 3 };
enum { GODOT_USAGE_DEFAULT = 7 };

typedef struct {
  int32_t rset_type;
  godot_int type;
  int32_t hint;
  godot_string hint_string;
  int32_t usage;
  godot_variant default_value;
} godot_property_attributes;

typedef struct {
  void (*set)(godot_object* object, void* method_data, void* user_data, godot_variant* value);
  void* method_data;
  void (*free_func)(void* method_data);
} godot_property_set;

typedef struct {
  godot_variant (*get)(godot_object* object, void* method_data, void* user_data);
  void* method_data;
  void (*free_func)(void* method_data);
} godot_property_get;

typedef struct {
  godot_string name;
  godot_int type;
  int32_t hint;
  godot_string hint_string;
  int32_t usage;
  godot_variant default_value;
} godot_signal_argument;

typedef struct {
  godot_string name;
  int num_args;
  godot_signal_argument* args;
  int num_default_args;
  godot_variant* default_args;
} godot_signal;

typedef struct {
  godot_api header;
  void (*register_class)(void* handle, const char* name, const char* base, godot_create create,
                         godot_destroy destroy);
  godot_slot register_tool_class;
  void (*register_method)(void* handle, const char* class_name, const char* name,
                          godot_method_attributes attributes, godot_method method);
  void (*register_property)(void* handle, const char* class_name, const char* path,
                            godot_property_attributes* attributes, godot_property_set set,
                            godot_property_get get);
  void (*register_signal)(void* handle, const char* class_name, const godot_signal* signal);
} godot_nativescript_api;

}  // extern "C"

#endif
