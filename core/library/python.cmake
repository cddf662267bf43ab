# The Python package `airlight`, where pybind11 (pybind11-dev) and Python's headers (python3-dev) are installed. All of
# libairlight is part of its module, so that the folder may lie anywhere.
if(NOT Python_EXECUTABLE AND EXISTS /usr/bin/python3)
  set(Python_EXECUTABLE /usr/bin/python3)  # the system's, for which pybind11-dev is
endif()
find_package(Python COMPONENTS Interpreter Development.Module QUIET)
find_package(pybind11 CONFIG QUIET)
if(NOT Python_FOUND OR NOT pybind11_FOUND)
  message(STATUS "The Python package is left out: it needs python3-dev and pybind11-dev")
  return()
endif()

set(python_folder ${PROJECT_BINARY_DIR}/python/airlight)
pybind11_add_module(airlight_python MODULE NO_EXTRAS ${CMAKE_CURRENT_LIST_DIR}/python/module.cpp)
target_link_libraries(airlight_python PRIVATE airlight_library airlight_flags)
airlight_harden(airlight_python)
target_link_options(airlight_python PRIVATE LINKER:--exclude-libs,ALL LINKER:--as-needed)
set_target_properties(airlight_python PROPERTIES OUTPUT_NAME _airlight CXX_VISIBILITY_PRESET hidden
                                                 LIBRARY_OUTPUT_DIRECTORY ${python_folder})
set(python_sources)
foreach(name IN ITEMS __init__.py __init__.pyi py.typed)
  list(APPEND python_sources ${CMAKE_CURRENT_LIST_DIR}/python/${name})
endforeach()
add_custom_target(airlight_python_package ALL
                  COMMAND ${CMAKE_COMMAND} -E copy_if_different ${python_sources} ${python_folder}
                  DEPENDS airlight_python)
add_dependencies(airlight_libraries airlight_python_package)
