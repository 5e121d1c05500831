// Records baselines of the lumped tier, compiled without optimisation: what stands beside the
// records of the program as it is.  usage: record_unoptimised TIERS-FOLDER BASELINES-FOLDER
#include <exception>
#include <iostream>

#include "comparisons/accuracy/tier_comparison/baseline.hpp"
#include "tests/unit/comparisons/accuracy/tier_comparison/lumped_cases.hpp"

#ifdef __OPTIMIZE__
#error "this program is to be compiled without optimisation"
#endif

int main(int count, char** arguments) try {
  if (count != 3) return 2;
  for (const rebound::CompareCase& one : rebound::testing::lumped_cases())
    rebound::write_baseline(arguments[2], one.name, rebound::run_case(one, arguments[1], {}));
  return 0;
} catch (const std::exception& error) {
  std::cerr << error.what() << "\n";
  return 3;
}
