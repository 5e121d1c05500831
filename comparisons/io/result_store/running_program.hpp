#pragma once

#include <string>

namespace rebound {

/// Version and first digits of the digest of the program that runs, with the FE module's: results
/// of two programs are not mixed. Errors: Error(input_output_failed).
std::string running_program();

}  // namespace rebound
