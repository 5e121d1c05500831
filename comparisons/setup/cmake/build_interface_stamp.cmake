# Target rebound_interface_stamp: generated/fem/interface/interface_stamp.hpp, anew whenever a
# header that crosses to the FE module has changed.
file(GLOB crossing CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/fem/interface/*.hpp
  ${PROJECT_SOURCE_DIR}/fem/interface/*.inc ${PROJECT_SOURCE_DIR}/lumped/problem/*.hpp)
set(stamp_header ${PROJECT_BINARY_DIR}/generated/fem/interface/interface_stamp.hpp)
add_custom_command(OUTPUT ${stamp_header}
  COMMAND ${CMAKE_COMMAND} -DROOT=${PROJECT_SOURCE_DIR} -DOUTPUT=${stamp_header}
          "-DCOMPILER=${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}"
          -P ${PROJECT_SOURCE_DIR}/comparisons/setup/cmake/interface_stamp.cmake
  COMMAND ${CMAKE_COMMAND} -E touch ${stamp_header}
  DEPENDS ${crossing} ${PROJECT_SOURCE_DIR}/meshes/mesh.hpp ${PROJECT_SOURCE_DIR}/meshes/gmsh/interface.hpp
          ${PROJECT_SOURCE_DIR}/comparisons/io/array_files/interface.hpp
          ${PROJECT_SOURCE_DIR}/comparisons/setup/cmake/interface_stamp.cmake
  COMMENT "Stamp of the FE module's interface" VERBATIM)
add_custom_target(rebound_interface_stamp DEPENDS ${stamp_header})
