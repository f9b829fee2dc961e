// Calls reject null pointers, wrong struct sizes and invalid handles: the error text has the name or the value of the
// argument, and no output changes.
#include <array>
#include <set>
#include <tuple>

#include "generated/fields.h"
#include "tests/plugin/fixture.h"

namespace hrt::test {
namespace {

std::set<std::string> tried;

std::vector<std::string> parameters_of(std::string_view call) {
  std::vector<std::string> names;
  for (const plugin::Call& known : plugin::calls) {
    if (known.name != call) continue;
    std::string_view rest = known.parameters;
    for (std::size_t space = 0; !rest.empty(); rest.remove_prefix(std::min(space + 1, rest.size()))) {
      space = std::min(rest.find(' '), rest.size());
      names.emplace_back(rest.substr(0, space));
    }
  }
  return names;
}

template <class T>
concept Sized = requires(T value) { value.struct_size; };
template <class T>
concept Handle = requires(T value) { value.value; } && sizeof(T) == 8;

/// Makes the call with each pointer and handle in turn invalid. `given` are valid arguments.
template <class... P>
class Refusals {
 public:
  Refusals(const char* call, hrt_result (*function)(P...) noexcept, std::set<std::string> optional, P... given)
      : function_(function), given_(given...), optional_(std::move(optional)), names_(parameters_of(call)) {
    tried.insert(call);
    SCOPED_TRACE(call);
    EXPECT_EQ(names_.size(), sizeof...(P));
    if (names_.size() == sizeof...(P)) try_all(std::index_sequence_for<P...>());
  }

 private:
  template <std::size_t... i>
  void try_all(std::index_sequence<i...>) {
    (try_one<i>(), ...);
  }

  template <std::size_t i>
  void try_one() {
    using T = std::tuple_element_t<i, std::tuple<P...>>;
    if constexpr (std::is_pointer_v<T>) {
      using Pointed = std::remove_const_t<std::remove_pointer_t<T>>;
      if (!optional_.contains(names_[i])) with<i>(nullptr, HRT_ERROR_NULL_ARGUMENT, names_[i]);
      if constexpr (Sized<Pointed>) {
        for (const std::uint32_t size : {0u, 4u, static_cast<unsigned>(sizeof(Pointed)) - 8,
                                         static_cast<unsigned>(sizeof(Pointed)) + 4, 4104u, ~0u}) {
          Pointed spoilt = *std::get<i>(given_);
          spoilt.struct_size = size;
          with<i>(&spoilt, HRT_ERROR_STRUCT_SIZE, "struct_size is " + std::to_string(size));
        }
      }
    } else if constexpr (Handle<T>) {
      if (!optional_.contains(names_[i])) with<i>(T{0}, HRT_ERROR_INVALID_HANDLE, "0");
      for (const std::uint64_t value : {~std::uint64_t{0}, std::uint64_t{1} << 56})
        with<i>(T{value}, HRT_ERROR_INVALID_HANDLE, std::to_string(value));
    }
  }

  template <std::size_t i>
  void with(std::tuple_element_t<i, std::tuple<P...>> spoilt, hrt_result expected, const std::string& part) {
    std::tuple<P...> arguments = given_;
    std::get<i>(arguments) = spoilt;
    const std::vector<std::string> before =
        std::apply([](auto... argument) { return std::vector<std::string>{bytes_of(argument)...}; }, arguments);
    expect_error(std::apply(function_, arguments), expected, part);
    const std::vector<std::string> after =
        std::apply([](auto... argument) { return std::vector<std::string>{bytes_of(argument)...}; }, arguments);
    EXPECT_EQ(before, after) << "an output changed";
  }

  template <class T>
  static std::string bytes_of(T argument) {
    if constexpr (std::is_pointer_v<T>) {
      if constexpr (!std::is_void_v<std::remove_pointer_t<T>> && !std::is_function_v<std::remove_pointer_t<T>>)
        if (argument) return {reinterpret_cast<const char*>(argument), sizeof *argument};
    }
    return {};
  }

  hrt_result (*function_)(P...) noexcept;
  std::tuple<P...> given_;
  std::set<std::string> optional_;
  std::vector<std::string> names_;
};

template <class... P, class... Given>
void refuses(const char* call, hrt_result (*function)(P...) noexcept, const std::set<std::string>& optional,
             Given... given) {
  Refusals<P...>(call, function, optional, static_cast<P>(given)...);
}
#define REFUSES(call, ...) refuses(#call, call, {}, __VA_ARGS__)
#define REFUSES_BUT(optional, call, ...) refuses(#call, call, std::set<std::string> optional, __VA_ARGS__)

class ArgumentsTest : public SessionTest {
 protected:
  void try_reaches();
  void try_people();
  void try_set_up();
};

void ArgumentsTest::try_reaches() {
  const hrt_target real = add(HRT_TARGET_REAL, 0.0), seen = add(HRT_TARGET_VIRTUAL, 5.0);
  std::array<hrt_target, 64> targets{};
  std::array<char, 4096> text{};
  std::uint64_t count = 7;
  std::uint32_t number = 7;

  hrt_session_config config = session_config();
  hrt_session other{7};
  REFUSES_BUT(({"config"}), hrt_session_create, HRT_VERSION, &config, &other);
  REFUSES_BUT(({"out_config", "out_state"}), hrt_session_get, session, &config, &number);
  REFUSES(hrt_session_destroy, hrt_session{0});
  REFUSES_BUT(({"config"}), hrt_session_set, session, &config);
  REFUSES(hrt_profile_reset, hrt_session{0});

  hrt_target_config target = target_config(HRT_TARGET_REAL, 0.0);
  REFUSES(hrt_target_add, session, &target, targets.data());
  REFUSES(hrt_target_set, session, real, &target);
  REFUSES(hrt_target_get, session, real, &target);
  REFUSES(hrt_target_remove, session, real);
  REFUSES(hrt_target_list, session, 0, targets.size(), targets.data(), &count);

  REFUSES(hrt_flags_text, HRT_COMMAND_HELD, text.size(), text.data(), &count);

  auto gap = output<hrt_gap>();
  REFUSES(hrt_gap_query, session, real, seen, &gap);
  REFUSES(hrt_gap_assign, session, &seen, 1, &real, 1, 0, 1, &gap);

  auto conditions = output<hrt_conditions>();
  REFUSES(hrt_profile_set_conditions, session, &conditions);
  REFUSES(hrt_profile_get_conditions, session, &conditions);
  REFUSES(hrt_profile_save, session, text.size(), text.data(), &count);
  REFUSES(hrt_profile_load, session, "{}", 2);

  const hrt_reach_config reach = reach_config(real, seen);
  hrt_sample sample = direction_sample(0, 0.0);
  auto command = output<hrt_command>();
  auto summary = output<hrt_reach_summary>();
  REFUSES(hrt_reach_begin, session, &reach);
  ASSERT_OK(begin(real, seen));
  REFUSES(hrt_reach_update, session, &sample, &command);
  REFUSES(hrt_reach_retarget, session, real, seen);
  const auto contact = output<hrt_contact>();
  REFUSES_BUT(({"contact"}), hrt_reach_touched, session, &contact);
  REFUSES(hrt_reach_cancel, hrt_session{0});
  REFUSES(hrt_reach_end, session, &summary);
  ASSERT_OK(hrt_reach_cancel(session));

  auto status = output<hrt_recording_status>();
  auto report = output<hrt_replay_report>();
  const std::string path = testing::TempDir() + "hrt_arguments.csv";
  REFUSES(hrt_recording_start, session, path.c_str());
  ASSERT_OK(hrt_recording_start(session, path.c_str()));
  REFUSES(hrt_recording_get_status, session, &status);
  REFUSES(hrt_recording_flush, session, &status);
  REFUSES(hrt_recording_stop, session, &status);
  ASSERT_OK(hrt_recording_stop(session, &status));
  REFUSES_BUT(({"text"}), hrt_recording_replay, path.c_str(), nullptr, 0, &report);
  std::remove(path.c_str());
}

void ArgumentsTest::try_people() {
  const hrt_target seen = add(HRT_TARGET_VIRTUAL, 10.0);
  const auto config = output<hrt_person_config>();
  hrt_person person{};
  hrt_sample sample = position_sample(0, 0.0, 0.0);
  auto state = output<hrt_person_state>();
  REFUSES_BUT(({"config"}), hrt_person_create, &config, 1, &person);
  ASSERT_OK(hrt_person_create(&config, 1, &person));
  REFUSES_BUT({"virtual_target"}, hrt_person_begin, person, session, seen);
  ASSERT_OK(hrt_person_begin(person, session, seen));
  REFUSES(hrt_person_move, person, 0, 0.0, &sample);
  REFUSES(hrt_person_get_state, person, &state);
  REFUSES(hrt_person_destroy, hrt_person{0});
  ASSERT_OK(hrt_person_destroy(person));
}

void ArgumentsTest::try_set_up() {
  const hrt_sample sample = position_sample(0, 0.0, 0.0);
  const hrt_setup_config loop = hrt_setup_config_init();
  auto step = output<hrt_setup_step>();
  auto found = output<hrt_setup_result>();
  REFUSES_BUT(({"config"}), hrt_setup_begin, session, HRT_SETUP_CALIBRATION, &loop);
  ASSERT_OK(hrt_setup_begin(session, HRT_SETUP_CALIBRATION, &loop));
  REFUSES(hrt_setup_update, session, &sample, &step);
  REFUSES(hrt_setup_finish, session, &found);
  REFUSES(hrt_setup_cancel, hrt_session{0});
  auto residual = output<hrt_setup_residual>();
  REFUSES(hrt_setup_get_residual, session, 0, &residual);
  ASSERT_OK(hrt_setup_cancel(session));

  hrt_scene scene{};
  std::array<hrt_target, 64> targets{};
  auto info = output<hrt_scene_info>();
  auto target = output<hrt_scene_target>();
  REFUSES_BUT(({"bytes"}), hrt_scene_load, HRT_DESK_SCENE, nullptr, 0, &scene);
  ASSERT_OK(hrt_scene_load(HRT_DESK_SCENE, nullptr, 0, &scene));
  REFUSES(hrt_scene_get_info, scene, &info);
  REFUSES(hrt_scene_get_target, scene, 0, &target);
  REFUSES(hrt_scene_register, scene, session, targets.size(), targets.data());
  REFUSES(hrt_scene_destroy, hrt_scene{0});
  ASSERT_OK(hrt_scene_destroy(scene));
}

// For a new call, add a line to a function above.
TEST_F(ArgumentsTest, InvalidArgumentsOfEveryCallAreRejectedByName) {
  try_reaches();
  try_people();
  try_set_up();
  const hrt_host host = hrt_host_init();
  REFUSES_BUT({"host"}, hrt_host_set_log, session, &host);
  tried.insert("hrt_host_set");  // memory_test.cpp tests it
  for (const plugin::Call& call : plugin::calls) EXPECT_TRUE(tried.contains(call.name)) << call.name;
}

}  // namespace
}  // namespace hrt::test
