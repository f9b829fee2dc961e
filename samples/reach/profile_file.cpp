#include "samples/reach/profile_file.h"

#include <fstream>
#include <iterator>
#include <string>

#include "samples/reach/exit_code.h"

namespace hrt::reach {

void load_profile(const Plugin& plugin, hrt_session session, const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (!stream || plugin.hrt_profile_load(session, text.data(), text.size()) != HRT_OK)
    throw Failure(ExitCode::plugin, file.string() + " is not a profile" +
                                        (stream ? std::string(": ") + plugin.hrt_last_error() : ""));
}

void save_profile(const Plugin& plugin, hrt_session session, const std::filesystem::path& file) {
  std::uint64_t length = 0;
  plugin.check(plugin.hrt_profile_save(session, 0, nullptr, &length));
  std::string text(length + 1, '\0');
  plugin.check(plugin.hrt_profile_save(session, text.size(), text.data(), &length));
  text.back() = '\n';
  const std::filesystem::path unfinished = file.string() + ".unfinished";
  std::ofstream stream(unfinished, std::ios::binary);
  stream << text << std::flush;
  stream.close();
  std::error_code error;
  if (stream) std::filesystem::rename(unfinished, file, error);
  if (stream && !error) return;
  std::error_code ignored;
  std::filesystem::remove(unfinished, ignored);
  throw Failure(ExitCode::output, file.string() + " cannot be written");
}

}  // namespace hrt::reach
