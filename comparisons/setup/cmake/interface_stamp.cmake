cmake_minimum_required(VERSION 3.25)
# cmake -DROOT=… -DOUTPUT=… -DCOMPILER=… -P interface_stamp.cmake
#
# Writes OUTPUT, a header with `interface_stamp`: a digest of every header whose records cross
# from the program to the FE module, and of the compiler. Program and module carry it; a module
# of other headers is refused. Ends with an error where such a header includes one that is not
# digested.
file(GLOB headers RELATIVE ${ROOT} ${ROOT}/fem/interface/*.hpp ${ROOT}/fem/interface/*.inc
  ${ROOT}/lumped/problem/*.hpp ${ROOT}/meshes/mesh.hpp ${ROOT}/meshes/gmsh/interface.hpp
  ${ROOT}/comparisons/io/array_files/interface.hpp)
list(SORT headers)
set(all "${COMPILER}")
foreach(header IN LISTS headers)
  file(SHA256 ${ROOT}/${header} digest)
  string(APPEND all "\n${header} ${digest}")
  file(STRINGS ${ROOT}/${header} includes REGEX "^#include \"")
  foreach(include IN LISTS includes)
    string(REGEX REPLACE "^#include \"([^\"]*)\".*" "\\1" include "${include}")
    if(NOT include IN_LIST headers AND NOT include STREQUAL "fem/interface/interface_stamp.hpp")
      message(FATAL_ERROR "${header} crosses to the FE module and includes ${include}, which the stamp does not cover")
    endif()
  endforeach()
endforeach()
string(SHA256 digest "${all}")
string(SUBSTRING "${digest}" 0 16 stamp)
file(CONFIGURE OUTPUT ${OUTPUT} @ONLY CONTENT "#pragma once

// Written by comparisons/setup/cmake/interface_stamp.cmake.
namespace rebound {

/// Digest of the headers whose records cross to the FE module. Program and module
/// are built together; a stale one of the two must be refused, not crash.
inline constexpr unsigned long interface_stamp = 0x${stamp}UL;

}  // namespace rebound
")
