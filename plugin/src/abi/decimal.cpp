#include "plugin/src/abi/decimal.h"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cfloat>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace hrt::plugin::in_c {
namespace {

// A finite number other than 0 as 0.d1 d2 ... dn * 10^point, or as an integer below 10^17 * 10^point.
struct Digits {
  char text[20];  // no zeros at the end
  int count;
  int point;  // digits before the decimal point; at most 0: zeros follow it first
};

// Makes the digits before the exponent those of the next larger number of as many, unless all are 9.
void step_up(char* text) {
  for (char* digit = std::strchr(text, 'e') - 1; digit >= text; --digit) {
    if (*digit == '.') continue;
    if (*digit != '9') {
      ++*digit;
      return;
    }
    *digit = '0';
  }
}

bool reads_back(const char* text, double number) {
  return std::strtod(text, nullptr) == number;
}

// Writes the decimal of so many digits that is nearest, or the next above if only that reads back, as can be
// at powers of two: numbers lie closer below these.
bool write_digits(double number, int precision, char (&text)[40]) {
  std::snprintf(text, sizeof text, "%.*e", precision - 1, number);
  if (reads_back(text, number)) return true;
  step_up(text);
  return reads_back(text, number);
}

// The correctly rounded decimal of the fewest digits that reads back. 15 digits always tell decimals apart,
// so that of fewer digits is the one of 15 without its zeros; subnormal numbers have fewer digits to begin
// with.
Digits shortest(double number) {
  char text[40];
  int precision = std::abs(number) < DBL_MIN ? 1 : 15;
  while (!write_digits(std::abs(number), precision, text) && precision < 17) ++precision;

  Digits digits{};
  const char* exponent = std::strchr(text, 'e');
  for (const char* c = text; c != exponent; ++c) {
    if (*c != '.') digits.text[digits.count++] = *c;
  }
  while (digits.count > 1 && digits.text[digits.count - 1] == '0') --digits.count;
  digits.point = std::atoi(exponent + 1) + 1;
  return digits;
}

// Appends to a buffer known to be large enough.
class Writer {
 public:
  explicit Writer(char* begin) : begin_(begin), at_(begin) {}
  void put(char c) { *at_++ = c; }
  void put(const char* from, int count) { at_ = std::copy(from, from + count, at_); }
  void zeros(int count) { at_ = std::fill_n(at_, count, '0'); }
  std::size_t size() const { return static_cast<std::size_t>(at_ - begin_); }

 private:
  char* begin_;
  char* at_;
};

void write_fixed(const Digits& digits, double number, Writer& out) {
  if (digits.point >= digits.count) {  // an integer, of which all digits are written
    char text[longest_decimal];
    out.put(text, std::snprintf(text, sizeof text, "%.0f", std::abs(number)));
  } else if (digits.point > 0) {
    out.put(digits.text, digits.point);
    out.put('.');
    out.put(digits.text + digits.point, digits.count - digits.point);
  } else {
    out.put("0.", 2);
    out.zeros(-digits.point);
    out.put(digits.text, digits.count);
  }
}

void write_scientific(const Digits& digits, Writer& out) {
  out.put(digits.text[0]);
  if (digits.count > 1) {
    out.put('.');
    out.put(digits.text + 1, digits.count - 1);
  }
  char exponent[8];
  out.put(exponent, std::snprintf(exponent, sizeof exponent, "e%+03d", digits.point - 1));
}

int fixed_length(const Digits& digits) {
  if (digits.point >= digits.count) return digits.point;
  return digits.point > 0 ? digits.count + 1 : 2 - digits.point + digits.count;
}

int scientific_length(const Digits& digits) {
  return digits.count + (digits.count > 1 ? 1 : 0) + (std::abs(digits.point - 1) < 100 ? 4 : 5);
}

}  // namespace

std::size_t write_decimal(double number, char (&out)[longest_decimal]) {
  Writer writer(out);
  if (std::signbit(number)) writer.put('-');
  if (number == 0.0) {
    writer.put('0');
    return writer.size();
  }
  const Digits digits = shortest(number);
  if (fixed_length(digits) <= scientific_length(digits)) {
    write_fixed(digits, number, writer);
  } else {
    write_scientific(digits, writer);
  }
  return writer.size();
}

bool read_decimal(std::string_view text, double* out) {
  // strtod() also takes spaces, a plus and hexadecimal digits, and wants a zero at the end.
  constexpr std::size_t longest = 1000;
  if (text.empty() || text.size() > longest || text[0] == '+' ||
      std::isspace(static_cast<unsigned char>(text[0])) || text.find_first_of("xX(") != text.npos) {
    return false;
  }
  char copy[longest + 1];
  *std::copy(text.begin(), text.end(), copy) = '\0';
  char* end = nullptr;
  errno = 0;
  const double number = std::strtod(copy, &end);
  if (end != copy + text.size()) return false;
  if (errno == ERANGE && (std::isinf(number) || number == 0.0)) return false;
  *out = number;
  return true;
}

}  // namespace hrt::plugin::in_c
