#pragma once

#include <string>

#include "comparisons/app/commands.hpp"
#include "comparisons/io/toml/document.hpp"

namespace rebound {

/// Is this calibration file for the material of the FE tier?
bool asks_for_material(const Document& document);

/// `rebound calibrate` on such a file: fits, prints, stores as for a law.
ExitCode calibrate_material_file(const Session& session, const std::string& path,
                                 const Document& document);

}  // namespace rebound
