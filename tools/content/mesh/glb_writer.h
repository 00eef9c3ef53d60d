#pragma once

#include <string>
#include <vector>

#include "tools/content/mesh/model.h"

namespace fulcrum::content {

// Writes a binary glTF with one node per part. The same model gives the same bytes.
// `program` is named in it as its author. Returns an empty string, or a sentence that says what went wrong.
std::string write_glb(const Model& model, const std::string& path, const std::string& program);

// Each as folder/NAME.glb, printed with its size. False, and a sentence on the standard error, if one fails.
bool write_models(const std::vector<Model>& models, const std::string& folder, const std::string& program);

}  // namespace fulcrum::content
