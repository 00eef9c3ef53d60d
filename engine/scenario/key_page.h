#pragma once
// The reference of all keys as a page for people, made of the schemas, so that no key is missing from it.

#include <string>

namespace fulcrum::scenario {

std::string key_page();  // Markdown

}  // namespace fulcrum::scenario
