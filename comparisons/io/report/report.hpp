#pragma once

#include <string>
#include <variant>
#include <vector>

#include "comparisons/io/report/animation.hpp"
#include "comparisons/io/report/figure.hpp"
#include "comparisons/io/report/matrix.hpp"
#include "comparisons/io/report/table.hpp"

/// Plain records of a report. All text is plain text: whatever it holds, markup
/// included, is shown as it stands.
namespace rebound::report {

struct Paragraph {
  std::string text;
};

/// A sentence that must not be overlooked. An abstention ("not decided by these
/// data") has the rank of a finding.
struct Notice {
  enum class Level { finding, abstention, warning, failure } level = Level::warning;
  std::string text;
  std::string evidence = {};  ///< what it rests on, in the same box; may be empty
};

/// Text that is typed somewhere or hashed, e.g. a command; shown as it stands.
struct Verbatim {
  std::string title;
  std::string text;
};

/// What is shown for one chosen cell: figures side by side, then tables.
struct Overlay {
  std::string key;    ///< unique in its block, e.g. "A/15"
  std::string title;  ///< e.g. "Core A at 15 m/s"
  std::string note;   ///< may be empty
  std::vector<Figure> figures;
  std::vector<Table> tables;
};

/// A place on the page that shows one overlay at a time.
struct Overlays {
  std::string id;      ///< matrices name it
  std::string chosen;  ///< key of the overlay shown first
  std::vector<Overlay> items;
};

using Block = std::variant<Paragraph, Notice, Verbatim, Table, Figure, Animation, Matrix, Overlays>;

/// One question and its answer. What only some readers want stands folded behind it.
struct Section {
  enum class Folding { open, folded };
  std::string title;
  Folding folding = Folding::open;
  std::vector<Block> blocks;
  std::vector<Block> details = {};  ///< after the blocks, folded under "Details"
};

struct Report {
  std::string title;
  std::string subtitle;          ///< e.g. which study on which data; may be empty
  std::string question = {};     ///< what the report answers; may be empty
  std::string headline;          ///< the sentence, or the three, that a reader takes away
  std::vector<Block> lead = {};  ///< the picture or table that belongs on the first screen
  std::vector<Notice> notices;
  std::vector<Section> sections;
};

}  // namespace rebound::report
