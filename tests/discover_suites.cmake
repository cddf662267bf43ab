# cmake -DPROGRAM=test_ROOM -DPREFIX=ROOM. -DPROPERTIES="TIMEOUT;600" -DOUT=file.cmake -P discover_suites.cmake: writes a
# test for CTest for each suite of a GoogleTest program.
execute_process(COMMAND ${PROGRAM} --gtest_list_tests OUTPUT_VARIABLE listed COMMAND_ERROR_IS_FATAL ANY TIMEOUT 60)
string(REGEX MATCHALL "(^|\n)[^ \n][^\n ]*\\." suites "${listed}")  # tests are indented
set(text)
foreach(suite IN LISTS suites)
  string(STRIP "${suite}" suite)
  string(REGEX REPLACE "\\.$" "" name "${suite}")
  string(APPEND text "add_test([=[${PREFIX}${name}]=] [=[${PROGRAM}]=] [=[--gtest_filter=${suite}*]=])\n"
                     "set_tests_properties([=[${PREFIX}${name}]=] PROPERTIES ${PROPERTIES})\n")
endforeach()
if(NOT text)
  message(FATAL_ERROR "${PROGRAM} lists no tests")
endif()
file(WRITE ${OUT} "${text}")
