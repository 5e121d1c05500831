#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace rebound {

/// A commented file to start from.
struct ExampleFile {
  std::string file;  ///< its path below the folder that is written to
  std::string use;   ///< which command reads it
  std::string (*text)();
};

/// All of them, in the order in which a newcomer meets them.
const std::vector<ExampleFile>& example_files();

/// One thing to try: the files that it needs and no other, and the commands that use them.
struct NamedExample {
  std::string name;
  std::string shows;                  ///< half a sentence
  std::vector<std::string> files;     ///< of example_files()
  std::vector<std::string> commands;  ///< without the program's name; "@/" is the folder
};

const std::vector<NamedExample>& named_examples();

/// Errors: Error(bad_input) for a name that is not among them, with the nearest one and the list.
const NamedExample& named_example(const std::string& name);

/// The commands of an example as a shell takes them, its files being in `folder`.
std::vector<std::string> commands_in(const NamedExample& example,
                                     const std::filesystem::path& folder);

}  // namespace rebound
