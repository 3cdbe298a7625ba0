# Writes OUTPUT, a C++ source in which function FUNCTION returns the bytes of INPUT.
# Run as: cmake -DINPUT=... -DOUTPUT=... -DHEADER=... -DFUNCTION=... -P embed_text.cmake
file(READ ${INPUT} hex HEX)
string(REGEX REPLACE "(................................................................)" "\\1\n" hex "${hex}")
string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," hex "${hex}")
file(WRITE ${OUTPUT} "#include \"${HEADER}\"

namespace mrsim {
namespace {

constexpr unsigned char kBytes[] = {
${hex}
};

}  // namespace

std::string_view ${FUNCTION}() { return {reinterpret_cast<const char*>(kBytes), sizeof kBytes}; }

}  // namespace mrsim
")
