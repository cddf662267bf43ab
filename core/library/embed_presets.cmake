# cmake -DOUT=FILE.cpp -DPRESETS="a.json;b.json" -DCHART=chart.json -P embed_presets.cmake
# The presets' texts as a table in C++, so that the program finds them wherever it runs.
set(table)
foreach(file IN LISTS PRESETS)
  get_filename_component(name ${file} NAME)
  file(READ ${file} text)
  string(APPEND table "    {\"${name}\", R\"preset(${text})preset\"},\n")
endforeach()
file(READ ${CHART} chart)
file(WRITE ${OUT} "#include \"core/library/embedded_presets.h\"

namespace airlight {

const BundledPresets& embedded_presets() {
  static const BundledPresets presets = {
${table}  };
  return presets;
}

std::string_view embedded_chart_list() {
  return R\"preset(${chart})preset\";
}

}  // namespace airlight
")
