// A double of liblsl, which Debian does not have: writes what it is given to the file LSL_DOUBLE. A stream is its
// number of channels.
#include <cstdint>
#include <cstdlib>
#include <fstream>

#pragma GCC visibility push(default)

static std::ofstream file() { return std::ofstream(std::getenv("LSL_DOUBLE"), std::ios::app); }

extern "C" {
int* lsl_create_streaminfo(const char* name, const char* type, std::int32_t channels, double rate, int format,
                           const char* source) {
  file() << "stream " << name << " " << type << " " << channels << " " << rate << " " << format << " " << source
         << "\n";
  return new int(channels);
}
int* lsl_create_outlet(const int* info, std::int32_t, std::int32_t) { return new int(*info); }
int* lsl_get_desc(int* info) { return info; }
int* lsl_append_child(int* element, const char*) { return element; }
int* lsl_append_child_value(int* element, const char* name, const char* value) {
  file() << name << " " << value << "\n";
  return element;
}
std::int32_t lsl_push_sample_ftp(const int* outlet, const float* values, double, std::int32_t) {
  std::ofstream to = file();
  to << "floats";
  for (int i = 0; i < *outlet; ++i) to << " " << values[i];
  to << "\n";
  return 0;
}
std::int32_t lsl_push_sample_strtp(int*, const char** texts, double, std::int32_t) {
  file() << "text " << *texts << "\n";
  return 0;
}
void lsl_destroy_outlet(const int* outlet) { delete outlet; }
void lsl_destroy_streaminfo(const int* info) { delete info; }
}
