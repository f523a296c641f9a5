#pragma once

/// Verbs that write files, and a folder that must survive them.

#include "tools/run_program.hpp"
#include "tools/test_scenes.hpp"

#include <pelt/version.hpp>

#include <cstdlib>
#include <filesystem>
#include <map>
#include <ostream>
#include <string>
#include <vector>

namespace pelt::test {

inline const std::string kOld = "what was there before\n";

/// A verb with one output, whose name is the last argument.
struct Writer {
  std::string name;
  Words words;
  bool reads_scene = true;  ///< otherwise a.gltf
};

inline void PrintTo(const Writer& writer, std::ostream* out) { *out << writer.name; }

/// All outputs of all verbs, except `demo`, which writes a folder and has tests of its own.
inline std::vector<Writer> writers() {
  return {{"check_jsonl", {"check", "scene.json", "--fail-on", "never", "--jsonl"}},
          {"check_glb", {"check", "scene.json", "--fail-on", "never", "--glb"}},
          {"check_html", {"check", "scene.json", "--fail-on", "never", "--html"}},
          {"bounds", {"bounds", "scene.json", "--jsonl"}},
          {"distance", {"distance", "scene.json", "--jsonl"}},
          {"closest", {"distance", "scene.json", "--from", "0,0,0", "--jsonl"}},
          {"ray", {"ray", "scene.json", "--from", "0,0.5,-3", "--to", "0,0.5,3", "--jsonl"}},
          {"region", {"region", "scene.json", "--sphere", "0,0,0,1", "--jsonl"}},
          {"pose", {"pose", "scene.json", "--frame", "3", "-o"}},
          {"prepare", {"prepare", "a.gltf", "-o"}, false},
          {"view", {"view", "scene.json", "--no-browser", "-o"}},
          {"bench",
           {"bench", "scene.json", "--frames", "0:1", "--repeat", "1", "--methods", "on_demand",
            "--json"}}};
}

/// A folder with a scene of a.gltf, the buffer a.bin and the image that a.gltf names, and the
/// viewer's page.
class SafetyFolder : public TestFolder {
 public:
  SafetyFolder() {
    GltfBuilder builder = build_limb(12);
    builder.document["buffers"] = {{{"byteLength", builder.binary.size()}, {"uri", "a.bin"}}};
    builder.document["images"] = {{{"uri", "skin%20a.png"}}};
    write_text(*this / "a.gltf", builder.document.dump());
    write_bytes(*this / "a.bin", builder.binary);
    write_text(*this / "skin a.png", "picture");
    std::string scene = kLimbsScene;
    for (const std::string model : {"one.glb", "two.glb"})
      scene.replace(scene.find(model), model.size(), "a.gltf");
    write_text(*this / "scene.json", scene);
  }

  /// Names and contents of the files; follows links.
  std::map<std::string, std::string> contents() const {
    std::map<std::string, std::string> all;
    for (const std::string& name : names_in(*this)) {
      if (std::filesystem::is_regular_file(*this / name)) all[name] = read_text(*this / name);
    }
    return all;
  }

 private:
  const ViewerPage viewer_{*this};
};

inline Words with(const Words& words, const std::string& last) { return joined(words, {last}); }

inline std::string shell_command(const Words& words) {
  std::string command = "'" PELT_COMMAND "'";
  for (const std::string& word : words) command.append(" '").append(word).append("'");
  return command;
}

inline Ended run_in_shell(const SafetyFolder& folder, const std::string& script) {
  return run_program(folder.path(), {"bash", "-c", script});
}

/// Name of a test of one writer.
inline std::string name_of_writer(const ::testing::TestParamInfo<Writer>& info) {
  return info.param.name;
}

}  // namespace pelt::test
