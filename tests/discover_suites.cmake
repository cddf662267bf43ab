# cmake -DPROGRAM=test_ROOM -DPREFIX=ROOM. -DPROPERTIES="TIMEOUT;600" -DLONG=:SUITE.TEST:... -DOUT=file.cmake
#   -P discover_suites.cmake
# Writes a test for CTest for each suite of a GoogleTest program, with the label `quick`, and one more, SUITE.long, for
# those of its tests that are LONG.
set(text)
function(add_suites filter suffix more_properties)
  execute_process(COMMAND ${PROGRAM} --gtest_list_tests --gtest_filter=${filter} OUTPUT_VARIABLE listed
                  COMMAND_ERROR_IS_FATAL ANY TIMEOUT 60)
  string(REGEX MATCHALL "(^|\n)[^ \n][^\n ]*\\." suites "${listed}")  # tests are indented
  foreach(suite IN LISTS suites)
    string(STRIP "${suite}" suite)
    string(REPLACE "." "\\." pattern "${suite}")
    string(REGEX MATCHALL ":${pattern}[^:]*" tests "${LONG}")
    list(JOIN tests "" tests)
    if(NOT suffix)
      set(tests "${suite}*-${tests}")
    endif()
    string(REGEX REPLACE "\\.$" "" name "${suite}${suffix}")
    string(APPEND text "add_test([=[${PREFIX}${name}]=] [=[${PROGRAM}]=] [=[--gtest_filter=${tests}]=])\n"
                       "set_tests_properties([=[${PREFIX}${name}]=] PROPERTIES ${PROPERTIES} ${more_properties})\n")
  endforeach()
  set(text "${text}" PARENT_SCOPE)
endfunction()
add_suites("-${LONG}" "" "LABELS quick")
if(LONG)
  add_suites("${LONG}" "long" "")
endif()
if(NOT text)
  message(FATAL_ERROR "${PROGRAM} lists no tests")
endif()
file(WRITE ${OUT} "${text}")
