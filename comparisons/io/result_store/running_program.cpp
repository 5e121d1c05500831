#include "comparisons/io/result_store/running_program.hpp"

#include "comparisons/io/results/digest.hpp"
#include "comparisons/io/results/provenance.hpp"
#include "comparisons/models/fem_access/module_loader.hpp"
#include "comparisons/models/installation.hpp"

namespace rebound {

std::string running_program() {
  std::string digest = sha256(bytes_of("/proc/self/exe"));
  if (has_fem_tier()) digest = sha256(digest + sha256(bytes_of(module_file("rebound_fem"))));
  return to_json(Provenance{}).at("version").get<std::string>() + "+" + digest.substr(0, 16);
}

}  // namespace rebound
