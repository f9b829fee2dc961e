using System;
using System.Globalization;
using System.IO;
using NUnit.Framework;

namespace Hrt.Tests
{
    public sealed class SessionTests
    {
        HapticRetargetingSession session;

        [SetUp]
        public void SetUp() => session = new HapticRetargetingSession();

        [TearDown]
        public void TearDown() => session.Dispose();

        [Test]
        public void TheLibraryHasTheVersionOfThePackage()
        {
            Assert.AreEqual(Constants.VersionMajor, HapticRetargetingLibrary.Version.Major);
            Assert.GreaterOrEqual(HapticRetargetingLibrary.Version.Minor, Constants.VersionMinor);
        }

        [Test]
        public void ListsHaveTheLengthOfTheirContent()
        {
            Assert.AreEqual(0, session.ListTargets(0).Length);
            TargetId first = session.AddTarget(TargetRole.Real, -5);
            TargetId second = session.AddTarget(TargetRole.Virtual, 5);
            CollectionAssert.AreEqual(new[] {first, second}, session.ListTargets(0));
            CollectionAssert.AreEqual(new[] {second}, session.ListTargets(TargetRole.Virtual));
            var two = new[] {first, session.AddTarget(TargetRole.Real, 8)};
            Assert.AreEqual(two[1], session.AssignTargets(new[] {second}, two, AssignFlags.Exclusive)[0].realTarget);
        }

        [Test]
        public void TextsDoNotDependOnTheCulture()
        {
            CultureInfo culture = CultureInfo.CurrentCulture;
            CultureInfo.CurrentCulture = new CultureInfo("de-DE");
            try
            {
                Assert.AreEqual("(0.5, -1.25, 3)", new Double3(0.5, -1.25, 3).ToString());
                Assert.AreEqual("(0.5, 0, 0, 1)", new Double4(0.5, 0, 0, 1).ToString());
                StringAssert.Contains("\"tactile_weight\":0.2", session.SaveProfile());
            }
            finally
            {
                CultureInfo.CurrentCulture = culture;
            }
        }

        [Test]
        public void NamesEndWithin63Bytes()
        {
            string longest = new string('x', 63);
            Assert.AreEqual(longest, new Name(longest).ToString());
            Assert.AreEqual("", default(Name).ToString());
            Assert.Throws<ArgumentException>(() => new Name(longest + "x"));
            Assert.Throws<ArgumentException>(() => new Name("a\0b"));
            Assert.Throws<ArgumentNullException>(() => new Name(null));
        }

        [Test]
        public void ARefusedUpdateThrowsOrReturnsFalse()
        {
            var refusal = Assert.Throws<HapticRetargetingException>(() => session.Update(StraightAhead(0)));
            Assert.AreEqual(Result.WrongState, refusal.Result);
            Assert.IsFalse(session.TryUpdate(StraightAhead(0), out Command command));
            StringAssert.Contains("hrt_reach_update", HapticRetargetingLibrary.LastError);
        }

        [Test]
        public void NullTextsThrow()
        {
            Assert.Throws<ArgumentNullException>(() => session.LoadProfile(null));
            Assert.Throws<ArgumentNullException>(() => session.StartRecording(null));
        }

        [Test]
        public void RecordingsReplayBitForBit()
        {
            string path = Path.Combine(Path.GetTempPath(), "hrt-" + Guid.NewGuid() + ".csv");
            try
            {
                session.StartRecording(path);
                session.BeginReach(session.AddTarget(TargetRole.Real, -5), session.AddTarget(TargetRole.Virtual, 5));
                for (int frame = 0; frame <= 50; ++frame) session.Update(StraightAhead(frame));
                session.EndReach();
                Assert.AreEqual(0, session.GetRecordingStatus().rowsLost);
                RecordingStatus status = session.StopRecording();
                Assert.AreEqual(0, status.rowsLost);
                Assert.AreEqual(0, status.systemError);
                ReplayReport report = HapticRetargetingLibrary.Replay(path);
                Assert.AreEqual(1, report.complete);
                Assert.AreEqual(53, report.rows);
                Assert.AreEqual(0, report.firstDifferentLine);
            }
            finally
            {
                File.Delete(path);
            }
        }

        [Test]
        public void CallsOnADisposedSessionThrow()
        {
            session.Dispose();
            session.Dispose();
            Assert.IsTrue(session.IsDisposed);
            Assert.Throws<ObjectDisposedException>(() => session.AddTarget(TargetRole.Real, 0));
            Assert.Throws<ObjectDisposedException>(() => session.TryUpdate(StraightAhead(0), out Command command));
        }

        static Sample StraightAhead(int frame) => new Sample
        {
            flags = SampleFlags.PlatePosition,
            timeNs = frame * 11111111L,
            fingerPositionM = new Double3(0, 0, 0.05 - frame * 0.1 / 270)
        };
    }
}
