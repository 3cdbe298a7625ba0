#include "core/text/zip.h"

#include "core/process/error.h"
#include "core/process/memory_limit.h"
#include "core/text/bytes.h"

#include <algorithm>

#include <fmt/format.h>
#include <zlib.h>

namespace mrsim::detail {
namespace {

constexpr std::uint32_t kLocalMark = 0x04034b50, kCentralMark = 0x02014b50, kEndMark = 0x06054b50,
                        kDataMark = 0x08074b50;
constexpr std::size_t kLocalSize = 30, kCentralSize = 46, kEndSize = 22;
constexpr std::size_t kStored = 0, kDeflated = 8;
constexpr std::size_t kLargest = 0xfffffff0;

[[noreturn]] void fail(const std::string& name, const char* what) {
  throw Error("3mf-zip", fmt::format("{}: {}; copy or export it again", name, what));
}

std::size_t end_record(std::string_view bytes, const std::string& name) {
  if (bytes.size() < kEndSize) fail(name, "it is too short for a 3MF file");
  // A comment of up to 65535 bytes may follow.
  const std::size_t last = bytes.size() - kEndSize;
  for (std::size_t i = 0; i <= std::min<std::size_t>(last, 65535); ++i)
    if (load<std::uint32_t>(bytes.data() + last - i) == kEndMark) return last - i;
  fail(name, "it is cut short, or not a 3MF file (no ZIP directory)");
}

std::string inflated(std::string_view packed, std::size_t size, const std::string& name) {
  std::string out(size, '\0');
  z_stream stream{};
  if (inflateInit2(&stream, -MAX_WBITS) != Z_OK) fail(name, "it cannot be unpacked");
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
  stream.avail_in = uInt(packed.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = uInt(size);
  const int result = inflate(&stream, Z_FINISH);
  const bool complete = result == Z_STREAM_END && stream.total_out == size;
  inflateEnd(&stream);
  if (!complete) fail(name, "its compressed content is damaged");
  return out;
}

// Compresses the bytes that it is given and hands them on in chunks.
class Deflater {
 public:
  explicit Deflater(const ByteSink& out) : out_(out), packed_(kChunk, '\0') {
    constexpr int kLevel = 6, kMemory = 8;
    const int ready =
        deflateInit2(&stream_, kLevel, Z_DEFLATED, -MAX_WBITS, kMemory, Z_DEFAULT_STRATEGY);
    MRSIM_ASSERT(ready == Z_OK);
  }
  Deflater(const Deflater&) = delete;
  Deflater& operator=(const Deflater&) = delete;
  ~Deflater() { deflateEnd(&stream_); }

  void add(const void* data, std::size_t size) {
    const auto* bytes = static_cast<const Bytef*>(data);
    crc_ = crc32_z(crc_, bytes, size);
    plain_ += size;
    for (std::size_t done = 0; done < size; done += kChunk) {
      stream_.next_in = const_cast<Bytef*>(bytes + done);
      stream_.avail_in = uInt(std::min(size - done, kChunk));
      while (stream_.avail_in > 0) run(Z_NO_FLUSH);
    }
  }
  void finish() {
    while (run(Z_FINISH) != Z_STREAM_END) {
    }
  }
  std::uint32_t crc() const { return std::uint32_t(crc_); }
  std::size_t plain_size() const { return plain_; }
  std::size_t packed_size() const { return packed_size_; }

 private:
  static constexpr std::size_t kChunk = std::size_t(1) << 18;

  int run(int flush) {
    stream_.next_out = reinterpret_cast<Bytef*>(packed_.data());
    stream_.avail_out = uInt(packed_.size());
    const int result = deflate(&stream_, flush);
    MRSIM_ASSERT(result == Z_OK || result == Z_STREAM_END);
    const std::size_t made = packed_.size() - stream_.avail_out;
    if (made > 0) out_(packed_.data(), made);
    packed_size_ += made;
    return result;
  }

  const ByteSink& out_;
  std::string packed_;
  z_stream stream_{};
  uLong crc_ = 0;
  std::size_t plain_ = 0, packed_size_ = 0;
};

std::uint32_t crc_of(std::string_view bytes) {
  return std::uint32_t(crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

// The part that local and central headers share; the local one leaves crc and sizes to the record
// after the content (bit 3 of the flags).
void append_common(std::string& out, const std::string& name, std::uint32_t crc = 0,
                   std::size_t packed = 0, std::size_t plain = 0) {
  store(out, std::uint16_t(20));  // version needed
  store(out, std::uint16_t(8));
  store(out, std::uint16_t(kDeflated));
  store(out, std::uint16_t(0));     // 00:00:00
  store(out, std::uint16_t(0x21));  // 1980-01-01
  store(out, crc);
  store(out, std::uint32_t(packed));
  store(out, std::uint32_t(plain));
  store(out, std::uint16_t(name.size()));
  store(out, std::uint16_t(0));
}

}  // namespace

std::vector<ZipEntry> zip_directory(std::string_view bytes, const std::string& name) {
  const std::size_t end = end_record(bytes, name);
  const std::size_t count = load<std::uint16_t>(bytes.data() + end + 10);
  std::size_t at = load<std::uint32_t>(bytes.data() + end + 16);
  if (count == 0xffff || at == 0xffffffff) fail(name, "archives of the ZIP64 kind are not read");
  std::vector<ZipEntry> entries;
  for (std::size_t i = 0; i < count; ++i) {
    if (at > end || end - at < kCentralSize ||
        load<std::uint32_t>(bytes.data() + at) != kCentralMark)
      fail(name, "its ZIP directory is damaged");
    const char* p = bytes.data() + at;
    const std::size_t name_size = load<std::uint16_t>(p + 28);
    const std::size_t rest = std::size_t(load<std::uint16_t>(p + 30)) + load<std::uint16_t>(p + 32);
    if (end - at - kCentralSize < name_size + rest) fail(name, "its ZIP directory is damaged");
    ZipEntry entry;
    entry.name.assign(p + kCentralSize, name_size);
    entry.method = load<std::uint16_t>(p + 10);
    entry.crc = load<std::uint32_t>(p + 16);
    entry.packed_size = load<std::uint32_t>(p + 20);
    entry.size = load<std::uint32_t>(p + 24);
    entry.offset = load<std::uint32_t>(p + 42);
    if (load<std::uint16_t>(p + 8) & 1) fail(name, "it is encrypted");
    entries.push_back(std::move(entry));
    at += kCentralSize + name_size + rest;
  }
  return entries;
}

std::string unzip(std::string_view bytes, const ZipEntry& entry, std::size_t limit,
                  const std::string& name) {
  // Deflate packs at most 1032 to 1: a larger claim is no file, and is not given memory.
  if (entry.size > limit || entry.size / 1032 > entry.packed_size)
    throw Error("3mf-too-large",
                fmt::format("{}: \"{}\" claims to unpack to {} bytes; {} are the limit", name,
                            entry.name.substr(0, 80), entry.size, limit));
  if (entry.offset > bytes.size() || bytes.size() - entry.offset < kLocalSize ||
      load<std::uint32_t>(bytes.data() + entry.offset) != kLocalMark)
    fail(name, "its ZIP directory points nowhere");
  const char* p = bytes.data() + entry.offset;
  const std::size_t begin =
      entry.offset + kLocalSize + load<std::uint16_t>(p + 26) + load<std::uint16_t>(p + 28);
  if (begin > bytes.size() || bytes.size() - begin < entry.packed_size)
    fail(name, "it is cut short");
  const std::string_view packed = bytes.substr(begin, entry.packed_size);
  require_memory(static_cast<double>(entry.size), "unpacking " + name);
  std::string out;
  if (entry.method == kDeflated)
    out = inflated(packed, entry.size, name);
  else if (entry.method == kStored && entry.size == entry.packed_size)
    out = packed;
  else
    fail(name, "it is packed in a way that is not read");
  if (crc_of(out) != entry.crc) fail(name, "its content does not match its check sum");
  return out;
}

void ZipWriter::put(const std::string& bytes) {
  out_(bytes.data(), bytes.size());
  position_ += bytes.size();
}

void ZipWriter::add(const std::string& name, const std::function<void(const ByteSink&)>& writer) {
  const std::size_t offset = position_;
  std::string head;
  store(head, kLocalMark);
  append_common(head, name);
  put(head + name);
  Deflater deflater(out_);
  const ByteSink in = [&](const void* data, std::size_t size) {
    deflater.add(data, size);
    if (deflater.plain_size() > kLargest || offset + deflater.packed_size() > kLargest)
      throw Error("3mf-too-large", "the mesh is too large for a 3MF file; write .ply or .stl");
  };
  writer(in);
  deflater.finish();
  position_ += deflater.packed_size();
  std::string tail;
  store(tail, kDataMark);
  store(tail, deflater.crc());
  store(tail, std::uint32_t(deflater.packed_size()));
  store(tail, std::uint32_t(deflater.plain_size()));
  put(tail);
  store(directory_, kCentralMark);
  store(directory_, std::uint16_t(20));  // version made by
  append_common(directory_, name, deflater.crc(), deflater.packed_size(), deflater.plain_size());
  for (int i = 0; i < 3; ++i) store(directory_, std::uint16_t(0));  // comment, disk, attributes
  store(directory_, std::uint32_t(0));
  store(directory_, std::uint32_t(offset));
  directory_ += name;
  ++files_;
}

void ZipWriter::finish() {
  const std::size_t start = position_;
  std::string end = directory_;
  store(end, kEndMark);
  store(end, std::uint32_t(0));  // disks
  store(end, std::uint16_t(files_));
  store(end, std::uint16_t(files_));
  store(end, std::uint32_t(directory_.size()));
  store(end, std::uint32_t(start));
  store(end, std::uint16_t(0));
  put(end);
}

std::string deflated(std::string_view bytes) {
  std::string out;
  const ByteSink sink = [&](const void* data, std::size_t size) {
    out.append(static_cast<const char*>(data), size);
  };
  Deflater packed(sink);
  packed.add(bytes.data(), bytes.size());
  packed.finish();
  return out;
}

std::string zip(const std::vector<std::pair<std::string, std::string>>& files) {
  std::string bytes;
  const ByteSink out = [&](const void* data, std::size_t size) {
    bytes.append(static_cast<const char*>(data), size);
  };
  ZipWriter writer(out);
  for (const auto& [name, content] : files) writer.add(name, content);
  writer.finish();
  return bytes;
}

}  // namespace mrsim::detail
