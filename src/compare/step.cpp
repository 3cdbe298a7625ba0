// STEP files through the module that reads them, opened when the first one is read.
#include "compare/step/module.h"
#include "core/process/child_process.h"
#include "core/process/error.h"
#include "core/process/memory_limit.h"
#include "core/process/module.h"
#include "core/text/text_io.h"
#include "mesh/solid/check.h"
#include "mesh/solid/weld.h"
#include <mrsim/solid_files.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include <fmt/format.h>

namespace mrsim {
namespace {

#ifdef MRSIM_HAS_STEP

constexpr double kTriangleMemory = 360;  // bytes, measured: welding and checking the mesh

struct StepModule {
  Module module{{"step", "step-module", "reads STEP files",
                 "install mrsim with all its files and Open CASCADE's libraries, build it again "
                 "where they have changed, or export the model as STL or 3MF"}};
  ReadStepFacets* read = module.function<ReadStepFacets>(kReadStepFacets);
  FreeStepFacets* free = module.function<FreeStepFacets>(kFreeStepFacets);
};

constexpr double kFarthest = 1e10;  // 10 km, were the unit a micrometre

// Whether the number at the front of `text` is farther than that; of what is no number, no.
bool is_far(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(" \r\n\t+"), text.size()));
  double value = 0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (fault != std::errc::result_out_of_range) return std::abs(value) > kFarthest;
  return std::string_view(text.data(), end).find("E-") == text.npos;
}

struct EntityNames {
  std::vector<std::uint64_t> held, used;
  std::optional<std::string>
      none;  ///< the first that no entity can have: #-1, #99999999999999999999
};

// The number behind a # and where it ends; nothing for what is no whole number of 64 bits.
std::optional<std::uint64_t> entity_number(std::string_view text, std::size_t& at) {
  std::uint64_t number = 0;
  const auto [end, fault] = std::from_chars(text.data() + at, text.data() + text.size(), number);
  const auto next = static_cast<std::size_t>(end - text.data());
  const char c = next < text.size() ? text[next] : ' ';
  const bool goes_on = c == '.' || c == '-' || c == '_' || (c >= 'A' && c <= 'z');
  if (fault != std::errc() || goes_on) return std::nullopt;
  at = next;
  return number;
}

// What stands behind a # that is no number, as far as it can be shown.
std::string entity_text(std::string_view text, std::size_t at) {
  constexpr std::string_view kShown =
      "0123456789+-._ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz";
  const std::size_t end = std::min(text.find_first_not_of(kShown, at), text.size());
  return std::string(text.substr(at, std::min<std::size_t>(end - at, 30)));
}

// #12 where it stands before = is held, else used. Texts, comments and addresses (<file.stp#12>)
// hold none.
EntityNames entity_names(std::string_view text) {
  EntityNames names;
  const auto skip_past = [&](std::size_t at, std::string_view end) {
    const std::size_t found = text.find(end, at);
    return found == text.npos ? text.size() : found + end.size();
  };
  for (std::size_t at = text.find_first_of("'#</"); at < text.size();
       at = text.find_first_of("'#</", at)) {
    const char c = text[at++];
    if (c == '\'') at = skip_past(at, "'");
    if (c == '<') at = skip_past(at, ">");
    if (c == '/' && at < text.size() && text[at] == '*') at = skip_past(at + 1, "*/");
    if (c != '#') continue;
    const auto number = entity_number(text, at);
    if (!number && !names.none) names.none = entity_text(text, at);
    if (!number) continue;
    const std::size_t next = text.find_first_not_of(" \t\r\n", at);
    const bool is_held = next != text.npos && text[next] == '=';
    (is_held ? names.held : names.used).push_back(*number);
  }
  return names;
}

// Throws Error "step-too-far" for a point at infinity, which a damaged exponent gives: it keeps
// Open CASCADE busy for minutes. `path` names the file.
void require_near(std::string_view text, const std::string& path) {
  for (std::size_t at = 0; (at = text.find("CARTESIAN_POINT", at)) != text.npos;) {
    const std::size_t end = std::min(text.find(';', at), text.size());
    for (at = text.find('(', at); at < end; at = text.find_first_of("(,", at + 1))
      if (is_far(text.substr(at + 1, end - at)))
        throw Error("step-too-far", path + " has a point farther than 10 km from the origin");
    at = end;
  }
}

// Throws Error "step-unreadable" where an entity names one that the file does not hold: Open
// CASCADE puts any other in its place.
void require_references(std::string_view text, const std::string& path) {
  EntityNames names = entity_names(text);
  std::sort(names.held.begin(), names.held.end());
  const auto missing =
      std::find_if(names.used.begin(), names.used.end(), [&](std::uint64_t number) {
        return !std::binary_search(names.held.begin(), names.held.end(), number);
      });
  if (missing != names.used.end()) names.none = std::to_string(*missing);
  if (names.none)
    throw Error("step-unreadable",
                fmt::format("{} is damaged: it refers to #{}, which it does not hold; export it "
                            "again",
                            path, *names.none));
}

TriMesh weld_facets(const StepFacets& facets) {
  Welder welder;
  std::vector<std::uint32_t> index(facets.point_count);
  for (std::size_t i = 0; i < facets.point_count; ++i) {
    const float* p = facets.points + 3 * i;
    index[i] = welder.add({p[0], p[1], p[2]});
  }
  TriMesh mesh;
  for (std::size_t i = 0; i < facets.triangle_count; ++i) {
    const std::uint32_t* corners = facets.triangles + 3 * i;
    const std::array<std::uint32_t, 3> t{index[corners[0]], index[corners[1]], index[corners[2]]};
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) mesh.triangles.push_back(t);
  }
  mesh.vertices = welder.take();
  return mesh;
}

// Finds faults for which Open CASCADE has poor messages, or on which it runs without end. The
// module reads the file again afterwards, so a pipe is refused. Returns the size of the file,
// bytes.
std::size_t checked_step_size(const std::string& path) {
  std::error_code ignored;
  const auto status = std::filesystem::status(path, ignored);
  if (std::filesystem::is_fifo(status) || std::filesystem::is_character_file(status))
    throw Error("step-unreadable", path + " is a pipe or a device: store the model in a file");
  const std::string text = read_file(path);
  const std::string head = text.substr(0, 4096);
  if (head.find("ISO-10303-21") == std::string::npos)
    throw Error("step-unreadable", path + " is not a STEP file: it has no ISO-10303-21 header");
  require_near(text, path);
  require_references(text, path);
  return text.size();
}

// What goes through the pipe before the texts, points and triangles.
struct FacetHeader {
  std::uint64_t code = 0, text = 0, points = 0, triangles = 0;
  double deviation = 0;
};

void send_facets(const StepFacets& facets, const ByteSink& sink) {
  const std::string code = facets.code ? facets.code : "", text = facets.text ? facets.text : "";
  const FacetHeader header{code.size(), text.size(), facets.point_count, facets.triangle_count,
                           facets.deviation};
  sink(&header, sizeof header);
  sink(code.data(), code.size());
  sink(text.data(), text.size());
  sink(facets.points, facets.point_count * 3 * sizeof(float));
  sink(facets.triangles, facets.triangle_count * 3 * sizeof(std::uint32_t));
}

struct StepMesh {
  TriMesh mesh;
  double deviation = 0;  // mm, found
  std::string left_out;
};

// Empty where the bytes are not what their header says: a process that died while it wrote.
std::optional<StepMesh> receive_facets(const std::string& bytes, const std::string& path) {
  FacetHeader header;
  if (bytes.size() < sizeof header) return std::nullopt;
  std::memcpy(&header, bytes.data(), sizeof header);
  const std::size_t point_bytes = header.points * 3 * sizeof(float);
  const std::size_t index_bytes = header.triangles * 3 * sizeof(std::uint32_t);
  if (bytes.size() != sizeof header + header.code + header.text + point_bytes + index_bytes)
    return std::nullopt;
  const char* at = bytes.data() + sizeof header;
  const std::string code(at, header.code), text(at + header.code, header.text);
  if (!code.empty()) throw Error(code, path + text);
  at += header.code + header.text;
  std::vector<float> points(header.points * 3);
  std::vector<std::uint32_t> triangles(header.triangles * 3);
  if (point_bytes > 0) std::memcpy(points.data(), at, point_bytes);
  if (index_bytes > 0) std::memcpy(triangles.data(), at + point_bytes, index_bytes);
  require_memory(kTriangleMemory * double(header.triangles), "reading " + path,
                 "a larger --deflection takes less");
  StepFacets facets;
  facets.points = points.data();
  facets.point_count = header.points;
  facets.triangles = triangles.data();
  facets.triangle_count = header.triangles;
  return StepMesh{weld_facets(facets), header.deviation, text};
}

constexpr std::size_t kSpare = std::size_t(32) << 20;  // what a small file needs at a time

// Open CASCADE crashes on some damaged files, or never ends: it reads in a process of its own.
StepMesh read_solids(const std::string& path, double deflection) {
  const std::size_t size = checked_step_size(path);
  static const StepModule module;
  ChildLimits limits;
  limits.what = "reading " + path;
  limits.seconds = 120 + static_cast<int>(std::min<std::size_t>(size >> 20, 1000)) * 30;
  limits.bytes = (std::size_t(2) << 30) + 400 * size;
  const ChildOutcome outcome = run_in_child(limits, [&](const ByteSink& sink) {
    const StepFacets* facets = module.read(path.c_str(), deflection);
    // Open CASCADE takes a shortage for a fault of the file.
    if (facets == nullptr || (facets->code && !has_address_space(kSpare))) throw std::bad_alloc();
    send_facets(*facets, sink);
    module.free(facets);
  });
  using End = ChildOutcome::End;
  if (outcome.end == End::done)
    if (std::optional<StepMesh> step = receive_facets(outcome.bytes, path)) return *std::move(step);
  throw Error("step-unreadable",
              path +
                  (outcome.end == End::too_long ? ": Open CASCADE takes too long to read it"
                   : outcome.end == End::out_of_memory
                       ? ": Open CASCADE takes too much memory to read it"
                       : ": the file is damaged: Open CASCADE crashed while it read it") +
                  "; export it again, or as STL or 3MF");
}

#else

StepMesh read_solids(const std::string& path, double) {
  throw Error("step-unsupported",
              path +
                  ": this mrsim was built without Open CASCADE (MRSIM_STEP) and reads no STEP; "
                  "export the model as STL or 3MF");
}

#endif

constexpr double kFinest = 1e-6;  // mm; Open CASCADE takes points within 1e-7 mm for one

}  // namespace

TriMesh read_step(const std::string& path, double deflection, std::string* note) {
  if (!(deflection > 0) || !std::isfinite(deflection))
    throw Error("deflection-invalid", "the deflection of a STEP file is a length above 0 mm",
                Error::Kind::usage);
  if (deflection < kFinest)
    throw Error(
        "deflection-invalid",
        fmt::format("a deflection of {} mm is too small: {} mm or more", deflection, kFinest),
        Error::Kind::usage);
  StepMesh step = read_solids(path, deflection);
  const MeshSummary summary = check_mesh(step.mesh);
  if (!summary.closed || !summary.oriented)
    throw Error("step-open", path + ": the solids' faces do not join: " + summary.first_fault +
                                 "; solids that touch are to be united in CAD");
  if (note != nullptr)
    *note = fmt::format(
        "{}: {} triangles within {:.4g} mm of the exact faces{}{}{}", path,
        step.mesh.triangles.size(), std::max(deflection, step.deviation),
        step.deviation > deflection ? fmt::format(", {:.4g} mm were asked for", deflection) : "",
        step.left_out.empty() ? "" : "; ", step.left_out);
  return std::move(step.mesh);
}

}  // namespace mrsim
