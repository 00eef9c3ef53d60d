#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iterator>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "engine/app/author/first_guess.h"
#include "engine/app/author/first_text.h"
#include "engine/app/author/starter_models.h"
#include "engine/app/cli/beside.h"
#include "engine/app/cli/exit_code.h"
#include "engine/app/cli/terminal.h"
#include "engine/app/commands/commands.h"
#include "engine/assets/gltf.h"
#include "engine/assets/gltf_writer.h"
#include "engine/files/put_file.h"
#include "engine/scenario/content.h"
#include "engine/scenario/content_file.h"
#include "engine/scenario/load.h"
#include "engine/scenario/marked.h"
#include "engine/scenario/text_store.h"
#include "engine/scenario/words.h"

namespace fulcrum::app {
namespace {

namespace fs = std::filesystem;

constexpr const char* kDevice = "phantom_like";

struct NewOptions {
  std::string folder;
  std::string from;         // a scenario to copy
  std::string scene, tool;  // mesh files
};

bool refuse(const std::string& sentence) {
  complain(sentence);
  return false;
}

bool put(const fs::path& path, const std::string& bytes) {
  if (put_file(path, {std::as_bytes(std::span(bytes))})) return true;
  return refuse(path.string() + " cannot be written: see that its folder is yours and has room.");
}

// A folder that is not there, or is empty: nothing that somebody made is written over.
bool may_make(const fs::path& folder) {
  std::error_code fault;
  if (!fs::exists(fs::symlink_status(folder, fault))) return true;
  if (fs::is_directory(folder, fault) && fs::is_empty(folder, fault)) return true;
  return refuse(folder.string() + " is there already: name a folder that is not.");
}

// Files that named their schema by where they lay name it by where it is.
bool name_schemas(const fs::path& folder) {
  std::error_code fault;
  for (const auto& entry : fs::directory_iterator(folder, fault)) {
    if (entry.path().extension() != ".yaml") continue;
    const std::string kind = entry.path().filename() == scenario::kScenarioFile ? "scenario" : "hand";
    const std::string before = schema_line("../../schema", kind);
    const Result<std::string> text = scenario::read_text(RegularFile::open(entry.path()));
    if (!text || !text->starts_with(before)) continue;
    if (!put(entry.path(), schema_line(schema_folder(), kind) + text->substr(before.size()))) return false;
  }
  return true;
}

// All that lies in a scenario's folder.
bool copy_scenario(const std::string& name, const fs::path& folder) {
  const Result<fs::path> file = scenario::find_scenario(name);
  if (!file) return refuse(file.error().sentence);
  std::error_code fault;
  fs::create_directories(folder, fault);
  if (!fault) fs::copy(file->parent_path(), folder, fs::copy_options::recursive, fault);
  if (fault) return refuse(folder.string() + " cannot be made: " + fault.message() + ".");
  return name_schemas(folder);
}

// The mesh as a .glb of that name in the folder. Other formats are read by the program beside this one.
bool take_mesh(const std::string& mesh, const fs::path& to) {
  std::error_code fault;
  if (!fs::is_regular_file(mesh, fault))
    return refuse(mesh + " is no file: name a mesh, OBJ, STL, PLY, 3DS or glTF.");
  const fs::path extension = fs::path(mesh).extension();
  if (extension == ".glb") {
    fs::copy_file(mesh, to, fault);
    return fault ? refuse(to.string() + " cannot be written: " + fault.message() + ".") : true;
  }
  std::vector<std::string> words{"fulcrum", "import", mesh, "--out", to.string()};
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  return run_beside({"fulcrum-import", "meshes are imported"}, argv.data(),
                    mesh + " could not be read: it is damaged; export it again.") == kCompleted;
}

std::optional<Model> model_of(const fs::path& folder, const std::string& file) {
  Result<Model> model = load_gltf(fs::absolute(folder), fs::absolute(folder) / file);
  if (model) return std::move(*model);
  complain(model.error().sentence);
  return std::nullopt;
}

// Of the models with that role, as one solid.
std::optional<Solid> solid_of(const fs::path& folder, const std::vector<FirstModel>& models,
                              scenario::ModelRole role, const char* use) {
  Model all;
  std::string file;
  for (const FirstModel& each : models) {
    if (each.role != names_of<scenario::ModelRole>[static_cast<std::size_t>(role)]) continue;
    std::optional<Model> model = model_of(folder, file = each.file);
    if (!model) return std::nullopt;
    if (each.marked) scenario::take_marked(*model, role, each.material);
    std::ranges::move(model->parts, std::back_inserter(all.parts));
  }
  Result<Solid> solid = build_solid(to_triangle_mesh(all));
  if (solid) return std::move(*solid);
  complain(file + " cannot be " + use + ": " + solid.error().sentence);
  return std::nullopt;
}

bool is_word(const std::string& text) {
  return std::ranges::all_of(
      text,
      [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
               c == '-';
      });
}

// A model for each mark that the objects of the file have; none, and a sentence: they are not marked for
// both.
std::vector<FirstModel> marked_models(const fs::path& folder, const std::string& file) {
  const std::optional<Model> model = model_of(folder, file);
  if (!model) return {};
  std::vector<FirstModel> models;
  bool has_scene = false, has_tool = false;
  for (const scenario::ObjectMark& mark : scenario::marks_of(*model)) {
    has_scene = has_scene || mark.role == scenario::ModelRole::scene;
    has_tool = has_tool || mark.role == scenario::ModelRole::tool;
    if (const std::string wrong = refuse_marked(*model, mark.role, mark.material); !wrong.empty()) {
      std::string sentence = scenario::in_quotes(file);
      complain(sentence.append(" ").append(wrong).append("."));
      return {};
    }
    if (!mark.material.empty() &&
        (!is_word(mark.material) ||
         !scenario::ContentFile(folder, "materials", mark.material).is_installed())) {
      std::string sentence = scenario::in_quotes(file);
      complain(sentence.append(" has an object whose 'fulcrum_material' is ")
                   .append(scenario::in_quotes(mark.material))
                   .append(", which is no material that there is."));
      return {};
    }
    const std::string role(names_of<scenario::ModelRole>[static_cast<std::size_t>(mark.role)]);
    std::string name = role;
    if (!mark.material.empty()) name.append("_").append(mark.material);
    models.push_back({std::move(name), file, role, true, mark.material});
  }
  if (has_scene && has_tool) return models;
  complain(
      "a scenario of your own meshes needs what is touched and what is held: --scene FILE and --tool FILE, "
      "or "
      "one --scene whose objects are marked 'scene' and 'tool' by a custom property 'fulcrum_role'. In "
      "Blender "
      "tick Include > Custom Properties when exporting.");
  return {};
}

// The models of a new scenario, their files in its folder. None: a sentence has said why.
std::vector<FirstModel> take_models(const NewOptions& options, const fs::path& folder) {
  const std::vector<FirstModel> both{{"scene", "scene.glb", "scene", false, {}},
                                     {"tool", "tool.glb", "tool", false, {}}};
  if (options.scene.empty()) {
    const bool made = put(folder / "scene.glb", to_glb(starter_board(), "board", "Fulcrum new")) &&
                      put(folder / "tool.glb", to_glb(starter_pin(), "pin", "Fulcrum new"));
    return made ? both : std::vector<FirstModel>();
  }
  if (!take_mesh(options.scene, folder / "scene.glb")) return {};
  if (options.tool.empty()) return marked_models(folder, "scene.glb");
  return take_mesh(options.tool, folder / "tool.glb") ? both : std::vector<FirstModel>();
}

// A title of the folder's name: "my_peg" is "My peg".
std::string title_of(const fs::path& folder) {
  std::string title = fs::absolute(folder).lexically_normal().filename().string();
  if (title.empty()) title = fs::absolute(folder).lexically_normal().parent_path().filename().string();
  for (char& c : title)
    if (c == '_' || c == '-' || static_cast<unsigned char>(c) < ' ') c = ' ';
  if (!title.empty() && title[0] >= 'a' && title[0] <= 'z')
    title[0] = static_cast<char>(title[0] - 'a' + 'A');
  return title.empty() ? "A scene of my own" : title;
}

// As a shell takes it for one word.
std::string shell_word(const std::string& text) {
  constexpr std::string_view kPlain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./+:@%";
  if (text.find_first_not_of(kPlain) == text.npos) return text;
  std::string word = "'";
  for (const char c : text) c == '\'' ? word += "'\\''" : word += c;
  return word + "'";
}

bool make_scenario(const NewOptions& options, const fs::path& folder) {
  std::error_code fault;
  fs::create_directories(folder, fault);
  if (fault) return refuse(folder.string() + " cannot be made: " + fault.message() + ".");
  const std::vector<FirstModel> models = take_models(options, folder);
  if (models.empty()) return false;
  const std::optional<Solid> scene = solid_of(folder, models, scenario::ModelRole::scene, "touched");
  const std::optional<Solid> tool = solid_of(folder, models, scenario::ModelRole::tool, "held");
  if (!scene || !tool) return false;
  const auto devices = scenario::device_files(scenario::content_roots());
  const auto table = devices.find(kDevice);
  if (table == devices.end())
    return refuse(
        "no content folder was found, in which the devices are: set FULCRUM_CONTENT to the one of your "
        "copy.");
  const scenario::Checked<DeviceDesc> device = scenario::load_device(table->second);
  if (!device) return refuse(scenario::to_text(device.faults()));
  const FirstGuess guess = guess_scenario(*scene, *tool, *device);
  const FirstFiles files{title_of(folder), models, kDevice, schema_folder()};
  if (!put(folder / "expert.yaml", expert_text(files, guess)) ||
      !put(folder / scenario::kScenarioFile, scenario_text(files, guess)))
    return false;
  if (!guess.is_clear)
    complain(
        "no way without a touch was found from above to the middle of the scene: move 'start' and the "
        "checkpoints.");
  return true;
}

int new_command(const NewOptions& options) {
  if (options.scene.empty() && !options.tool.empty()) {
    complain("--tool FILE is what is held: say with --scene FILE what is touched.");
    return kUsage;
  }
  if (!options.from.empty() && !options.scene.empty()) {
    complain("--from copies a scenario with its models: leave --scene and --tool out, or --from.");
    return kUsage;
  }
  const fs::path folder(options.folder);
  if (!may_make(folder)) return kError;
  const bool made =
      options.from.empty() ? make_scenario(options, folder) : copy_scenario(options.from, folder);
  if (!made) {  // the folder was not there, or empty: what is in it is this program's
    std::error_code ignored;
    for (const char* file : {"scene.glb", "tool.glb", "expert.yaml", scenario::kScenarioFile})
      fs::remove(folder / file, ignored);
    fs::remove(folder, ignored);
    return kError;
  }
  const fs::path file = folder / scenario::kScenarioFile;
  const std::string name = shell_word(file.string());
  std::printf("%s is made. What was guessed is said in it.\n  fulcrum run %s\n  fulcrum check %s\n",
              bold(file.string()).c_str(), name.c_str(), name.c_str());
  return kCompleted;
}

}  // namespace

void add_new(Program& program) {
  const auto options = std::make_shared<NewOptions>();
  program.add(
      "new", "Make a scenario of your own that runs at once",
      [options](Arguments& arguments) {
        arguments.required({"folder", "DIR", "The folder to make"}, options->folder);
        arguments.text({"--from", "NAME|FILE", "Copy this scenario instead of guessing one"}, options->from);
        arguments.text(
            {"--scene", "FILE",
             "What is touched: OBJ, STL, PLY, 3DS or glTF (default: a board); with the tool, where a glTF's "
             "objects are marked"},
            options->scene);
        arguments.text({"--tool", "FILE", "What is held (default: a pin)"}, options->tool);
      },
      [options] { return new_command(*options); });
}

}  // namespace fulcrum::app
