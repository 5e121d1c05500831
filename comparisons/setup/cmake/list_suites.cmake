cmake_minimum_required(VERSION 3.25)
# cmake -DNAME=… -DPROGRAM=… -DOUTPUT=… -DLABELS=… -DLONG=… -DTIMEOUT=… -P list_suites.cmake
#
# Writes the CTest entries NAME.SUITE of a GoogleTest program. Ends with an error where it lists
# none, or not one of LONG; an entry fails where its filter selects no test.
execute_process(COMMAND ${PROGRAM} --gtest_list_tests OUTPUT_VARIABLE listed RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "${PROGRAM} --gtest_list_tests: ${status}")
endif()
string(REGEX MATCHALL "(^|\n)[A-Za-z0-9_/]+\\." suites "${listed}")
if(NOT suites)
  message(FATAL_ERROR "${PROGRAM} lists no suite")
endif()
foreach(suite IN LISTS LONG)
  if(NOT "${suites}" MATCHES "(^|[;\n])${suite}[.]")
    message(FATAL_ERROR "${PROGRAM} lists no suite ${suite}")
  endif()
endforeach()
set(text "")
foreach(suite IN LISTS suites)
  string(REGEX REPLACE "[\n.]" "" suite "${suite}")
  set(labels "${LABELS}")
  if(suite IN_LIST LONG)
    set(labels "long;${LABELS}")
  endif()
  string(APPEND text "add_test([==[${NAME}.${suite}]==] [==[${PROGRAM}]==] [==[--gtest_filter=${suite}.*]==])\n"
    "set_tests_properties([==[${NAME}.${suite}]==] PROPERTIES LABELS [==[${labels}]==] TIMEOUT ${TIMEOUT}"
    " FAIL_REGULAR_EXPRESSION [==[0 tests from 0 test suites ran]==])\n")
endforeach()
file(WRITE ${OUTPUT} "${text}")
