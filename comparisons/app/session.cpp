#include "comparisons/app/session.hpp"

#include "comparisons/io/results/digest.hpp"
#include "comparisons/models/fem_access/module_loader.hpp"

namespace rebound {

Provenance provenance_of(const Session& session, const std::string& input_file,
                         std::string_view input) {
  return {.command_line = session.command_line,
          .input_file = input_file,
          .input_sha256 = sha256(input)};
}

Provenance provenance_with_fem(const Session& session, const std::string& input_file,
                               std::string_view input) {
  Provenance provenance = provenance_of(session, input_file, input);
  provenance.modules = {fem_tier().versions()};
  return provenance;
}

std::string exit_code_help() {
  return "Exit codes:\n"
         "  0    done\n"
         "  1    a comparison or verification failed\n"
         "  2    bad usage or bad input\n"
         "  3    a solver did not converge, or the contact did not end\n"
         "  4    reading or writing failed\n"
         "  5    a stored result or checkpoint is corrupt\n"
         "  130  interrupted\n";
}

}  // namespace rebound
