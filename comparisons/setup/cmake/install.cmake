# What `cmake --install` lays down: the program with its data, the libraries and headers
# of both tiers, what find_package(rebound) reads, and the Python module. Components are the
# packages of package.cmake; without one named, all are installed.
include(CMakePackageConfigHelpers)
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME development)
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/rebound)

install(TARGETS rebound RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
# Completions and manual pages, written by the program from its own table of options.
install(CODE "
  execute_process(COMMAND \"$<TARGET_FILE:rebound>\" completion
    --out \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_DATADIR}\"
    OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)" COMPONENT program)
# The main job: `rebound study PREFIX/share/rebound/sliotar.toml --out FOLDER`.
install(DIRECTORY comparisons/studies/data comparisons/studies/experiments
  DESTINATION ${CMAKE_INSTALL_DATADIR}/rebound COMPONENT data)
install(FILES comparisons/studies/sliotar.toml DESTINATION ${CMAKE_INSTALL_DATADIR}/rebound COMPONENT data)
install(FILES tests/mutations/faults.txt tests/mutations/results.tsv
  DESTINATION ${CMAKE_INSTALL_DATADIR}/rebound/mutations COMPONENT data)
install(FILES comparisons/accuracy/numerical_error/error_bars/coverage.csv
  DESTINATION ${CMAKE_INSTALL_DATADIR}/rebound/error_bars COMPONENT data)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT data)

# rebound::lumped for laws and impacts; rebound::models for effects, the instrument and
# the FE module, which it loads on first use.
install(TARGETS rebound_options rebound_problem rebound_lumped rebound_fem_interface rebound_meshes
  rebound_models
  EXPORT rebound_targets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}/rebound)
foreach(library problem lumped fem_interface meshes models options)
  set_target_properties(rebound_${library} PROPERTIES EXPORT_NAME ${library})
endforeach()
if(REBOUND_FEM)
  install(TARGETS rebound_fem rebound_gmsh LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/rebound
    COMPONENT fem)
endif()
if(TARGET rebound_array_files)
  install(TARGETS rebound_array_files LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/rebound
    COMPONENT program)
endif()
foreach(room lumped fem/interface meshes comparisons/models)
  install(DIRECTORY ${room}/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/rebound/${room}
    FILES_MATCHING PATTERN "*.hpp" PATTERN "*.ipp" PATTERN "*.inc")
endforeach()

# Headers that the build writes from the lists of laws and materials.
install(DIRECTORY ${PROJECT_BINARY_DIR}/generated/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/rebound
  FILES_MATCHING PATTERN "*.hpp")

install(EXPORT rebound_targets NAMESPACE rebound:: DESTINATION ${package_folder})
configure_package_config_file(comparisons/setup/cmake/rebound-config.cmake.in rebound-config.cmake
  INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(rebound-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/rebound-config.cmake
  ${PROJECT_BINARY_DIR}/rebound-config-version.cmake DESTINATION ${package_folder})

if(TARGET rebound_python)
  install(TARGETS rebound_python LIBRARY DESTINATION ${REBOUND_PYTHON_FOLDER} COMPONENT python)
endif()
