#include "removal/part/stock_file.h"

#include "core/numbers/hash.h"
#include "core/process/error.h"
#include "core/text/base64.h"
#include "core/text/bytes.h"
#include "removal/part/recipe_codec.h"
#include "removal/part/stock_grid.h"

#include <algorithm>
#include <exception>
#include <ostream>
#include <streambuf>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr std::string_view kMagic = "MRSIMVDB";
constexpr std::uint64_t kVersion = 2;
constexpr std::size_t kSeal = 16;                               // bytes behind OpenVDB's stream
constexpr std::size_t kRecipeHead = 2 * sizeof(std::uint64_t);  // version and hash, before a recipe
// OpenVDB's stream: 8 bytes magic, 4 file version, 8 library version, 1 grid offsets, then the
// identifier, 36 characters, and the metadata of the file.
constexpr std::int64_t kVdbMagic = 0x56444220;
constexpr std::uint32_t kLeastFileVersion = 218;  // of files that begin like that
constexpr std::size_t kUuidOffset = 21, kUuidSize = 36;

// Hands what OpenVDB writes to a ByteSink, with the identifier replaced.
class SinkBuffer : public std::streambuf {
 public:
  SinkBuffer(const ByteSink& out, ContentHash& hash, std::string uuid)
      : out_(out), hash_(hash), uuid_(std::move(uuid)) {}

  /// Throws again what the sink threw: the stream itself only knows that something has failed.
  void rethrow() const {
    if (fault_) std::rethrow_exception(fault_);
  }

 protected:
  std::streamsize xsputn(const char* data, std::streamsize size) override {
    try {
      return hand_on(data, size);
    } catch (...) {
      fault_ = std::current_exception();
      return 0;
    }
  }
  int_type overflow(int_type c) override {
    const char byte = traits_type::to_char_type(c);
    if (traits_type::eq_int_type(c, traits_type::eof())) return 0;
    return xsputn(&byte, 1) == 1 ? c : traits_type::eof();
  }
  // OpenVDB reads the position of the stream, and never goes back in it.
  pos_type seekoff(off_type offset, std::ios_base::seekdir direction,
                   std::ios_base::openmode) override {
    return offset == 0 && direction == std::ios_base::cur
               ? pos_type(static_cast<off_type>(position_))
               : pos_type(off_type(-1));
  }

 private:
  std::streamsize hand_on(const char* data, std::streamsize size) {
    std::string chunk(data, static_cast<std::size_t>(size));
    for (std::size_t i = 0; i < chunk.size() && position_ + i < kUuidOffset + kUuidSize; ++i)
      if (position_ + i >= kUuidOffset) chunk[i] = uuid_[position_ + i - kUuidOffset];
    hash_.update(chunk.data(), chunk.size());
    out_(chunk.data(), chunk.size());
    position_ += chunk.size();
    return size;
  }

  const ByteSink& out_;
  ContentHash& hash_;
  std::string uuid_;
  std::size_t position_ = 0;
  std::exception_ptr fault_;
};

// Takes strings, numbers and bytes from the front of a text; what is missing is an empty text.
class Front {
 public:
  explicit Front(std::string_view text) : text_(text) {}
  bool is_good() const { return good_; }
  std::string_view bytes(std::size_t count) {
    good_ = good_ && count <= text_.size();
    if (!good_) return {};
    const std::string_view taken = text_.substr(0, count);
    text_.remove_prefix(count);
    return taken;
  }
  template <class T>
  T number() {
    const std::string_view taken = bytes(sizeof(T));
    return taken.empty() ? T() : detail::load<T>(taken.data());
  }
  /// A length of 32 bits and as many bytes, as OpenVDB writes names and values.
  std::string_view sized() { return bytes(number<std::uint32_t>()); }

 private:
  std::string_view text_;
  bool good_ = true;
};

struct Metadata {
  std::string_view recipe, voxels;
};

// Ours among the entries of the file's metadata; nothing where the file ends within them.
std::optional<Metadata> find_metadata(std::string_view bytes) {
  Metadata found;
  Front front(bytes);
  front.bytes(sizeof kVdbMagic);
  if (front.number<std::uint32_t>() < kLeastFileVersion) return found;
  front.bytes(kUuidOffset - sizeof kVdbMagic - sizeof(std::uint32_t) + kUuidSize);
  const auto count = front.number<std::uint32_t>();
  for (std::uint32_t k = 0; k < count && front.is_good(); ++k) {
    const std::string_view name = front.sized(), type = front.sized(), value = front.sized();
    if (type != "string") continue;
    if (name == kRecipeMetadata) found.recipe = value;
    if (name == kVoxelsMetadata) found.voxels = value;
  }
  return front.is_good() ? std::optional(found) : std::nullopt;
}

std::uint64_t hash_of(std::string_view bytes) {
  ContentHash hash;
  hash.update(bytes.data(), bytes.size());
  return hash.digest();
}

std::string identifier_of(std::string_view encoded) {
  ContentHash hash;
  hash.update(encoded.data(), encoded.size());
  return hash.uuid();
}

std::string sealed_recipe(std::string_view encoded) {
  std::string bytes;
  detail::store(bytes, kVersion);
  detail::store(bytes, hash_of(encoded));
  bytes += encoded;
  return base64(bytes);
}

Error damaged(const std::string& name) {
  return {"vdb-damaged",
          name +
              " is damaged: its bytes do not match their checksum; simulate the earlier setup "
              "again"};
}

// The recipe's bytes out of what sealed_recipe() made.
std::string open_recipe(std::string_view text, const std::string& name) {
  const std::optional<std::string> bytes = from_base64(text);
  if (!bytes || bytes->size() < kRecipeHead) throw damaged(name);
  const auto version = detail::load<std::uint64_t>(bytes->data());
  if (version != kVersion)
    throw Error("vdb-version", fmt::format("{} has version {}, this mrsim reads version {}", name,
                                           version, kVersion));
  std::string encoded = bytes->substr(kRecipeHead);
  if (hash_of(encoded) != detail::load<std::uint64_t>(bytes->data() + sizeof kVersion))
    throw damaged(name);
  return encoded;
}

bool has_seal(std::string_view bytes) {
  return bytes.size() >= kSeal && bytes.substr(bytes.size() - kSeal, kMagic.size()) == kMagic;
}

}  // namespace

void write_vdb(const Stock& stock, const StockRecipe& recipe, const ByteSink& out) {
  const std::string encoded = encode_recipe(recipe);
  ContentHash hash;
  SinkBuffer buffer(out, hash, identifier_of(encoded));
  std::ostream stream(&buffer);
  stock.grid().voxels->write(*stock.grid().field, *stock.grid().index, sealed_recipe(encoded),
                             stream);
  buffer.rethrow();
  if (!stream) throw Error("output-unwritable", "cannot write the .vdb file");

  std::string seal(kMagic);
  detail::store(seal, hash.digest());
  out(seal.data(), seal.size());
}

VdbFile read_vdb(std::string_view bytes, const std::string& name) {
  if (bytes.size() < kUuidOffset + kUuidSize ||
      detail::load<std::int64_t>(bytes.data()) != kVdbMagic)
    throw Error("vdb-unreadable", name + " is not an OpenVDB file: it does not begin like one");
  if (has_seal(bytes)) {
    const auto wanted = detail::load<std::uint64_t>(bytes.data() + bytes.size() - 8);
    if (hash_of(bytes.substr(0, bytes.size() - kSeal)) != wanted) throw damaged(name);
  }
  VdbFile file;
  const std::optional<Metadata> metadata = find_metadata(bytes);
  if (!metadata) throw damaged(name);
  if (metadata->recipe.empty()) return file;
  const std::string encoded = open_recipe(metadata->recipe, name);
  file.rewritten = bytes.substr(kUuidOffset, kUuidSize) != identifier_of(encoded);
  if (!file.rewritten && !has_seal(bytes)) throw damaged(name);
  file.voxels = metadata->voxels;
  file.recipe = decode_recipe(encoded, name);
  return file;
}

}  // namespace mrsim
