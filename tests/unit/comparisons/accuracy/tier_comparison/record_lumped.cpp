// Records baselines of the lumped tier as another build has it: what stands beside the records of
// the program as it is.  usage: record_... TIERS-FOLDER BASELINES-FOLDER
#include <exception>
#include <iostream>

#include "comparisons/accuracy/tier_comparison/baseline.hpp"
#include "tests/unit/comparisons/accuracy/tier_comparison/lumped_cases.hpp"

#if defined(UNOPTIMISED) && defined(__OPTIMIZE__)
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
