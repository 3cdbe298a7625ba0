// Whole programs by the public functions interpret() and trace().

#include "core/process/heap.h"
#include "core/process/memory_limit.h"
#include "core/text/json_text.h"
#include "core/text/text_io.h"
#include "interp/interpreter.h"
#include "interp/show/motion_text.h"
#include <mrsim/memory.h>
#include <mrsim/mrsim.h>

#include <filesystem>
#include <system_error>

#include <fmt/format.h>

namespace mrsim {
namespace {

class Collector : public MotionSink {
 public:
  // Room for a program of short lines: growing would copy all motions, and touch new pages for
  // them, again and again.
  explicit Collector(const std::string& path) {
    constexpr std::uintmax_t kLineBytes = 24;
    std::error_code failed;
    const std::uintmax_t bytes = std::filesystem::file_size(path, failed);
    const double most = memory_left() / 4 / sizeof(Motion);
    if (!failed && double(bytes) / kLineBytes <= most) reserve_large(motions, bytes / kLineBytes);
  }
  void motion(const Motion& motion) override {
    if (motions.size() == motions.capacity() && motions.size() > kFew) grow(motions, "motions");
    motions.push_back(motion);
  }
  void event(const Event& event) override {
    if (events.size() == events.capacity() && events.size() > kFew) grow(events, "events");
    if (!events.empty() && events.back().before == motions.size() && joins(event, events.back()))
      return;
    events.push_back(event);
    events.back().before = motions.size();
  }
  void diagnostic(const Diagnostic& diagnostic) override { diagnostics.push_back(diagnostic); }
  std::vector<Motion> motions;
  std::vector<Event> events;
  std::vector<Diagnostic> diagnostics;

 private:
  static constexpr std::size_t kFew = 10000;  // motions that may be kept without asking for memory

  // The old memory of a list is given back to the system at once. Otherwise a program that never
  // ends would take twice the memory that its motions need.
  template <class T>
  static void grow(std::vector<T>& list, const char* name) {
    require_memory(2.0 * double(list.size()) * sizeof(T),
                   fmt::format("a program of more than {} {}", list.size(), name));
    list.reserve(2 * list.size());
    release_freed_memory();
  }
};

class TraceSinkAdapter : public MotionSink {
 public:
  TraceSinkAdapter(const TraceSink& sink, bool json) : sink_(sink), json_(json) {}
  void begin(const Program& program) override { program_ = &program; }
  void motion(const Motion& motion) override {
    if (sink_.motion) sink_.motion(motion);
    if (sink_.line)
      sink_.line(json_ ? motion_json(*program_, motion) : motion_text(*program_, motion));
  }
  void event(const Event& event) override {
    if (sink_.line) sink_.line(json_ ? event_json(*program_, event) : event_text(*program_, event));
  }
  void diagnostic(const Diagnostic& diagnostic) override {
    if (sink_.diagnostic) sink_.diagnostic(diagnostic);
  }
  void assignment(const SourcePlace& place, const std::string& name,
                  const std::string& value) override {
    if (!sink_.line) return;
    sink_.line(json_ ? fmt::format(R"({{"line":{},"kind":"variable","name":{},"value":{}}})",
                                   place.line, json_string(name), json_string(value))
                     : fmt::format("{:5}     {} = {}", place.line, name, value));
  }

 private:
  const TraceSink& sink_;
  bool json_;
  const Program* program_ = nullptr;
};

}  // namespace

Program interpret(const std::string& path, const InterpOptions& options) {
  Collector collector(path);
  Program program = interpret(path, options, collector);
  program.motions = std::move(collector.motions);
  program.events = std::move(collector.events);
  program.diagnostics = std::move(collector.diagnostics);
  return program;
}

Program trace(const std::string& path, const InterpOptions& options, bool json,
              const TraceSink& sink) {
  TraceSinkAdapter adapter(sink, json);
  return interpret(path, options, adapter);
}

}  // namespace mrsim
