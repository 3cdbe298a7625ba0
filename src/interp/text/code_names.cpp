#include "interp/text/code_names.h"

#include <algorithm>

namespace mrsim {
namespace {

using C = Code;
using G = Group;

struct NamedRow {
  std::string_view name;
  Code code;
  Group group;
};

constexpr NamedRow kFunctions[] = {
    {"CIP", C::arc_point, G::motion},
    {"CT", C::arc_tangent, G::motion},
    {"TRANS", C::trans, G::frame},
    {"ATRANS", C::atrans, G::frame},
    {"ROT", C::rot, G::frame},
    {"AROT", C::arot, G::frame},
    {"SCALE", C::scale, G::frame},
    {"ASCALE", C::ascale, G::frame},
    {"MIRROR", C::mirror, G::frame},
    {"AMIRROR", C::amirror, G::frame},
    {"SUPA", C::suppress_frames, G::suppress},
    {"DIAMON", C::diameter_on, G::diameter},
    {"DIAMOF", C::diameter_off, G::diameter},
    {"DIAM90", C::diameter_absolute, G::diameter},
    {"DIAMCYCOF", C::diameter_cycles_off, G::diameter},
    {"NORM", C::approach_normal, G::approach},
    {"KONT", C::approach_contour, G::approach},
    {"KONTC", C::approach_normal, G::approach},
    {"KONTT", C::approach_normal, G::approach},
    {"CUTCONON", C::comp_suspend, G::suspend},
    {"CUTCONOF", C::comp_resume, G::suspend},
    {"RET", C::program_return, G::none},
    {"PROC", C::header, G::none},
    {"BRISK", C::ignored, G::acceleration},
    {"SOFT", C::ignored, G::acceleration},
    {"DRIVE", C::ignored, G::acceleration},
    {"FFWON", C::ignored, G::feed_forward},
    {"FFWOF", C::ignored, G::feed_forward},
    {"CFC", C::ignored, G::feed_reference},
    {"CFTCP", C::ignored, G::feed_reference},
    {"CFIN", C::ignored, G::feed_reference},
    {"CDON", C::ignored, G::bottleneck},
    {"CDOF", C::ignored, G::bottleneck},
    {"CDOF2", C::ignored, G::bottleneck},
    {"COMPOF", C::ignored, G::compressor},
    {"COMPON", C::ignored, G::compressor},
    {"COMPCURV", C::ignored, G::compressor},
    {"COMPCAD", C::ignored, G::compressor},
    {"CUT2D", C::ignored, G::comp_kind},
    {"CUT2DF", C::ignored, G::comp_kind},
    {"DIACYCOFA", C::ignored, G::other},
    {"TRAFOOF", C::ignored, G::other},
    {"STOPRE", C::ignored, G::other},
    {"SETMS", C::ignored, G::other},
    {"SPCON", C::ignored, G::other},
    {"SPCOF", C::ignored, G::other},
    {"FIFOCTRL", C::ignored, G::other},
    {"STARTFIFO", C::ignored, G::other},
    {"STOPFIFO", C::ignored, G::other},
    {"SAVE", C::ignored, G::other},
    {"SBLOF", C::ignored, G::other},
    {"SBLON", C::ignored, G::other},
    {"DISPLOF", C::ignored, G::other},
    {"DISPLON", C::ignored, G::other},
    {"UPATH", C::ignored, G::path_reference},
    {"SPATH", C::ignored, G::path_reference},
    {"FNORM", C::ignored, G::feed_profile},
    {"FLIN", C::ignored, G::feed_profile},
    {"RTLION", C::ignored, G::other},
    {"RTLIOF", C::ignored, G::other},
    {"ORIMKS", C::ignored, G::other},
    {"ORIWKS", C::ignored, G::other},
    {"ORIAXES", C::ignored, G::other},
    {"ORIVECT", C::ignored, G::other},
    {"ORIPLANE", C::ignored, G::other},
    {"ORIEULER", C::ignored, G::other},
    {"ORIRPY", C::ignored, G::other},
    {"ORIRPY2", C::ignored, G::other},
    {"ORIVIRT1", C::ignored, G::other},
    {"ORIVIRT2", C::ignored, G::other},
    {"ORID", C::ignored, G::other},
    {"OSOF", C::ignored, G::other},
    {"OSC", C::ignored, G::other},
    {"OSS", C::ignored, G::other},
    {"OSSE", C::ignored, G::other},
    {"OSD", C::ignored, G::other},
    {"OST", C::ignored, G::other},
    {"COMPSURF", C::ignored, G::compressor},
    {"COMPPATH", C::ignored, G::compressor},
    {"DYNNORM", C::ignored, G::other},
    {"DYNPOS", C::ignored, G::other},
    {"DYNROUGH", C::ignored, G::other},
    {"DYNSEMIFIN", C::ignored, G::other},
    {"DYNFINISH", C::ignored, G::other},
    {"DYNPREC", C::ignored, G::other},
    {"WALIMON", C::ignored, G::other},
    {"WALIMOF", C::ignored, G::other},
    {"LFON", C::ignored, G::other},
    {"LFOF", C::ignored, G::other},
    {"LFTXT", C::ignored, G::other},
    {"LFWP", C::ignored, G::other},
    {"LFPOS", C::ignored, G::other},
    {"CPRECON", C::ignored, G::other},
    {"CPRECOF", C::ignored, G::other},
    {"BNS", C::ignored, G::other},
    {"GWPSON", C::ignored, G::other},
    {"GWPSOF", C::ignored, G::other},
    {"PAROTOF", C::ignored, G::other},
    {"TOROTOF", C::ignored, G::other},
    {"FENDNORM", C::ignored, G::other},
    {"TOWSTD", C::ignored, G::other},
    {"TOWMCS", C::ignored, G::other},
    {"TOWWCS", C::ignored, G::other},
    {"TOWBCS", C::ignored, G::other},
    {"TOWTCS", C::ignored, G::other},
    {"TOWKCS", C::ignored, G::other},
    {"ORISON", C::ignored, G::other},
    {"ORISOF", C::ignored, G::other},
    {"STOPREOF", C::ignored, G::other},
    {"NEWCONF", C::ignored, G::other},
    {"IPTRLOCK", C::ignored, G::other},
    {"IPTRUNLOCK", C::ignored, G::other},
    {"FTOCOF", C::ignored, G::other},
    {"FPRAOF", C::ignored, G::other},
    {"CORROF", C::ignored, G::other},
    {"WAITS", C::ignored, G::other},
    {"TCOABS", C::ignored, G::other},
    {"TCOFR", C::ignored, G::other},
    {"CP", C::ignored, G::other},
    {"PTPG0", C::ignored, G::other},
    {"DRFOF", C::ignored, G::other},
    {"ASPLINE", C::unsupported, G::motion},
    {"BSPLINE", C::unsupported, G::motion},
    {"CSPLINE", C::unsupported, G::motion},
    {"POLY", C::unsupported, G::motion},
    {"INVCW", C::unsupported, G::motion},
    {"INVCCW", C::unsupported, G::motion},
    {"ROTS", C::unsupported, G::frame},
    {"AROTS", C::unsupported, G::frame},
    {"CROTS", C::unsupported, G::frame},
    {"TOROT", C::unsupported, G::frame},
    {"TOFRAME", C::unsupported, G::frame},
    {"CUT3DC", C::unsupported, G::other},
    {"CUT3DF", C::unsupported, G::other},
    {"TRAORI", C::unsupported, G::other},
    {"TRANSMIT", C::unsupported, G::other},
    {"TRACYL", C::unsupported, G::other},
    {"TRAANG", C::unsupported, G::other},
    {"TRACON", C::unsupported, G::other},
    {"REPOSL", C::unsupported, G::motion},
};

// Cycles and calls whose values are read; the last ones measure.
constexpr std::string_view kReadCalls[] = {
    "WORKPIECE", "CYCLE81",  "CYCLE82",  "CYCLE83",  "CYCLE84",  "CYCLE85",  "CYCLE86",  "CYCLE87",
    "CYCLE88",   "CYCLE89",  "CYCLE840", "CYCLE800", "CYCLE801", "CYCLE802", "HOLES1",   "HOLES2",
    "POCKET1",   "POCKET2",  "POCKET3",  "POCKET4",  "SLOT1",    "SLOT2",    "LONGHOLE", "CYCLE60",
    "CYCLE61",   "CYCLE71",  "CYCLE76",  "CYCLE77",  "CYCLE899", "CYCLE90",  "CYCLE62",  "CYCLE63",
    "CYCLE72",   "CYCLE92",  "CYCLE93",  "CYCLE95",  "CYCLE951", "CYCLE952", "CYCLE97",  "CYCLE98",
    "CYCLE99",   "CYCLE971", "CYCLE973", "CYCLE974", "CYCLE976", "CYCLE977", "CYCLE978", "CYCLE979",
    "CYCLE982",  "CYCLE994", "CYCLE995", "CYCLE996", "CYCLE997", "CYCLE998"};

// Calls without effect on geometry. COUP... couples spindles to hand over a part.
constexpr std::string_view kHarmlessCalls[] = {
    "MSG",       "SETMS",  "FGROUP",  "CYCLE832", "WAITM",   "WAITP",    "WAITS",
    "INIT",      "START",  "CLRINT",  "SPCON",    "SPCOF",   "COMPLETE", "COUPON",
    "COUPONC",   "COUPOF", "COUPOFS", "COUPDEF",  "COUPDEL", "COUPRES",  "GROUP_BEGIN",
    "GROUP_END", "BRISKA", "SOFTA",   "DRIVEA",   "JERKA",   "CALLPATH", "GWPSON",
    "GWPSOF",    "CANCEL", "FPRAON",  "FPRAOF",   "FPR",     "CORROF",   "GROUP_ADDEND",
    "CLEARM",    "SETM",   "RELEASE", "GET",      "GETD",    "WRITE",    "DELETE",
    "SETPIECE",  "WAITMC", "NPROT",   "CPROT",    "MMC",     "WAITE",    "DISABLE",
    "ENABLE"};

// Cycles of SINUMERIK 802S and 802C, which read their values from R parameters.
constexpr std::string_view kCyclesOf802[] = {"LCYC60", "LCYC61",  "LCYC75", "LCYC82", "LCYC83",
                                             "LCYC84", "LCYC840", "LCYC85", "LCYC95", "LCYC97"};

struct UnsupportedName {
  std::string_view prefix;
  bool whole;  // the name alone is meant; else the name and a number
  std::string_view what;
};

constexpr UnsupportedName kUnsupported[] = {{"IF", true, "a condition"},
                                            {"ELSE", true, "a condition"},
                                            {"ENDIF", true, "a condition"},
                                            {"THEN", true, "a condition"},
                                            {"CASE", true, "a condition"},
                                            {"GOTO", true, "a jump"},
                                            {"GOTOF", true, "a jump"},
                                            {"GOTOB", true, "a jump"},
                                            {"GOTOC", true, "a jump"},
                                            {"REPEATB", true, "a loop"},
                                            {"WHILE", true, "a loop"},
                                            {"ENDWHILE", true, "a loop"},
                                            {"FOR", true, "a loop"},
                                            {"ENDFOR", true, "a loop"},
                                            {"TO", true, "a loop"},
                                            {"DO", true, "a loop"},
                                            {"END", true, "a loop"},
                                            {"REPEAT", true, "a loop"},
                                            {"UNTIL", true, "a loop"},
                                            {"LOOP", true, "a loop"},
                                            {"ENDLOOP", true, "a loop"},
                                            {"DEF", true, "a variable"},
                                            {"REDEF", true, "a variable"},
                                            {"EXTERN", true, "a declaration"},
                                            {"SETVN", true, "a variable"},
                                            {"MCALL", true, "a modal call"},
                                            {"CYCLE", false, "a canned cycle"},
                                            {"LCYC", false, "a canned cycle"},
                                            {"HOLES", false, "a canned cycle"},
                                            {"POCKET", false, "a canned cycle"},
                                            {"SLOT", false, "a canned cycle"},
                                            {"LONGHOLE", false, "a canned cycle"},
                                            {"WHEN", true, "a synchronised action"},
                                            {"WHENEVER", true, "a synchronised action"},
                                            {"EVERY", true, "a synchronised action"},
                                            {"ID", true, "a synchronised action"},
                                            {"IDS", true, "a synchronised action"},
                                            {"SETINT", true, "an interrupt routine"},
                                            {"POPEN", true, "an output command"},
                                            {"DPRNT", true, "an output command"},
                                            {"ISOCALL", true, "a call in ISO mode"}};

}  // namespace

std::span<const std::string_view> read_calls() { return kReadCalls; }

std::span<const std::string_view> cycles_of_802() { return kCyclesOf802; }

std::span<const std::string_view> harmless_calls() { return kHarmlessCalls; }

bool is_built_in_call(std::string_view name) {
  const auto among = [&](std::span<const std::string_view> names) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  return among(kReadCalls) || among(kHarmlessCalls);
}

CodeEntry find_function(std::string_view name) {
  for (const NamedRow& row : kFunctions)
    if (row.name == name) return {row.code, row.group, 0};
  return {};
}

std::vector<std::pair<std::string_view, CodeEntry>> function_names() {
  std::vector<std::pair<std::string_view, CodeEntry>> all;
  for (const NamedRow& row : kFunctions)
    all.emplace_back(row.name, CodeEntry{row.code, row.group, 0});
  return all;
}

std::string_view unsupported_name(std::string_view name) {
  for (const UnsupportedName& entry : kUnsupported) {
    if (entry.whole && name == entry.prefix) return entry.what;
    if (entry.whole || !name.starts_with(entry.prefix) || name.size() == entry.prefix.size())
      continue;
    if (name.find_first_not_of("0123456789", entry.prefix.size()) == std::string_view::npos)
      return entry.what;
  }
  return {};
}

}  // namespace mrsim
