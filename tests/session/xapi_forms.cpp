#include "tests/session/xapi_forms.h"

#include <cctype>
#include <regex>

namespace fulcrum::test {
namespace {

bool fits(const std::string& text, const char* form) {
  return text.size() < 4000 && std::regex_match(text, std::regex(form, std::regex::ECMAScript));
}

int days_of(int year, int month) {
  const bool leap = (year % 4 == 0 && year % 100 != 0) || year % 400 == 0;
  return month == 2 ? (leap ? 29 : 28) : (month == 4 || month == 6 || month == 9 || month == 11) ? 30 : 31;
}

// std::regex walks a long text by recursion, so the bytes of addresses are looked at one by one.
bool has_bytes_of_iri(const std::string& text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    if (byte <= 0x20 || byte == 0x7f || std::string("<>\"{}|\\^`").find(text[i]) != std::string::npos)
      return false;
    if (text[i] == '%' &&
        (i + 2 >= text.size() || std::isxdigit(text[i + 1]) == 0 || std::isxdigit(text[i + 2]) == 0))
      return false;
  }
  return true;
}

}  // namespace

bool is_xapi_uuid(const std::string& text) {
  return fits(text, "[0-9a-fA-F]{8}-[0-9a-fA-F]{4}-[0-9a-fA-F]{4}-[89abAB][0-9a-fA-F]{3}-[0-9a-fA-F]{12}");
}

bool is_iri(const std::string& text) {
  const std::size_t colon = text.find(':');
  return has_bytes_of_iri(text) && colon != text.npos && colon + 1 < text.size() &&
         fits(text.substr(0, colon), "[A-Za-z][A-Za-z0-9+.-]*");
}

bool is_irl(const std::string& text) {
  const std::size_t host = text.find("://");
  return is_iri(text) && host != text.npos && text.find_first_of("/?#", host + 3) != host + 3 &&
         host + 3 < text.size();
}

bool is_xapi_timestamp(const std::string& text) {
  if (!fits(text, "\\d{4}-\\d\\d-\\d\\dT\\d\\d:\\d\\d:\\d\\d(\\.\\d+)?(Z|[+-]\\d\\d:\\d\\d)")) return false;
  const auto number = [&](std::size_t at, std::size_t digits) { return std::stoi(text.substr(at, digits)); };
  const int month = number(5, 2), day = number(8, 2);
  const bool zone =
      text.back() == 'Z' || (number(text.size() - 5, 2) < 24 && number(text.size() - 2, 2) < 60);
  return zone && !text.ends_with("-00:00") && month >= 1 && month <= 12 && day >= 1 &&
         day <= days_of(number(0, 4), month) && number(11, 2) < 24 && number(14, 2) < 60 &&
         number(17, 2) <= 60;
}

bool is_xapi_duration(const std::string& text) {
  const bool weeks = fits(text, "P\\d+W");
  const bool parts = fits(text, "P(\\d+Y)?(\\d+M)?(\\d+D)?(T(\\d+H)?(\\d+M)?(\\d+(\\.\\d{1,2})?S)?)?");
  return weeks || (parts && text != "P" && !text.ends_with('T'));
}

bool is_language_tag(const std::string& text) {
  return fits(text, "([A-Za-z]{2,8}|[xXiI]-[A-Za-z0-9]{1,8})(-[A-Za-z0-9]{1,8})*");
}

bool is_mailto(const std::string& text) {
  return fits(text, "mailto:[^@\\s]+@[^@\\s]+");
}

}  // namespace fulcrum::test
