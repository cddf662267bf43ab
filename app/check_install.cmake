# Run before the first file is copied: checks that every file exists and every folder can be made or written.
foreach(file IN LISTS airlight_files)
  if(NOT EXISTS "${file}")
    message(FATAL_ERROR "airlight: ${file} is missing, so nothing is installed; build the program first: "
                        "cmake --build ${airlight_build} --target airlight")
  endif()
endforeach()
foreach(folder IN LISTS airlight_folders)
  get_filename_component(place "$ENV{DESTDIR}${CMAKE_INSTALL_PREFIX}/${folder}" ABSOLUTE)
  while(NOT EXISTS "${place}")
    get_filename_component(place "${place}" DIRECTORY)
  endwhile()
  execute_process(COMMAND test -d "${place}" -a -w "${place}" RESULT_VARIABLE refused)
  if(refused)
    message(FATAL_ERROR "airlight: ${place} cannot be written, so nothing is installed; choose another place with "
                        "cmake --install ${airlight_build} --prefix FOLDER, or become root")
  endif()
endforeach()
