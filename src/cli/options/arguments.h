// The command line as values.
#pragma once

#include "cli/options/compare_request.h"
#include "cli/options/job_places.h"
#include <mrsim/mrsim.h>

#include <string>
#include <vector>

namespace mrsim::cli {

enum class Command { simulate, trace, check, render, help, version };

struct Arguments {
  Command command = Command::simulate;
  std::string help;  ///< text for Command::help

  std::string input;                    ///< the program, or the part that render draws
  std::vector<std::string> inputs;      ///< check: programs and folders
  InterpOptions interp;                 ///< with the tools of --tools and --tool
  std::vector<std::string> outputs;     ///< -o
  std::vector<NamedPath> named_inputs;  ///< files read besides `input` and `stock`
  JobPlaces job;                        ///< the job that these are from, if any
  std::string stock;
  StockOptions stock_options;
  CarveOptions carve;
  MeshOptions mesh;
  MeshFileOptions files;
  KeepPieces keep = KeepPieces::all;
  std::size_t max_triangles = 0;
  std::string until;              ///< as Job::until
  int frames = 0;                 ///< --frames; 0 = the part at the end alone
  bool frames_by_volume = false;  ///< --frames-by: equal shares of the volume, not of the time
  std::string history;            ///< --history: a file, "off" or empty
  std::string rest;               ///< --rest: a file, or empty
  MachineData machine;            ///< of --machine-file
  RenderOptions render;
  CompareRequest compare;  ///< of the part just cut, when it names a nominal
  bool quiet = false, verbose = false, strict = false, json = false;
};

/// Reads the command line. Throws Error of kind usage for anything it does not understand, with the
/// word that was probably meant, and what reading --tools throws. `refused`, where given, then
/// holds the files that were named, so that the refusal can be written to them.
Arguments parse_arguments(int argc, const char* const* argv, Arguments* refused = nullptr);

}  // namespace mrsim::cli
