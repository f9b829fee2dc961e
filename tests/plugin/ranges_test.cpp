// Input fields accept the limits that the headers document, and reject values beyond them, naming the field.
#include <cmath>
#include <limits>
#include <set>

#include "generated/fields.h"
#include "tests/plugin/fixture.h"

namespace hrt::test {
namespace {

using plugin::Field;
using plugin::FieldKind;

template <class S, class T>
std::vector<typename Field<S, T>::Number> limits_of_field(const Field<S, T>& field) {
  if (field.kind == FieldKind::reserved) return {0};
  if (field.kind == FieldKind::free) return {};
  std::vector<typename Field<S, T>::Number> values{field.low, field.high};
  if (field.zero) values.push_back(0);
  return values;
}

/// Returns values just beyond the limits of a field and, for a double, infinities and NaN.
template <class S, class T>
std::vector<typename Field<S, T>::Number> beyond(const Field<S, T>& field) {
  using Number = typename Field<S, T>::Number;
  using Limits = std::numeric_limits<Number>;
  if (field.kind == FieldKind::reserved) return {1};
  if (field.kind == FieldKind::free) return {};
  if constexpr (std::is_floating_point_v<Number>) {
    const double infinity = Limits::infinity();
    return {std::nextafter(field.low, -infinity), std::nextafter(field.high, infinity), infinity, -infinity,
            std::nan("")};
  } else {
    std::vector<Number> values;
    if (field.low > Limits::min()) values.push_back(static_cast<Number>(field.low - 1));
    if (field.high < Limits::max()) values.push_back(static_cast<Number>(field.high + 1));
    if (values.size() == 2 && field.zero) values.erase(values.begin());
    return values;
  }
}

/// Passes structs with each field at its limits and beyond to `take`. `prepare` returns a struct in which that field is
/// read. Returns the names of the fields that were rejected at a limit, because the limit depends on other fields.
template <class S, class Prepare, class Take>
std::set<std::string> try_ranges(Prepare&& prepare, Take&& take) {
  std::set<std::string> refused_at_an_end;
  int tried = 0;
  const auto try_field = [&](const auto& field) {
    SCOPED_TRACE(field.name);
    const auto with = [&]([[maybe_unused]] auto value, [[maybe_unused]] std::size_t element) {
      S values = prepare(std::string(field.name));
      auto& into = field.of(values);
      using T = std::remove_reference_t<decltype(into)>;
      if constexpr (std::is_array_v<T>)
        into[element] = static_cast<std::remove_extent_t<T>>(value);
      else if constexpr (std::is_arithmetic_v<T>)
        into = value;
      return take(values);
    };
    constexpr std::size_t elements = std::extent_v<std::remove_reference_t<decltype(field.of(std::declval<S&>()))>>;
    for (std::size_t i = 0; i < std::max<std::size_t>(elements, 1); ++i) {
      for (const auto value : limits_of_field(field))
        if (with(value, i) != HRT_OK) refused_at_an_end.insert(field.name);
      for (const auto value : beyond(field)) {
        expect_error(with(value, i), HRT_ERROR_OUT_OF_RANGE, std::string(field.name));
        ++tried;
      }
    }
  };
  std::apply([&](const auto&... field) { (try_field(field), ...); }, plugin::Fields<S>::all);
  EXPECT_GT(tried, 0);
  return refused_at_an_end;
}

using Names = std::set<std::string>;

TEST(Ranges, SessionConfigAcceptsExactlyItsRanges) {
  const auto prepare = [](const std::string& field) {
    hrt_session_config config = session_config();
    if (field == "plate_latency_ns") config.paper.step_period_ns = 1'000'000'000;
    return config;
  };
  const auto take = [](const hrt_session_config& config) {
    hrt_session session{7};
    const hrt_result result = hrt_session_create(HRT_VERSION, &config, &session);
    if (result == HRT_OK) return hrt_session_destroy(session);
    EXPECT_EQ(session.value, 7u);
    return result;
  };
  // Stops must be 180 degrees apart; a single element is not a valid covariance matrix.
  EXPECT_EQ(try_ranges<hrt_session_config>(prepare, take),
            (Names{"plate_lower_stop_deg", "plate_upper_stop_deg", "person_covariance", "plate_covariance",
                   "contact_covariance"}));
}

TEST_F(SessionTest, SetupConfigAcceptsExactlyItsRanges) {
  const auto take = [&](const hrt_setup_config& config) {
    const hrt_result result = hrt_setup_begin(session, HRT_SETUP_CALIBRATION, &config);
    return result == HRT_OK ? hrt_setup_cancel(session) : result;
  };
  const auto prepare = [](const std::string& field) {
    hrt_setup_config config = hrt_setup_config_init();
    // At least three marks must form a triangle.
    if (field == "mark_count") config.marks_m[0] = config.marks_m[5] = 0.05;
    return config;
  };
  // upper_plate_deg must be at least 40 degrees above lower_plate_deg.
  EXPECT_EQ(try_ranges<hrt_setup_config>(prepare, take), (Names{"lower_plate_deg", "upper_plate_deg"}));
}

TEST(Ranges, PersonConfigAcceptsExactlyItsRanges) {
  const auto take = [](const hrt_person_config& config) {
    hrt_person person{7};
    const hrt_result result = hrt_person_create(&config, 1, &person);
    if (result == HRT_OK) return hrt_person_destroy(person);
    EXPECT_EQ(person.value, 7u);
    return result;
  };
  EXPECT_EQ(try_ranges<hrt_person_config>([](const std::string&) { return output<hrt_person_config>(); }, take),
            Names{});
}

TEST_F(SessionTest, TargetConfigAcceptsExactlyItsRanges) {
  const auto prepare = [](const std::string& field) {
    hrt_target_config config = target_config(HRT_TARGET_REAL, 0.0);
    if (field == "position_m") config.place = HRT_PLACE_WORLD_POSITION;
    return config;
  };
  const auto take = [&](const hrt_target_config& config) {
    hrt_target target{7};
    const hrt_result result = hrt_target_add(session, &config, &target);
    if (result == HRT_OK) return hrt_target_remove(session, target);
    EXPECT_EQ(target.value, 7u);
    return result;
  };
  EXPECT_EQ(try_ranges<hrt_target_config>(prepare, take), Names{});
}

TEST_F(SessionTest, ReachConfigAcceptsExactlyItsRanges) {
  const hrt_target real = add(HRT_TARGET_REAL, 0.0), seen = add(HRT_TARGET_VIRTUAL, 5.0);
  const auto prepare = [&](const std::string& field) {
    return reach_config(real, seen, field == "plate_orientation_deg" ? HRT_REACH_PLATE_ORIENTATION : 0u);
  };
  const auto take = [&](const hrt_reach_config& config) {
    const hrt_result result = hrt_reach_begin(session, &config);
    return result == HRT_OK ? hrt_reach_cancel(session) : result;
  };
  EXPECT_EQ(try_ranges<hrt_reach_config>(prepare, take), Names{});
}

hrt_sample sample_with(const std::string& field) {
  auto sample = output<hrt_sample>();
  sample.plate_rotation[3] = 1.0;
  if (field == "finger_direction_deg") sample.flags = HRT_SAMPLE_DIRECTION;
  if (field == "finger_position_m") sample.flags = HRT_SAMPLE_PLATE_POSITION;
  if (field == "plate_orientation_deg") sample.flags = HRT_SAMPLE_PLATE_ORIENTATION;
  if (field == "plate_position_m") sample.flags = HRT_SAMPLE_WORLD_POSITION | HRT_SAMPLE_PLATE_POSE;
  return sample;
}

TEST_F(SessionTest, SampleAcceptsExactlyItsRanges) {
  begin_reach();
  const auto take = [&](const hrt_sample& sample) {
    auto command = output<hrt_command>();
    command.paper.step = 77;
    const hrt_result result = hrt_reach_update(session, &sample, &command);
    EXPECT_EQ(result == HRT_OK, command.paper.step != 77);
    return result;
  };
  // At most one of DIRECTION, PLATE_POSITION and WORLD_POSITION is allowed.
  EXPECT_EQ(try_ranges<hrt_sample>(sample_with, take), Names{"flags"});
}

TEST_F(SessionTest, ConditionsAcceptExactlyTheirRanges) {
  auto given = output<hrt_conditions>();
  for (const std::int64_t time_s : limits_of_field(plugin::Fields<hrt_conditions>::time_s)) {
    given.time_s = time_s;
    EXPECT_OK(hrt_profile_set_conditions(session, &given));
  }
  for (const std::int64_t time_s : beyond(plugin::Fields<hrt_conditions>::time_s)) {
    given.time_s = time_s;
    expect_error(hrt_profile_set_conditions(session, &given), HRT_ERROR_OUT_OF_RANGE,
                 "time_s is " + std::to_string(time_s) + "; allowed: 0 to 253402300799");
  }
}

TEST(Defaults, InitFunctionsSetTheDefaultsOfTheHeaders) {
  EXPECT_TRUE(same(hrt_session_config_init(), plugin::defaults<hrt_session_config>));
  EXPECT_TRUE(same(hrt_target_config_init(), plugin::defaults<hrt_target_config>));
  EXPECT_TRUE(same(hrt_reach_config_init(), plugin::defaults<hrt_reach_config>));
  EXPECT_TRUE(same(hrt_setup_config_init(), plugin::defaults<hrt_setup_config>));
  EXPECT_TRUE(same(hrt_person_config_init(), plugin::defaults<hrt_person_config>));
}

}  // namespace
}  // namespace hrt::test
