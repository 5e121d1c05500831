#include "comparisons/discrepancy/trials/generator/fem_program.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <vector>

extern char** environ;

namespace trials {
namespace {

namespace fs = std::filesystem;

/// A folder that goes when it is left.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (fs::temp_directory_path() / "trial-fem-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make a folder " + name);
    path = name;
  }
  ~TemporaryFolder() {
    std::error_code status;
    fs::remove_all(path, status);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  fs::path path;
};

std::string text_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// Exit code of a program, its messages in a file.
int run(std::vector<std::string> arguments, const fs::path& messages) {
  std::vector<char*> pointers;
  pointers.reserve(arguments.size() + 1);
  for (std::string& one : arguments) pointers.push_back(one.data());
  pointers.push_back(nullptr);
  constexpr int readable = 0600;
  posix_spawn_file_actions_t streams;
  posix_spawn_file_actions_init(&streams);
  posix_spawn_file_actions_addopen(&streams, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addopen(&streams, STDERR_FILENO, messages.c_str(), O_WRONLY | O_CREAT,
                                   readable);
  pid_t child = 0;
  const int failure =
      ::posix_spawn(&child, pointers.front(), &streams, nullptr, pointers.data(), environ);
  posix_spawn_file_actions_destroy(&streams);
  if (failure != 0) throw std::runtime_error(fmt::format("cannot run {}", arguments.front()));
  int status = 0;
  if (::waitpid(child, &status, 0) != child || !WIFEXITED(status)) return -1;
  return WEXITSTATUS(status);
}

/// Exit codes of a program that works, of a ball that nobody can compute; another one is drawn. All
/// others say that the program does not work.
constexpr int deck_refused = 2, no_result = 3;

/// Columns time_s and force_N.
struct Trace {
  std::vector<double> time, force;
};

Trace trace_of(const fs::path& file) {
  std::ifstream stream(file);
  Trace trace;
  std::string line;
  std::getline(stream, line);
  if (!line.starts_with("time_s,force_N"))
    throw std::runtime_error(file.string() + " is no record of time_s,force_N");
  while (std::getline(stream, line)) {
    const auto comma = line.find(',');
    if (comma == std::string::npos) break;
    trace.time.push_back(std::strtod(line.c_str(), nullptr));
    trace.force.push_back(std::strtod(line.c_str() + comma + 1, nullptr));
  }
  if (trace.time.size() < 10) throw std::runtime_error(file.string() + " holds no impact");
  return trace;
}

}  // namespace

FemProgram::FemProgram(const fs::path& program) : program_(fs::absolute(program)) {
  if (::access(program_.c_str(), X_OK) != 0 || fs::is_directory(program_))
    throw std::runtime_error(fmt::format("'{}' is no program", program.string()));
}

const SimulatedImpact& FemProgram::impact(const FemBall& ball, const FemImpact& impact) {
  const std::string deck = deck_text(ball, impact);
  if (const auto known = known_.find(deck); known != known_.end()) return known->second;
  const TemporaryFolder folder;
  const fs::path file = folder.path / "deck.toml", out = folder.path / "out",
                 messages = folder.path / "messages";
  std::ofstream(file) << deck;
  const int code = run(
      {program_.string(), "fem", file.string(), "--out", out.string(), "--threads", "1"}, messages);
  const std::string said =
      fmt::format("{} ends with exit code {}: {}", program_.string(), code, text_of(messages));
  if (code == deck_refused || code == no_result) throw NoRebound(said);
  if (code != 0) throw std::runtime_error(said);
  SimulatedImpact result = read_fem_impact(out);
  constexpr double share_of_contact = 1.5;
  if (ball.plate)
    let_ring_on(*ball.plate, share_of_contact * result.contact_time, result);
  else
    result.force.back() = 0.0;
  result.momentum_change = impact.mass * impact.speed * (1.0 + result.restitution);
  return known_.emplace(deck, std::move(result)).first->second;
}

SimulatedImpact read_fem_impact(const fs::path& folder) {
  constexpr double steps_of_contact = 2000.0;
  const auto json = nlohmann::json::parse(text_of(folder / "result.json"));
  const Trace trace = trace_of(folder / "trace.csv");
  SimulatedImpact impact;
  impact.contact_time = json.at("contact_time_s");
  impact.restitution = json.at("restitution");
  impact.step = impact.contact_time / steps_of_contact;
  std::size_t next = 1;
  for (double time = trace.time.front(); time <= trace.time.back(); time += impact.step) {
    while (next + 1 < trace.time.size() && trace.time[next] < time) ++next;
    const double before = trace.time[next - 1],
                 share = (time - before) / (trace.time[next] - before);
    impact.force.push_back(trace.force[next - 1] +
                           share * (trace.force[next] - trace.force[next - 1]));
  }
  impact.start = trace.time.front();
  impact.peak_force = *std::max_element(impact.force.begin(), impact.force.end());
  return impact;
}

void let_ring_on(const FemPlate& plate, double duration, SimulatedImpact& impact) {
  // Backwards over a few steps, for a slope between two nearly equal values says little.
  constexpr std::size_t back = 20;
  const double last = impact.force.back();
  const double slope = (last - impact.force[impact.force.size() - 1 - back]) /
                       (static_cast<double>(back) * impact.step);
  const double natural = std::sqrt(plate.stiffness / plate.mass), zeta = plate.damping_ratio;
  const double decay = zeta * natural;
  const double frequency = natural * std::sqrt(std::max(1e-6, 1.0 - zeta * zeta));
  const int steps = static_cast<int>(duration / impact.step);
  // The slope is that of the middle of those steps.
  const double middle = 0.5 * static_cast<double>(back) * impact.step;
  const double now = slope - middle * (2.0 * decay * slope + natural * natural * last);
  for (int i = 1; i <= steps; ++i) {
    const double t = i * impact.step;
    impact.force.push_back(std::exp(-decay * t) *
                           (last * std::cos(frequency * t) +
                            (now + decay * last) / frequency * std::sin(frequency * t)));
  }
}

}  // namespace trials
