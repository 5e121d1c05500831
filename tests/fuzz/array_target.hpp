#pragma once

#include "comparisons/io/laboratory/array_table.hpp"
#include "comparisons/io/laboratory/laboratory_table.hpp"
#include "tests/fuzz/fuzz_target.hpp"

namespace rebound::fuzz {

/// A MATLAB or HDF5 file as a user's data set names it. The libraries work in a process of their
/// own: what brings them down is to come back as an Error.
inline int array_file(const std::uint8_t* data, std::size_t size, const char* extension) {
  const auto file = as_file(data, size, extension);
  refused_or_read([&] { preview_array_file(file); });
  return refused_or_read([&] {
    read_array_table(file, {{.heading = "time", .accepted = {dimension::time}, .unit = "ms"},
                            {.heading = "force", .accepted = {dimension::force}, .unit = "N"}});
  });
}

}  // namespace rebound::fuzz
