#include "core/person/tuning.h"

#include <gtest/gtest.h>

#include <set>

namespace hrt {
namespace {

TEST(Tuning, EveryField_HasOneNameAndIsInItsRange) {
  Tuning tuning;
  std::set<std::string> names;
  std::set<const double*> values;
  for (const TuningField& field : tuning_fields(tuning)) {
    names.insert(field.name);
    values.insert(field.value);
    EXPECT_GE(*field.value, field.min) << field.name;
    EXPECT_LE(*field.value, field.max) << field.name;
  }
  EXPECT_EQ(names.size(), sizeof(Tuning) / sizeof(double));
  EXPECT_EQ(values.size(), names.size());
}

}  // namespace
}  // namespace hrt
