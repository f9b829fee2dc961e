#include "samples/text.h"

#include <gtest/gtest.h>

namespace hrt {
namespace {

TEST(Text, ColumnsCountCharacters) {
  const std::string word = "\u00e4\u20ac\U0001f600";
  EXPECT_EQ(length_of(word), 3U);
  EXPECT_EQ(left(word, 5), word + "  ");
  EXPECT_EQ(right(word, 5), "  " + word);
  EXPECT_EQ(left(word, 2), word);
  EXPECT_EQ(cut_to(word, 2), "\u00e4\u20ac");
  EXPECT_EQ(cut_to(word, 3), word);
  EXPECT_EQ(cut_to(word, 0), "");
}

TEST(Text, MarkupIsEscaped) {
  EXPECT_EQ(escaped("<a href=\"x\">\u00fc & \x1b\n"), "&lt;a href=&quot;x&quot;&gt;\u00fc &amp; ?\n");
}

}  // namespace
}  // namespace hrt
