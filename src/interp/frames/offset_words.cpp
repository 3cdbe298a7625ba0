#include "interp/frames/offset_words.h"

#include "core/numbers/rounding.h"
#include "core/words/tool_types.h"

#include <cmath>

#include <fmt/format.h>

namespace mrsim {
namespace {

constexpr int kSharedLength = 2;     // a kind of length; those of L10 and L11 are 0 and 1
constexpr double kGeometry = 10000;  // from this P of G10 on: geometry of a lathe's tool

WorkOffset& work_entry(std::vector<WorkOffset>& list, const std::string& name) {
  for (WorkOffset& offset : list)
    if (offset.name == name) return offset;
  return list.emplace_back(WorkOffset{name, {}});
}

}  // namespace

bool OffsetWords::run() {
  const Word& where = *block_.oneshot;
  const Word* l = take('L');
  const Word* p = take('P');
  if (!l && p && lathe() && is(Dialect::fanuc))
    return p->value == 0 ? work_shift(where) : turned_offset(where);
  const bool plain_offset = !l && p && peek('R') && is(Dialect::fanuc);
  if (!l && !plain_offset)
    return error("value-missing", "G10 needs L, which says what is set", where);
  const double number = p ? p->value : 0;
  if (number < 0 || number > 9999 || number != std::floor(number))
    return error("value-range", "P of G10 is a whole number", *p);
  const int kind = plain_offset ? 12 : static_cast<int>(l->value);
  if (!p && (kind <= 2 || (kind >= 10 && kind <= 20)))
    return error("value-missing", fmt::format("G10 L{} needs P, the number of what it sets", kind),
                 where);
  if (kind == 2 || kind == 20) return work(kind, static_cast<int>(number));
  if (kind == 1 || (kind >= 10 && kind <= 13))
    return tool_register(kind, static_cast<int>(number), where);
  if (kind == 3 && is(Dialect::fanuc)) return tool_life(where);
  if (kind >= 50 && kind <= 52 && is(Dialect::fanuc)) return parameters(where);
  return error("not-supported", fmt::format("G10 L{:g} is not supported yet", l->value), *l);
}

// Blocks from G10 L3 to G11 set groups of tools and their lives.
bool OffsetWords::tool_life(const Word& where) {
  control_.skips_data = true;
  note_once("tool-life", "G10 L3: how long tools last is not read, up to G11", where, "life");
  return true;
}

// Blocks from G10 L50 to G11 set parameters; newer controls write L52.
bool OffsetWords::parameters(const Word& where) {
  control_.skips_data = true;
  reporter_.once(Severity::warning, "parameter-set",
                 "the parameters of the control that are set up to G11 are not read", where,
                 "parameters");
  return true;
}

// G10 P0 X Z of a lathe shifts the zero. Its direction depends on the machine's parameters, so that
// only a shift of 0 is read.
bool OffsetWords::work_shift(const Word& where) {
  for (const char c : {'X', 'Y', 'Z', 'U', 'V', 'W', 'C'})
    if (const Word* word = take(c); word && word->value != 0)
      return error("not-supported",
                   fmt::format("{} of G10 P0 shifts the zero, towards the side that a parameter of "
                               "the machine tells: write G52 with the place of the zero instead",
                               text_of(*word)),
                   *word);
  return turned_offset(where);
}

// G10 P X Z of a lathe says where the tool's tip is. Positions of a program are those of the tip,
// so X and Z have no effect. R is the nose radius, to be compared with that of the tool, and Q the
// orientation of the tip.
bool OffsetWords::turned_offset(const Word& where) {
  const Word* p = peek('P');
  if (const Word* r = take('R'); r && p && r->value > 0)
    control_.told_noses[static_cast<long>(p->value) % 100] = r->value * length_unit(*r);
  if (const Word* q = take('Q'); q && p && q->value >= 1 && q->value <= 8)
    control_.told_tips[static_cast<long>(p->value) % 100] = static_cast<int>(q->value);
  const double number = p ? p->value : 0;
  const bool wear = number < kGeometry;  // P10001 is the place of the tip, P1 the wear of it
  for (const char c : {'X', 'Z', 'U', 'W'})
    if (const Word* word = take(c); word && number > 0 && number < 2 * kGeometry)
      keep_length(static_cast<int>(number) % 100, 2 * wear + (c == 'Z' || c == 'W'), wear,
                  {word->value * length_unit(*word), modal_.incremental || c == 'U' || c == 'W',
                   fmt::format("{} of G10 P{:g}", text_of(*word), number),
                   c == 'X' || c == 'U' ? 'X' : 'Z'});
  for (const char c : {'Y', 'V', 'C'}) take(c);
  note_once("tool-length", "positions are read as those of the tool's tip, whatever its offset",
            where, "length");
  return true;
}

// The offset that P means. P0 of LinuxCNC is the one in force, P0 of FANUC the external offset,
// which is part of all others. L20 of FANUC is G54.1.
std::string OffsetWords::work_name(int l, int p) const {
  if (l == 20 && !is(Dialect::ngc)) return fmt::format("G54.1P{}", p);
  if (p == 0) return is(Dialect::ngc) ? frames_.work_name : "EXT";
  if (p <= 6) return fmt::format("G{}", 53 + p);
  return p <= 9 && is(Dialect::ngc) ? fmt::format("G59.{}", p - 6) : std::string();
}

bool OffsetWords::work(int l, int p) {
  const std::string name = work_name(l, p);
  if (name.empty())
    return error("value-range", fmt::format("G10 L{} P{}: there is no such work offset", l, p),
                 *block_.oneshot);
  const Word* r = take('R');
  if (r && !is(Dialect::ngc))
    return error("word-unexpected", "R turns a work offset on LinuxCNC only", *r);
  frame_words_.save();
  if (r) control_.work_turns[name] = r->value;
  WorkOffset& offset = work_entry(control_.work, name);
  if (l == 20 && is(Dialect::ngc)) {
    offset.shift = shift_to_here(offset.shift, name);
    if (name == frames_.work_name) frame_words_.renew_work();
    return true;
  }
  for (int i = 0; i < 3; ++i) {
    const Word* word = take("XYZ"[i]);
    if (!word) continue;
    const double value = axis_value(i, *word, false);
    double& shift = component(offset.shift, i);
    const bool more = modal_.incremental && !is(Dialect::ngc);
    const double zero = name == "EXT" ? 0 : component(control_.machine_shift, i);
    shift = value + (more ? shift : zero);
  }
  if (!is(Dialect::ngc) || name == frames_.work_name) frame_words_.renew_work();
  if (name != "EXT" && !modal_.incremental && !control_.machine_known) tell_of_machine(offset);
  return true;
}

// G10 L2 counts from the machine's zero. Only a zero in [machine] says where that lies in the
// stock.
void OffsetWords::tell_of_machine(const WorkOffset& offset) {
  const Vec3& at = offset.shift;
  if (at.x == 0 && at.y == 0 && at.z == 0) return;
  note_once("work-offset-set",
            fmt::format("the zero of {0} is read as a place of the stock: X{1:g} Y{2:g} Z{3:g}. "
                        "Where it is one of the machine, and the stock's own zero, say "
                        "zero.{0} = [{1:g}, {2:g}, {3:g}] in [machine]",
                        offset.name, at.x, at.y, at.z),
            *block_.oneshot, "work-set");
}

// G10 L20 gives the offset in which the current position has the coordinates of the block.
Vec3 OffsetWords::shift_to_here(const Vec3& old, const std::string& name) {
  const auto angle = control_.work_turns.find(name);
  const Frame turned = rotation_frame(2, angle == control_.work_turns.end() ? 0 : angle->second);
  const Vec3 inner = frames_.position_shift + frames_.local;
  meet_unknown(compose(compose(shift_frame(old), turned), shift_frame(inner)));
  Vec3 at = turn_inverse(turned, position_.physical - old) - inner;
  for (int i = 0; i < 3; ++i)
    if (const Word* word = take("XYZ"[i])) component(at, i) = axis_value(i, *word, false);
  return position_.physical - turn(turned, at + inner);
}

// An axis whose place is unknown, as behind a probe, is taken to stand where the offset as it is
// puts the coordinate of the block.
void OffsetWords::meet_unknown(const Frame& frame) {
  Vec3 at = apply_inverse(frame, position_.physical);
  AxisSet met;
  for (int i = 0; i < 3; ++i) {
    const Word* word = position_.known.has(i) ? nullptr : peek("XYZ"[i]);
    if (!word) continue;
    component(at, i) = axis_value(i, *word, false);
    met.add(i);
    note_once("touch-off",
              fmt::format("the place of {} is unknown here: it is taken to be where this offset "
                          "says, which stays as it was",
                          "XYZ"[i]),
              *word, fmt::format("touch-off {}", i));
  }
  if (met.empty()) return;
  position_.physical = apply(frame, at);
  position_.programmed = apply_inverse(frames_.total, position_.physical);
  position_.known |= met;
}

// L12 and L13 are the radius and its wear. Lengths (L10, L11) are taken to be those of the real
// tools, since positions of the program are those of the tip. Controls with one offset for H and D
// of a number (memory A) write P and R alone: that is read as a radius, because a length has no
// effect. On LinuxCNC P is the tool and R its radius.
bool OffsetWords::tool_register(int l, int p, const Word& where) {
  const Word* r = take('R');
  const Word* z = peek('Z');
  if (is(Dialect::ngc)) table_lengths(l, p);
  if (const Word* q = is(Dialect::ngc) ? peek('Q') : nullptr; q && q->value >= 1 && q->value <= 8)
    control_.told_tips[p] = tip_of_linuxcnc(static_cast<int>(q->value));
  for (const char c : {'X', 'Y', 'Z', 'I', 'J', 'Q'}) take(c);
  if (is(Dialect::ngc) && p < 1)
    return error("value-range", "P of G10 is the number of a tool", where);
  if (!is(Dialect::ngc) && !r) return error("value-missing", "G10 needs R with the value", where);
  const bool radius = is(Dialect::ngc) ? r != nullptr : l >= 12;
  if (z || !radius)
    note_once("tool-length", "positions are read as those of the tool's tip, whatever its length",
              where, "length");
  if (!radius) {
    if (!is(Dialect::ngc))
      keep_length(
          p, l == 11, l == 11,
          {r->value * length_unit(*r), modal_.incremental, fmt::format("G10 L{} P{}", l, p)});
    return true;
  }
  if (!peek('L'))  // memory A: one offset for H and D
    keep_length(p, kSharedLength, false,
                {r->value * length_unit(*r), modal_.incremental, fmt::format("G10 P{}", p)});
  const std::string name = fmt::format("D{}", p);
  double& value = l == 13 ? control_.change_wear(name) : control_.change_register(name).radius;
  const double mm = r->value * length_unit(*r);
  value = modal_.incremental && !is(Dialect::ngc) ? value + mm : mm;
  return true;
}

// Lengths of LinuxCNC hold from the next G43 of that tool on. L10 and L11 touch off: the tip stays
// where it is, and the length changes.
void OffsetWords::table_lengths(int l, int tool) {
  const SetLengths::Register which{SetLengths::kTable, tool};
  for (int i = 0; i < 3; ++i) {
    const Word* word = peek("XYZ"[i]);
    if (!word) continue;
    SetLengths::Setting setting{word->value * length_unit(*word), false,
                                fmt::format("{} of G10 L{} P{}", text_of(*word), l, tool),
                                block_.motion_at(block_.oneshot->column), "XYZ"[i]};
    if (l == 1)
      control_.lengths.set(which, i, std::nullopt, std::move(setting));
    else
      control_.lengths.set_another(which, i, std::move(setting));
  }
}

// Lengths move nothing here. What a length was before the program first set it is not known; a wear
// is taken to have been 0.
void OffsetWords::keep_length(int number, int kind, bool wear, const Length& length) {
  const SetLengths::Register which{0, number};
  SetLengths::Setting setting{length.mm, length.incremental && !wear, length.name,
                              block_.motion_at(block_.oneshot->column), length.axis};
  const SetLengths::Setting* before = control_.lengths.find(which, kind);
  if (length.incremental && before) {
    setting.mm += before->mm;
    setting.relative = before->relative;
  }
  control_.lengths.set(which, kind, wear ? std::optional(0.0) : std::nullopt, std::move(setting));
}

}  // namespace mrsim
