// A straight move of a convex tool (form_records.h), for one point (V = double) or several;
// included once per instruction set after falling_lanes.inl.
//
// Seen from the tool, p moves on a line, and the tool's distance F(t) from it is convex on the
// whole line. So the least F of the move is that of the whole line, or at the end before it. Where
// a cone, a cylinder or a ball about the axis is nearest, place and distance are closed. Discs'
// rims, tori and the inside are searched, from the nearest of these places (docs/sweeps.md).

/// One move, in all lanes.
struct OneChain {
  const ChainLine& line;
  V x() const { return splat(line.x); }
  V y() const { return splat(line.y); }
  V z() const { return splat(line.z); }
  V ux() const { return splat(line.ux); }
  V uy() const { return splat(line.uy); }
  V plan() const { return splat(line.plan); }
  V rise() const { return splat(line.rise); }
  V per_plan() const { return splat(line.per_plan); }
  V per_way() const { return splat(line.per_way); }
  V tilt(std::size_t i) const { return splat(line.tilt[i]); }
};
/// A move in each lane: its record by columns.
struct EachChain {
  V c[16];
  V x() const { return c[ChainColumn::x]; }
  V y() const { return c[ChainColumn::y]; }
  V z() const { return c[ChainColumn::z]; }
  V ux() const { return c[ChainColumn::ux]; }
  V uy() const { return c[ChainColumn::uy]; }
  V plan() const { return c[ChainColumn::plan]; }
  V rise() const { return c[ChainColumn::rise]; }
  V per_plan() const { return c[ChainColumn::per_plan]; }
  V per_way() const { return c[ChainColumn::per_way]; }
  V tilt(std::size_t i) const { return c[ChainColumn::tilt + i]; }
};

struct ChainView {
  V u, v, w;  ///< p, as ChainLine counts it
};
template <class Move>
MRSIM_LANE ChainView chain_view(const Move& move, V px, V py, V pz) {
  const V dx = px - move.x(), dy = py - move.y(), ux = move.ux(), uy = move.uy();
  return {dx * ux + dy * uy, vabs(dx * uy - dy * ux), pz - move.z()};
}

/// The plane across the way from the tip's path to p, which touches the tip, where the tool lies
/// behind it; else, and where that way is too short to be known, minus infinity.
template <class Move>
MRSIM_LANE V tip_bound(const ChainTool& tool, const Move& move, const ChainView& at) {
  const V zero = splat(0.0), h = at.w - splat(tool.tip);
  const V t = (at.u * move.plan() + h * move.rise()) * move.per_way();
  const V way = vmin(vmax(t, zero), splat(1.0));
  const V along = at.u - way * move.plan(), up = h - way * move.rise();
  const V square = along * along + at.v * at.v;
  const V off = vsqrt(square + up * up), aside = vsqrt(square);
  const M behind =
      both(less(splat(1e-3), off), less_equal(up * splat(tool.last.x), aside * splat(tool.last.y)));
  const V reach = splat(tool.core) * aside / off + splat(tool.ball);
  return select(behind, off - reach, splat(-std::numeric_limits<double>::infinity()));
}

/// A flank, continued beyond its edge: where on the move p is farthest outwards of it, or least
/// deep within it, and the tool's distance there if the flank is what is nearest. Convex along the
/// move.
struct FlankPlace {
  V t, rho, z, f;
};
template <class Move>
MRSIM_LANE FlankPlace flank_place(const ChainTool& tool, const Move& move, const ChainView& at,
                                  std::size_t i) {
  const V zero = splat(0.0), one = splat(1.0);
  const ChainTool::Flank& flank = tool.flanks[i];
  const V end = select(less(zero, splat(flank.up) * move.rise()), one, zero), tilt = move.tilt(i);
  const M steep = less_equal(splat(std::numeric_limits<double>::infinity()), tilt);
  FlankPlace x;
  x.t = select(steep, end, vmin(vmax((at.u - at.v * tilt) * move.per_plan(), zero), one));
  const V along = at.u - x.t * move.plan();
  x.rho = vsqrt(along * along + at.v * at.v), x.z = at.w - x.t * move.rise();
  x.f = x.rho * splat(flank.across) + x.z * splat(flank.up) - splat(flank.offset);
  return x;
}

/// No position of the tool is nearer: it ends within its radius of the move in plan, along and
/// across it, and between its lowest and its highest place.
template <class Move>
MRSIM_LANE V ends_bound(const ChainTool& tool, const Move& move, const ChainView& at) {
  const V zero = splat(0.0), rise = move.rise();
  const V low = splat(tool.bottom) + vmin(rise, zero), high = splat(tool.top) + vmax(rise, zero);
  return vmax(vmax(vmax(zero - at.u, at.u - move.plan()), at.v) - splat(tool.radius),
              vmax(low - at.w, at.w - high));
}

/// A closer bound than ends_bound(): the tool lies within its flanks, continued, and its ball's
/// tangent planes. A result above `limit` only means *above limit*. A lower bound up to 1e-9 mm
/// within 10 m of the origin.
template <class Move>
MRSIM_LANE V chain_bound(const ChainTool& tool, const Move& move, const ChainView& at, V limit) {
  V bound = ends_bound(tool, move, at);
  for (std::size_t i = 0; i < tool.flank_count && any(less_equal(bound, limit)); ++i)
    bound = vmax(flank_place(tool, move, at, i).f, bound);
  if (!tool.tipped || !any(less_equal(bound, limit))) return bound;
  return vmax(bound, tip_bound(tool, move, at));
}

/// The nearest edge so far: distance squared, and what its outward normal is, times `scale`; a
/// scale of zero means the signed distance.
struct ChainFoot {
  V square, r, z, scale;
  M outside;
};
MRSIM_LANE void take_foot(ChainFoot& foot, V square, V r, V z, V scale) {
  const M closer = less(square, foot.square);
  foot.square = select(closer, square, foot.square);
  foot.r = select(closer, r, foot.r), foot.z = select(closer, z, foot.z);
  foot.scale = select(closer, scale, foot.scale);
}
// The normal at an end is that towards q, but on the end itself any of the edge's.
MRSIM_LANE void add_line(ChainFoot& foot, const ProfileEdge& e, V rho, V z) {
  const V zero = splat(0.0), one = splat(1.0);
  const V dx = splat(e.direction.x), dy = splat(e.direction.y);
  const V wx = rho - splat(e.a.x), wy = z - splat(e.a.y);
  const V side = dy * wx - dx * wy, along = dx * wx + dy * wy;
  const V over = along - vmin(vmax(along, zero), splat(e.length));
  const V square = side * side + over * over;
  const M end = both(either(less(over, zero), less(zero, over)), less(zero, square));
  foot.outside = either(foot.outside, less(zero, side));
  take_foot(foot, square, select(end, side * dy + over * dx, dy),
            select(end, over * dy - side * dx, -dx), select(end, zero, one));
}
MRSIM_LANE void add_arc(ChainFoot& foot, const ProfileEdge& e, V rho, V z) {
  const V zero = splat(0.0), one = splat(1.0), radius = splat(e.radius);
  const V wx = rho - splat(e.center.x), wy = z - splat(e.center.y);
  const V sx = splat(e.a.x - e.center.x), sy = splat(e.a.y - e.center.y);
  const V ex = splat(e.b.x - e.center.x), ey = splat(e.b.y - e.center.y);
  const M sector = both(less_equal(zero, sx * wy - sy * wx), less_equal(zero, wx * ey - wy * ex));
  const V n = vsqrt(wx * wx + wy * wy), away = n - radius;
  const V ax = wx - sx, ay = wy - sy, bx = wx - ex, by = wy - ey;
  const V to_a = ax * ax + ay * ay, to_b = bx * bx + by * by;
  const M first = less(to_a, to_b);
  const V square = select(sector, away * away, select(first, to_a, to_b));
  // At the end a, b the tool lies behind the arc's tangent.
  const V ahead = select(first, wx * sx + wy * sy, wx * ex + wy * ey);
  foot.outside = either(foot.outside, either(both(sector, less(zero, away)),
                                             except(less(radius * radius, ahead), sector)));
  const M center = both(sector, less_equal(n, zero)), on_end = less_equal(square, zero);
  const V r = select(sector, select(center, one, wx),
                     select(on_end, select(first, sx, ex), select(first, ax, bx)));
  const V h = select(sector, wy, select(on_end, select(first, sy, ey), select(first, ay, by)));
  take_foot(foot, square, r, h,
            select(sector, select(center, one, n), select(on_end, radius, zero)));
}

/// Profile::sample of a convex chain.
struct ChainValue {
  V f, slope_r, slope_z;
};
MRSIM_LANE ChainValue chain_value(const ChainTool& tool, V rho, V z) {
  const V zero = splat(0.0);
  ChainFoot foot{splat(std::numeric_limits<double>::infinity()), zero, zero, zero,
                 less(zero, zero)};
  for (std::size_t i = 0; i < tool.count; ++i)
    if (tool.edges[i].radius > 0)
      add_arc(foot, tool.edges[i], rho, z);
    else
      add_line(foot, tool.edges[i], rho, z);
  const V d = vsqrt(foot.square), f = select(foot.outside, d, -d);
  const V inverse = splat(1.0) / select(less(zero, foot.scale), foot.scale, f);
  return {f, foot.r * inverse, foot.z * inverse};
}

/// Values of F this near to each other are equal: F is rounded by less.
MRSIM_LANE V chain_tolerance(V f) { return splat(1e-13) * (splat(1.0) + vabs(f)); }

/// F at t, and its slope there.
struct ChainPlace {
  V t, f, slope;
};
MRSIM_LANE ChainPlace choose(M m, const ChainPlace& a, const ChainPlace& b) {
  return {select(m, a.t, b.t), select(m, a.f, b.f), select(m, a.slope, b.slope)};
}
/// F of one point.
struct ChainObjective {
  const ChainTool& tool;
  const ChainLine& line;
  ChainView at;

  ChainPlace operator()(V t) const {
    const V zero = splat(0.0), along = at.u - t * splat(line.plan);
    const V rho = vsqrt(along * along + at.v * at.v);
    const ChainValue x = chain_value(tool, rho, at.w - t * splat(line.rise));
    const V towards = select(less(zero, rho), along / rho, zero);
    return {t, x.f, -(x.slope_r * towards * splat(line.plan) + x.slope_z * splat(line.rise))};
  }

  /// The place of the least F if a flank is nearest there, or else a ball or point at the tip;
  /// whether that is so and p is outside, F with it.
  struct Closed {
    V t, f;
    M holds;
  };
  Closed closed() const {
    const V zero = splat(0.0), one = splat(1.0), h = at.w - splat(tool.tip);
    const V t = (at.u * splat(line.plan) + h * splat(line.rise)) * splat(line.per_way);
    Closed x{vmin(vmax(t, zero), one), zero, less(zero, zero)};
    if (tool.tipped && tool.core == 0) {
      const V along = at.u - x.t * splat(line.plan), up = h - x.t * splat(line.rise);
      const V square = along * along + at.v * at.v, rho = vsqrt(square);
      const V off = vsqrt(square + up * up);
      x.f = off - splat(tool.ball);
      // On the path of a point there is no direction to it.
      x.holds = both(both(less_equal(zero, x.f), less(splat(kRounding), off)),
                     less_equal(up * splat(tool.last.x), rho * splat(tool.last.y)));
    }
    for (std::size_t i = 0; i < tool.flank_count; ++i) add_flank(i, x);
    return x;
  }

  /// closed() for a flat or bull-nosed tip: where a mill with the same tip is nearest.
  Closed at_flat_tip(M wanted) const {
    const SlantRecord record = tip_record();
    const SlantStretch stretch(record, at.u, at.v, at.w);
    const Place x = best_place(stretch, wanted);
    const V f = value_of(x, splat(tool.ball)), zero = splat(0.0);
    // A place that differs from the end by rounding only is the end: other faces are nearest there.
    constexpr double kNearlyAll = 1 - 1e-14;
    const V one = splat(1.0), way = stretch.height_way(x.t);
    const V share = select(less_equal(splat(record.length * kNearlyAll), way), one,
                           vmin(vmax(way / splat(record.length), zero), one));
    const M tip = less_equal((zero - x.dz) * splat(tool.last.x), x.dr * splat(tool.last.y));
    const M clear = less(splat(kRounding), f + splat(tool.ball));
    return {line.rise < 0 ? one - share : share, f, both(tip, both(clear, less(zero, f)))};
  }

  /// closed() within a tool with a flat sharp tip, where its floor and the flank above it are what
  /// is nearest: both are planes for F, the one linear in t, the other convex. F is least where
  /// they cross, or where the tool is lowest; not where the flank alone decides, which closed()
  /// has.
  Closed at_floor() const {
    const V zero = splat(0.0), plan = splat(line.plan), rise = splat(line.rise);
    const ChainTool::Flank& flank = tool.flanks[0];
    const V across = splat(flank.across), up = splat(flank.up), h = at.w - splat(tool.bottom);
    // across rho = grow t + from, squared.
    const V grow = rise * (splat(1.0) + up), from = splat(flank.offset) - h - up * at.w;
    const V square = across * across;
    const V a = square * plan * plan - grow * grow, b = square * at.u * plan + grow * from;
    const V c = square * (at.u * at.u + at.v * at.v) - from * from;
    const V root = vsqrt(vmax(b * b - a * c, zero)), q = select(less(b, zero), b - root, b + root);
    const V lowest = splat(line.rise > 0 ? 0.0 : 1.0),
            decided = flank_place(tool, OneChain{line}, at, 0).t;
    const V low = vmin(lowest, decided), high = vmax(lowest, decided);
    const V first = q / a, second = c / q;
    const V t = select(between(low, first, high), first,
                       select(between(low, second, high), second, lowest));
    const V f = (*this)(t).f, floor = t * rise - h;
    return {t, f, less_equal(f - floor, chain_tolerance(f))};
  }

 private:
  // The tip as a slanted line, in the coordinates of ChainView.
  SlantRecord tip_record() const {
    const bool falls = line.rise < 0;
    const double length = std::sqrt(line.plan * line.plan + line.rise * line.rise);
    SlantRecord r;
    r.x = falls ? line.plan : 0, r.z = (falls ? line.rise : 0) + tool.tip;
    r.ux = falls ? -1 : 1;
    r.length = length, r.plan = line.plan / length, r.rise = std::fabs(line.rise) / length;
    r.core = tool.core, r.round = tool.ball;
    return r;
  }
  void add_flank(std::size_t i, Closed& x) const {
    const V zero = splat(0.0);
    const ProfileEdge& e = tool.edges[tool.flanks[i].edge];
    const auto [t, rho, z, f] = flank_place(tool, OneChain{line}, at, i);
    const V place =
        splat(e.direction.x) * (rho - splat(e.a.x)) + splat(e.direction.y) * (z - splat(e.a.y));
    const M fits = both(less_equal(zero, place), less_equal(place, splat(e.length)));
    x.t = select(fits, t, x.t), x.f = select(fits, f, x.f);
    x.holds = either(both(fits, less_equal(zero, f)), except(x.holds, fits));
  }
};

// Between a with a falling F and b with a rising one. Tangents find kinks at once, the secant of
// the slopes smooth minima; halving bounds both.
static inline ChainPlace chain_search(const ChainObjective& F, ChainPlace a, ChainPlace b, V limit,
                                      M active) {
  const V zero = splat(0.0);
  for (int i = 0; i < 80; ++i) {
    const V gain = b.slope - a.slope, best = vmin(a.f, b.f);
    const V met = (a.f - b.f + b.slope * b.t - a.slope * a.t) / gain;
    const V cut = vmin(vmax(met, a.t), b.t), floor = a.f + a.slope * (cut - a.t);
    active =
        both(active, both(less(chain_tolerance(best), best - floor), less_equal(floor, limit)));
    const V half = splat(0.5) * (a.t + b.t);
    V t = i % 3 == 0 ? cut : i % 3 == 1 ? a.t - a.slope * (b.t - a.t) / gain : half;
    t = select(between(a.t, t, b.t), t, half);
    active = both(active, between(a.t, t, b.t));
    if (!any(active)) break;
    const ChainPlace m = F(t);
    const M falls = less(m.slope, zero);
    a = choose(both(active, falls), m, a), b = choose(except(active, falls), m, b);
    active = both(active, either(falls, less(zero, m.slope)));
  }
  return choose(less(a.f, b.f), a, b);
}

/// The least F, and where it is: in the lanes that are wanted and whose least is below `limit`;
/// elsewhere some F.
static inline ChainPlace chain_least(const ChainObjective& F, V limit, M wanted) {
  const V zero = splat(0.0), one = splat(1.0);
  const ChainObjective::Closed closed = F.closed();
  M active = except(wanted, closed.holds);
  ChainPlace x{closed.t, closed.f, zero};
  if (!any(active)) return x;
  if (F.tool.tipped && F.tool.core > 0) {
    const ChainObjective::Closed tip = F.at_flat_tip(active);
    x = choose(both(active, tip.holds), ChainPlace{tip.t, tip.f, zero}, x);
    active = except(active, tip.holds);
    if (!any(active)) return x;
    if (F.tool.ball == 0 && F.tool.flank_count > 0) {
      const ChainObjective::Closed floor = F.at_floor();
      x = choose(both(active, floor.holds), ChainPlace{floor.t, floor.f, zero}, x);
      active = except(active, floor.holds);
      if (!any(active)) return x;
    }
  }
  x = choose(active, F(closed.t), x);
  const V gap = vmax(x.slope * x.t, x.slope * (x.t - one));
  active = both(active, both(less(chain_tolerance(x.f), gap), less_equal(x.f - gap, limit)));
  if (!any(active)) return x;
  const M falls = less(x.slope, zero);
  const ChainPlace end = F(select(falls, one, zero));
  const M beyond =
      either(both(falls, less_equal(end.slope, zero)), except(less_equal(zero, end.slope), falls));
  const ChainPlace best = choose(both(active, beyond), end, x);
  active = except(active, beyond);
  if (!any(active)) return best;
  const ChainPlace a = choose(falls, x, end), b = choose(falls, end, x);
  return choose(active, chain_search(F, a, b, limit, active), best);
}
