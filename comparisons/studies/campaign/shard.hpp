#pragma once

#include <cstddef>
#include <string>

namespace rebound {

/// A part of a campaign.
struct Shard {
  std::size_t number = 1;
  std::size_t of = 1;
};

/// The member that a shard gets in a round of dealing, in which every shard gets one: each round
/// begins at another shard, as if by chance, so that no shard gets all the slow corners of a grid
/// or the upper half of Sobol points. May lie beyond the last member.
/// Limit: every member goes to one shard -> test ShardTest.EveryMemberIsDealtOnce
std::size_t member_in_round(const Shard& shard, std::size_t round);

/// How many of `all` members a shard gets.
std::size_t members_of(const Shard& shard, std::size_t all);

/// Reads "3/10". Errors: Error(bad_input).
Shard parse_shard(const std::string& text);

/// That of this process among those that `mpirun` started, by what the launcher sets (Open MPI
/// OMPI_COMM_WORLD_RANK and _SIZE, others PMI_RANK and PMI_SIZE); 1/1 without one.
Shard shard_of_launcher();

}  // namespace rebound
