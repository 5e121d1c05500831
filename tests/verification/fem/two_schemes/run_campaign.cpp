// Makes table.csv: both schemes, each with its error bars, on four cores at
// three speeds. Some six minutes.
//
//   build/two_schemes_campaign tests/verification/fem/two_schemes > table.csv
#include <fmt/format.h>

#include <cstdio>
#include <exception>

#include "tests/verification/fem/two_schemes/campaign.hpp"

int main(int count, char** arguments) try {
  using namespace rebound::test;
  if (count != 2) {
    fmt::print(stderr, "usage: two_schemes_campaign FOLDER_OF_CORES\n");
    return 2;
  }
  std::vector<SchemePair> pairs;
  for (const char* core : campaign_cores)
    for (const double speed : campaign_speeds) {
      for (SchemePair& pair : run_both(arguments[1], core, speed)) pairs.push_back(std::move(pair));
      fmt::print(stderr, "core {} at {} m/s done\n", core, speed);
    }
  fmt::print("{}", campaign_csv(pairs));
  return 0;
} catch (const std::exception& error) {
  fmt::print(stderr, "{}\n", error.what());
  return 3;
}
