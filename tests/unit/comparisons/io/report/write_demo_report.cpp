// write_demo_report FILE [BALL-NAME]: the demo report, for the browser tests.

#include <exception>
#include <iostream>

#include "comparisons/io/report/write_report.hpp"
#include "tests/unit/comparisons/io/report/demo_report.hpp"

int main(int argc, char** argv) {
  if (argc != 2 && argc != 3) {
    std::cerr << "usage: write_demo_report FILE [BALL-NAME]\n";
    return 2;
  }
  try {
    rebound::report::write_report(argc == 3 ? rebound::report_tests::demo_report(argv[2])
                                            : rebound::report_tests::demo_report(),
                                  argv[1]);
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 4;
  }
}
