#include "random_soil.hpp"

#include <fmt/format.h>

#include <utility>

#include "flow_map.hpp"
#include "quantities.hpp"

namespace slope::random_cases {

namespace {

struct Law {
  FlowMap yaml;
  std::string word;
};

std::string number_text(double value) {
  return fmt::format("{:.4g}", value);
}

void add_softening_strains(RandomNumbers& random, FlowMap& softening) {
  const double from = random.chance(0.3) ? 0.0 : random.uniform(0.001, 0.02);
  softening.add("from_plastic_strain", share_text(random, from))
      .add("to_plastic_strain", share_text(random, from + random.uniform(0.01, 0.2)));
  if (random.chance(0.3)) softening.add("characteristic_length", length_text(random, random.uniform(0.1, 1.0)));
}

Law frictional(RandomNumbers& random) {
  const bool mohr_coulomb = random.chance(0.4);
  const double cohesion = random.chance(0.1) ? 0.0 : random.logarithmic(100.0, 3.0e4);
  const double friction = random.chance(0.03) ? 0.0 : random.uniform(15.0, 42.0);
  const double most_dilatancy = friction * (random.chance(0.2) ? 0.99 : 0.4);
  FlowMap law;
  law.add("model", mohr_coulomb ? "mohr_coulomb" : "drucker_prager")
      .add("cohesion", pressure_text(random, cohesion))
      .add("friction_angle", angle_text(random, friction))
      .add("dilatancy_angle", angle_text(random, random.chance(0.6) ? 0.0 : random.uniform(0.0, most_dilatancy)));
  if (random.chance(0.6)) {
    law.add("maximum_cohesion_increase", pressure_text(random, random.uniform(0.0, 1.0e5)))
        .add("cohesion_suction_rate", number_text(random.uniform(0.0, 0.5)))
        .add("friction_angle_suction_rate", angle_text(random, random.chance(0.7) ? 0.0 : random.uniform(0.0, 5.0)));
  }
  const bool brittle = random.chance(0.2);
  if (brittle) {
    FlowMap softening;
    softening.add("residual_cohesion", pressure_text(random, cohesion * random.uniform(0.0, 0.99)))
        .add("residual_friction_angle", angle_text(random, friction * random.uniform(0.6, 0.99)));
    add_softening_strains(random, softening);
    law.add("softening", softening.text());
  }
  return {law, std::string(mohr_coulomb ? "mohr-coulomb" : "drucker-prager") + (brittle ? " brittle" : "")};
}

Law undrained(RandomNumbers& random) {
  const double strength = random.logarithmic(3.0e3, 1.0e5);
  FlowMap law;
  law.add("model", "von_mises").add("undrained_strength", pressure_text(random, strength));
  const bool brittle = random.chance(0.2);
  if (brittle) {
    FlowMap softening;
    softening.add("residual_undrained_strength", pressure_text(random, strength * random.uniform(0.2, 0.99)));
    add_softening_strains(random, softening);
    law.add("softening", softening.text());
  }
  return {law, brittle ? "von-mises brittle" : "von-mises"};
}

Law strength(RandomNumbers& random, bool elastic) {
  if (elastic || random.chance(0.1)) return {FlowMap().add("model", "elastic"), "elastic"};
  return random.chance(0.12) ? undrained(random) : frictional(random);
}

void add_saturations(RandomNumbers& random, FlowMap& retention) {
  retention.add("residual_saturation", share_text(random, random.chance(0.3) ? 0.0 : random.uniform(0.01, 0.35)))
      .add("maximum_saturation", share_text(random, random.chance(0.85) ? 1.0 : random.uniform(0.85, 1.0)));
}

Law van_genuchten(RandomNumbers& random) {
  FlowMap retention;
  const double n = random.chance(0.2) ? random.uniform(1.08, 1.4) : random.uniform(1.4, 4.0);
  retention.add("model", "van_genuchten")
      .add("alpha", inverse_length_text(random, random.logarithmic(0.05, 15.0)))
      .add("n", number_text(n));
  // as the README says of n near 1
  if (n < 1.4 || random.chance(0.1)) retention.add("air_entry", length_text(random, random.uniform(0.01, 0.03)));
  add_saturations(random, retention);
  return {retention, "van-genuchten"};
}

Law other_retention(RandomNumbers& random) {
  FlowMap retention;
  if (random.chance(0.4)) {
    retention.add("model", "liakopoulos")
        .add("coefficient", number_text(random.uniform(0.05, 0.15)))
        .add("exponent", number_text(random.uniform(1.8, 2.8)))
        .add("floor", number_text(random.uniform(0.05, 0.3)));
    return {retention, "liakopoulos"};
  }
  retention.add("model", "exponential").add("alpha", inverse_length_text(random, random.logarithmic(0.1, 8.0)));
  add_saturations(random, retention);
  return {retention, "exponential"};
}

Law permeability(RandomNumbers& random, bool mualem) {
  Law law;
  if (mualem) {
    law = {FlowMap().add("model", "van_genuchten_mualem"), "mualem"};
  } else if (random.chance(0.5)) {
    law = {FlowMap().add("model", "hillel").add("exponent", number_text(random.uniform(1.0, 5.0))), "hillel"};
  } else if (random.chance(0.5)) {
    law.yaml.add("model", "liakopoulos")
        .add("coefficient", number_text(random.uniform(0.8, 2.3)))
        .add("exponent", number_text(random.uniform(0.9, 1.5)));
    law.word = "liakopoulos";
  } else {
    law.yaml.add("model", "exponential").add("alpha", inverse_length_text(random, random.logarithmic(0.1, 8.0)));
    law.word = "exponential";
  }
  if (random.chance(0.15)) law.yaml.add("floor", number_text(random.logarithmic(1.0e-8, 1.0e-3)));
  return law;
}

}  // namespace

RandomSoil random_soil(RandomNumbers& random, const std::string& name, bool elastic) {
  std::string text = fmt::format("  {}:\n", name);
  const auto line = [&text](const char* key, const std::string& value) {
    text += fmt::format("    {}: {}\n", key, value);
  };
  line("youngs_modulus", pressure_text(random, random.logarithmic(1.5e6, 8.0e7)));
  line("poissons_ratio", share_text(random, random.chance(0.05) ? 0.49 : random.uniform(0.1, 0.45)));
  line("porosity", share_text(random, random.uniform(0.25, 0.55)));
  line("grain_density", density_text(random, random.uniform(2500.0, 2850.0)));
  const Law law = strength(random, elastic);
  line("strength", law.yaml.text());
  line("hydraulic_conductivity", velocity_text(random, random.logarithmic(1.0e-8, 1.0e-3)));
  const bool has_n = random.chance(0.7);
  const Law retention = has_n ? van_genuchten(random) : other_retention(random);
  line("retention", retention.yaml.text());
  const Law flow = permeability(random, has_n && random.chance(0.6));
  line("relative_permeability", flow.yaml.text());
  return {name, text, law.word + "/" + retention.word + "/" + flow.word};
}

}  // namespace slope::random_cases
