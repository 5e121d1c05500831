# cmake -DNPM=... -DPLACE=... -P install.cmake
# Installs what package-lock.json names into PLACE, unless just that is there already.
file(SHA256 "${PLACE}/package-lock.json" wanted)
set(stamp "${PLACE}/node_modules/.installed")
if(EXISTS "${stamp}")
  file(READ "${stamp}" found)
  if(found STREQUAL wanted)
    return()
  endif()
endif()
execute_process(
  COMMAND "${NPM}" ci --ignore-scripts --no-audit --no-fund --prefer-offline
  WORKING_DIRECTORY "${PLACE}" RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "npm ci failed (${status}) in ${PLACE}")
endif()
file(WRITE "${stamp}" "${wanted}")
