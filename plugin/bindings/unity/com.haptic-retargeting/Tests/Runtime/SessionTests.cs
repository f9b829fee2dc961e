using System;
using System.IO;
using NUnit.Framework;

namespace Hrt.Tests
{
    public sealed class SessionTests
    {
        HapticRetargetingSession session;

        [SetUp]
        public void SetUp()
        {
            session = new HapticRetargetingSession();
        }

        [TearDown]
        public void TearDown()
        {
            session.Dispose();
        }

        [Test]
        public void TheLibraryIsOfThisPackagesVersion()
        {
            Assert.AreEqual(Constants.VersionMajor, HapticRetargetingLibrary.Version.Major);
            Assert.GreaterOrEqual(HapticRetargetingLibrary.Version.Minor, Constants.VersionMinor);
        }

        [Test]
        public void DefaultsAreTheLibrarys()
        {
            SessionConfig config = session.Config;
            Assert.AreEqual(3, config.horizon);
            Assert.AreEqual(100000000, config.stepPeriodNs);
            Assert.AreEqual(84.5, config.plateBoundDeg);
            Assert.AreEqual(0.2, config.tactileWeight);
            Assert.AreEqual(Guidance.Arrival, config.guidance);
            Assert.AreEqual(Adaptation.Carried, config.adaptation);
            Assert.AreEqual(0.05, config.startPositionM.z);
            Assert.AreEqual(1, config.plateRotation.w);
        }

        [Test]
        public void RefusalsSayWhatIsWrongAndWhatIsAllowed()
        {
            SessionConfig config = session.Config;
            config.tactileWeight = 0.7;
            var refusal = Assert.Throws<HapticRetargetingException>(() => session.Config = config);
            Assert.AreEqual(Result.OutOfRange, refusal.Result);
            StringAssert.Contains("tactile_weight", refusal.Message);
            StringAssert.Contains("0.499", refusal.Message);
            Assert.AreEqual(0.2, session.Config.tactileWeight);
        }

        [Test]
        public void TargetsKeepWhatTheyWereGiven()
        {
            TargetId target = session.AddTarget(TargetRole.Virtual, 12, 0.2, "gläsern");
            TargetConfig config = session.GetTarget(target);
            Assert.AreEqual(TargetRole.Virtual, config.role);
            Assert.AreEqual(12, config.directionDeg);
            Assert.AreEqual(0.2, config.distanceM);
            Assert.AreEqual("gläsern", config.name.ToString());

            Assert.IsTrue(session.TryFindTarget("gläsern", out TargetId found));
            Assert.AreEqual(target, found);
            Assert.IsFalse(session.TryFindTarget("glas", out found));

            config.directionDeg = -12;
            session.SetTarget(target, config);
            Assert.AreEqual(-12, session.GetTarget(target).directionDeg);

            session.RemoveTarget(target);
            var refusal = Assert.Throws<HapticRetargetingException>(() => session.GetTarget(target));
            Assert.AreEqual(Result.InvalidHandle, refusal.Result);
        }

        [Test]
        public void TargetsAreListedByRole()
        {
            Assert.AreEqual(0, session.GetTargets().Length);
            TargetId first = session.AddTarget(TargetRole.Real, -5);
            TargetId second = session.AddTarget(TargetRole.Virtual, 5);
            CollectionAssert.AreEqual(new[] {first, second}, session.GetTargets());
            CollectionAssert.AreEqual(new[] {second}, session.GetTargets(TargetRole.Virtual));
        }

        [Test]
        public void TargetsAreAssigned()
        {
            var reals = new[] {session.AddTarget(TargetRole.Real, 0), session.AddTarget(TargetRole.Real, 8)};
            var seen = new[] {session.AddTarget(TargetRole.Virtual, 5), session.AddTarget(TargetRole.Virtual, 9)};
            Assert.AreEqual(reals[1], session.AssignTargets(seen, reals)[0].realTarget);
            Authority[] exclusive = session.AssignTargets(seen, reals, true);
            Assert.AreEqual(reals[0], exclusive[0].realTarget);
            Assert.AreEqual(reals[1], exclusive[1].realTarget);
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

        // A linear illusion of 0.2, with the plate within 75 degrees of the motion.
        const double MaxGapDeg = 75 * 0.2;

        [Test]
        public void AuthorityReturnsWhatCanBeHeld()
        {
            TargetId near = session.AddTarget(TargetRole.Real, -5), far = session.AddTarget(TargetRole.Real, -25);
            TargetId seen = session.AddTarget(TargetRole.Virtual, 5);
            Authority authority = session.QueryAuthority(far, seen);
            Assert.AreEqual(30, authority.gapDeg);
            Assert.That(authority.maxGapDeg, Is.EqualTo(MaxGapDeg).Within(1e-9));
            Assert.That(authority.marginDeg, Is.EqualTo(MaxGapDeg - 30).Within(1e-9));
            Assert.IsFalse(authority.IsReachable);

            authority = session.QueryBestAuthority(seen);
            Assert.AreEqual(near, authority.realTarget);
            Assert.IsTrue(authority.IsReachable);

            Authority[] all = session.QueryAllAuthorities();
            Assert.AreEqual(2, all.Length);
            Assert.AreEqual(near, all[0].realTarget);
            Assert.AreEqual(far, all[1].realTarget);
        }

        // The example of the plugin's README, which says what it prints.
        [Test]
        public void AFingerStraightAheadMakesThePlateTurn()
        {
            BeginReach();
            Command command = default(Command);
            for (int frame = 0; frame <= 270; ++frame) command = session.Update(StraightAhead(frame));
            Assert.AreEqual(27, command.step);
            Assert.Greater(command.plateOrientationDeg, 45);
            ReachSummary summary = session.EndReach();
            Assert.AreEqual(271, summary.samples);
        }

        [Test]
        public void UpdatesAreRefusedOutsideAReachAndBackInTime()
        {
            var refusal = Assert.Throws<HapticRetargetingException>(() => session.Update(StraightAhead(0)));
            Assert.AreEqual(Result.WrongState, refusal.Result);
            BeginReach();
            session.Update(StraightAhead(5));
            refusal = Assert.Throws<HapticRetargetingException>(() => session.Update(StraightAhead(4)));
            Assert.AreEqual(Result.TimeReversed, refusal.Result);
            Assert.IsFalse(session.TryUpdate(StraightAhead(4), out Command command));
            StringAssert.Contains("time_ns", HapticRetargetingLibrary.LastError);
            Assert.IsTrue(session.TryUpdate(StraightAhead(5), out command));
        }

        [Test]
        public void ProfilesCanBeKept()
        {
            SessionConfig config = session.Config;
            config.tactileWeight = 0.2;
            session.Config = config;
            string profile = session.SaveProfile();
            StringAssert.Contains("\"tactile_weight\":0.2", profile);
            using (var tomorrow = new HapticRetargetingSession())
            {
                tomorrow.LoadProfile(profile);
                Assert.AreEqual(0.2, tomorrow.Config.tactileWeight);
                var refusal = Assert.Throws<HapticRetargetingException>(() => tomorrow.LoadProfile("{}"));
                Assert.AreEqual(Result.BadFormat, refusal.Result);
                Assert.Throws<ArgumentNullException>(() => tomorrow.LoadProfile(null));
            }
        }

        [Test]
        public void RecordingsReplayTheSame()
        {
            string path = Path.Combine(Path.GetTempPath(), "hrt-" + Guid.NewGuid() + ".csv");
            try
            {
                session.StartRecording(path);
                BeginReach();
                for (int frame = 0; frame <= 50; ++frame) session.Update(StraightAhead(frame));
                session.EndReach();
                Assert.AreEqual(0, session.GetRecordingStatus().rowsLost);
                RecordingStatus status = session.StopRecording();
                Assert.AreEqual(0, status.rowsLost);
                Assert.AreEqual(0, status.systemError);
                ReplayReport report = HapticRetargetingLibrary.ReplayFile(path);
                Assert.AreEqual(1, report.complete);
                Assert.AreEqual(53, report.rows);
                Assert.AreEqual(0, report.firstDifferentLine);
                Assert.AreEqual(report.hash, HapticRetargetingLibrary.ReplayText(File.ReadAllText(path)).hash);
            }
            finally
            {
                File.Delete(path);
            }
        }

        [Test]
        public void RefusalsNameTheFile()
        {
            var refusal = Assert.Throws<HapticRetargetingException>(() => session.LoadScene("/nowhere/désk.gltf"));
            StringAssert.Contains("/nowhere/désk.gltf", refusal.Message);
            Assert.Throws<ArgumentNullException>(() => session.StartRecording(null));
        }

        [Test]
        public void DisposedIsDisposed()
        {
            session.Dispose();
            session.Dispose();
            Assert.IsTrue(session.IsDisposed);
            Assert.Throws<ObjectDisposedException>(() => session.AddTarget(TargetRole.Real, 0));
            Assert.Throws<ObjectDisposedException>(() => session.TryUpdate(StraightAhead(0), out Command command));
        }

        void BeginReach()
        {
            session.BeginReach(session.AddTarget(TargetRole.Real, -5), session.AddTarget(TargetRole.Virtual, 5));
        }

        static Sample StraightAhead(int frame)
        {
            return new Sample
            {
                flags = SampleFlags.PlatePosition,
                timeNs = frame * 11111111L,
                fingerPositionM = new Double3(0, 0, 0.05 - frame * 0.1 / 270)
            };
        }
    }
}
