#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <cstdint>
#include <cstdio>
#include <exception>

#include "comparisons/discrepancy/trials/generator/trial_files.hpp"

/// The program `trial_generator`: blind trials for the diagnosis of missing effects.
namespace {

/// The same numbers as those of `rebound`.
enum ExitCode { done = 0, bad_input = 2, solver_failed = 3, input_output_failed = 4 };

struct Options {
  std::string out;
  int count = 0;
  std::uint64_t seed = 0;
  std::string set = "trials";
  std::string only;
  std::string fem;
  bool believe_fem = false;
  bool list = false;
};

constexpr const char* description =
    "Writes blind trials for the diagnosis of missing effects: data sets of impacts with a hidden "
    "effect, or with none.\n\n"
    "  FOLDER/trials/0001/dataset.toml, shot-01.csv ...  what a diagnosis may see\n"
    "  FOLDER/trials/0001/model.toml                     the model that is believed\n"
    "  FOLDER/truth/0001.json                            what is hidden; for scoring alone\n"
    "  FOLDER/sealed.txt                                 SHA-256 of each truth file;\n"
    "                                                    check with: sha256sum --check "
    "sealed.txt\n";

constexpr const char* footer =
    "With --fem the balls are bodies of finite size, half of them without an effect; the forms "
    "are\n"
    "then those that a deck of that program states, and all of the measurement.\n"
    "Kinds: null (30 % of the trials), elastic, rate, memory, history, surface, dynamics,\n"
    "measurement (50 % together), pair (10 %), out_of_family (10 %).\n"
    "The same seed and set give the same data, bit for bit. The nonce of a truth file comes from\n"
    "the system, not from the seed, so that a seal cannot be guessed.\n"
    "Exit codes: 0 done, 2 bad input, 3 a trial could not be computed, 4 reading or writing "
    "failed.\n"
    "Example: trial_generator --out blind --count 600 --seed 7 --set scoring";

void declare(CLI::App& app, Options& options) {
  app.footer(footer);
  app.add_option("--out", options.out, "Folder to write; must not hold sealed trials yet.")
      ->type_name("FOLDER");
  app.add_option("--count", options.count, "How many trials, 1 to 9999.")
      ->type_name("N")
      ->check(CLI::Range(1, 9999));
  app.add_option("--seed", options.seed, "Whole number from which all content is drawn, 0 to 9e15.")
      ->type_name("S")
      ->check(CLI::Range(std::uint64_t{0}, std::uint64_t{9'000'000'000'000'000}));
  app.add_option("--set", options.set,
                 "Name of the set, a part of the seed and of the data sets' names.")
      ->type_name("NAME")
      ->check([](const std::string& name) {
        const bool good = !name.empty() && name.size() <= 60 &&
                          std::all_of(name.begin(), name.end(), [](unsigned char letter) {
                            return std::isalnum(letter) || letter == '-' || letter == '_';
                          });
        return good ? std::string()
                    : fmt::format("'{}' is no name; allowed: letters, digits, - and _", name);
      })
      ->capture_default_str();
  std::vector<std::string> allowed = trials::kinds();
  for (const auto* forms : {&trials::all_forms(), &trials::all_fem_forms()})
    for (const auto& form : *forms) allowed.push_back(form.name);
  app.add_option("--only", options.only, "One kind, or one form by its name (see --list).")
      ->type_name("KIND")
      ->check([allowed](const std::string& kind) {
        if (std::find(allowed.begin(), allowed.end(), kind) != allowed.end()) return std::string();
        return fmt::format("'{}' is no kind or form; allowed: {}", kind, fmt::join(allowed, ", "));
      });
  app.add_option("--fem", options.fem,
                 "Balls in finite elements, computed by this program, as build/rebound; three "
                 "processor seconds a trial with nothing hidden, a minute or two with an effect.")
      ->type_name("PROGRAM");
  app.add_flag("--believe-fem", options.believe_fem,
               "With --fem: what is believed is the ball's material in finite elements, and not "
               "Hunt-Crossley.");
  app.add_flag("--list", options.list, "Print the forms of all families and stop.");
}

void print_forms(const Options& options) {
  for (const auto& form : options.fem.empty() ? trials::all_forms() : trials::all_fem_forms())
    fmt::print("{:14} {:24} |s| {:g} to {:g}  {}\n", form.family, form.name, form.smallest,
               form.largest, form.formula);
}

/// What is missing, or empty.
std::string missing(const CLI::App& app) {
  for (const char* flag : {"--out", "--count", "--seed"})
    if (app.count(flag) == 0) return fmt::format("{}: is required", flag);
  if (app.count("--believe-fem") > 0 && app.count("--fem") == 0)
    return "--believe-fem: takes balls in finite elements; allowed: with --fem PROGRAM";
  return "";
}

/// Is there a form of this kind or name for such balls?
bool is_known(const std::string& only, bool in_fem) {
  if (only.empty() || only == "null" || (only == "pair" && !in_fem)) return true;
  const auto& forms = in_fem ? trials::all_fem_forms() : trials::all_forms();
  return std::any_of(forms.begin(), forms.end(), [&](const trials::EffectForm& form) {
    return form.name == only || form.family == only;
  });
}

int generate(const Options& options) {
  if (std::filesystem::exists(std::filesystem::path(options.out) / "sealed.txt")) {
    fmt::print(stderr, "--out: '{}' holds sealed trials; allowed: a folder without sealed.txt\n",
               options.out);
    return bad_input;
  }
  const auto fem =
      options.fem.empty() ? nullptr : std::make_shared<trials::FemProgram>(options.fem);
  if (!is_known(options.only, fem != nullptr)) {
    fmt::print(stderr, "--only: '{}' has no form for these balls; allowed: see --list{}\n",
               options.only, fem ? " with --fem" : "");
    return bad_input;
  }
  trials::TrialFolder folder(options.out);
  for (int number = 1; number <= options.count; ++number)
    folder.add(trials::make_trial(
        {options.seed, options.set, number, options.only, fem, options.believe_fem}));
  fmt::print("{} trials in {}\n", options.count, options.out);
  return done;
}

}  // namespace

int main(int argc, char** argv) try {
  CLI::App app{description, "trial_generator"};
  Options options;
  declare(app, options);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? done : bad_input;
  }
  if (options.list) {
    print_forms(options);
    return done;
  }
  if (const std::string problem = missing(app); !problem.empty()) {
    fmt::print(stderr, "{}\nRun with --help for more information.\n", problem);
    return bad_input;
  }
  return generate(options);
} catch (const trials::FileError& error) {
  fmt::print(stderr, "{}\n", error.what());
  return input_output_failed;
} catch (const std::exception& error) {
  fmt::print(stderr, "{}\n", error.what());
  return solver_failed;
}
