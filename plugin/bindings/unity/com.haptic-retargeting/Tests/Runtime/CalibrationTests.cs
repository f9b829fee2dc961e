using System;
using NUnit.Framework;

namespace Hrt.Tests
{
    // A user who goes at once to where they would come to rest: of a plate at T, with a share of touch w and a bias b,
    // P = (b - w T) / (1 - w).
    public sealed class CalibrationTests
    {
        const double TactileWeight = 0.2;
        const double BiasDeg = 3;
        const long FrameNs = 11111111;

        readonly System.Random random = new System.Random(4);
        HapticRetargetingSession session;
        HapticRetargetingCalibration calibration;

        [SetUp]
        public void SetUp()
        {
            session = new HapticRetargetingSession();
            calibration = new HapticRetargetingCalibration(session);
        }

        [TearDown]
        public void TearDown()
        {
            calibration.Dispose();
            session.Dispose();
        }

        [Test]
        public void TheUserIsFoundAndTakenOver()
        {
            for (int i = 0; i < 40; ++i) Slide(30 * (i % 5 - 2));
            CalibrationResult result = calibration.Solve();
            Assert.AreEqual(40, result.trials);
            Assert.AreEqual(40, result.trialsUsed);
            Assert.IsTrue(result.tactileWeight.IsKnown);
            Assert.That(result.tactileWeight.value, Is.EqualTo(TactileWeight).Within(0.02));
            Assert.LessOrEqual(result.tactileWeight.lower, TactileWeight);
            Assert.GreaterOrEqual(result.tactileWeight.upper, TactileWeight);
            Assert.That(result.biasDeg.value, Is.EqualTo(BiasDeg).Within(1));
            Assert.That(result.trackerNoiseM.value, Is.EqualTo(0.0003).Within(0.00005));

            session.Apply(result);
            Assert.AreEqual(result.tactileWeight.value, session.Config.tactileWeight);
            Assert.AreEqual(result.biasDeg.value, session.Config.biasDeg);
            StringAssert.Contains("\"bias_deg\":", session.SaveProfile());
        }

        [Test]
        public void TooFewSlidesAreRefusedWithWhatIsNeeded()
        {
            Slide(0);
            var refusal = Assert.Throws<HapticRetargetingException>(() => calibration.Solve());
            Assert.AreEqual(Result.InsufficientData, refusal.Result);
            StringAssert.Contains("10", refusal.Message);
        }

        [Test]
        public void TrialsBeginAndEnd()
        {
            var refusal = Assert.Throws<HapticRetargetingException>(() => calibration.EndTrial());
            Assert.AreEqual(Result.WrongState, refusal.Result);
            calibration.BeginTrial(30);
            refusal = Assert.Throws<HapticRetargetingException>(() => calibration.BeginTrial(30));
            Assert.AreEqual(Result.WrongState, refusal.Result);
            calibration.CancelTrial();
            refusal = Assert.Throws<HapticRetargetingException>(() => calibration.AddSample(At(0, 0, 0)));
            Assert.AreEqual(Result.WrongState, refusal.Result);
            calibration.Dispose();
            Assert.Throws<ObjectDisposedException>(() => calibration.BeginTrial(30));
            Assert.Throws<ArgumentNullException>(() => new HapticRetargetingCalibration(null));
        }

        [Test]
        public void ItOutlivesTheSession()
        {
            session.Dispose();
            Slide(0);
            Assert.Throws<ObjectDisposedException>(() => new HapticRetargetingCalibration(session));
        }

        // Half a second at rest, then 10 cm in 3 seconds.
        void Slide(double plateOrientationDeg)
        {
            double directionDeg = (BiasDeg - TactileWeight * plateOrientationDeg) / (1 - TactileWeight) + Noise();
            double direction = directionDeg * Math.PI / 180;
            calibration.BeginTrial(plateOrientationDeg);
            for (int frame = 0; frame < 45 + 270; ++frame)
            {
                double way = Math.Max(0, frame - 45) * 0.1 / 270;
                calibration.AddSample(At(frame, -way * Math.Sin(direction), 0.05 - way * Math.Cos(direction)));
            }
            calibration.EndTrial();
        }

        Sample At(int frame, double x, double z)
        {
            return new Sample
            {
                flags = SampleFlags.PlatePosition,
                timeNs = frame * FrameNs,
                fingerPositionM = new Double3(x + 0.0003 * Noise(), 0, z + 0.0003 * Noise())
            };
        }

        // Of mean 0 and variance 1, nearly normal.
        double Noise()
        {
            double sum = -6;
            for (int i = 0; i < 12; ++i) sum += random.NextDouble();
            return sum;
        }
    }
}
