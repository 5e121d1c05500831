#pragma once

#include <cstddef>
#include <string>

namespace rebound {

/// A part of a campaign: members number − 1, number − 1 + of, …
struct Shard {
  std::size_t number = 1;
  std::size_t of = 1;
};

/// Reads "3/10". Errors: Error(bad_input).
Shard parse_shard(const std::string& text);

/// That of this process among those that `mpirun` started, by what the launcher sets (Open MPI
/// OMPI_COMM_WORLD_RANK and _SIZE, others PMI_RANK and PMI_SIZE); 1/1 without one.
Shard shard_of_launcher();

}  // namespace rebound
