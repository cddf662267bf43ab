#include "core/output/spectral_layout.h"

#include <gtest/gtest.h>

#include <regex>

namespace airlight {
namespace {

// The paper's authors' pattern for channels of a spectrum: Stokes' component, a number with a comma, a unit.
const std::regex kChannel(R"(^S([0-3])\.(\d*,?\d*([Ee][+-]?\d+)?)(Y|Z|E|P|T|G|M|k|h|da|d|c|m|u|n|p)?(m|Hz)$)");

TEST(SpectralLayout, ChannelsAreNamedByTheWavelength) {
  EXPECT_EQ(spectral_channel_name(550.0), "S0.550,000000nm");
  EXPECT_EQ(spectral_channel_name(382.5), "S0.382,500000nm");
  for (const double nm : {360.0, 555.1, 1000.0 / 3.0, 830.0}) {
    std::smatch parts;
    const std::string name = spectral_channel_name(nm);
    ASSERT_TRUE(std::regex_match(name, parts, kChannel)) << name;
    EXPECT_EQ(parts[1], "0");
    EXPECT_EQ(parts[4].str() + parts[5].str(), "nm");
    std::string number = parts[2];
    number[number.find(',')] = '.';
    EXPECT_NEAR(std::stod(number), nm, 1e-6);
  }
}

TEST(SpectralLayout, AttributesSayLayoutUnitAndSunlight) {
  SpectralImage spectrum{"W.m^-2.sr^-1.nm^-1", {380.0, 382.5}, {1.25, 1.5}, true, {}};
  const std::map<std::string, std::string> texts = spectral_attributes(spectrum);
  EXPECT_EQ(texts.at("spectralLayoutVersion"), "1.0");
  EXPECT_EQ(texts.at("emissiveUnits"), "W.m^-2.sr^-1.nm^-1");
  EXPECT_EQ(texts.at("airlight:sunlight"), "380nm:1.25;382.5nm:1.5;");
  EXPECT_EQ(texts.at("airlight:picture"), "the spectrum's integral");
  spectrum.tells_colours = false;
  EXPECT_NE(spectral_attributes(spectrum).at("airlight:picture"), texts.at("airlight:picture"));
}

}  // namespace
}  // namespace airlight
