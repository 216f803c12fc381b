#include <gtest/gtest.h>

#include "case_folder.hpp"
#include "slope/couple/read_case.hpp"

namespace slope::couple::test {
namespace {

/// What a case has to say of a soil of which the library knows the water only.
const std::string skeleton =
    "youngs_modulus: 10 MPa, poissons_ratio: 0.3, grain_density: 2650 kg/m3, strength: {model: elastic}";

/// The shipped slope with a soil of the shipped library, copied beside it.
class SoilLibrary : public testing::Test {
 protected:
  SoilLibrary() { folder_.write("soils.yaml", content_of(shipped_cases() / "soils.yaml")); }

  /// The case whose only soil is said to be this.
  [[nodiscard]] std::string content(const std::string& soil) const {
    const std::string slope = slope_with("", "").content;
    const std::size_t from = slope.find("  sandy_clay:\n"), to = slope.find("# What is soil");
    return slope.substr(0, from) + "  sandy_clay: {" + soil + "}\n\n" + slope.substr(to);
  }
  [[nodiscard]] Case with(const std::string& soil, const std::vector<std::string>& overrides = {}) const {
    return read_case(folder_.write("case.yaml", content(soil)), overrides);
  }
  [[nodiscard]] std::string problems(const std::string& soil, const std::vector<std::string>& overrides = {}) const {
    std::string text;
    try {
      (void)with(soil, overrides);
    } catch (const InputError& error) {
      text = error.what();
    }
    const std::string folder = folder_.path().string() + "/";
    for (std::size_t at = text.find(folder); at != std::string::npos; at = text.find(folder, at))
      text.erase(at, folder.size());
    return text;
  }

  const std::string place_ =
      "case.yaml:" + std::to_string(slope_with("  sandy_clay:\n", "").line) + ": soils.sandy_clay";
  const CaseFolder folder_;
};

TEST_F(SoilLibrary, ASoilTakesFromItWhatItDoesNotSayItself) {
  const Case input = with("from: soils.yaml, soil: loam, porosity: 0.4, retention: {n: 1.6}, " + skeleton);
  const Soil& soil = input.soils.at(0);
  EXPECT_EQ(soil.name, "sandy_clay");
  EXPECT_EQ(soil.porosity, 0.4);
  EXPECT_EQ(soil.solid.grain_density, 2650.0);
  EXPECT_EQ(soil.seepage.hydraulic_conductivity, 1.04 / 360000.0);
  const auto& retention = std::get<seepage::VanGenuchten>(soil.seepage.retention);
  EXPECT_EQ(retention.alpha, 3.6);
  EXPECT_EQ(retention.n, 1.6);
  EXPECT_EQ(std::get<seepage::VanGenuchtenMualem>(soil.seepage.relative_permeability.law).n, 1.6);
  const std::string resolved = resolved_yaml(input);
  EXPECT_EQ(resolved.find("from:"), std::string::npos) << "the case of a run stands on its own";
  EXPECT_EQ(resolved_yaml(read_case(folder_.write("resolved.yaml", resolved))), resolved);
}

TEST_F(SoilLibrary, TheNameInTheLibraryIsTheSoilsOwnWithoutAnother) {
  EXPECT_EQ(with("from: soils.yaml, " + skeleton).soils.at(0).seepage.hydraulic_conductivity, 0.12 / 360000.0);
}

TEST_F(SoilLibrary, OverridesCanChooseTheSoil) {
  const Case input = with("from: soils.yaml, soil: loam, " + skeleton,
                          {"soils.sandy_clay.soil=silt", "soils.sandy_clay.retention.alpha=2 1/m"});
  EXPECT_EQ(input.soils.at(0).porosity, 0.46);
  EXPECT_EQ(std::get<seepage::VanGenuchten>(input.soils.at(0).seepage.retention).alpha, 2.0);
}

TEST_F(SoilLibrary, ACaseFileIsOneToo) {
  folder_.write("w2.yaml", slope_with("", "").content);
  EXPECT_EQ(resolved_yaml(with("from: w2.yaml")), resolved_yaml(read_case(folder_.path() / "w2.yaml")));
}

TEST_F(SoilLibrary, PathsCountFromTheFileThatTheyStandIn) {
  std::filesystem::create_directory(folder_.path() / "base");
  folder_.write("base/base.yaml", content("from: ../soils.yaml, soil: loam, " + skeleton));
  const auto including = folder_.write("case.yaml", "include: base/base.yaml\nsoils: {sandy_clay: {soil: sand}}\n");
  EXPECT_EQ(read_case(including).soils.at(0).seepage.hydraulic_conductivity, 29.7 / 360000.0);
}

TEST_F(SoilLibrary, WhatNeitherGivesIsMissing) {
  EXPECT_EQ(
      problems("from: soils.yaml, soil: loam, youngs_modulus: 1 MPa, poissons_ratio: 0.3, strength: {model: elastic}"),
      place_ + ".grain_density: missing; write for example \"grain_density: 2700 kg/m3\"");
}

TEST_F(SoilLibrary, MistakesAreToldWithTheirPlace) {
  EXPECT_EQ(problems("from: soils.yaml, soil: laom, " + skeleton),
            place_ + ".soil: soils.yaml has no soil \"laom\", did you mean \"loam\"?");
  EXPECT_EQ(problems("from: solis.yaml, " + skeleton),
            place_ + ".from: there is no file solis.yaml; the path counts from the folder of this file");
  EXPECT_EQ(problems("from: 3, " + skeleton),
            place_ + ".from: expected the path of a soil library, such as \"soils.yaml\", got \"3\"");
  EXPECT_EQ(
      problems("soil: loam, porosity: 0.4, hydraulic_conductivity: 1 m/d, retention: {model: exponential, alpha: 1 "
               "1/m, residual_saturation: 0, maximum_saturation: 1}, relative_permeability: {model: hillel, "
               "exponent: 2}, " +
               skeleton),
      place_ +
          ".soil: is the name of a soil in another file; write for example \"from: soils.yaml\" beside it, or remove "
          "it");
  folder_.write("soils.yaml", "title: none\n");
  EXPECT_EQ(problems("from: soils.yaml, " + skeleton),
            place_ + ".from: soils.yaml has no soils; it needs the key \"soils\" with a map of them");
  folder_.write("soils.yaml", "soils: [1\n");
  EXPECT_EQ(problems("from: soils.yaml, " + skeleton), "soils.yaml:2: not YAML: end of sequence flow not found");
  folder_.write("soils.yaml", "soils:\n  sandy_clay: {from: other.yaml}\n");
  EXPECT_TRUE(problems("from: soils.yaml, " + skeleton).starts_with(place_ + ".porosity: missing"))
      << problems("from: soils.yaml, " + skeleton);
  EXPECT_NE(problems("from: soils.yaml, " + skeleton)
                .find("soils.yaml:2: soils.sandy_clay.from: cannot stand in a library; write the soil out there"),
            std::string::npos);
}

TEST_F(SoilLibrary, AWrongValueOfTheLibraryIsToldWithItsFile) {
  std::string library = content_of(shipped_cases() / "soils.yaml");
  const std::size_t at = library.find("porosity: 0.43");
  library.replace(at, 14, "porosity: 4.30");
  folder_.write("soils.yaml", library);
  const auto line = 1 + std::count(library.begin(), library.begin() + static_cast<std::ptrdiff_t>(at), '\n');
  EXPECT_EQ(
      problems("from: soils.yaml, soil: sand, " + skeleton),
      "soils.yaml:" + std::to_string(line) + ": soils.sandy_clay.porosity: must be above 0 and below 1, got 4.30");
}

/// A texture with its means in the units in which HYDRUS lists Carsel and Parrish's: 1/cm and cm/d.
struct Texture {
  const char* name;
  double theta_r, theta_s, alpha, n, conductivity;
};

TEST_F(SoilLibrary, TheTexturesAreThoseOfCarselAndParrish) {
  const std::vector<Texture> textures{{"sand", 0.045, 0.43, 0.145, 2.68, 712.8},
                                      {"loamy_sand", 0.057, 0.41, 0.124, 2.28, 350.2},
                                      {"sandy_loam", 0.065, 0.41, 0.075, 1.89, 106.1},
                                      {"loam", 0.078, 0.43, 0.036, 1.56, 24.96},
                                      {"silt", 0.034, 0.46, 0.016, 1.37, 6.0},
                                      {"silt_loam", 0.067, 0.45, 0.020, 1.41, 10.8},
                                      {"sandy_clay_loam", 0.100, 0.39, 0.059, 1.48, 31.44},
                                      {"clay_loam", 0.095, 0.41, 0.019, 1.31, 6.24},
                                      {"silty_clay_loam", 0.089, 0.43, 0.010, 1.23, 1.68},
                                      {"sandy_clay", 0.100, 0.38, 0.027, 1.23, 2.88},
                                      {"silty_clay", 0.070, 0.36, 0.005, 1.09, 0.48},
                                      {"clay", 0.068, 0.38, 0.008, 1.09, 4.8}};
  for (const Texture& texture : textures) {
    SCOPED_TRACE(texture.name);
    const Soil soil = with("from: soils.yaml, soil: " + std::string(texture.name) + ", " + skeleton).soils.at(0);
    const auto& retention = std::get<seepage::VanGenuchten>(soil.seepage.retention);
    EXPECT_EQ(soil.porosity, texture.theta_s);
    EXPECT_NEAR(retention.range.residual * soil.porosity, texture.theta_r, 5.0e-5);
    EXPECT_EQ(retention.range.maximum, 1.0);
    EXPECT_NEAR(retention.alpha, 100.0 * texture.alpha, 1.0e-12);
    EXPECT_EQ(retention.n, texture.n);
    EXPECT_NEAR(soil.seepage.hydraulic_conductivity * 8.64e6, texture.conductivity, 0.05) << "cm/d";
    EXPECT_EQ(std::get<seepage::VanGenuchtenMualem>(soil.seepage.relative_permeability.law).n, texture.n);
  }
}

TEST_F(SoilLibrary, HoldsThePapersSoils) {
  folder_.write("w2.yaml", slope_with("", "").content);
  EXPECT_EQ(resolved_yaml(with("from: soils.yaml, soil: paper_sandy_clay")),
            resolved_yaml(read_case(folder_.path() / "w2.yaml")));
  const Case column = read_case(shipped_cases() / "paper/liakopoulos.yaml");
  Case same = column;
  same.soils = with("from: soils.yaml, soil: paper_del_monte_sand").soils;
  same.soils.at(0).name = column.soils.at(0).name;
  EXPECT_EQ(resolved_yaml(same), resolved_yaml(column));
}

}  // namespace
}  // namespace slope::couple::test
