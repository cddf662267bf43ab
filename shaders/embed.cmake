# cmake -DIN=x.spv -DOUT=x.cpp -DNAME=id -P embed.cmake: SPIR-V words (little-endian) as a constant array.
file(READ ${IN} hex HEX)
file(SHA256 ${IN} digest)
string(REGEX REPLACE "(..)(..)(..)(..)" "0x\\4\\3\\2\\1," words "${hex}")
string(REGEX REPLACE "(0x........,0x........,0x........,0x........,0x........,0x........,0x........,0x........,)"
       "\\1\n" words "${words}")
file(WRITE ${OUT} "#include \"core/gpu/embedded_shaders.h\"

namespace airlight {
namespace {
constexpr std::uint32_t kSpirv_${NAME}[] = {
${words}
};
}  // namespace
extern const EmbeddedShader kShader_${NAME};
const EmbeddedShader kShader_${NAME} = {\"${NAME}\", kSpirv_${NAME},
                                              \"${digest}\"};
}  // namespace airlight
")
