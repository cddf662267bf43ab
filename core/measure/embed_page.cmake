# cmake -DOUT=FILE.cpp -DPAGE=page.html -P embed_page.cmake
# The page's text as a string in C++, so that the program finds it wherever it runs.
file(READ ${PAGE} text)
file(WRITE ${OUT} "#include \"core/measure/page.h\"

namespace airlight::measure {

std::string_view page_template() {
  return R\"page(${text})page\";
}

}  // namespace airlight::measure
")
