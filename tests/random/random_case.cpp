#include "random_case.hpp"

#include <fmt/format.h>

#include <array>
#include <vector>

#include "flow_map.hpp"
#include "quantities.hpp"
#include "random_ground.hpp"
#include "random_soil.hpp"
#include "random_water.hpp"

namespace slope::random_cases {

namespace {

enum class Scheme { coupled, rigid, alone, as_printed };

/// Writes a case section by section.
class CaseText {
 public:
  CaseText(std::uint64_t seed, std::uint64_t number) : random_(seed, number) {
    line("title", fmt::format("\"Random case {} of seed {}\"", number, seed));
  }

  RandomCase write() {
    choose_frame();
    write_domain();
    write_walls();
    write_soils();
    write_water();
    write_forces();
    write_numerics();
    write_end();
    case_.yaml = text_;
    return case_;
  }

 private:
  void line(const std::string& key, const std::string& value) { text_ += key + ": " + value + "\n"; }
  void line(const std::string& key, const FlowMap& value) {
    if (!value.empty()) line(key, value.text());
  }
  std::string point_text(const couple::Point& point) {
    std::string text = "[" + length_text(random_, frame_.left + point[0]) + ", ";
    return text + length_text(random_, frame_.bottom + point[1]) + "]";
  }
  std::string polygon_text(const std::vector<couple::Point>& polygon) {
    std::string text;
    for (const couple::Point& point : polygon) text += (text.empty() ? "" : ", ") + point_text(point);
    return "[" + text + "]";
  }

  void choose_frame() {
    frame_.ground = random_ground(random_);
    case_.ground = frame_.ground.word;
    if (random_.chance(0.3)) {
      frame_.left = frame_.ground.cell * random_.whole(-50, 50);
      frame_.bottom = frame_.ground.cell * random_.whole(-20, 500);
    }
    constexpr std::array schemes{Scheme::coupled, Scheme::rigid, Scheme::alone, Scheme::as_printed};
    scheme_ = schemes[random_.index({0.52, 0.12, 0.28, 0.08})];
    frame_.water_alone = scheme_ == Scheme::alone;
    real_time_ = scheme_ == Scheme::coupled && random_.chance(0.1);
    frame_.duration = scheme_ == Scheme::alone        ? random_.logarithmic(600.0, 1.0e6)
                      : scheme_ == Scheme::as_printed ? random_.logarithmic(0.02, 0.3)
                      : real_time_                    ? random_.logarithmic(0.5, 5.0)
                                                      : random_.logarithmic(30.0, 1.0e5);
  }

  void write_domain() {
    const RandomGround& ground = frame_.ground;
    FlowMap domain;
    domain.add("lower", point_text({0.0, 0.0}))
        .add("upper", point_text({ground.width, ground.height}))
        .add("cell_size", length_text(random_, ground.cell))
        .add("particles_per_cell", std::to_string(ground.particles_per_cell));
    if (random_.chance(0.3)) domain.add("surface_particles", random_.one_of({"lattice", "clipped"}));
    line("domain", domain);
  }

  void write_walls() {
    FlowMap walls;
    bool absorbs = false;
    for (const char* side : {"left", "right", "base"}) {
      const bool base = side == std::string("base");
      const auto kind = random_.index({base ? 0.1 : 0.7, base ? 0.7 : 0.13, 0.1, 0.07});
      walls.add(side, std::array{"roller", "fixed", "friction", "absorbing"}[kind]);
      if (kind == 2) walls.add(std::string(side) + "_friction", share_text(random_, random_.uniform(0.1, 0.8)));
      absorbs = absorbs || kind == 3;
    }
    if (absorbs) walls.add("absorbing_depth", length_text(random_, random_.uniform(2.0, 50.0)));
    line("walls", walls);
  }

  void write_soils() {
    const bool elastic = random_.chance(0.12);
    const int count = 1 + static_cast<int>(random_.index({0.4, 0.4, 0.2}));
    std::string regions;
    text_ += "soils:\n";
    for (int i = 0; i < count; ++i) {
      const RandomSoil soil = random_soil(random_, "soil" + std::to_string(i), elastic);
      text_ += soil.yaml;
      FlowMap region;
      region.add("soil", soil.name);
      if (i == 0) {
        add_ground(region);
      } else {
        const RandomRegion inside =
            random_.chance(0.6) ? random_layer(random_, frame_.ground) : random_lens(random_, frame_.ground);
        region.add("polygon", polygon_text(inside.polygon));
        case_.ground += " + " + inside.word;
      }
      regions += "  - " + region.text() + "\n";
      case_.soils += (i > 0 ? " + " : "") + soil.words;
    }
    text_ += "geometry:\n" + regions;
  }

  void add_ground(FlowMap& region) {
    const RandomGround& ground = frame_.ground;
    if (random_.chance(0.15)) {
      std::string& table = case_.tables["ground.csv"];
      table = "x_m,y_m\n";
      for (const couple::Point& point : ground.line)
        table += fmt::format("{:.7g},{:.7g}\n", frame_.left + point[0], frame_.bottom + point[1]);
      region.add("surface", "{file: ground.csv}");
      return;
    }
    std::vector<couple::Point> outline{{0.0, 0.0}, {ground.width, 0.0}};
    outline.insert(outline.end(), ground.line.rbegin(), ground.line.rend());
    region.add("polygon", polygon_text(outline));
  }

  void write_water() {
    const RandomWater water = random_water(random_, frame_);
    case_.tables.insert(water.tables.begin(), water.tables.end());
    case_.water = water.initial_word;
    case_.conditions = water.boundary_words;
    FlowMap initial;
    initial.add("water", water.initial);
    const std::size_t stress = random_.index({0.8, 0.14, 0.06});
    if (stress == 1) {
      initial.add("stress", "k0").add("k0_coefficient", share_text(random_, random_.uniform(0.3, 1.0)));
    } else if (stress == 2) {
      initial.add("stress", "none");
    }
    line("initial", initial);
    if (!water.boundaries.empty()) text_ += "water_boundaries:\n" + water.boundaries;
  }

  void write_forces() {
    if (frame_.water_alone) return;
    if (random_.chance(0.1)) {
      FlowMap load;
      load.add("name", "fill").add("at", "ground_surface");
      std::string traction = "[" + pressure_text(random_, random_.chance(0.8) ? 0.0 : random_.uniform(-2e3, 2e3));
      traction += ", " + pressure_text(random_, -random_.logarithmic(500.0, 2.0e4)) + "]";
      load.add("traction", traction).add("ramp", time_text(random_, random_.uniform(0.0, 0.5) * frame_.duration));
      line("loads", "[" + load.text() + "]");
      case_.conditions += " + load";
    }
    if (random_.chance(0.08)) {
      FlowMap seismic;
      seismic.add("horizontal_coefficient", fmt::format("{:.3g}", random_.uniform(-0.2, 0.2)));
      if (random_.chance(0.3)) seismic.add("vertical_coefficient", fmt::format("{:.3g}", random_.uniform(-0.1, 0.1)));
      if (random_.chance(0.5)) {
        seismic.add("start", time_text(random_, random_.uniform(0.0, 0.5) * frame_.duration));
        seismic.add("ramp", time_text(random_, random_.uniform(0.0, 0.3) * frame_.duration));
      }
      line("seismic", seismic);
      case_.conditions += " + earthquake";
    }
  }

  void write_numerics() {
    FlowMap coupling, numerics, clock;
    case_.scheme = std::array{"coupled", "rigid", "water alone", "as printed"}[static_cast<std::size_t>(scheme_)];
    if (scheme_ == Scheme::alone) coupling.add("scheme", "seepage");
    if (scheme_ == Scheme::as_printed) coupling.add("scheme", "explicit");
    if (scheme_ == Scheme::rigid) coupling.add("skeleton", "rigid");
    if (random_.chance(0.1)) coupling.add("mixture_density", "saturated");
    line("coupling", coupling);
    if (random_.chance(0.12)) numerics.add("shape_function", "linear");
    if (random_.chance(0.1)) numerics.add("flip_fraction", fmt::format("{:.3g}", random_.uniform(0.0, 1.0)));
    if (random_.chance(0.1)) numerics.add("courant_number", fmt::format("{:.3g}", random_.uniform(0.2, 0.8)));
    if (random_.chance(0.1)) numerics.add("pressure_tolerance", fmt::format("{:.3g}", random_.logarithmic(1e-3, 0.2)));
    if (random_.chance(0.15)) numerics.add("smoothing_length", fmt::format("{:.3g}", random_.uniform(1.0, 1.8)));
    line("numerics", numerics);
    if (real_time_) clock.add("adaptive", "false");
    if (random_.chance(0.1)) clock.add("maximum_factor", fmt::format("{:.3g}", random_.logarithmic(2.0, 1.0e5)));
    line("clock", clock);
  }

  void write_end() {
    FlowMap failure, stop, output;
    if (random_.chance(0.2)) failure.add("onset", "runaway");
    if (random_.chance(0.2)) failure.add("onset_displacement", length_text(random_, random_.logarithmic(0.003, 0.1)));
    line("failure", failure);
    stop.add("time", time_text(random_, frame_.duration));
    if (random_.chance(0.7)) stop.add("displacement", length_text(random_, random_.logarithmic(0.05, 0.5)));
    if (random_.chance(0.15)) stop.add("after_onset", time_text(random_, random_.uniform(0.0, 0.5) * frame_.duration));
    if (random_.chance(0.15)) stop.add("at_rest", "true");
    line("stop", stop);
    const double interval = frame_.duration / random_.whole(10, 40);
    line("output", output.add("history_interval", time_text(random_, interval)));
    const double x = random_.uniform(0.1, 0.9) * frame_.ground.width;
    line("points", FlowMap().add("ground", point_text({x, frame_.ground.height_at(x)})));
  }

  RandomNumbers random_;
  RandomCase case_;
  std::string text_;
  Frame frame_;
  Scheme scheme_ = Scheme::coupled;
  bool real_time_ = false;
};

}  // namespace

RandomCase random_case(std::uint64_t seed, std::uint64_t number) {
  return CaseText(seed, number).write();
}

}  // namespace slope::random_cases
