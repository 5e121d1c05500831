// Of fuzzers alone, in the place of meshes/gmsh/isolated.cpp: the work of the foreign libraries in
// this process, where its counters and a sanitizer's report are seen.
#include <exception>
#include <new>

#include "lumped/problem/error.hpp"
#include "meshes/gmsh/isolated.hpp"

namespace rebound {

std::string isolated(const std::function<std::string()>& work, const Isolation& limits,
                     const RunControl&) {
  const std::string program = limits.program;
  try {
    return work();
  } catch (const Error&) {
    throw;
  } catch (const std::string& reason) {  // what Gmsh 4.8 throws
    throw Error(ExitCode::bad_input, program + ": " + reason);
  } catch (const std::bad_alloc&) {
    throw Error(ExitCode::bad_input, "it needs more memory than a file of its size can: damaged?");
  } catch (const std::exception& error) {
    throw Error(ExitCode::bad_input, program + ": " + error.what());
  }
}

}  // namespace rebound
