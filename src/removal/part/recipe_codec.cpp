#include "removal/part/recipe_codec.h"

#include "core/process/error.h"
#include "core/process/memory_limit.h"
#include "core/text/bytes.h"

#include <array>
#include <cmath>

namespace mrsim {
namespace {

// One description of the layout serves both directions: Archive is Writer or Reader, `field`
// appends or reads.
class Writer {
 public:
  template <class T>
  void number(const T& value) {
    detail::store(bytes, value);
  }
  template <class E>
  void choice(const E& value, int) {
    number(static_cast<std::uint8_t>(value));
  }
  std::uint64_t count(std::size_t n, std::size_t) {
    number(static_cast<std::uint64_t>(n));
    return n;
  }
  void text(const std::string& value) {
    count(value.size(), 1);
    bytes += value;
  }
  std::string bytes;
};

class Reader {
 public:
  Reader(std::string_view rest, const std::string& name) : rest_(rest), name_(name) {}

  template <class T>
  void number(T& value) {
    value = detail::load<T>(take(sizeof(T)).data());
    if constexpr (std::is_floating_point_v<T>)
      if (!std::isfinite(value)) fail();
  }
  template <class E>
  void choice(E& value, int values) {
    std::uint8_t raw = 0;
    number(raw);
    if (raw >= values) fail();
    value = static_cast<E>(raw);
  }
  // The number of entries of at least `least_size` bytes each.
  std::uint64_t count(std::size_t, std::size_t least_size) {
    std::uint64_t n = 0;
    number(n);
    if (n > rest_.size() / least_size) fail();
    return n;
  }
  void text(std::string& value) { value = std::string(take(count(0, 1))); }
  void finish() const {
    if (!rest_.empty()) fail();
  }
  [[noreturn]] void fail() const {
    throw Error(
        "vdb-damaged",
        name_ + " is damaged: its recipe can not be read; simulate the earlier setup again");
  }

 private:
  std::string_view take(std::size_t size) {
    if (size > rest_.size()) fail();
    const std::string_view head = rest_.substr(0, size);
    rest_.remove_prefix(size);
    return head;
  }
  std::string_view rest_;
  const std::string& name_;
};

template <class Archive, class T>
void fields(Archive& a, T& v);

template <class Archive, class List>
void list(Archive& a, List& v, std::size_t least_size) {
  const std::uint64_t n = a.count(v.size(), least_size);
  if constexpr (!std::is_const_v<List>) {
    constexpr std::uint64_t kFew = 10000;
    if (n > kFew)
      require_memory(double(n) * sizeof(typename List::value_type), "what a .vdb was cut by");
    v.resize(n);
  }
  for (auto& entry : v) fields(a, entry);
}

template <class Archive, class V>
void vec3(Archive& a, V& v) {
  a.number(v.x);
  a.number(v.y);
  a.number(v.z);
}

template <class Archive, class M>
void motion(Archive& a, M& m) {
  a.choice(m.kind, 3);
  a.choice(m.feed_unit, 3);
  a.choice(m.constant_surface_speed, 2);
  a.choice(m.assumed_start, 2);
  for (auto* v : {&m.start, &m.end, &m.center, &m.axis, &m.tool_axis}) vec3(a, *v);
  for (auto* x : {&m.radius, &m.sweep, &m.rise, &m.feed, &m.speed, &m.lead}) a.number(*x);
  for (auto* x : {&m.tool, &m.file, &m.line, &m.column}) a.number(*x);
}

template <class Archive, class T>
void tool(Archive& a, T& t) {
  a.text(t.id);
  a.choice(t.type, static_cast<int>(ToolType::threading) + 1);
  for (auto* x : {&t.diameter, &t.corner_radius, &t.taper_angle, &t.tip_angle, &t.tip_diameter,
                  &t.neck_diameter, &t.profile_radius, &t.flute_length, &t.insert_angle,
                  &t.nose_radius, &t.lead_angle, &t.edge_length, &t.width})
    a.number(*x);
  list(a, t.profile, 24);
  list(a, t.shank, 24);
  list(a, t.holder, 24);
  a.text(t.insert);
  a.choice(t.left_hand, 2);
  a.number(t.tip);
  a.choice(t.tip_is_nose_centre, 2);
  a.text(t.origin);
}

template <class Archive, class S>
void shape(Archive& a, S& s) {
  a.choice(s.kind, 4);
  vec3(a, s.box.lo);
  vec3(a, s.box.hi);
  a.number(s.outer_radius);
  a.number(s.inner_radius);
  vec3(a, s.axis_point);
  list(a, s.mesh.vertices, 12);
  list(a, s.mesh.triangles, 12);
  a.text(s.description);
  list(a, s.history.files, 8);
  list(a, s.history.tools, 8);
  list(a, s.history.motions, 8);
}

template <class Archive, class T>
void fields(Archive& a, T& v) {
  using Plain = std::remove_const_t<T>;
  if constexpr (std::is_same_v<Plain, std::string>) {
    a.text(v);
  } else if constexpr (std::is_same_v<Plain, Motion>) {
    motion(a, v);
  } else if constexpr (std::is_same_v<Plain, Tool>) {
    tool(a, v);
  } else if constexpr (std::is_same_v<Plain, ProfilePoint>) {
    for (auto* x : {&v.r, &v.z, &v.bulge}) a.number(*x);
  } else if constexpr (std::is_same_v<Plain, ToolSegment>) {
    for (auto* x : {&v.diameter_low, &v.diameter_high, &v.length}) a.number(*x);
  } else {
    for (auto& x : v) a.number(x);  // a vertex or a triangle
  }
}

void check_indices(const StockShape& s, const Reader& reader) {
  for (const auto& triangle : s.mesh.triangles)
    for (const std::uint32_t corner : triangle)
      if (corner >= s.mesh.vertices.size()) reader.fail();
  for (const Motion& m : s.history.motions)
    if (m.tool < -1 || m.tool >= static_cast<int>(s.history.tools.size()) || m.file < 0 ||
        m.file >= static_cast<int>(s.history.files.size()))
      reader.fail();
}

}  // namespace

std::string encode_recipe(const StockRecipe& recipe) {
  Writer writer;
  writer.number(recipe.voxel);
  shape(writer, recipe.shape);
  return std::move(writer.bytes);
}

StockRecipe decode_recipe(std::string_view bytes, const std::string& name) {
  Reader reader(bytes, name);
  StockRecipe recipe;
  reader.number(recipe.voxel);
  shape(reader, recipe.shape);
  reader.finish();
  check_indices(recipe.shape, reader);
  if (!(recipe.voxel > 0)) reader.fail();
  return recipe;
}

}  // namespace mrsim
