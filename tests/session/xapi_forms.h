#pragma once
// The forms that texts in a statement of the Experience API have.

#include <string>

namespace fulcrum::test {

bool is_xapi_uuid(const std::string& text);       // RFC 4122, of variant 2
bool is_iri(const std::string& text);             // RFC 3987, with a scheme
bool is_irl(const std::string& text);             // that, with a host
bool is_xapi_timestamp(const std::string& text);  // RFC 3339
bool is_xapi_duration(const std::string& text);   // ISO 8601, 4.4.3.2, to hundredths of a second
bool is_language_tag(const std::string& text);    // RFC 5646, by the lengths of its parts
bool is_mailto(const std::string& text);

}  // namespace fulcrum::test
