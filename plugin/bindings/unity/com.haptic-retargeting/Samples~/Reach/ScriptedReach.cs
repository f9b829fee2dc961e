using System;
using Hrt;

namespace HrtSamples
{
    /// <summary>The reach that a sample of each language and engine ("host") runs: passes a scripted finger to a
    /// session, and hashes the bits of the resulting commands.</summary>
    public sealed class ScriptedReach
    {
        /// <summary>FNV-1a hash of the commands, as in ReplayReport.hash; the same on every host.</summary>
        public ulong Hash { get; private set; } = 0xcbf29ce484222325;

        public ReachSummary Summary { get; private set; }

        long seed = 7;

        public static ScriptedReach Run()
        {
            var reach = new ScriptedReach();
            using (var session = new HapticRetargetingSession(Configuration()))
            {
                TargetId cylinder = session.AddTarget(TargetRole.Real, -5, name: "cylinder");
                TargetId cup = session.AddTarget(TargetRole.Virtual, 5, name: "cup");
                session.BeginReach(cylinder, cup);
                Command command = default(Command);
                for (int i = 1; i <= 170; ++i)
                {
                    Sample sample = reach.Scripted(i, command.plateOrientationDeg);
                    if (i > 105 && i <= 108) continue; // frames that the host drops
                    command = session.Update(sample);
                    reach.Add(command);
                }
                reach.Summary = session.EndReach();
            }
            return reach;
        }

        static SessionConfig Configuration()
        {
            SessionConfig config = SessionConfig.Default;
            config.horizon = 20;
            config.guidance = Guidance.Arrival;
            config.adaptation = Adaptation.Reach;
            config.plateMaxSpeedDegS = 200;
            config.plateMaxAccelerationDegS2 = 20000;
            config.plateLatencyNs = 30000000;
            config.plateLowerStopDeg = -360;
            config.plateUpperStopDeg = 360;
            return config;
        }

        long Noise()
        {
            seed = seed * 16807 % 2147483647;
            return seed % 1001 - 500;
        }

        // Returns sample i. Coordinates are constants or quotients of integers: the same doubles on every host.
        Sample Scripted(int i, double plateDeg)
        {
            long moved = Math.Min(Math.Max(i - 10, 0), 120), distanceUm = moved * moved * (180 - moved) * 25 / 216;
            bool lost = i % 40 == 7 || i > 40 && i <= 52, lifted = i > 65 && i <= 75;
            var sample = new Sample { flags = SampleFlags.PlateOrientation, plateOrientationDeg = plateDeg };
            if (!lost) sample.flags |= SampleFlags.PlatePosition;
            if (lifted) sample.flags |= SampleFlags.Lifted;
            sample.timeNs = 20000000L * i + 400 * Noise();
            sample.fingerPositionM.x = (distanceUm * 87 / 1000 + Noise()) / 1e6;
            sample.fingerPositionM.y = lifted ? 0.03 : 0.002;
            sample.fingerPositionM.z = (50000 - distanceUm + Noise()) / 1e6;
            return sample;
        }

        void Add(Command command)
        {
            Add((ulong)command.flags);
            double[] numbers =
            {
                command.plateOrientationDeg, command.bearingDeg, command.perceivedDirectionDeg, command.feltErrorDeg,
                command.predictedMissDeg, command.missSdDeg, command.distanceToGoM, command.timeToGoS, command.tactileWeight,
                command.tactileWeightSd, command.misfit
            };
            foreach (double number in numbers) Add(number);
            Add((ulong)command.paperStep);
            Add(command.paperFingerDirectionDeg);
            Add(command.paperAimedDirectionDeg);
        }

        void Add(double number)
        {
            Add((ulong)BitConverter.DoubleToInt64Bits(number));
        }

        void Add(ulong word)
        {
            for (int shift = 0; shift < 64; shift += 8)
                Hash = unchecked((Hash ^ (word >> shift & 0xff)) * 0x100000001b3);
        }
    }
}
