#include "random_water.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <vector>

#include "flow_map.hpp"
#include "quantities.hpp"

namespace slope::random_cases {

namespace {

constexpr double mm_per_h = 0.001 / 3600.0, mm_per_d = 0.001 / 86400.0;

/// What has been chosen so far.
class Waters {
 public:
  Waters(RandomNumbers& random, const Frame& frame) : random_(random), frame_(frame), ground_(frame.ground) {}

  RandomWater choose() {
    steady_ = random_.chance(0.15);
    if (!steady_ && random_.chance(0.2)) stand_reservoirs();
    if (steady_ || random_.chance(0.2)) hold_sides();
    treat_surface();
    if (!steady_) treat_base();
    begin();
    return water_;
  }

 private:
  std::string x_text(double x) { return length_text(random_, frame_.left + x); }
  std::string y_text(double y) { return length_text(random_, frame_.bottom + y); }

  void add(const std::string& word, const FlowMap& boundary) {
    water_.boundaries += fmt::format("  - {}\n", boundary.text());
    water_.boundary_words += (water_.boundary_words.empty() ? "" : " + ") + word;
  }

  /// One value, or points in time between two values.
  std::string series(double from, double to, const std::function<std::string(double)>& text) {
    if (random_.chance(0.5)) return text(from);
    const double begin = random_.uniform(0.0, 0.3), end = random_.uniform(0.5, 1.1);
    std::string points = "[[" + time_text(random_, begin * frame_.duration);
    points += ", " + text(from);
    points += "], [" + time_text(random_, end * frame_.duration);
    return points + ", " + text(to) + "]]";
  }

  void add_start(FlowMap& boundary) {
    if (random_.chance(0.3)) boundary.add("start", time_text(random_, random_.uniform(0.0, 0.3) * frame_.duration));
    if (random_.chance(0.6)) boundary.add("ramp", time_text(random_, random_.uniform(0.0, 0.2) * frame_.duration));
  }

  /// On the low side, or on both sides of an embankment, up to levels below the crest.
  void stand_reservoirs() {
    const double foot = ground_.low, rise = ground_.high - ground_.low;
    if (rise < 2.0 * ground_.cell) return;
    const auto level = [&] { return foot + random_.uniform(-0.5 * ground_.cell, 0.7 * rise); };
    const bool embankment = ground_.word == "embankment";
    const bool before = random_.chance(0.6);
    double from = level(), to = level();
    if (embankment) from = std::min(from, foot + 0.6 * rise), to = std::min(to, foot + 0.6 * rise);
    const auto text = [this](double y) { return y_text(y); };
    FlowMap first;
    first.add("name", "lake").add("at", "free_surface");
    if (embankment) {
      const double middle = 0.5 * (ground_.line[2][0] + ground_.line[3][0]), gap = 1.05 * ground_.cell;
      FlowMap second;
      second.add("name", "land").add("at", "free_surface").add("from", x_text(middle + gap));
      second.add("reservoir", FlowMap().add("level", y_text(before ? from : std::min(from, foot))).text());
      if (before) second.add("initial", "true");
      add("reservoir", second);
      first.add("to", x_text(middle - gap));
    }
    standing_ = before ? from : -1.0;
    first.add("reservoir", FlowMap().add("level", series(before ? from : std::min(from, foot), to, text)).text());
    if (before) first.add("initial", "true");
    add("reservoir", first);
    has_reservoir_ = true;
    if (before) table_ = from;
  }

  /// Heads on both sides or on one: a ditch, a hillside.
  void hold_sides() {
    const std::size_t which = random_.index({0.3, 0.3, 0.4});
    for (const bool left : {true, false}) {
      if (which == (left ? 1U : 0U)) continue;
      const double ground = ground_.height_at(left ? 0.0 : ground_.width);
      const double most = has_reservoir_ ? std::min(ground, std::max(standing_, ground_.low)) : ground;
      const double head = random_.uniform(ground_.cell, most), later = random_.uniform(ground_.cell, most);
      const auto text = [this](double y) { return y_text(y); };
      FlowMap boundary;
      boundary.add("name", left ? "left_side" : "right_side").add("at", left ? "left" : "right");
      // above the ground there are other outermost particles of a row: those of the face
      boundary.add("to", y_text(random_.chance(0.5) ? head : ground));
      boundary.add("total_head", series(head, later, text));
      if (random_.chance(0.2)) boundary.add("applied_to", "particle");
      if (steady_) {
        boundary.add("initial", "true");
      } else {
        add_start(boundary);
      }
      add("head at a side", boundary);
      if (random_.chance(0.6)) table_ = std::min(head, ground_.low);
    }
  }

  double intensity() {
    return random_.chance(0.15) ? -random_.uniform(0.5, 10.0) * mm_per_d : random_.logarithmic(0.3, 200.0) * mm_per_h;
  }

  /// Rows of a hyetograph: times (s), intensities (m/s).
  std::vector<couple::RainStep> storm() {
    std::vector<couple::RainStep> rows;
    const int count = random_.whole(2, 7);
    for (int i = 0; i < count; ++i) {
      const double time = frame_.duration * (i + (i > 0 ? random_.uniform(0.0, 0.9) : 0.0)) / count;
      rows.push_back({time, random_.chance(0.3) ? 0.0 : intensity()});
    }
    return rows;
  }

  std::string rain_text(std::string& word) {
    FlowMap rain;
    switch (random_.index({0.4, 0.3, 0.2, 0.1})) {
      case 0: {
        const double rate = intensity();
        rain.add("intensity", velocity_text(random_, rate));
        word = rate > 0.0 ? "rain" : "evaporation";
        break;
      }
      case 1: {
        std::string rows;
        for (const couple::RainStep& row : storm()) {
          rows += (rows.empty() ? "[" : ", [") + time_text(random_, row.time) + ", ";
          rows += velocity_text(random_, row.intensity) + "]";
        }
        rain.add("hyetograph", "[" + rows + "]");
        word = "hyetograph";
        break;
      }
      case 2: {
        std::string table = "time_h,intensity_mm_per_h\n";
        for (const couple::RainStep& row : storm())
          table += fmt::format("{:.7g},{:.5g}\n", row.time / 3600.0, row.intensity / mm_per_h);
        water_.tables["storm.csv"] = table;
        rain.add("file", "storm.csv").add("after_table", random_.one_of({"dry", "last_row"}));
        word = "storm";
        break;
      }
      default:
        rain.add("intensity", "0 mm/h");
        word = "seepage face";
    }
    if (random_.chance(0.25)) rain.add("ponding_depth", length_text(random_, random_.uniform(0.0, 0.05)));
    if (random_.chance(0.4)) rain.add("evaporation_limit", pressure_text(random_, random_.logarithmic(2.0e3, 5.0e5)));
    if (steady_) rain.add("before_start", velocity_text(random_, random_.uniform(0.0, 3.0) * mm_per_h));
    return rain.text();
  }

  void treat_surface() {
    const std::size_t kind = random_.index({0.72, 0.1, 0.08, 0.1});
    if (kind == 3 || (kind != 0 && has_reservoir_)) return;
    FlowMap boundary;
    if (kind == 0) {
      std::string word;
      const std::string rain = rain_text(word);
      boundary.add("name", "rain").add("at", "free_surface");
      if (random_.chance(0.15)) boundary.add("from", x_text(random_.uniform(0.1, 0.5) * ground_.width));
      if (steady_) boundary.add("initial", "true");
      if (random_.chance(0.2)) boundary.add("start", time_text(random_, random_.uniform(0.0, 0.5) * frame_.duration));
      add(word, boundary.add("rain", rain));
      return;
    }
    boundary.add("name", "ground").add("at", "ground_surface");
    if (kind == 1) {
      boundary.add("pressure", random_.chance(0.7) ? "0 kPa" : pressure_text(random_, -random_.uniform(0.0, 1.0e4)));
      if (random_.chance(0.3)) boundary.add("applied_to", "particle");
      add_start(boundary);
      add("pressure at the ground", boundary);
    } else {
      boundary.add("flux", velocity_text(random_, random_.logarithmic(0.1, 5.0) * mm_per_h));
      add_start(boundary);
      add("flux at the ground", boundary);
    }
  }

  void treat_base() {
    FlowMap boundary;
    boundary.add("name", "base").add("at", "base");
    switch (random_.index({0.7, 0.12, 0.1, 0.08})) {
      case 0:
        return;
      case 1:
        add("free drainage", boundary.add("free_drainage", "true"));
        return;
      case 2: {
        const double pressure = 9810.0 * random_.uniform(-0.5, 1.0) * ground_.low;
        const auto text = [this](double value) { return pressure_text(random_, value); };
        boundary.add("pressure", series(pressure, random_.uniform(0.3, 1.0) * pressure, text));
        add_start(boundary);
        add("pressure at the base", boundary);
        return;
      }
      default:
        boundary.add("flux", velocity_text(random_, random_.uniform(-1.0, 1.0) * mm_per_h));
        add_start(boundary);
        add("flux at the base", boundary);
    }
  }

  /// What the pores hold before the start: never above ground that no reservoir stands on.
  void begin() {
    if (steady_) {
      water_.initial =
          FlowMap().add("type", "steady").add("water_table", y_text(random_.uniform(0.0, ground_.low))).text();
      water_.initial_word = "steady";
      return;
    }
    const std::size_t kind = standing_ >= 0.0 ? 0 : random_.index({0.5, 0.25, 0.25});
    const bool capped = random_.chance(0.4);
    FlowMap initial;
    if (kind == 2) {
      initial.add("type", "uniform").add("pressure", pressure_text(random_, -random_.logarithmic(500.0, 6.0e4)));
      water_.initial_word = "uniform";
    } else if (kind == 1) {
      const double left = random_.uniform(-1.0, 1.0) * ground_.low, right = random_.uniform(-1.0, 1.0) * ground_.low;
      std::string points = "[[" + x_text(0.0);
      points += ", " + y_text(left);
      points += "], [" + x_text(ground_.width);
      points += ", " + y_text(right) + "]]";
      initial.add("type", "water_table").add("points", points);
      water_.initial_word = "inclined table";
    } else {
      const double level = table_ > 0.0 ? table_ : random_.uniform(-2.0, 1.0) * ground_.low;
      initial.add("type", "hydrostatic").add("water_table", y_text(level));
      water_.initial_word = "hydrostatic";
    }
    if (kind != 2 && capped) {
      initial.add("maximum_suction", pressure_text(random_, random_.logarithmic(500.0, 5.0e4)));
      water_.initial_word += " capped";
    }
    water_.initial = initial.text();
  }

  RandomNumbers& random_;
  const Frame& frame_;
  const RandomGround& ground_;
  RandomWater water_;
  bool steady_ = false, has_reservoir_ = false;
  double table_ = 0.0;      ///< y that the water table has to have (m); zero: any
  double standing_ = -1.0;  ///< y of the water that stands before the start (m); negative: none
};

}  // namespace

RandomWater random_water(RandomNumbers& random, const Frame& frame) {
  return Waters(random, frame).choose();
}

}  // namespace slope::random_cases
