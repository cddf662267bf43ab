# Run before the first file is copied: checks that every file exists and every folder can be made or written. Then makes
# the folders that are missing, with rights for all: CMake would make them with those that the umask leaves.
# CMake wraps a message's lines, so that no command could be copied from them, but none that begins with a blank.
string(REPLACE "'" "'\\''" airlight_build_word "${airlight_build}")
set(airlight_build_word "'${airlight_build_word}'")  # as a shell takes it
foreach(file IN LISTS airlight_files)
  if(NOT EXISTS "${file}")
    message(FATAL_ERROR " airlight: ${file} is missing, so nothing is installed; build the program first:\n"
                        "   cmake --build ${airlight_build_word} --target airlight")
  endif()
endforeach()
set(missing)
foreach(folder IN LISTS airlight_folders)
  get_filename_component(place "$ENV{DESTDIR}${CMAKE_INSTALL_PREFIX}/${folder}" ABSOLUTE)
  while(NOT EXISTS "${place}")
    list(PREPEND missing "${place}")
    get_filename_component(place "${place}" DIRECTORY)
  endwhile()
  execute_process(COMMAND test -d "${place}" -a -w "${place}" RESULT_VARIABLE refused)
  if(refused)
    message(FATAL_ERROR " airlight: ${place} cannot be written, so nothing is installed; become root, or choose another "
                        "place:\n   cmake --install ${airlight_build_word} --prefix FOLDER")
  endif()
endforeach()
foreach(folder IN LISTS missing)
  file(MAKE_DIRECTORY "${folder}")
  file(CHMOD "${folder}" DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ
       WORLD_EXECUTE)
endforeach()
