#include "engine/importing/import_command.h"

#include <array>
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <system_error>
#include <vector>

#include "engine/app/cli/exit_code.h"
#include "engine/app/cli/listed.h"
#include "engine/app/cli/terminal.h"
#include "engine/assets/gltf_writer.h"
#include "engine/files/put_file.h"
#include "engine/importing/import_file.h"

namespace fulcrum::importing {
namespace {

namespace fs = std::filesystem;
using app::bold;
using app::complain;

struct Options {
  std::vector<std::string> files;
  std::string out = ".";
  std::string unit, up;  // names; empty: guessed
  std::optional<double> simplify_mm;
  bool force = false;
  bool json = false;
};

template <class Enum>
std::optional<Enum> named(const std::string& name) {
  for (std::size_t i = 0; i < names_of<Enum>.size(); ++i)
    if (names_of<Enum>[i] == name) return static_cast<Enum>(i);
  return std::nullopt;
}

std::string unit_text(double unit_m) {
  constexpr std::array<std::string_view, names_of<LengthUnit>.size()> kWords{
      "metres", "centimetres", "millimetres", "micrometres", "inches", "feet"};
  for (std::size_t i = 0; i < kWords.size(); ++i)
    if (metres(static_cast<LengthUnit>(i)) == unit_m) return std::string(kWords[i]);
  char text[48];
  std::snprintf(text, sizeof text, "units of %.6g m", unit_m);
  return text;
}

std::string count_text(std::size_t count, const char* one) {
  return std::to_string(count) + " " + one + (count == 1 ? "" : "s");
}

std::string size_text(const Vec3& size) {
  const bool large = size.maxCoeff() >= 1;
  char text[96];
  std::snprintf(text, sizeof text, large ? "%.3g x %.3g x %.3g m" : "%.3g x %.3g x %.3g mm",
                (large ? 1 : 1e3) * size.x(), (large ? 1 : 1e3) * size.y(), (large ? 1 : 1e3) * size.z());
  return text;
}

// Whole or not at all; false, where a sentence on stderr says why not.
bool write(const fs::path& path, const Model& model) {
  const std::string bytes = to_glb(model, path.stem().string(), "Fulcrum import");
  if (put_file(path, {std::as_bytes(std::span(bytes))})) return true;
  complain(path.string() + " cannot be written: see that its folder is yours and has room.");
  return false;
}

void print(const std::string& file, const fs::path& out, const fs::path& drawn, const Imported& imported) {
  const auto line = [](const std::string& text) { std::printf("%s\n", app::in_lines(text, 2).c_str()); };
  std::printf("%s\n", bold(file + " -> " + out.string()).c_str());
  line(imported.format + ", " + count_text(imported.model.parts.size(), "part") + ", " +
       count_text(imported.triangles, "triangle") + ", " + size_text(imported.size) + " (x, y, z; y is up)");
  if (!imported.unit_m.why.empty())
    line("Taken in " + unit_text(imported.unit_m.value) + ", " + imported.unit_m.why +
         ": --unit says otherwise.");
  if (!imported.up.why.empty())
    line("Its " + std::string(name_of(imported.up.value)) + " is taken as up, " + imported.up.why +
         ": --up says otherwise.");
  if (!imported.question.empty()) line(imported.question);
  if (imported.why_not_solid.empty())
    line(imported.mended.empty() ? "Its surface is closed, and nothing of it has to be mended."
                                 : "It can be touched; each time that it is loaded this is mended:");
  else
    line("It can be drawn (role: decor) and not touched: " + imported.why_not_solid);
  for (const std::string& note : imported.mended) std::printf("%s\n", app::in_lines(note, 4).c_str());
  if (imported.thin_triangles > 0)
    line(count_text(imported.thin_triangles, "triangle") + (imported.thin_triangles == 1 ? " is" : " are") +
         " lower than a micrometre, which costs time only.");
  if (imported.images > 0)
    line(count_text(imported.images, "image") + (imported.images == 1 ? " is" : " are") +
         " left out: only colours are taken.");
  if (imported.lights > 0)
    line(count_text(imported.lights, "light") + (imported.lights == 1 ? " is" : " are") +
         " left out: a scenario that names a .glb or .gltf itself has its lights.");
  const std::vector<std::string>& left_out = imported.materials_left_out;
  if (!left_out.empty())
    line("Of its materials " + app::listed(left_out) + (left_out.size() == 1 ? " is" : " are") +
         " left out: only colours, metallic and roughness are taken.");
  if (imported.format == "glTF" && (imported.images > 0 || !left_out.empty()))
    line("A scenario can name this file itself, and has what is left out of its materials.");
  if (!drawn.empty()) {
    char text[64];
    std::snprintf(text, sizeof text, "%.3g mm", 1e3 * imported.drawn_deviation);
    line(imported.drawn
             ? drawn.string() + " has " + count_text(imported.drawn_triangles, "triangle") + ", within " +
                   text + " of it: beside 'file' say 'drawn: " + drawn.filename().string() + "'."
             : "Nothing could be simplified within that tolerance.");
  }
}

nlohmann::ordered_json as_json(const std::string& file, const fs::path& out, const fs::path& drawn,
                               const Imported& imported) {
  const auto or_null = [](const std::string& text) {
    return text.empty() ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(text);
  };
  return {{"file", file},
          {"model", out.string()},
          {"drawn", imported.drawn ? nlohmann::ordered_json(drawn.string()) : nullptr},
          {"format", imported.format},
          {"unit_m", imported.unit_m.value},
          {"unit_why", or_null(imported.unit_m.why)},
          {"up", name_of(imported.up.value)},
          {"up_why", or_null(imported.up.why)},
          {"size_m", {imported.size.x(), imported.size.y(), imported.size.z()}},
          {"parts", imported.model.parts.size()},
          {"triangles", imported.triangles},
          {"thin_triangles", imported.thin_triangles},
          {"drawn_triangles", imported.drawn ? nlohmann::ordered_json(imported.drawn_triangles) : nullptr},
          {"drawn_deviation_m", imported.drawn ? nlohmann::ordered_json(imported.drawn_deviation) : nullptr},
          {"images_left_out", imported.images},
          {"lights_left_out", imported.lights},
          {"materials_left_out", imported.materials_left_out},
          {"can_be_touched", imported.why_not_solid.empty()},
          {"why_not", or_null(imported.why_not_solid)},
          {"mended", imported.mended},
          {"question", or_null(imported.question)}};
}

// Where the model of `file` goes: `out` itself where that names a .glb, otherwise a file in it.
fs::path out_path(const std::string& file, const Options& options) {
  fs::path out(options.out);
  if (out.extension() == ".glb") return out;
  return (out / fs::path(file).filename().replace_extension(".glb")).lexically_normal();
}

// Where the coarser one goes that is drawn.
fs::path drawn_path(const fs::path& out) {
  return out.parent_path() / (out.stem().string() + "_drawn.glb");
}

// No two files become one; false, where a sentence on stderr says which would.
bool go_apart(const Options& options) {
  std::map<fs::path, std::string> sources;  // of each file that would be written
  const auto take = [&](const fs::path& path, const std::string& file) {
    std::error_code fault, ignored;
    fs::path whole = fs::weakly_canonical(path, fault);
    if (fault) whole = fs::absolute(path, ignored);  // a folder that may not be looked into
    const auto [known, is_new] = sources.try_emplace(whole, file);
    if (!is_new)
      complain(known->second + " and " + file + " would both become " + path.string() +
               ": import one at a time, and name a .glb for each with --out.");
    return is_new;
  };
  for (const std::string& file : options.files) {
    const fs::path out = out_path(file, options);
    if (!take(out, file) || (options.simplify_mm && !take(drawn_path(out), file))) return false;
  }
  return true;
}

bool may_write(const fs::path& path, const std::string& source, bool force) {
  std::error_code ignored;
  if (fs::equivalent(path, source, ignored)) {
    complain(path.string() + " is the file that is read: name another folder with --out.");
    return false;
  }
  if (force || !fs::exists(fs::symlink_status(path, ignored))) return true;
  complain(path.string() + " is there already: --force replaces it, --out names another place.");
  return false;
}

int import_command(const Options& options) {
  if (fs::path(options.out).extension() == ".glb" && options.files.size() > 1) {
    complain("--out names one .glb, and there are " + std::to_string(options.files.size()) +
             " files: name a folder.");
    return app::kError;
  }
  if (!go_apart(options)) return app::kError;
  ImportOptions import;
  import.unit = named<LengthUnit>(options.unit);
  import.up = named<UpAxis>(options.up);
  if (options.simplify_mm) import.simplify = 1e-3 * *options.simplify_mm;
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  bool good = true;
  for (const std::string& file : options.files) {
    const fs::path out = out_path(file, options);
    const fs::path drawn = import.simplify ? drawn_path(out) : fs::path();
    if (!may_write(out, file, options.force) || (!drawn.empty() && !may_write(drawn, file, options.force))) {
      good = false;
      continue;
    }
    const Result<Imported> imported = import_file(file, import);
    if (!imported) complain(imported.error().sentence);
    if (!imported || !write(out, imported->model) || (imported->drawn && !write(drawn, *imported->drawn))) {
      good = false;
      continue;
    }
    if (options.json)
      all.push_back(as_json(file, out, drawn, *imported));
    else
      print(file, out, drawn, *imported);
  }
  if (options.json) std::printf("%s\n", all.dump(2).c_str());
  return good ? app::kCompleted : app::kError;
}

}  // namespace

void add_import(app::Program& program) {
  const auto options = std::make_shared<Options>();
  program.add(
      "import", "Make models for scenarios of the meshes of other programs",
      [options](app::Arguments& arguments) {
        arguments.required({"files", "FILE", "OBJ, STL, PLY, 3DS, glTF and others"}, options->files);
        arguments.text({"--out", "DIR|FILE", "Where the .glb goes (default: here, with the file's name)"},
                       options->out);
        arguments.choice("--unit", "Of the file's numbers; without it guessed, and the reason said",
                         options->unit, {"m", "cm", "mm", "um", "in", "ft"});
        arguments.choice("--up", "The file's axis that points up; without it guessed, and the reason said",
                         options->up, {"y", "z"});
        arguments.positive({"--simplify", "MM", "Make a coarser model to draw, too, within so many mm"},
                           options->simplify_mm);
        arguments.flag("--force", "Replace files that are there", options->force);
        arguments.json("Print what was found as JSON", options->json);
      },
      [options] { return import_command(*options); });
}

}  // namespace fulcrum::importing
