// Keys of electrodes: what each control needs and has no use for.
#include <cmath>

#include "io/refusal.h"

namespace taut::io
{
namespace
{
using testing::CaseOnDisk;
using testing::Refusal;
using testing::small_case;

class BadSource : public ::testing::TestWithParam<Refusal>
{
};

TEST_P(BadSource, IsRefusedWithFileLineAndKey)
{
  testing::expect_refused(small_case, GetParam());
}

const Refusal sources[] = {
    {"no voltage", "  set Voltage = table(0: 0, 1: 5000)\n", "",
     "subsection Electrode left", "Electrode left/Voltage", "needs it"},
    {"charge beside a voltage", "table(0: 0, 1: 5000)",
     "5000\n  set Charge = 1e-6", "set Charge", "Electrode left/Charge",
     "Control = voltage has no Charge"},
    {"voltage beside a charge", "table(0: 0, 1: 5000)",
     "5000\n  set Control = charge\n  set Charge = 1e-6", "set Voltage",
     "Electrode left/Voltage", "Control = charge has no Voltage"},
    {"no charge", "Voltage = table(0: 0, 1: 5000)", "Control = charge",
     "subsection Electrode left", "Electrode left/Charge", "needs it"},
    {"no resistance", "table(0: 0, 1: 5000)", "5000\n  set Control = circuit",
     "subsection Electrode left", "Electrode left/Series resistance",
     "needs it"},
    {"resistance of zero", "table(0: 0, 1: 5000)",
     "5000\n  set Control = circuit\n  set Series resistance = 0", "set Series",
     "Electrode left/Series resistance", "Control = voltage"},
    {"leakage of zero", "table(0: 0, 1: 5000)",
     "5000\n  set Control = circuit\n  set Series resistance = 1\n"
     "  set Leakage resistance = 0",
     "set Leakage", "Electrode left/Leakage resistance", "above 0"},
    {"leakage without a circuit", "table(0: 0, 1: 5000)",
     "5000\n  set Leakage resistance = 1e9", "set Leakage",
     "Electrode left/Leakage resistance", "has no Leakage resistance"},
    {"unknown control", "table(0: 0, 1: 5000)", "5000\n  set Control = charged",
     "set Control", "Electrode left/Control", "did you mean 'charge'"}};
INSTANTIATE_TEST_SUITE_P(Sources, BadSource, ::testing::ValuesIn(sources));

TEST(Sources, OfACircuitAreRead)
{
  const CaseOnDisk disk(testing::edit(small_case, "table(0: 0, 1: 5000)",
                                      "5000\n  set Control = circuit\n"
                                      "  set Series resistance = 2e6\n"
                                      "  set Leakage resistance = none"));
  const auto electrode = read_case(disk.file()).device.electrodes.at(0);
  EXPECT_EQ(electrode.control, structure::Electrode::Control::circuit);
  EXPECT_EQ(electrode.voltage.value(0), 5000);
  EXPECT_EQ(electrode.series_resistance, 2e6);
  EXPECT_TRUE(std::isinf(electrode.leakage_resistance));
}
} // namespace
} // namespace taut::io
