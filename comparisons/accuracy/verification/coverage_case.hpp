#pragma once

#include <filesystem>

#include "comparisons/accuracy/verification/verification_part.hpp"

namespace rebound {

/// How often the error bars of `rebound fem --reference` cover the truth, and how wide they are:
/// from the stored campaign, whose bars are made anew by the estimator of this build. Not run now.
/// Errors: those of read_coverage().
VerificationPart verify_coverage(const std::filesystem::path& table);

}  // namespace rebound
