# embed_text(OUT FILE HEADER NAMESPACE FUNCTION)
# Names in OUT a source that is made of FILE: NAMESPACE::FUNCTION(), which HEADER declares, returns the file's text. So
# the program finds it wherever it runs.
if(CMAKE_SCRIPT_MODE_FILE)
  file(READ ${FILE} text)
  file(WRITE ${OUT} "#include \"${HEADER}\"

namespace ${NAMESPACE} {

std::string_view ${FUNCTION}() {
  return R\"embedded(${text})embedded\";
}

}  // namespace ${NAMESPACE}
")
  return()
endif()

set(embed_text_script ${CMAKE_CURRENT_LIST_FILE})

function(embed_text out file header namespace function)
  set(source ${PROJECT_BINARY_DIR}/embedded/${function}.cpp)
  add_custom_command(
    OUTPUT ${source}
    COMMAND ${CMAKE_COMMAND} -DOUT=${source} -DFILE=${file} -DHEADER=${header} -DNAMESPACE=${namespace}
            -DFUNCTION=${function} -P ${embed_text_script}
    DEPENDS ${file} ${embed_text_script}
    VERBATIM)
  set(${out} ${source} PARENT_SCOPE)
endfunction()
