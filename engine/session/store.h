#pragma once
// Results over days and people: participants, their sessions and trials, in one SQLite file beside the
// recordings. A trial is there whole or not at all, whenever the program is killed; several programs may use
// the file at a time. What is known of people is in this file and in the folders of their trials alone.

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/session/trial.h"
#include "haptics/math/result.h"

namespace fulcrum::session {

struct Participant {
  std::string name;
  bool consents = false;  // to results being sent to others
  std::string since;      // UTC
  std::int64_t trials = 0;
};

struct StoredTrial {
  Trial trial;
  Session session;
};

// What is not named is not asked for.
struct Filter {
  std::string participant{}, scenario{};
};

class Store {
public:
  // $XDG_DATA_HOME/fulcrum/results.sqlite, or ~/.local/share/fulcrum/results.sqlite.
  static Result<std::filesystem::path> default_file();

  // The file is made where it is missing, for nobody but its owner to read. Of an older version, it becomes
  // one of this; of a newer one, it is refused.
  static Result<Store> open(const std::filesystem::path& file);

  Store(Store&&) noexcept;
  Store& operator=(Store&&) noexcept;
  ~Store();

  // With its session and its participant, where they are not there yet; on disk when this returns.
  std::optional<Error> add(const Session& session, const Trial& trial);

  Result<std::vector<Participant>> participants() const;
  Result<std::vector<StoredTrial>> trials(const Filter& filter) const;  // by the time at which they began
  // Of the participant in that scenario, among whole trials of the task as it is, without guidance; none:
  // there is none.
  Result<std::optional<double>> best_score(const std::string& participant, const std::string& scenario) const;

  // Whether there is such a participant.
  Result<bool> set_consent(const std::string& participant, bool consents);

  // The trials of participants who consent, that came to an end, of the task as it is, without guidance, and
  // that this address has not been sent yet.
  Result<std::vector<StoredTrial>> unsent(const std::string& url) const;
  // Whether it is still to be sent: asked again before each, since somebody may withdraw meanwhile.
  Result<bool> may_send(const std::string& trial_uuid, const std::string& url) const;
  std::optional<Error> mark_sent(const std::string& trial_uuid, const std::string& url,
                                 const std::string& at);

  // The participant and all of their rows, overwritten in the file.
  enum class Removal {
    done,
    still_read,   // done, but another program reads the file: until it ends, the log of writes holds them
    more_trials,  // nothing is removed: there are trials beyond those named, which ended meanwhile
  };
  Result<Removal> remove_participant(const std::string& participant,
                                     const std::vector<std::string>& trial_uuids);

private:
  class Implementation;
  explicit Store(std::unique_ptr<Implementation> implementation);

  std::unique_ptr<Implementation> implementation_;
};

}  // namespace fulcrum::session
