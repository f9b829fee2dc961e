#include "samples/mock_runtime/calls/call_text.h"

namespace hrt::mock {
namespace {

bool is_header(const char* member) { return std::string_view(member) == "type" || std::string_view(member) == "next"; }

template <typename T>
void put_member(std::string& out, const char* name, const T& value) {
  if (is_header(name)) return;
  out += out.back() == '{' ? "" : ", ";
  out += std::string(name) + '=';
  put_value(out, value, false);
}

}  // namespace

#define HRT_MOCK_MEMBER(member) put_member(out, #member, shown.member);
#define HRT_MOCK_PUT(name)                             \
  void put(std::string& out, const name& shown) {      \
    out += '{';                                        \
    XR_LIST_STRUCT_##name(HRT_MOCK_MEMBER) out += '}'; \
  }
HRT_MOCK_SHOWN_STRUCTS(HRT_MOCK_PUT)
#undef HRT_MOCK_PUT
#undef HRT_MOCK_MEMBER

}  // namespace hrt::mock
