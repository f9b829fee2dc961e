// gdextension.h against facts of the engine's own gdextension_interface.h (MIT licence), read off godot-cpp's
// commits 04b3f745 (Godot 4.5) and e3f3cb58 (Godot 4.3): numbers, sizes and offsets on 64-bit machines, and
// how many arguments each function takes. Compiling is the test.

#include <cstddef>
#include <type_traits>

#include "../../../../plugin/bindings/godot/godot4/gdextension.h"

static_assert(GDE_NIL == 0 && GDE_BOOL == 1 && GDE_INT == 2 && GDE_FLOAT == 3 && GDE_STRING == 4);
static_assert(GDE_VECTOR3 == 9 && GDE_TRANSFORM3D == 18 && GDE_STRING_NAME == 21 && GDE_OBJECT == 24);
static_assert(GDE_DICTIONARY == 27 && GDE_METHOD_NORMAL == 1 && GDE_LEVEL_SCENE == 2);
// extension_api.json of Godot 4.7: sizes "float_64". PropertyHint, PropertyUsageFlags (storage 2, editor 4),
// constructors of String: of the class reference.
static_assert(GDE_HINT_NONE == 0 && GDE_HINT_ENUM == 2 && GDE_USAGE_DEFAULT == 6 &&
              GDE_STRING_OF_STRING_NAME == 2);
static_assert(sizeof(gde_variant) == 24 && sizeof(gde_string) == 8 && sizeof(gde_string_name) == 8);
static_assert(sizeof(gde_dictionary) == 8 && sizeof(gde_bool) == 1);

static_assert(sizeof(gde_call_error) == 12 && offsetof(gde_call_error, expected) == 8);

static_assert(sizeof(gde_property) == 48 && offsetof(gde_property, name) == 8);
static_assert(offsetof(gde_property, class_name) == 16 && offsetof(gde_property, hint) == 24);
static_assert(offsetof(gde_property, hint_string) == 32 && offsetof(gde_property, usage) == 40);

static_assert(sizeof(gde_method) == 88 && offsetof(gde_method, method) == 8 &&
              offsetof(gde_method, call) == 16);
static_assert(offsetof(gde_method, ptrcall) == 24 && offsetof(gde_method, flags) == 32);
static_assert(offsetof(gde_method, has_return_value) == 36 && offsetof(gde_method, return_value) == 40);
static_assert(offsetof(gde_method, return_value_metadata) == 48 &&
              offsetof(gde_method, argument_count) == 52);
static_assert(offsetof(gde_method, arguments) == 56 && offsetof(gde_method, argument_metadata) == 64);
static_assert(offsetof(gde_method, default_argument_count) == 72 &&
              offsetof(gde_method, default_arguments) == 80);

// GDExtensionClassCreationInfo2: three flags, then nineteen pointers.
static_assert(sizeof(gde_class2) == 160 && offsetof(gde_class2, is_exposed) == 2 &&
              offsetof(gde_class2, set) == 8);
static_assert(offsetof(gde_class2, notification) == 64 && offsetof(gde_class2, create_instance) == 96);
static_assert(offsetof(gde_class2, free_instance) == 104 && offsetof(gde_class2, get_virtual) == 120);
static_assert(offsetof(gde_class2, get_rid) == 144 && offsetof(gde_class2, class_data) == 152);

static_assert(sizeof(gde_initialization) == 32 && offsetof(gde_initialization, data) == 8);
static_assert(offsetof(gde_initialization, initialize) == 16 &&
              offsetof(gde_initialization, deinitialize) == 24);

namespace {

/** p a pointer, i 64 bits, w 32 bits, b 8 bits, v nothing: a function's result and arguments, as machines
 * pass them. */
template <typename T>
constexpr char kind() {
  if constexpr (std::is_void_v<T>)
    return 'v';
  else if constexpr (std::is_pointer_v<T>)
    return 'p';
  else
    return sizeof(T) == 8 ? 'i' : sizeof(T) == 4 ? 'w' : 'b';
}

template <typename Function>
struct Signature;
template <typename Result, typename... Arguments>
struct Signature<Result(Arguments...)> {
  static constexpr bool is(const char* expected) {
    const char found[] = {kind<Result>(), kind<Arguments>()..., '\0'};
    for (size_t i = 0; i < sizeof found; ++i)
      if (found[i] != expected[i]) return false;
    return true;
  }
};

#define HAS(function, expected) static_assert(Signature<gde_fn_##function>::is(expected), #function)
HAS(print_error, "vpppwb");
HAS(variant_new_nil, "vp");
HAS(variant_new_copy, "vpp");
HAS(variant_destroy, "vp");
HAS(variant_get_type, "wp");
HAS(variant_call, "vpppipp");
HAS(get_variant_from_type_constructor, "pw");
HAS(get_variant_to_type_constructor, "pw");
HAS(variant_get_ptr_constructor, "pww");
HAS(variant_get_ptr_destructor, "pw");
HAS(string_new_with_utf8_chars, "vpp");
HAS(string_to_utf8_chars, "ippi");
HAS(string_name_new_with_utf8_chars, "vpp");
HAS(dictionary_operator_index, "ppp");
HAS(object_set_instance, "vppp");
HAS(classdb_construct_object, "pp");
HAS(classdb_register_extension_class2, "vpppp");
HAS(classdb_register_extension_class_method, "vppp");
HAS(classdb_register_extension_class_integer_constant, "vppppib");
HAS(classdb_register_extension_class_property, "vppppp");
HAS(classdb_register_extension_class_signal, "vppppi");
HAS(classdb_unregister_extension_class, "vpp");
static_assert(Signature<std::remove_pointer_t<gde_call>>::is("vpppipp"));
static_assert(Signature<std::remove_pointer_t<gde_ptrcall>>::is("vpppp"));

}  // namespace
