#include "removal/columns/build_columns.h"

#include "core/process/error.h"
#include "core/process/heap.h"
#include "core/process/ordered.h"
#include "removal/columns/sweep_builder.h"
#include "removal/columns/sweep_classes.h"
#include "removal/forms/helix_sweep.h"
#include "removal/forms/outline.h"
#include "removal/forms/upright_sweep.h"

#include <algorithm>
#include <atomic>
#include <iterator>
#include <memory>

namespace mrsim {
namespace {

constexpr std::size_t kMotionsOfPart = 1 << 13;  // motions; their rows stay in the cache

// Appends parts to a table, in their order.
class Joiner {
 public:
  Joiner(SweepColumns& table, std::size_t motions)
      : table_(table), parts_((motions + kMotionsOfPart - 1) / kMotionsOfPart) {
    reserve_large(table.refs, motions);
    reserve_large(table.tags, motions);
    reserve_large(table.motions, motions);
    table.uniform = true;
  }

  void append(SweepBuilder& part) {
    ++joined_;
    SweepColumns& from = part.columns();
    const std::vector<std::int32_t> shapes = shapes_of(part);
    const std::vector<std::uint16_t> frames = frames_of(from);
    const std::uint32_t first[] = {append(from.ball_lines, table_.ball_lines),
                                   append(from.plane_lines, table_.plane_lines),
                                   append(from.plane_arcs, table_.plane_arcs),
                                   append(from.ball_arcs, table_.ball_arcs),
                                   append(from.profiles, table_.profiles),
                                   append_paths(from.paths),
                                   append(from.turns, table_.turns)};
    static_assert(
        static_cast<int>(SweepKind::ball_line) == 0 &&
        static_cast<int>(SweepKind::plane_line) == 1 &&
        static_cast<int>(SweepKind::plane_arc) == 2 && static_cast<int>(SweepKind::ball_arc) == 3 &&
        static_cast<int>(SweepKind::profile) == 4 && static_cast<int>(SweepKind::path) == 5 &&
        static_cast<int>(SweepKind::turn) == 6 && std::size(first) == kSweepKinds);
    for (std::size_t kind = 0; kind < kSweepKinds; ++kind)
      append(from.bounds[kind], table_.bounds[kind]);
    for (SweepRef ref : from.refs) {
      const auto form = static_cast<std::uint32_t>(ref.kind);
      ref.row += first[form];
      ref.shape = shapes[static_cast<std::size_t>(ref.shape)];
      ref.frame = frames[ref.frame];
      const bool listed = ref.frame == 0 && form < kOtherForm && ref.row <= kTagRow;
      table_.tags.push_back(listed ? form << kTagShift | ref.row : kOtherForm << kTagShift);
      table_.uniform = table_.uniform && ref.frame == 0 && ref.row == table_.refs.size() &&
                       (table_.refs.empty() || ref.kind == table_.refs[0].kind);
      table_.refs.push_back(ref);
    }
    table_.motions.insert(table_.motions.end(), from.motions.begin(), from.motions.end());
    table_.max_error = std::max(table_.max_error, from.max_error);
    double& least = table_.smallest_radius;
    if (from.smallest_radius > 0 && (least == 0 || from.smallest_radius < least))
      least = from.smallest_radius;
  }

 private:
  template <class Row>
  std::uint32_t append(std::vector<Row>& rows, std::vector<Row>& column) const {
    const auto first = static_cast<std::uint32_t>(column.size());
    reserve_ahead(column, rows.size(), joined_, parts_);
    column.insert(column.end(), std::make_move_iterator(rows.begin()),
                  std::make_move_iterator(rows.end()));
    return first;
  }

  std::uint32_t append_paths(const PathColumn& rows) {
    const auto first = static_cast<std::uint32_t>(table_.paths.size());
    table_.paths.append(rows, joined_, parts_);
    return first;
  }

  std::vector<std::int32_t> shapes_of(SweepBuilder& part) {
    std::vector<std::int32_t> indices;
    for (std::size_t k = 0; k < part.keys().size(); ++k) {
      const auto next = static_cast<std::int32_t>(table_.shapes.size());
      const auto [at, added] = shapes_.try_emplace(part.keys()[k], next);
      if (added) table_.shapes.push_back(part.columns().shapes[k]);
      indices.push_back(at->second);
    }
    return indices;
  }

  // The table's number for each frame of a part. Numbers count from 1; 0, the stock's own frame,
  // stays.
  std::vector<std::uint16_t> frames_of(const SweepColumns& from) {
    std::vector<std::uint16_t> indices(1, 0);
    for (const ToolFrame& frame : from.frames) {
      auto& known = table_.frames;
      const auto at = std::find_if(known.begin(), known.end(),
                                   [&](const ToolFrame& other) { return other.z == frame.z; });
      indices.push_back(static_cast<std::uint16_t>(at - known.begin() + 1));
      if (at == known.end()) known.push_back(frame);
    }
    MRSIM_ASSERT(table_.frames.size() < 65000);
    return indices;
  }

  SweepColumns& table_;
  std::size_t parts_, joined_ = 0;
  std::map<ShapeKey, std::int32_t> shapes_;
};

void add_chains(SweepColumns& c) {
  for (const ToolShape& shape : c.shapes)
    c.chain_tools.push_back(shape.turning ? ChainTool{} : chain_tool(shape.cutter));
  for (const SweepRef& ref : c.refs) {
    if (ref.kind != SweepKind::path || !c.paths.is_line(ref.row)) continue;
    const ChainTool& tool = c.chain_tools[ref.shape];
    if (tool.count == 0) continue;
    c.chain_lines.resize(c.paths.size());
    c.chain_lines[ref.row] = chain_line(tool, *c.paths[ref.row]);
  }
}

// A rounded tool on a horizontal path has a closed form.
void add_outlines(SweepColumns& c) {
  if (c.profiles.empty()) return;
  std::vector<std::size_t> first;
  for (const ToolShape& shape : c.shapes) {
    first.push_back(c.outline_edges.size());
    if (!shape.turning && !shape.cutter.is_end_mill())
      append_outline(shape.cutter, c.outline_edges);
  }
  first.push_back(c.outline_edges.size());
  for (std::size_t k = 0; k < c.shapes.size(); ++k) {
    const Profile& cutter = c.shapes[k].cutter;
    const auto edges =
        std::span<const OutlineEdge>(c.outline_edges).subspan(first[k], first[k + 1] - first[k]);
    c.outlines.push_back({edges, cutter.max_radius(), cutter.bottom()});
  }
}

void add_slants(SweepColumns& c) {
  for (const SweepRef& ref : c.refs) {
    if (ref.kind != SweepKind::path || !c.paths.is_line(ref.row) ||
        !is_slant(c.cutter(ref), *c.paths[ref.row]))
      continue;
    c.slant_lines.resize(c.paths.size());
    c.slant_lines[ref.row] = slant_record(c.cutter(ref), *c.paths[ref.row]);
  }
}

void add_bores(SweepColumns& c) {
  for (const SweepRef& ref : c.refs) {
    if (ref.kind != SweepKind::path || c.paths.is_line(ref.row)) continue;
    const ToolPath& path = c.paths.arc(ref.row);
    if (!path.lowest_turn || !c.cutter(ref).is_end_mill()) continue;
    c.bores.resize(c.paths.size());
    c.bores[ref.row] = bore_record(c.cutter(ref), path);
  }
}

// Paths are rows in the order of their sweeps.
void add_uprights(SweepColumns& c) {
  const auto is_upright = [&c](const SweepRef& ref) {
    return ref.frame == 0 && c.upright_arc(ref) != nullptr;
  };
  if (std::none_of(c.refs.begin(), c.refs.end(), is_upright)) return;
  for (const SweepRef& ref : c.refs) {
    if (ref.kind != SweepKind::path) continue;
    c.first_quarter.push_back(static_cast<std::uint32_t>(c.upright_quarters.size()));
    if (is_upright(ref)) append_quarters(c.cutter(ref), *c.upright_arc(ref), c.upright_quarters);
  }
  c.first_quarter.push_back(static_cast<std::uint32_t>(c.upright_quarters.size()));
}

void tag_others(SweepColumns& c) {
  for (std::size_t i = 0; i < c.refs.size(); ++i) {
    if (!is_other(c.tags[i])) continue;
    const SweepRef& ref = c.refs[i];
    const bool has_record = ref.frame == 0 && ref.row <= kSingleRow;
    const SingleForm form = ref.kind == SweepKind::turn          ? SingleForm::turned
                            : has_record && c.is_slant_line(ref) ? SingleForm::slant
                            : has_record && c.is_chain(ref)      ? SingleForm::chain
                            : has_record && c.has_outline(ref)   ? SingleForm::outline
                            : has_record && c.is_bore(ref)       ? SingleForm::bore
                            : has_record && c.upright_arc(ref)   ? SingleForm::upright
                                                                 : SingleForm::box;
    c.tags[i] = kOtherForm << kTagShift | static_cast<std::uint32_t>(form) << kSingleShift |
                (ref.row & kSingleRow);
  }
}

}  // namespace

void build_columns(std::span<const Motion> program, std::span<const Tool> tools,
                   const SweepSelection& selection, int threads, SweepColumns& out) {
  static std::atomic<std::uint64_t> tables{0};
  out.serial = ++tables;
  Joiner joiner(out, program.size());
  make_in_order((program.size() + kMotionsOfPart - 1) / kMotionsOfPart, threads,
                [&](std::size_t part) {
                  auto builder = std::make_unique<SweepBuilder>(tools, selection);
                  for (std::size_t i = part * kMotionsOfPart;
                       i < std::min((part + 1) * kMotionsOfPart, program.size()); ++i)
                    builder->add(program[i], static_cast<std::int32_t>(i));
                  return builder;
                },
                [&](const std::unique_ptr<SweepBuilder>& part) { joiner.append(*part); });
  out.uniform = out.uniform && !out.refs.empty();
  add_chains(out);
  add_slants(out);
  add_outlines(out);
  add_bores(out);
  add_uprights(out);
  tag_others(out);
  cut_segments(out);
  out.packs = SweepPacks(out, threads);
  out.run_chords = RunChords(out);
  classify(out, threads);
  std::vector<TurnTree::Item> items;
  for (std::size_t i = 0; i < out.refs.size() && !out.turns.empty(); ++i)
    if (out.refs[i].kind == SweepKind::turn)
      items.push_back({static_cast<std::uint32_t>(i), out.refs[i].row, out.refs[i].shape});
  out.turn_tree = TurnTree(out.turns, out.shapes, std::move(items), threads);
  out.all_turned = std::all_of(program.begin(), program.end(), [&](const Motion& m) {
    const bool counts = m.tool >= 0 && (selection.rapids || m.kind != MotionKind::rapid);
    return !counts || is_turning(tools[static_cast<std::size_t>(m.tool)].type) || runs_on_axis(m);
  });
}

}  // namespace mrsim
