#include "comparisons/io/results/provenance.hpp"

#include <fmt/format.h>
#include <openssl/opensslv.h>
#include <toml++/toml.h>

namespace rebound {

std::vector<std::string> library_versions() {
  return {
      fmt::format("compiler {}", __VERSION__),
      fmt::format("fmt {}.{}.{}", FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100),
      fmt::format("nlohmann-json {}.{}.{}", NLOHMANN_JSON_VERSION_MAJOR,
                  NLOHMANN_JSON_VERSION_MINOR, NLOHMANN_JSON_VERSION_PATCH),
      fmt::format("toml++ {}.{}.{}", TOML_LIB_MAJOR, TOML_LIB_MINOR, TOML_LIB_PATCH),
      fmt::format("OpenSSL {}", OPENSSL_VERSION_STR)};
}

Json to_json(const Provenance& provenance) {
  return {{"program", "rebound"},
          {"version", REBOUND_VERSION},
          {"command", provenance.command_line},
          {"input", provenance.input_file},
          {"input_sha256", provenance.input_sha256},
          {"modules", provenance.modules},
          {"libraries", library_versions()}};
}

}  // namespace rebound
