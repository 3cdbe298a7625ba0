// The lists of values of SINUMERIK's cycles: which value stands where. docs/sinumerik_cycles.md
// says where each list comes from. Private to src/interp.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace mrsim {

/// Names are those of the manuals, without a leading underscore. `$` marks a value that may be a
/// text. Values behind the last name are not read.
struct CycleList {
  std::string_view cycle, values;
};

inline constexpr CycleList kCycleLists[] = {
    {"CYCLE60",
     "TEXT$ RTP RFP SDIS DP DPR PA PO STA CP1 CP2 WID DF FFD FFP1 VARI CODEP UMODE "
     "GMODE DMODE AMODE"},
    {"CYCLE61", "RTP RFP SDIS DP PA PO LENG WID MID MIDA FALD FFP1 VARI LIM DMODE AMODE"},
    {"CYCLE62", "NAME$ KIND$ LAB1$ LAB2$"},
    {"CYCLE63",
     "PRG$ VARI RP Z0 SC Z1 F FZ DXY DZ UXY UZ CDIR XS YS ER EP EW FS ZFS TR DR "
     "UMODE GMODE DMODE AMODE"},
    {"CYCLE71", "RTP RFP SDIS DP PA PO LENG WID STA MID MIDA FDP FALD FFP1 VARI FDP1"},
    {"CYCLE72",
     "KNAME$ RTP RFP SDIS DP MID FAL FALD FFP1 FFD VARI RL AS1 LP1 FF3 AS2 LP2 UMODE "
     "FS ZFS GMODE DMODE AMODE"},
    {"CYCLE76",
     "RTP RFP SDIS DP DPR LENG WID CRAD PA PO STA MID FAL FALD FFP1 FFD CDIR VARI "
     "AP1 AP2 FS ZFS GMODE DMODE AMODE"},
    {"CYCLE77",
     "RTP RFP SDIS DP DPR CDIAM PA PO MID FAL FALD FFP1 FFD CDIR VARI AP1 FS ZFS "
     "GMODE DMODE AMODE"},
    {"CYCLE81", "RTP RFP SDIS DP DPR DTB GMODE DMODE AMODE"},
    {"CYCLE82", "RTP RFP SDIS DP DPR DTB GMODE DMODE AMODE"},
    {"CYCLE83",
     "RTP RFP SDIS DP DPR FDEP FDPR DAM DTB DTS FRF VARI AXN MDEP VRT DTD DIS1 GMODE "
     "DMODE AMODE FFR"},
    {"CYCLE84",
     "RTP RFP SDIS DP DPR DTB SDAC MPIT PIT POSS SST SST1 AXN PITA TECHNO VARI DAM "
     "VRT PITM$ PTAB$ PTABA$ GMODE DMODE AMODE"},
    {"CYCLE85", "RTP RFP SDIS DP DPR DTB FFR RFF GMODE DMODE AMODE"},
    {"CYCLE86", "RTP RFP SDIS DP DPR DTB SDIR RPA RPO RPAP POSS GMODE DMODE AMODE"},
    {"CYCLE87", "RTP RFP SDIS DP DPR SDIR"},
    {"CYCLE88", "RTP RFP SDIS DP DPR DTB SDIR"},
    {"CYCLE89", "RTP RFP SDIS DP DPR DTB"},
    {"CYCLE90", "RTP RFP SDIS DP DPR DIATH KDIAM PIT FFR CDIR TYPTH CPA CPO"},
    {"CYCLE92", "SPD SPL DIAG1 DIAG2 RC SDIS SV1 SV2 SDAC FF1 FF2 SS2 DIAGM VARI DN DMODE AMODE"},
    {"CYCLE93",
     "SPD SPL WIDG DIAG STA1 ANG1 ANG2 RCO1 RCO2 RCI1 RCI2 FAL1 FAL2 IDEP DTB VARI "
     "VRT DN"},
    {"CYCLE95", "NPP$ MID FALZ FALX FAL FF1 FF2 FF3 VARI DT DAM VRT"},
    {"CYCLE97", "PIT MPIT SPL FPL DM1 DM2 APP ROP TDEP FAL IANG NSP NRC NID VARI NUMT VRT"},
    {"CYCLE98",
     "PO1 DM1 PO2 DM2 PO3 DM3 PO4 DM4 APP ROP TDEP FAL IANG NSP NRC NID PP1 PP2 PP3 "
     "VARI NUMT VRT"},
    {"CYCLE99",
     "SPL SPD FPL FPD APP ROP TDEP FAL IANG NSP NRC NID PIT VARI NUMTH SDIS MID GDEP "
     "PIT1 FDEP GST GUD IFLANK PITA PITM$ PTAB$ PTABA$ DMODE AMODE"},
    {"CYCLE800", "FR TC$ ST MODE X0 Y0 Z0 A B C X1 Y1 Z1"},
    {"CYCLE801", "SPCA SPCO STA DIS1 DIS2 NUM1 NUM2 VARI UMODE ANG1 ANG2 HIDE$"},
    {"CYCLE802", "XA YA X0 Y0 X1 Y1 X2 Y2 X3 Y3 X4 Y4 X5 Y5 X6 Y6 X7 Y7 X8 Y8"},
    {"CYCLE840",
     "RTP RFP SDIS DP DPR DTB SDR SDAC ENC MPIT PIT AXN PITA TECHNO PITM$ PTAB$ PTABA$ "
     "GMODE DMODE AMODE"},
    {"CYCLE899",
     "RTP RFP SDIS DP LENG WID PA PO STA MID MIDA FAL FALD FFP1 CDIR VARI GMODE "
     "DMODE AMODE"},
    {"CYCLE951",
     "SPD SPL EPD EPL ZPD ZPL LAGE MID FALX FALZ VARI RF1 RF2 RF3 SDIS FF1 NR DMODE "
     "AMODE"},
    {"CYCLE952",
     "PRG$ CON$ CONR$ VARI F FR RP D DX DZ UX UZ U U1 BL XD ZD XA ZA XB ZB XDA XDB N "
     "DP DI SC DN GMODE DMODE AMODE PK DCH FS"},
    {"HOLES1", "SPCA SPCO STA1 FDIS DBH NUM VARI UMODE HIDE$"},
    {"HOLES2", "CPA CPO RAD STA1 INDA NUM VARI UMODE HIDE$"},
    {"LONGHOLE",
     "RTP RFP SDIS DP DPR NUM LENG CPA CPO RAD STA1 INDA FFD FFP1 MID VARI UMODE "
     "GMODE DMODE AMODE"},
    {"POCKET1",
     "RTP RFP SDIS DP DPR LENG WID CRAD CPA CPO STA1 FFD FFP1 MID CDIR FAL VARI MIDF "
     "FFP2 SSF"},
    {"POCKET2", "RTP RFP SDIS DP DPR PRAD CPA CPO FFD FFP1 MID CDIR FAL VARI MIDF FFP2 SSF"},
    {"POCKET3",
     "RTP RFP SDIS DP LENG WID CRAD PA PO STA MID FAL FALD FFP1 FFD CDIR VARI MIDA "
     "AP1 AP2 AD RAD1 DP1 UMODE FS ZFS GMODE DMODE AMODE"},
    {"POCKET4",
     "RTP RFP SDIS DP PRAD PA PO MID FAL FALD FFP1 FFD CDIR VARI MIDA AP1 AD RAD1 "
     "DP1 UMODE FS ZFS GMODE DMODE AMODE"},
    {"SLOT1",
     "RTP RFP SDIS DP DPR NUM LENG WID CPA CPO RAD STA1 INDA FFD FFP1 MID CDIR FAL "
     "VARI MIDF FFP2 SSF FALD STA2 DP1 UMODE FS ZFS GMODE DMODE AMODE"},
    {"SLOT2",
     "RTP RFP SDIS DP DPR NUM AFSL WID CPA CPO RAD STA1 INDA FFD FFP1 MID CDIR FAL "
     "VARI MIDF FFP2 SSF FFCP UMODE FS ZFS GMODE DMODE AMODE"},
};

/// Removes the next name from a list and returns it. `text`: its value may be a text.
constexpr std::string_view next_value_name(std::string_view& list, bool& text) {
  const std::size_t end = list.find(' ');
  std::string_view name = list.substr(0, end);
  list = end == std::string_view::npos ? std::string_view() : list.substr(end + 1);
  text = name.ends_with('$');
  if (text) name.remove_suffix(1);
  return name;
}

/// The place of a value in a list. Nothing: the list has no value of this name.
constexpr std::optional<std::size_t> place_in_list(std::string_view list, std::string_view name) {
  bool text = false;
  for (std::size_t i = 0; !list.empty(); ++i)
    if (next_value_name(list, text) == name) return i;
  return std::nullopt;
}

constexpr bool is_value_name(std::string_view name) {
  for (const CycleList& row : kCycleLists)
    if (place_in_list(row.values, name)) return true;
  return false;
}

/// The name of a value in any list. A name that is in none does not compile.
class ValueName {
 public:
  template <std::size_t N>
  consteval ValueName(const char (&name)[N]) : text_(name, N - 1) {
    if (!is_value_name(text_)) throw "no list has a value of this name";
  }
  constexpr std::string_view text() const { return text_; }

 private:
  std::string_view text_;
};

/// The list of a cycle; empty: it is not known.
constexpr std::string_view list_of_cycle(std::string_view cycle) {
  for (const CycleList& row : kCycleLists)
    if (row.cycle == cycle) return row.values;
  return {};
}

}  // namespace mrsim
