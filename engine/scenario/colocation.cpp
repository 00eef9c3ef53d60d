#include "engine/scenario/colocation.h"

#include <cmath>
#include <utility>

#include "engine/files/number_text.h"
#include "engine/files/user_folders.h"
#include "engine/scenario/describe.h"
#include "engine/scenario/text_store.h"
#include "engine/scenario/tree_reader.h"
#include "engine/scenario/words.h"
#include "engine/scenario/yaml_tree.h"

namespace fulcrum::scenario {
namespace {

std::string numbers_text(std::initializer_list<double> values) {
  std::string text = "[";
  for (const double value : values) {
    if (text.size() > 1) text += ", ";
    append_number(text, value);
  }
  return text + "]";
}

}  // namespace

double Colocation::rms() const {
  double squares = 0;
  for (const double residual : residuals) squares += residual * residual;
  return residuals.empty() ? 0 : std::sqrt(squares / static_cast<double>(residuals.size()));
}

void describe_colocation_file(KeyVisitor& visitor, Colocation& colocation) {
  visitor.version({"fulcrum", "", "version of the file's format", true}, kFormatVersion);
  visitor.word({"device", "", "that stands there, as --device takes it", true}, colocation.device);
  visitor.word({"space", "", "of the headset, as --xr-space takes it", true}, colocation.space);
  visitor.mapping({"base", "", "the device's base in that space", true}, [&](KeyVisitor& inner) {
    inner.vector({"position", "m", "of its origin", true}, colocation.X_LD.p, kPosition);
    inner.rotation({"orientation", "", "of its axes [w, x, y, z]", true}, colocation.X_LD.q);
  });
  visitor.numbers({"residuals", "m", "of each point that was touched", true}, colocation.residuals,
                  from_to(0, 4), Colocation::kMostPoints);  // one of twelve may be 3.3 times their mean
}

std::string colocation_text(const Colocation& colocation) {
  const auto& [q, p] = colocation.X_LD;
  std::string text = "fulcrum: " + std::to_string(kFormatVersion) + "\n# Written by `fulcrum run SCENE --xr";
  text.append(" --xr-space ").append(colocation.space).append(" --device ").append(colocation.device);
  text.append(" --colocate`.\ndevice: ").append(colocation.device);
  text.append("\nspace: ").append(colocation.space);
  text.append("\nbase: {position: ").append(numbers_text({p.x(), p.y(), p.z()}));
  text.append(", orientation: ").append(numbers_text({q.w(), q.x(), q.y(), q.z()}));
  text.append("}\nresiduals: [");
  for (std::size_t i = 0; i < colocation.residuals.size(); ++i) {
    if (i > 0) text += ", ";
    append_number(text, colocation.residuals[i]);
  }
  return text + "]\n";
}

std::filesystem::path colocation_file(std::string_view device, std::string_view space) {
  std::filesystem::path folder = config_folder();
  if (folder.empty()) return folder;
  std::string name(device);
  name.append(".xr-").append(space).append(".yaml");
  return folder / "calibration" / name;
}

Checked<Colocation> load_colocation(const std::filesystem::path& file, std::string_view device,
                                    std::string_view space) {
  const std::string source = file.string();
  const auto refused = [&](Faults faults) {
    faults.push_back(
        {source, 0, 0, "lay the device onto the headset's space anew with --colocate, or remove the file"});
    return faults;
  };
  const auto text = read_text(RegularFile::open(file));
  if (!text)
    return refused({{source, 0, 0, "cannot read where the device stands: " + text.error().sentence}});
  const auto root = parse_yaml(*text, source);
  if (!root) return refused(root.faults());
  Colocation colocation;
  Faults faults = read_tree(*root, file.parent_path(),
                            [&](KeyVisitor& visitor) { describe_colocation_file(visitor, colocation); });
  if (!faults.empty()) return refused(std::move(faults));
  if (colocation.device != device || colocation.space != space) {
    std::string sentence = "it is of " + in_quotes(colocation.device) + " in " + in_quotes(colocation.space);
    sentence.append(" space, and asked for is ").append(in_quotes(device)).append(" in ").append(space);
    return refused({{source, 0, 0, sentence}});
  }
  return colocation;
}

}  // namespace fulcrum::scenario
