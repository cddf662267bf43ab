# cmake -DAIRLIGHT=PROGRAM -DOUT=FOLDER -DGZIP=gzip -P program_documents.cmake
# The manual page and the shells' completion, printed by the program.
cmake_minimum_required(VERSION 3.22)
file(MAKE_DIRECTORY ${OUT})
execute_process(COMMAND ${AIRLIGHT} man OUTPUT_FILE ${OUT}/airlight.1 COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${GZIP} -9nf ${OUT}/airlight.1 COMMAND_ERROR_IS_FATAL ANY)
foreach(pair IN ITEMS bash:airlight.bash zsh:_airlight fish:airlight.fish)
  string(REPLACE ":" ";" pair ${pair})
  list(GET pair 0 shell)
  list(GET pair 1 file)
  execute_process(COMMAND ${AIRLIGHT} completion ${shell} OUTPUT_FILE ${OUT}/${file} COMMAND_ERROR_IS_FATAL ANY)
endforeach()
