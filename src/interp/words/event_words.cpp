#include "interp/words/event_words.h"

#include <utility>

namespace mrsim {

void EventWords::before_motion() {
  late_.clear();
  stops_once_ = block_.path_mode == PathMode::exact_once;
  if (block_.path_mode && !stops_once_) path_mode(*block_.path_mode);
  out_.change_tool();
  read_words();
  const bool other = speed() != told_speed_ || modal_.surface_speed != told_surface_;
  if (turn_ != SpindleTurn::off && other) spindle(turn_);
}

void EventWords::after_motion() {
  if (stops_once_) path_mode(PathMode::exact_once);
  for (const MCode code : late_) tell(code);
  late_.clear();
  stops_once_ = false;
}

void EventWords::read_words() {
  const Word* spindle = is(Dialect::ngc) ? peek('$') : nullptr;
  if (!find(letter('M')) || (spindle && spindle->value > 0)) return;
  for (const Word& word : block_.words) {
    if (word.address != letter('M')) continue;
    const MCode code =
        find_m_code(control_.dialect, program_.machine, static_cast<int>(word.value));
    is_late(code) ? late_.push_back(code) : tell(code);
  }
}

// By DIN 66025, words that end something take effect after the block's motion. In LinuxCNC's order
// of execution only the stops do.
bool EventWords::is_late(MCode code) const {
  switch (code) {
    case MCode::stop:
    case MCode::optional_stop:
    case MCode::end:
      return true;
    case MCode::spindle_off:
    case MCode::coolant_off:
      return !is(Dialect::ngc);
    default:
      return false;
  }
}

void EventWords::tell(MCode code) {
  switch (code) {
    case MCode::clockwise:
      return spindle(SpindleTurn::clockwise);
    case MCode::counter_clockwise:
      return spindle(SpindleTurn::counter_clockwise);
    case MCode::clockwise_flood:
      spindle(SpindleTurn::clockwise);
      return coolant(Coolant::flood);
    case MCode::counter_clockwise_flood:
      spindle(SpindleTurn::counter_clockwise);
      return coolant(Coolant::flood);
    case MCode::spindle_off:
      return spindle(SpindleTurn::off);
    case MCode::mist:
      return coolant(Coolant::mist);
    case MCode::flood:
      return coolant(Coolant::flood);
    case MCode::through:
      return coolant(Coolant::through);
    case MCode::coolant_off:
      return coolant(Coolant::off);
    case MCode::stop:
      return stop(StopKind::program);
    case MCode::optional_stop:
      return stop(StopKind::optional);
    case MCode::end:  // it is a return in a subprogram of SINUMERIK
      if (block_.stop_after) stop(StopKind::end);
      return;
    default:
      return;
  }
}

void EventWords::spindle(SpindleTurn turn) {
  Event event;
  event.kind = EventKind::spindle;
  event.turn = turn_ = turn;
  event.surface_speed = told_surface_ = modal_.surface_speed;
  event.speed = told_speed_ = speed();
  out_.event(std::move(event));
}

void EventWords::coolant(Coolant coolant) {
  Event event;
  event.kind = EventKind::coolant;
  event.coolant = coolant;
  out_.event(std::move(event));
}

void EventWords::stop(StopKind stop) {
  Event event;
  event.kind = EventKind::stop;
  event.stop = stop;
  out_.event(std::move(event));
}

void EventWords::path_mode(PathMode mode) {
  Event event;
  event.kind = EventKind::path_mode;
  event.path = mode;
  out_.event(std::move(event));
}

}  // namespace mrsim
