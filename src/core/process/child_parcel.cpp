#include "core/process/child_process.h"
#include "core/process/heap.h"

#include <array>
#include <cstdint>
#include <cstring>
#include <optional>

namespace mrsim {
namespace {

// What goes through the pipe first; then the lengths of the texts, and all in the order of its
// counts. Where the work ended in an Error, its code and its sentence are the only texts.
struct Header {
  std::uint64_t is_error = 0, is_usage = 0;
  std::uint64_t numbers = 0, texts = 0, vertices = 0, triangles = 0;
};

template <class T>
void send_all(const std::vector<T>& column, const ByteSink& sink) {
  sink(column.data(), bytes_of(column));
}

void send(Header header, const ChildParcel& parcel, const ByteSink& sink) {
  header.numbers = parcel.numbers.size();
  header.texts = parcel.texts.size();
  header.vertices = parcel.mesh.vertices.size();
  header.triangles = parcel.mesh.triangles.size();
  sink(&header, sizeof header);
  std::vector<std::uint64_t> lengths;
  for (const std::string& text : parcel.texts) lengths.push_back(text.size());
  send_all(lengths, sink);
  for (const std::string& text : parcel.texts) sink(text.data(), text.size());
  send_all(parcel.numbers, sink);
  send_all(parcel.mesh.vertices, sink);
  send_all(parcel.mesh.triangles, sink);
}

// Takes from the front of what came.
class Reader {
 public:
  explicit Reader(const std::string& bytes) : bytes_(bytes) {}

  bool take(void* to, std::size_t size) {
    if (size > bytes_.size() - at_) return false;
    if (size > 0) std::memcpy(to, bytes_.data() + at_, size);
    at_ += size;
    return true;
  }
  template <class T>
  bool take_all(std::vector<T>& column, std::uint64_t count) {
    if (count > (bytes_.size() - at_) / sizeof(T)) return false;
    column.resize(count);
    return take(column.data(), bytes_of(column));
  }
  bool take_texts(std::vector<std::string>& texts, std::uint64_t count) {
    std::vector<std::uint64_t> lengths;
    if (!take_all(lengths, count)) return false;
    for (const std::uint64_t length : lengths) {
      if (length > bytes_.size() - at_) return false;
      texts.push_back(bytes_.substr(at_, length));
      at_ += length;
    }
    return true;
  }

 private:
  const std::string& bytes_;
  std::size_t at_ = 0;
};

// Empty where bytes are missing: the process died while it wrote.
std::optional<ChildParcel> receive(const std::string& bytes) {
  Reader reader(bytes);
  Header header;
  ChildParcel parcel;
  const bool whole = reader.take(&header, sizeof header) &&
                     reader.take_texts(parcel.texts, header.texts) &&
                     reader.take_all(parcel.numbers, header.numbers) &&
                     reader.take_all(parcel.mesh.vertices, header.vertices) &&
                     reader.take_all(parcel.mesh.triangles, header.triangles);
  if (!whole) return std::nullopt;
  if (header.is_error != 0)
    throw Error(parcel.texts.at(0), parcel.texts.at(1),
                header.is_usage != 0 ? Error::Kind::usage : Error::Kind::input);
  return parcel;
}

}  // namespace

ChildDelivery deliver_from_child(const ChildLimits& limits,
                                 const std::function<ChildParcel()>& work) {
  const ChildOutcome outcome = run_in_child(limits, [&](const ByteSink& sink) {
    Header header;
    ChildParcel parcel;
    try {
      parcel = work();
    } catch (const Error& error) {
      header.is_error = 1;
      header.is_usage = error.kind() == Error::Kind::usage ? 1 : 0;
      parcel = {{}, {error.code(), error.what()}, {}};
    }
    send(header, parcel, sink);
  });
  if (outcome.end != ChildOutcome::End::done) return {outcome.end, {}};
  std::optional<ChildParcel> parcel = receive(outcome.bytes);
  if (!parcel) return {ChildOutcome::End::crashed, {}};
  return {outcome.end, *std::move(parcel)};
}

}  // namespace mrsim
