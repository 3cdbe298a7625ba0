#include "removal/part/stock_file.h"

#include "core/bytes.h"
#include "core/error.h"
#include "core/hash.h"
#include "removal/part/recipe_codec.h"
#include "removal/part/stock_grid.h"

#include <algorithm>
#include <ostream>
#include <streambuf>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr std::string_view kMagic = "MRSIMVDB";
constexpr std::uint64_t kVersion = 1;
constexpr std::size_t kTrailer = 32;
// OpenVDB's stream: 8 bytes magic, 4 file version, 8 library version, 1 grid offsets, then the
// identifier, 36 characters.
constexpr std::size_t kUuidOffset = 21, kUuidSize = 36;

// Hands what OpenVDB writes to a ByteSink, with the identifier replaced.
class SinkBuffer : public std::streambuf {
 public:
  SinkBuffer(const ByteSink& out, ContentHash& hash, std::string uuid)
      : out_(out), hash_(hash), uuid_(std::move(uuid)) {}

 protected:
  std::streamsize xsputn(const char* data, std::streamsize size) override {
    std::string piece(data, static_cast<std::size_t>(size));
    for (std::size_t i = 0; i < piece.size() && position_ + i < kUuidOffset + kUuidSize; ++i)
      if (position_ + i >= kUuidOffset) piece[i] = uuid_[position_ + i - kUuidOffset];
    hash_.update(piece.data(), piece.size());
    out_(piece.data(), piece.size());
    position_ += piece.size();
    return size;
  }
  int_type overflow(int_type c) override {
    const char byte = traits_type::to_char_type(c);
    return traits_type::eq_int_type(c, traits_type::eof()) ? 0 : (xsputn(&byte, 1), c);
  }
  // OpenVDB asks where it is, and never goes back in a stream.
  pos_type seekoff(off_type offset, std::ios_base::seekdir direction,
                   std::ios_base::openmode) override {
    return offset == 0 && direction == std::ios_base::cur
               ? pos_type(static_cast<off_type>(position_))
               : pos_type(off_type(-1));
  }

 private:
  const ByteSink& out_;
  ContentHash& hash_;
  std::string uuid_;
  std::size_t position_ = 0;
};

}  // namespace

void write_vdb(const Stock& stock, const StockRecipe& recipe, const ByteSink& out) {
  const std::string encoded = encode_recipe(recipe);
  ContentHash identity, hash;
  identity.update(encoded.data(), encoded.size());
  SinkBuffer buffer(out, hash, identity.uuid());
  std::ostream stream(&buffer);
  stock.grid().voxels->write(*stock.grid().field, *stock.grid().index, stream);
  if (!stream) throw Error("output-unwritable", "cannot write the .vdb file");

  hash.update(encoded.data(), encoded.size());
  std::string trailer;
  detail::store(trailer, static_cast<std::uint64_t>(encoded.size()));
  detail::store(trailer, hash.digest());
  trailer += kMagic;
  detail::store(trailer, kVersion);
  out(encoded.data(), encoded.size());
  out(trailer.data(), trailer.size());
}

StockRecipe read_vdb(std::string_view bytes, const std::string& name) {
  const auto damaged = [&] {
    return Error(
        "vdb-damaged",
        name +
            " is damaged: its bytes do not match their checksum; simulate the earlier setup again");
  };
  if (bytes.size() < kTrailer || bytes.substr(bytes.size() - 16, 8) != kMagic) {
    if (bytes.find(kMagic) != std::string_view::npos) throw damaged();
    throw Error("vdb-foreign", name +
                                   " was not written by mrsim: a .vdb stock must be one that mrsim "
                                   "saved; give the stock as a mesh");
  }
  const char* trailer = bytes.data() + bytes.size() - kTrailer;
  const auto size = detail::load<std::uint64_t>(trailer);
  const auto version = detail::load<std::uint64_t>(trailer + 24);
  if (version != kVersion)
    throw Error("vdb-version", fmt::format("{} has version {}, this mrsim reads version {}", name,
                                           version, kVersion));
  const std::string_view body = bytes.substr(0, bytes.size() - kTrailer);
  if (size > body.size()) throw damaged();
  ContentHash hash;
  hash.update(body.data(), body.size());
  if (hash.digest() != detail::load<std::uint64_t>(trailer + 8)) throw damaged();
  return decode_recipe(body.substr(body.size() - size), name);
}

}  // namespace mrsim
