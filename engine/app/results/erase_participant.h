#pragma once
// What --delete-participant does: every file and every row that is known of a participant goes.

#include <string>

#include "engine/session/store.h"

namespace fulcrum::app {

struct Erased {
  std::size_t trials = 0, files = 0;
  bool whole = true;  // false: something of theirs is left, and sentences on stderr said what and why
  bool still_read =
      false;  // another program reads the results: their log holds what was deleted until it ends
};

// Of a trial's folder go the files that a run writes, and the folder where nothing else lies in it; a folder
// that holds another trial by now stays. Errors: of the store; rows are removed after files, so that a second
// try finds what a first could not remove.
Result<Erased> erase_participant(session::Store& store, const std::string& participant);

}  // namespace fulcrum::app
