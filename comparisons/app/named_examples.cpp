#include "comparisons/app/named_examples.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "comparisons/app/examples.hpp"
#include "comparisons/io/dataset/describe_dataset.hpp"
#include "comparisons/io/toml/describe_compression.hpp"
#include "comparisons/io/toml/describe_fem.hpp"
#include "comparisons/io/toml/describe_lumped.hpp"
#include "comparisons/io/toml/key_text.hpp"
#include "comparisons/io/toml/nearest_key.hpp"
#include "comparisons/io/toml/toml_writer.hpp"

namespace rebound {
namespace {

/// One word of a command, quoted where a shell would take it apart.
std::string shell_word(const std::string& word) {
  const std::string plain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=:,./";
  if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

}  // namespace

const std::vector<ExampleFile>& example_files() {
  static const std::vector<ExampleFile> list{
      {"lumped.toml", "an impact for `rebound lumped`",
       [] { return write_toml(example_lumped_problem(), Comments::sentences); }},
      {"fem.toml", "an impact for `rebound fem`",
       [] { return write_toml(example_fem_problem(), Comments::sentences); }},
      {"compression.toml", "a slow compression between platens for `rebound compress`",
       [] { return write_toml(example_compression(), Comments::sentences); }},
      {"synthesis.toml", "an experiment for `rebound synthesize`, with something hidden in it",
       [] { return write_toml(example_synthesis(), Comments::sentences); }},
      {"dataset/dataset.toml", "the data set of a study; its CSV files go beside it",
       [] { return write_toml(example_dataset(), Comments::sentences); }},
      {"calibrate.toml",
       "a fit for `rebound calibrate`, once `rebound lumped lumped.toml --out reference` has run",
       [] { return write_toml(example_calibration(), Comments::sentences); }},
      {"select.toml", "two laws for `rebound select`, on the same reference",
       [] { return write_toml(example_selection(), Comments::sentences); }},
      {"benchmark.toml", "two laws for `rebound benchmark`, on the same reference",
       [] { return write_toml(example_benchmark(), Comments::sentences); }},
      {"campaign.toml", "many impacts like lumped.toml for `rebound campaign`",
       [] { return write_toml(example_campaign(), Comments::sentences); }},
      {"compare.toml", "both tiers against each other for `rebound compare`",
       [] { return write_toml(example_comparison(), Comments::sentences); }},
  };
  return list;
}

const std::vector<NamedExample>& named_examples() {
  static const std::string reference = "lumped @/lumped.toml --out @/reference";
  static const std::vector<NamedExample> list{
      {"lumped",
       "one impact of a contact law, with published parameters",
       {"lumped.toml"},
       {"lumped @/lumped.toml"}},
      {"fem",
       "one impact by finite elements, with its balances of momentum and energy",
       {"fem.toml"},
       {"fem @/fem.toml --out @/fem"}},
      {"compression",
       "the force of a slow compression between two platens",
       {"compression.toml"},
       {"compress @/compression.toml"}},
      {"measurements",
       "measured restitution and contact time as a data set, held against themselves",
       {"dataset/dataset.toml"},
       {"inspect @/dataset --out @/inspection"}},
      {"diagnosis",
       "an experiment with something hidden in it, and a model that is asked what it lacks",
       {"lumped.toml", "synthesis.toml"},
       {"synthesize @/synthesis.toml --out @/experiment",
        "diagnose @/experiment/data --model @/lumped.toml --out @/diagnosis"}},
      {"calibration",
       "a contact law fitted to a force history",
       {"lumped.toml", "calibrate.toml"},
       {reference, "calibrate @/calibrate.toml"}},
      {"selection",
       "which of two laws a force history speaks for",
       {"lumped.toml", "select.toml"},
       {reference, "select @/select.toml"}},
      {"benchmark",
       "errors of a law as it stands and of one fitted, on the same force history",
       {"lumped.toml", "benchmark.toml"},
       {reference, "benchmark @/benchmark.toml"}},
      {"campaign",
       "one impact at twenty speeds, and a table of them",
       {"lumped.toml", "campaign.toml"},
       {"campaign @/campaign.toml --out @/store",
        "campaign query @/campaign.toml --out @/store --csv @/campaign.csv"}},
      {"comparison",
       "contact law and finite elements side by side at two speeds",
       {"lumped.toml", "fem.toml", "compare.toml"},
       {"compare @/compare.toml"}},
  };
  return list;
}

const NamedExample& named_example(const std::string& name) {
  std::vector<std::string> names;
  for (const NamedExample& example : named_examples()) {
    if (example.name == name) return example;
    names.push_back(example.name);
  }
  names.push_back("dataset --from FILE");
  const std::string near = nearest_key(name, names);
  throw Error(ExitCode::bad_input,
              near.empty() ? "there is no example of this name; `rebound init --list` lists them"
                           : fmt::format("there is no example of this name; did you mean "
                                         "`rebound init {}`?",
                                         near),
              {.key = "WHAT", .value = name, .allowed = joined(names)});
}

std::vector<std::string> commands_in(const NamedExample& example,
                                     const std::filesystem::path& folder) {
  std::vector<std::string> lines;
  for (const std::string& command : example.commands) {
    std::string line = "rebound";
    std::istringstream words(command);
    for (std::string word; words >> word;)
      line += " " + (word.starts_with("@/")
                         ? shell_word((folder / word.substr(2)).lexically_normal().string())
                         : word);
    lines.push_back(line);
  }
  return lines;
}

}  // namespace rebound
