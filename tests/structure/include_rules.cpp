#include "tests/structure/include_rules.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <regex>
#include <sstream>
#include <stdexcept>

namespace rebound::testing {
namespace {

/// "lumped/laws" begins "lumped/laws/power.hpp", and "meshes/mesh.hpp" itself.
bool begins(const std::string& name, const std::string& path) {
  return path.starts_with(name) && (path.size() == name.size() || path[name.size()] == '/');
}

bool is_source(const std::filesystem::path& file) {
  static constexpr std::array<const char*, 4> endings = {".cpp", ".hpp", ".inl", ".ipp"};
  return std::find(endings.begin(), endings.end(), file.extension().string()) != endings.end();
}

std::vector<std::filesystem::path> sources_below(const std::filesystem::path& root) {
  std::vector<std::filesystem::path> sources;
  auto entry = std::filesystem::recursive_directory_iterator(root);
  for (; entry != std::filesystem::recursive_directory_iterator(); ++entry) {
    const std::string name = entry->path().filename().string();
    if (entry->is_directory() && (name.starts_with('.') || name.starts_with("build")))
      entry.disable_recursion_pending();
    else if (entry->is_regular_file() && is_source(entry->path()))
      sources.push_back(std::filesystem::relative(entry->path(), root));
  }
  std::sort(sources.begin(), sources.end());
  return sources;
}

}  // namespace

IncludeRules::IncludeRules(const std::filesystem::path& table) {
  std::ifstream stream(table);
  if (!stream) throw std::runtime_error("no table " + table.string());
  for (std::string line; std::getline(stream, line);) {
    if (line.empty() || line.front() == '#') continue;
    if (line.front() == '=') {
      written_by_the_build_.insert(line.substr(2));
      continue;
    }
    const auto colon = line.find(':');
    if (colon == std::string::npos) throw std::runtime_error("no colon in: " + line);
    std::istringstream names(line.substr(colon + 1));
    std::vector<std::string> allowed;
    for (std::string name; names >> name;) {
      if (name.front() == '<') libraries_.push_back(name.substr(1, name.size() - 2));
      allowed.push_back(name);
    }
    if (!allowed_.emplace(line.substr(0, colon), allowed).second)
      throw std::runtime_error("twice in the table: " + line);
  }
}

std::string IncludeRules::room_of(const std::string& path) const {
  std::string found;
  for (const auto& [room, allowed] : allowed_)
    if (begins(room, path) && room.size() > found.size()) found = room;
  return found;
}

std::string IncludeRules::complaint(const std::string& room, const std::string& included) const {
  const auto& allowed = allowed_.at(room);
  if (room_of(included) == room) return "";
  for (const std::string& name : allowed)
    if (begins(name, included)) return "";
  return room + " may not include " + included;
}

std::string IncludeRules::library_complaint(const std::string& room,
                                            const std::string& header) const {
  for (const std::string& library : libraries_) {
    if (!header.starts_with(library)) continue;
    const auto& allowed = allowed_.at(room);
    if (std::find(allowed.begin(), allowed.end(), "<" + library + ">") == allowed.end())
      return room + " may not include <" + header + ">";
  }
  return "";
}

IncludeRules::Report IncludeRules::check(const std::filesystem::path& root) const {
  static const std::regex include(R"re(^\s*#\s*include\s*(["<])([^">]+)[">].*)re");
  Report report;
  for (const auto& file : sources_below(root)) {
    ++report.files;
    const std::string path = file.generic_string(), room = room_of(path);
    if (room.empty()) {
      report.violations.push_back(path + ": is in no room of the table");
      continue;
    }
    std::ifstream stream(root / file);
    int number = 0;
    for (std::string line; std::getline(stream, line);) {
      ++number;
      std::smatch match;
      if (!std::regex_match(line, match, include)) continue;
      ++report.includes;
      const std::string name = match[2];
      std::string why;
      if (match[1] == "<")
        why = library_complaint(room, name);
      else if (!written_by_the_build_.contains(name) && !std::filesystem::exists(root / name))
        why = "there is no " + name;
      else
        why = complaint(room, name);
      if (!why.empty())
        report.violations.push_back(path + ":" + std::to_string(number) + ": " + why);
    }
  }
  return report;
}

}  // namespace rebound::testing
