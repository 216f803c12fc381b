#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include "case_format.hpp"

namespace slope::couple {

namespace {

constexpr auto itself = [](auto& value) -> auto& {
  return value;
};

constexpr double right_angle = std::numbers::pi / 2.0;

constexpr const char* modified_cam_clay = "modified_cam_clay";

/// The fields of a softening law that say over which plastic strain it goes.
template <class Softening>
Record<Softening>& with_softening_range(Record<Softening>& softening) {
  const auto part_of = [](auto member) {
    return [member](auto& law) -> auto& {
      return law.range.*member;
    };
  };
  using solid::SofteningRange;
  return softening
      .required("from_plastic_strain", part_of(&SofteningRange::from), quantity(Dimension::number, at_least(0.0)),
                "accumulated deviatoric plastic strain up to which the peak strength holds", "1 %")
      .required("to_plastic_strain", part_of(&SofteningRange::to), quantity(Dimension::number, above(0.0)),
                "accumulated deviatoric plastic strain from which on the residual strength holds", "10 %")
      .optional("characteristic_length", part_of(&SofteningRange::characteristic_length),
                quantity(Dimension::length, at_least(0.0)),
                "cell size for which the two strains were found: with other cells the softening takes their difference "
                "times this length over the cell size; 0 m: the same strains for all cells")
      .check([](const Input& input, Softening& law) {
        if (law.range.to > law.range.from) return;
        input.at("to_plastic_strain")
            .problem(fmt::format("must be above from_plastic_strain, {:g}, got {:g}", law.range.from, law.range.to));
      });
}

/// Says so if the residual value of a strength exceeds its peak.
void check_residual(const Input& strength, const char* residual, double value, const char* peak, double peak_value,
                    Dimension dimension) {
  if (value <= peak_value) return;
  strength.at("softening")
      .at(residual)
      .problem(fmt::format("must not exceed {}, {}, got {}", peak, quantity_text(peak_value, dimension),
                           quantity_text(value, dimension)));
}

/// Two keys of which one without the other has no effect.
void check_pair(const Input& input, const char* one, const char* one_example, const char* other,
                const char* other_example) {
  if (input.has(one) == input.has(other)) return;
  const bool first = input.has(one);
  input.problem_with(
      first ? other : one,
      fmt::format("missing, and {} has no effect without it; write for example \"{}: {}\", or remove both",
                  first ? one : other, first ? other : one, first ? other_example : one_example));
}

/// The fields of Drucker-Prager and Mohr-Coulomb.
template <class Law>
Record<Law> frictional_record() {
  using solid::FrictionalSoftening;
  Record<FrictionalSoftening> softening;
  softening
      .required("residual_cohesion", &FrictionalSoftening::residual_cohesion,
                quantity(Dimension::pressure, at_least(0.0)), "what c' falls to", "0 kPa")
      .required("residual_friction_angle", &FrictionalSoftening::residual_friction_angle,
                quantity(Dimension::angle, from_to_below(0.0, right_angle)), "what phi' falls to", "20 deg");
  Record<Law> law;
  law.required("cohesion", &Law::cohesion, quantity(Dimension::pressure, at_least(0.0)), "c', cohesion at zero suction",
               "1 kPa")
      .required("friction_angle", &Law::friction_angle, quantity(Dimension::angle, from_to_below(0.0, right_angle)),
                "phi', friction angle at zero suction", "25 deg")
      .required("dilatancy_angle", &Law::dilatancy_angle, quantity(Dimension::angle, from_to_below(0.0, right_angle)),
                "psi, not above the friction angle", "0 deg")
      .optional(
          "maximum_cohesion_increase", &Law::maximum_cohesion_increase, quantity(Dimension::pressure, at_least(0.0)),
          "Delta c_max, largest increase of the cohesion by suction s: c = c' + Delta c_max (1 - exp(-B s / p_a)), "
          "p_a = 101.325 kPa (Eq. 15); without it suction adds nothing, which is cautious")
      .optional("cohesion_suction_rate", &Law::cohesion_suction_rate, quantity(Dimension::number, at_least(0.0)),
                "B, how fast the cohesion grows with suction: c = c' + Delta c_max (1 - exp(-B s / p_a)) (Eq. 15)")
      .optional("friction_angle_suction_rate", &Law::friction_angle_suction_rate, quantity(Dimension::angle),
                "A, increase of the friction angle per atmosphere of suction: phi = phi' + A s / p_a (Eq. 16)")
      .optional("softening", &Law::softening, maybe(with_softening_range(softening).format()),
                "brittle soil: c' and phi' fall linearly with plastic strain, and psi to zero with them; what suction "
                "adds stays")
      .check([](const Input& input, Law& soil) {
        if (soil.dilatancy_angle > soil.friction_angle) {
          input.at("dilatancy_angle")
              .problem(fmt::format("must not exceed the friction angle of {}, got {}",
                                   quantity_text(soil.friction_angle, Dimension::angle),
                                   quantity_text(soil.dilatancy_angle, Dimension::angle)));
        }
        check_pair(input, "maximum_cohesion_increase", "100 kPa", "cohesion_suction_rate", "0.07");
        if (!soil.softening) return;
        check_residual(input, "residual_cohesion", soil.softening->residual_cohesion, "cohesion", soil.cohesion,
                       Dimension::pressure);
        check_residual(input, "residual_friction_angle", soil.softening->residual_friction_angle, "friction_angle",
                       soil.friction_angle, Dimension::angle);
      });
  return law;
}

Record<solid::VonMises> von_mises_record() {
  using solid::UndrainedSoftening;
  using solid::VonMises;
  Record<UndrainedSoftening> softening;
  softening.required("residual_undrained_strength", &UndrainedSoftening::residual_undrained_strength,
                     quantity(Dimension::pressure, at_least(0.0)), "what s_u falls to", "5 kPa");
  Record<VonMises> law;
  law.required("undrained_strength", &VonMises::undrained_strength, quantity(Dimension::pressure, above(0.0)),
               "s_u, the largest shear stress in plane strain", "20 kPa")
      .optional("softening", &VonMises::softening, maybe(with_softening_range(softening).format()),
                "brittle soil: s_u falls linearly with plastic strain")
      .check([](const Input& input, VonMises& soil) {
        if (!soil.softening) return;
        check_residual(input, "residual_undrained_strength", soil.softening->residual_undrained_strength,
                       "undrained_strength", soil.undrained_strength, Dimension::pressure);
      });
  return law;
}

/// M of triaxial compression at a friction angle (rad).
double critical_state_ratio(double friction_angle) {
  return 6.0 * std::sin(friction_angle) / (3.0 - std::sin(friction_angle));
}

/// Of some keys exactly one has to be there.
void check_one_of(const Input& input, const std::vector<const char*>& keys, const char* example) {
  std::vector<const char*> given;
  std::ranges::copy_if(keys, std::back_inserter(given), [&input](const char* key) { return input.has(key); });
  if (given.empty()) {
    input.problem_with(
        keys.front(), fmt::format("missing; give one of {}; write for example \"{}\"", fmt::join(keys, ", "), example));
  } else if (given.size() > 1) {
    input.at(given.back()).problem(fmt::format("{} says this too; keep one of the two", given.front()));
  }
}

Record<solid::ModifiedCamClay> modified_cam_clay_record() {
  using solid::ModifiedCamClay;
  Format<double> friction_angle = quantity(Dimension::angle, between(0.0, right_angle));
  friction_angle.read = [read = friction_angle.read](const Input& input, double& ratio) {
    double angle = 0.0;
    read(input, angle);
    ratio = critical_state_ratio(angle);
  };
  friction_angle.write = [](const double& /*written as critical_state_ratio*/) { return Document{}; };
  Format<double> given_ratio = quantity(Dimension::number, between(0.0, 3.0));
  given_ratio.write = [write = given_ratio.write](const double& ratio) {
    return ratio > 0.0 ? write(ratio) : Document{};
  };
  const auto ratio = [](auto& law) -> auto& {
    return law.critical_state_ratio;
  };
  Record<ModifiedCamClay> law;
  law.optional("critical_state_friction_angle", ratio, friction_angle,
               "phi_cs' in triaxial compression, instead of M = 6 sin(phi_cs') / (3 - sin(phi_cs'))")
      .optional("critical_state_ratio", ratio, given_ratio, "M, q / p' at the critical state in all directions")
      .required("lambda", &ModifiedCamClay::lambda, quantity(Dimension::number, above(0.0)),
                "slope of the normal compression line, specific volume against ln p'", "0.16")
      .required("kappa", &ModifiedCamClay::kappa, quantity(Dimension::number, above(0.0)),
                "slope of the swelling lines; the bulk modulus is v p' / kappa with v = 1 / (1 - porosity)", "0.04")
      .required("minimum_mean_stress", &ModifiedCamClay::minimum_mean_stress, quantity(Dimension::pressure, above(0.0)),
                "p' that stiffness and preconsolidation pressure are at least taken at, as at a free surface", "2 kPa")
      .optional("overconsolidation_ratio", &ModifiedCamClay::overconsolidation_ratio,
                maybe(quantity(Dimension::number, at_least(1.0))),
                "p_c over the p_c of soil that yields under the initial stress; or one of the next two keys")
      .optional("pre_overburden_pressure", &ModifiedCamClay::pre_overburden_pressure,
                maybe(quantity(Dimension::pressure, at_least(0.0))),
                "by how much p_c exceeds the p_c of soil that yields under the initial stress")
      .optional("preconsolidation_pressure", &ModifiedCamClay::preconsolidation_pressure,
                maybe(quantity(Dimension::pressure, above(0.0))),
                "p_c itself, where soil under the initial stress would not yield already")
      .check([](const Input& input, ModifiedCamClay& soil) {
        check_one_of(input, {"critical_state_friction_angle", "critical_state_ratio"},
                     "critical_state_friction_angle: 25 deg");
        check_one_of(input, {"overconsolidation_ratio", "pre_overburden_pressure", "preconsolidation_pressure"},
                     "overconsolidation_ratio: 1.5");
        if (soil.kappa < soil.lambda) return;
        input.at("kappa").problem(fmt::format("must be below lambda, {:g}, got {:g}", soil.lambda, soil.kappa));
      });
  return law;
}

Format<solid::Strength> strength_format() {
  return Alternatives<solid::Strength>("model")
      .add("drucker_prager",
           "Drucker-Prager matched to Mohr-Coulomb in plane strain, stronger with suction (Eqs. 11-16)", itself,
           frictional_record<solid::DruckerPrager>())
      .add("mohr_coulomb", "Mohr-Coulomb, stronger with suction (Eqs. 15, 16)", itself,
           frictional_record<solid::MohrCoulomb>())
      .add("von_mises", "von Mises: undrained strength, whatever the mean stress and the suction", itself,
           von_mises_record())
      .add(modified_cam_clay,
           "Modified Cam-clay: stiffness and strength by the stress that the clay has borne; suction acts through the "
           "effective stress",
           itself, modified_cam_clay_record())
      .add("elastic", "the soil never yields", itself, Record<solid::NoYield>())
      .format();
}

/// The fields of a law that has a saturation range, and the check that the range is not empty.
template <class Law>
Record<Law>& with_range(Record<Law>& law, bool required) {
  const auto residual = [](auto& curve) -> auto& {
    return curve.range.residual;
  };
  const auto maximum = [](auto& curve) -> auto& {
    return curve.range.maximum;
  };
  const Format<double> lowest = quantity(Dimension::number, from_to_below(0.0, 1.0));
  const Format<double> highest = quantity(Dimension::number, above_to(0.0, 1.0));
  if (required) {
    law.required("residual_saturation", residual, lowest, "degree of saturation that no suction goes below", "0")
        .required("maximum_saturation", maximum, highest, "degree of saturation at zero suction", "1");
  } else {
    law.optional("residual_saturation", residual, lowest, "as in the retention curve, if that is a van Genuchten curve")
        .optional("maximum_saturation", maximum, highest,
                  "as in the retention curve, if that is a van Genuchten curve");
  }
  return law.check([](const Input& input, Law& curve) {
    if (curve.range.residual < curve.range.maximum) return;
    input.at("residual_saturation")
        .problem(
            fmt::format("must be below maximum_saturation, {}, got {}", curve.range.maximum, curve.range.residual));
  });
}

Format<seepage::Retention> retention_format() {
  using namespace seepage;
  Record<VanGenuchten> van_genuchten;
  van_genuchten
      .required("alpha", &VanGenuchten::alpha, quantity(Dimension::inverse_length, above(0.0)), "alpha' of Eq. 8",
                "0.05 1/m")
      .required("n", &VanGenuchten::n, quantity(Dimension::number, above(1.0)), "n' of Eq. 8", "3")
      .optional(
          "air_entry", &VanGenuchten::air_entry, quantity(Dimension::length, at_least(0.0)),
          "suction head up to which the soil stays wet (Vogel et al. 2001); 2 cm helps clays with n near 1, whose "
          "permeability falls within a millimetre of suction by half without it");
  Record<LiakopoulosRetention> liakopoulos;
  liakopoulos
      .required("coefficient", &LiakopoulosRetention::coefficient, quantity(Dimension::number, above(0.0)),
                "a of S_r = 1 - a h^b (Eq. 20), with the suction head h in metres", "0.10152")
      .required("exponent", &LiakopoulosRetention::exponent, quantity(Dimension::number, above(1.0)), "b of Eq. 20",
                "2.4279")
      .optional("floor", &LiakopoulosRetention::floor, quantity(Dimension::number, from_to_below(0.0, 1.0)),
                "degree of saturation that no suction goes below");
  Record<ExponentialRetention> exponential;
  exponential.required("alpha", &ExponentialRetention::alpha, quantity(Dimension::inverse_length, above(0.0)),
                       "alpha of S_e = exp(-alpha h)", "1 1/m");
  return Alternatives<Retention>("model")
      .add("van_genuchten", "S_e = (1 + (alpha h)^n)^-(1 - 1/n), h the suction head", itself,
           with_range(van_genuchten, true))
      .add("liakopoulos", "S_r = 1 - a h^b, h the suction head (Eq. 20)", itself, liakopoulos)
      .add("exponential", "S_e = exp(-alpha h), h the suction head (Gardner)", itself, with_range(exponential, true))
      .format();
}

Format<seepage::RelativePermeability> permeability_format() {
  using namespace seepage;
  const auto law = [](auto& permeability) -> auto& {
    return permeability.law;
  };
  Record<HillelPower> hillel;
  hillel.required("exponent", &HillelPower::exponent, quantity(Dimension::number, above(0.0)), "L of Eq. 10", "2");
  Record<LiakopoulosPermeability> liakopoulos;
  liakopoulos
      .required("coefficient", &LiakopoulosPermeability::coefficient, quantity(Dimension::number, above(0.0)),
                "a of k_rw = 1 - a (1 - S_r)^b (Eq. 21)", "2.207")
      .required("exponent", &LiakopoulosPermeability::exponent, quantity(Dimension::number, above(0.0)), "b of Eq. 21",
                "1");
  Record<ExponentialPermeability> exponential;
  exponential.required("alpha", &ExponentialPermeability::alpha, quantity(Dimension::inverse_length, above(0.0)),
                       "alpha of k_rw = exp(-alpha h)", "1 1/m");
  Record<VanGenuchtenMualem> mualem;
  mualem.optional("n", &VanGenuchtenMualem::n, quantity(Dimension::number, above(1.0)),
                  "as in the retention curve, if that is a van Genuchten curve");
  Record<RelativePermeability> shared;
  shared.optional("floor", &RelativePermeability::floor, quantity(Dimension::number, between(0.0, 1.0)),
                  "relative permeability that no suction goes below");
  return Alternatives<RelativePermeability>("model")
      .add("hillel", "k_rw = S_r^L (Eq. 10)", law, hillel)
      .add("liakopoulos", "k_rw = 1 - a (1 - S_r)^b (Eq. 21)", law, liakopoulos)
      .add("exponential", "k_rw = exp(-alpha h), h the suction head (Gardner)", law, exponential)
      .add("van_genuchten_mualem", "k_rw = sqrt(S_e) (1 - (1 - S_e^(1/m))^m)^2, m = 1 - 1/n", law,
           with_range(mualem, false))
      .shared(shared)
      .format();
}

/// Soils of a library are put in before a case is read: what is still there is in the library itself.
Field<Soil> library_field() {
  const std::string description =
      "another file with soils, path from this one: its keys hold where this soil does not give them";
  return {{library_key, false, "", described(library_format().schema, description)},
          [](const Input& input, Soil&) { input.problem("cannot stand in a library; write the soil out there"); },
          [](const Soil&) { return Document{}; }};
}

Field<Soil> library_soil_field() {
  const std::string description = "name of the soil in the file that it comes from, if it has another name there";
  return {{library_soil_key, false, "", described(text().schema, description)},
          [](const Input& input, Soil&) {
            input.problem(
                fmt::format("is the name of a soil in another file; write for example \"{}: soils.yaml\" "
                            "beside it, or remove it",
                            library_key));
          },
          [](const Soil&) { return Document{}; }};
}

/// Takes what the Mualem law leaves open from the retention curve.
void complete_mualem(const Input& input, Soil& soil) {
  auto* mualem = std::get_if<seepage::VanGenuchtenMualem>(&soil.seepage.relative_permeability.law);
  if (mualem == nullptr) return;
  const Input place = input.at("relative_permeability");
  const auto* retention = std::get_if<seepage::VanGenuchten>(&soil.seepage.retention);
  if (retention != nullptr) {
    mualem->entry_saturation = retention->entry_saturation();
    if (!place.has("n")) mualem->n = retention->n;
    if (!place.has("residual_saturation")) mualem->range.residual = retention->range.residual;
    if (!place.has("maximum_saturation")) mualem->range.maximum = retention->range.maximum;
  } else if (!place.has("n")) {
    place.problem_with(
        "n", "missing; the retention curve is no van Genuchten curve to take it from; write for example \"n: 3\"");
  }
}

/// Young's modulus of a soil whose strength law has a stiffness of its own: a base or a library may have given one.
Field<Soil> idle_stiffness_field() {
  const Format<double> modulus = quantity(Dimension::pressure, above(0.0));
  return {{"youngs_modulus", false, "", described(modulus.schema, "E; of no effect with this strength model")},
          [modulus](const Input& input, Soil&) {
            double ignored = 0.0;
            modulus.read(input, ignored);
            input.warning(fmt::format(
                "has no effect with the strength model {}, whose stiffness comes from kappa and the mean stress",
                modified_cam_clay));
          },
          [](const Soil&) { return Document{}; }};
}

/// @param own_stiffness  whether the strength law has a stiffness of its own
Record<Soil> soil_record(bool own_stiffness) {
  Record<Soil> record;
  record.field(library_field()).field(library_soil_field());
  if (own_stiffness) {
    record.field(idle_stiffness_field());
  } else {
    record.required(
        "youngs_modulus", [](auto& soil) -> auto& { return soil.solid.elastic.youngs_modulus; },
        quantity(Dimension::pressure, above(0.0)), "E, of the skeleton; not needed with modified_cam_clay", "10 MPa");
  }
  return record
      .required(
          "poissons_ratio", [](auto& soil) -> auto& { return soil.solid.elastic.poissons_ratio; },
          quantity(Dimension::number, between(-1.0, 0.5)), "nu, of the skeleton", "0.33")
      .required("porosity", &Soil::porosity, quantity(Dimension::number, between(0.0, 1.0)), "n at the start", "0.35")
      .required(
          "grain_density", [](auto& soil) -> auto& { return soil.solid.grain_density; },
          quantity(Dimension::density, above(0.0)), "rho_s", "2700 kg/m3")
      .required(
          "strength", [](auto& soil) -> auto& { return soil.solid.strength; }, strength_format(),
          "when the skeleton yields", "{model: elastic}")
      .required(
          "hydraulic_conductivity", [](auto& soil) -> auto& { return soil.seepage.hydraulic_conductivity; },
          quantity(Dimension::velocity, above(0.0)), "k, of the saturated soil", "1e-5 m/s")
      .required(
          "retention", [](auto& soil) -> auto& { return soil.seepage.retention; }, retention_format(),
          "degree of saturation against suction",
          "{model: van_genuchten, alpha: 0.05 1/m, n: 3, residual_saturation: 0, maximum_saturation: 1}")
      .required(
          "relative_permeability", [](auto& soil) -> auto& { return soil.seepage.relative_permeability; },
          permeability_format(), "share of the conductivity that is left in unsaturated soil",
          "{model: hillel, exponent: 2}")
      .check(complete_mualem);
}

/// A schema that holds for maps in which strength.model is modified_cam_clay.
Document has_own_stiffness_schema() {
  Document model = Document::map(), models = Document::map(), strength = Document::map(), soil = Document::map(),
           schema = Document::map();
  model.set("const", Document::text(modified_cam_clay));
  models.set("model", std::move(model));
  strength.set("properties", std::move(models)).set("required", Document::list({Document::text("model")}));
  soil.set("strength", std::move(strength));
  return schema.set("properties", std::move(soil)).set("required", Document::list({Document::text("strength")}));
}

bool has_own_stiffness(const Input& input) {
  const Document* strength = input.node().find("strength");
  const Document* model = strength == nullptr ? nullptr : strength->find("model");
  return model != nullptr && model->value == modified_cam_clay;
}

}  // namespace

Format<Soil> soil_format() {
  const Format<Soil> linear = soil_record(false).format(), own = soil_record(true).format();
  Format<Soil> format{
      [linear, own](const Input& input, Soil& soil) { (has_own_stiffness(input) ? own : linear).read(input, soil); },
      [linear, own](const Soil& soil) {
        const bool cam_clay = std::holds_alternative<solid::ModifiedCamClay>(soil.solid.strength);
        return (cam_clay ? own : linear).write(soil);
      },
      Document::map()};
  format.schema.set("if", has_own_stiffness_schema()).set("then", own.schema).set("else", linear.schema);
  Document from_library = Document::map();
  from_library.set("required", Document::list({Document::text(library_key)}));
  Document either = Document::map();
  either.set("if", std::move(from_library)).set("then", overlay_schema(linear.schema)).set("else", format.schema);
  format.schema = std::move(either);
  return format;
}

}  // namespace slope::couple
