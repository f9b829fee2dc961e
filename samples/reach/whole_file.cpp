#include "samples/reach/whole_file.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>

#include "samples/reach/exit_code.h"

namespace hrt::reach {

void write_whole_file(const std::filesystem::path& file, std::string_view text) {
  const std::filesystem::path unfinished = file.string() + ".unfinished";
  errno = 0;
  std::ofstream stream(unfinished, std::ios::binary);
  stream << text << std::flush;
  stream.close();
  std::error_code error(stream ? 0 : errno, std::generic_category());
  if (stream) std::filesystem::rename(unfinished, file, error);
  if (stream && !error) return;
  std::error_code ignored;
  std::filesystem::remove(unfinished, ignored);
  throw Failure(ExitCode::output, file.string() + " cannot be written: " + error.message());
}

}  // namespace hrt::reach
