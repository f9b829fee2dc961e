using System;
using System.Threading;
using NUnit.Framework;

namespace Hrt.HostTests
{
    // Tests libhrt_plate from C# with the firmware on an emulated board; run by with_plate.
    public sealed class PlateTests
    {
        // Waits up to 30 s for a report that fulfils a condition, and returns it.
        static PlateReport Eventually(HapticRetargetingPlate plate, Func<PlateReport, bool> wanted)
        {
            PlateReport report = plate.Get();
            for (int i = 0; i < 3000 && !wanted(report); ++i, report = plate.Get()) Thread.Sleep(10);
            Assert.IsTrue(wanted(report), $"{report.state} at {report.orientationDeg} deg, {report.message}");
            return report;
        }

        [Test]
        public void TurnsTheFirmwaresPlateAndStopsIt()
        {
            PlateOptions options = PlateOptions.Default;
            Assert.AreEqual(300000000, options.hostTimeoutNs);
            options.hostTimeoutNs = 10000000000; // so that the plate does not stop on a busy machine
            using (var plate = new HapticRetargetingPlate(Environment.GetEnvironmentVariable("HRT_PLATE_DEVICE"), options))
            {
                PlateReport report = plate.WaitUntilReady();
                Assert.AreEqual("protocol 2, firmware 1.1.0, serial number 000000", report.description.ToString());
                Assert.AreEqual(PlateFault.None, report.fault);
                SessionConfig config = SessionConfig.Default;
                config.TakePlate(report);
                Assert.AreEqual(-90.0, config.plateLowerStopDeg);
                Assert.AreEqual(report.latencyNs, config.plateLatencyNs);
                plate.Set(210); // equivalent to 30
                report = Eventually(plate, r => r.orientationDeg == 30);
                Assert.AreEqual(30.0, report.commandDeg);
                Assert.IsTrue((report.flags & PlateReportFlags.Commanded) != 0);
                plate.Stop();
                Eventually(plate, r => (r.flags & PlateReportFlags.Commanded) == 0);
            }
        }

        [Test]
        public void FailuresThrowWithTheirReason()
        {
            using (var plate = new HapticRetargetingPlate("serial:/nonexistent"))
            {
                var failed = Assert.Throws<InvalidOperationException>(() => plate.WaitUntilReady());
                StringAssert.StartsWith("the plate at /nonexistent cannot be opened: No such file or directory", failed.Message);
                var refused = Assert.Throws<HapticRetargetingException>(() => plate.Set(0));
                Assert.AreEqual(Result.WrongState, refused.Result);
            }
            var wrong = Assert.Throws<HapticRetargetingException>(() => new HapticRetargetingPlate("usb:0"));
            Assert.AreEqual(Result.OutOfRange, wrong.Result);
            Assert.AreEqual("hrt_plate_open: device is of kind \"usb\"; allowed: serial:..., dynamixel:...", wrong.Message);
        }
    }
}
