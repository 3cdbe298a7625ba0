// G60, G62, G63 and G64 of Fagor's 8055 run the cycle in force at more places: in a line, in a
// grid, on a circle, on an arc. Private to src/interp.
#pragma once

#include "interp/control/control.h"

namespace mrsim {

class FagorPlaces : public ControlPart {
 public:
  explicit FagorPlaces(Control& control) : ControlPart(control) {}

  static bool knows(int g) { return g == 60 || (g >= 62 && g <= 64); }
  /// Called before the words are indexed. Fills BlockWords::places with the places that follow the
  /// current one, and removes the words. False: an error was reported.
  bool read(Word& word);

 private:
  /// A row of places, with the first one.
  struct Row {
    long number = 0;
    double step = 0;
  };

  bool row(char whole, char step, char number, bool lengths, Row& out);
  bool line(bool grid);
  bool circle(bool arc);
  bool take_number(char letter, bool is_length, double& out);
  void add(double along, double across);

  const Word* where_ = nullptr;
};

}  // namespace mrsim
