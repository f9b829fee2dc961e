// Plays scenario.txt, which every host plays: what it calls is the host's, what must come of it is written
// there.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <map>
#include <sstream>
#include <string>

namespace scenario {

/// A call as it is written.
struct Call {
  std::string name;
  std::map<std::string, std::string> arguments;

  const std::string& text(const std::string& key) const { return arguments.at(key); }
  double number(const std::string& key) const { return std::strtod(text(key).c_str(), nullptr); }
  /// Of "x,y,z".
  double part(const std::string& key, int index) const {
    std::istringstream parts(text(key));
    std::string each;
    for (int i = 0; i <= index; ++i) std::getline(parts, each, ',');
    return std::strtod(each.c_str(), nullptr);
  }
};

/// What has come of a call.
struct Answer {
  bool failed;
  std::string error;  ///< the code and the text of it, as far as the host has them
  std::map<std::string, double> values;
};

inline std::map<std::string, std::string> pairs_of(const std::string& words) {
  std::map<std::string, std::string> pairs;
  std::istringstream stream(words);
  for (std::string word; stream >> word;) pairs[word.substr(0, word.find('='))] = word.substr(word.find('=') + 1);
  return pairs;
}

inline void expect(const std::string& wanted, Answer answer) {
  for (const auto& [name, text] : pairs_of(wanted)) {
    ASSERT_TRUE(answer.values.contains(name)) << name;
    const double value = answer.values[name], number = std::strtod(text.c_str(), nullptr);
    if (name == "flags")
      EXPECT_TRUE(static_cast<unsigned>(value) & static_cast<unsigned>(number)) << value;
    else
      EXPECT_NEAR(value, number, 1e-4) << name;
  }
}

/// `has_codes`: errors of the host begin with their code's name.
inline void play(const char* path, bool has_codes, const std::function<Answer(const Call&)>& host) {
  std::ifstream file(path);
  int played = 0;
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line[0] == '#') continue;
    SCOPED_TRACE(line);
    const std::size_t refused = line.find(" ! "), gives = line.find(" -> ");
    const std::string call = line.substr(0, std::min(refused, gives));
    const std::size_t name_ends = std::min(call.find(' '), call.size());
    const Answer answer = host({call.substr(0, name_ends), pairs_of(call.substr(name_ends))});
    ++played;
    EXPECT_EQ(answer.failed, refused != std::string::npos) << answer.error;
    if (answer.failed && refused != std::string::npos) {
      const std::string wanted = line.substr(refused + 3), code = wanted.substr(0, wanted.find(' '));
      EXPECT_NE(answer.error.find(wanted.substr(code.size() + 1)), std::string::npos) << answer.error;
      EXPECT_TRUE(!has_codes || answer.error.starts_with("HRT_ERROR_" + code)) << answer.error;
    }
    if (gives != std::string::npos) expect(line.substr(gives + 4), answer);
  }
  EXPECT_GT(played, 30);
}

}  // namespace scenario
