using System;
using System.Linq;
using NUnit.Framework;

namespace Hrt.Tests
{
    // A plate a metre up and turned by 90 degrees about its normal: its x axis is the world's -z, its z the world's x.
    public sealed class RegistrationTests
    {
        static readonly Double3[] Marks =
        {
            new Double3(0, 0, 0.05), new Double3(0, 0, 0), new Double3(0.075, 0, 0), new Double3(-0.075, 0, 0),
            new Double3(0, 0, -0.075)
        };

        static Double3 InWorld(Double3 mark) => new Double3(0.5 + mark.z, 1 + mark.y, -2 - mark.x);

        static MarkTouch[] Touches() =>
            Marks.Select(mark => new MarkTouch { markM = mark, touchedM = InWorld(mark) }).ToArray();

        [Test]
        public void ThePoseIsFoundAndTakenOver()
        {
            Registration found = HapticRetargetingRegistration.Fit(Touches());
            Assert.AreEqual(RegistrationVerdict.Holds, found.verdict);
            Assert.AreEqual(-1, found.leftOut);
            Assert.That(found.platePositionM.x, Is.EqualTo(0.5).Within(1e-9));
            Assert.That(found.platePositionM.z, Is.EqualTo(-2).Within(1e-9));
            Assert.That(Math.Abs(found.plateRotation.y), Is.EqualTo(Math.Sqrt(0.5)).Within(1e-9));
            using (var session = new HapticRetargetingSession())
            {
                session.Apply(found, 7);
                SessionConfig config = session.Config;
                Assert.AreEqual(found.platePositionM, config.platePositionM);
                Assert.AreEqual(7, config.registrationTimeNs);
                Assert.IsTrue((config.flags & SessionFlags.Registered) != 0);
            }
        }

        [Test]
        public void ABadTouchIsNamed()
        {
            MarkTouch[] touches = Touches();
            touches[3].touchedM.x += 0.05;
            double[] residuals;
            Registration found =
                HapticRetargetingRegistration.Fit(touches, RegistrationConfig.Default, out residuals);
            Assert.AreEqual(RegistrationVerdict.Holds, found.verdict);
            Assert.AreEqual(3, found.leftOut);
            Assert.That(residuals[3], Is.EqualTo(0.05).Within(1e-6));
            found = HapticRetargetingRegistration.Fit(touches.Take(2).ToArray());
            Assert.AreEqual(RegistrationVerdict.TooFew, found.verdict);
            Assert.IsTrue(HapticRetargetingRegistration.Advice(found.verdict).Length > 10);
            touches[1].touchedM.y = double.NaN;
            var refused = Assert.Throws<HapticRetargetingException>(() => HapticRetargetingRegistration.Fit(touches));
            StringAssert.Contains("touches[1]", refused.Message);
        }

        [Test]
        public void ALaterTouchIsChecked()
        {
            Registration found = HapticRetargetingRegistration.Fit(Touches());
            MarkTouch touch = Touches()[0];
            Assert.AreEqual(1, HapticRetargetingRegistration.CheckTouch(found, touch).holds);
            touch.touchedM.x += 0.04;
            TouchCheck moved = HapticRetargetingRegistration.CheckTouch(found, touch);
            Assert.AreEqual(0, moved.holds);
            Assert.That(moved.distanceM, Is.EqualTo(0.04).Within(1e-6));
        }

        // The skin is 12 mm along the joint's -z, which is turned about its x and its y axis over one mark.
        [Test]
        public void TheSkinIsFoundFromTheJoint()
        {
            var touches = new JointTouch[8];
            for (int i = 0; i < touches.Length; ++i)
            {
                double angle = 0.3 * (i / 2 - 1.5), s = Math.Sin(angle), c = Math.Cos(angle);
                bool aboutX = i % 2 == 0;
                double half = Math.Sin(angle / 2);
                Double3 skin = aboutX ? new Double3(0, 0.012 * s, -0.012 * c) : new Double3(-0.012 * s, 0, -0.012 * c);
                touches[i].rotation = new Double4(aboutX ? half : 0, aboutX ? 0 : half, 0, Math.Cos(angle / 2));
                touches[i].positionM = new Double3(0.2 - skin.x, 0.7 - skin.y, -0.3 - skin.z);
            }
            Fingertip found = HapticRetargetingRegistration.FitFingertip(touches);
            Assert.AreEqual(1, found.known);
            Assert.That(found.offsetM.x, Is.EqualTo(0).Within(1e-9));
            Assert.That(found.offsetM.y, Is.EqualTo(0).Within(1e-9));
            Assert.That(found.offsetM.z, Is.EqualTo(-0.012).Within(1e-9));
        }

        // A finger 7 cm from the centre, carried by the plate and seen 50 ms late.
        [Test]
        public void TheTrackersLatencyIsFound()
        {
            var samples = new Sample[600];
            for (int i = 0; i < samples.Length; ++i)
            {
                double late = PlateDeg(Math.Max(i - 5, 0)) * Math.PI / 180;
                samples[i].flags = SampleFlags.PlatePosition | SampleFlags.PlateOrientation;
                samples[i].timeNs = 10000000L * i;
                samples[i].plateOrientationDeg = PlateDeg(i);
                samples[i].fingerPositionM = new Double3(0.07 * Math.Cos(late), 0, -0.07 * Math.Sin(late));
            }
            Latency found = HapticRetargetingRegistration.FitLatency(samples);
            Assert.AreEqual(1, found.known);
            Assert.That(found.latencyNs, Is.EqualTo(50000000).Within(1000000));
            Assert.AreEqual(0, samples[0].structSize, "the caller's samples are left as they were");
        }

        static double PlateDeg(int i) => 30 * Math.Sin(0.02 * i + 2e-5 * i * i);
    }
}
