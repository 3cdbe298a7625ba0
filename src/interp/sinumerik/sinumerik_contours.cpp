#include "interp/sinumerik/sinumerik_contours.h"

#include "core/text/text_io.h"
#include "interp/sinumerik/contour_milling.h"
#include "interp/sinumerik/contour_pocket.h"
#include "interp/sinumerik/contour_turning.h"
#include "interp/text/characters.h"

#include <utility>

#include <fmt/format.h>

namespace mrsim {

bool SinumerikContours::knows(std::string_view name) {
  return name == "CYCLE62" || name == "CYCLE63" || name == "CYCLE72" || name == "CYCLE95" ||
         name == "CYCLE952";
}

bool SinumerikContours::run(const CycleCall& call, const Word& where) {
  call_ = call;
  where_ = where;
  if (call.name == "CYCLE62") return name_contour();
  if (modal_.comp != Code::comp_off)
    return error("cycle-compensation", "a cycle under radius compensation: G40 before it", where);
  if (!goes_on(where)) return false;
  waits_ = find_contours();
  return waits_;
}

// CYCLE62(NAME, kind, two labels) names a contour. Calls in a row add contours to a list; the first
// call after a cycle has used the list starts a new one.
bool SinumerikContours::name_contour() {
  if (named_used_) named_.clear();
  named_used_ = false;
  const std::string labels = call_.text("LAB1") + ":" + call_.text("LAB2");
  const std::string name = call_.text("LAB1").empty() ? call_.text("NAME") : labels;
  if (name.empty()) return error("value-missing", "CYCLE62 needs the name of a contour", where_);
  named_.push_back(name);
  return true;
}

bool SinumerikContours::find_contours() {
  const bool own_name = call_.name == "CYCLE72" || call_.name == "CYCLE95";
  std::vector<std::string> names = named_;
  const std::string own =
      call_.text(call_.name == "CYCLE72" ? ValueName("KNAME") : ValueName("NPP"));
  if (own_name && !own.empty()) names = {own};
  if (own_name && names.size() > 1) names = {names.back()};
  if (names.empty()) names = {""};
  named_used_ = true;
  requests_.clear();
  contours_.clear();
  for (const std::string& name : names)
    if (!find_contour(name, requests_.emplace_back())) return false;
  return true;
}

// Finds a contour: a subprogram, the labels "FIRST:LAST" of this program, or those of the contour
// editor.
bool SinumerikContours::find_contour(const std::string& name, CallRequest& request) {
  const std::size_t colon = name.find(':');
  const bool labels = colon != std::string::npos;
  std::string first = upper_case(name.substr(0, colon)), last;
  if (labels) last = upper_case(name.substr(colon + 1));
  SubprogramName program;
  program.text = first;
  Place end;
  request.file = reader_.file();
  if (!labels && !name.empty() && reader_.has_subprogram(program)) {
    request = call_of(*reader_.locate(program, where_));
    return true;
  }
  if (!labels) {
    last = "E_LAB_E_" + first;
    first.insert(0, "E_LAB_A_");
  }
  if (name.empty() || !statements_ ||
      !statements_->places().find_labels(first, last, request.begin, end))
    return error(
        "subprogram-missing",
        fmt::format("the contour \"{}\" is neither a subprogram nor between labels of this "
                    "program",
                    to_utf8(name.substr(0, 60))),
        where_);
  request.end = end.offset;
  return true;
}

void SinumerikContours::end_block() {
  if (!waits_) return;
  waits_ = false;
  contour_.keep_state(call_.place);
  enter_contour();
}

void SinumerikContours::enter_contour() {
  CallRequest request = requests_[contours_.size()];
  request.on_start = [this] { begin_contour(); };
  request.on_end = [this] { end_contour(); };
  request.on_left = [this] {
    if (contours_.size() < requests_.size() && !contours_.empty()) enter_contour();
  };
  const Word where = where_;
  reader_.enter(std::move(request), where);
}

void SinumerikContours::end_program() { contour_.end_program(where_); }

void SinumerikContours::begin_contour() {
  contour_.begin();
  if (modal_.feed == 0) modal_.feed = 1;  // the cycle has its own feeds
}

void SinumerikContours::end_contour() {
  const bool faultless = contour_.end();
  const Code comp = std::exchange(modal_.comp, Code::comp_off);
  if (!faultless) {
    contours_.clear();
    requests_.clear();
    return;
  }
  if (!contour_.has_usual_size(where_)) {
    requests_.clear();
  } else {
    contours_.push_back(contour_.motions());
    if (contours_.size() == requests_.size()) finish_contours();
  }
  modal_.comp = comp;
}

void SinumerikContours::finish_contours() {
  const ContourCall call{call_, where_, contours_};
  if (call_.name == "CYCLE63")
    ContourPocket(control_, tools_, moves_, call).run();
  else if (call_.name == "CYCLE72")
    ContourMilling(control_, tools_, moves_, call).run();
  else
    ContourTurning(control_, tools_, moves_, call).run();
}

}  // namespace mrsim
