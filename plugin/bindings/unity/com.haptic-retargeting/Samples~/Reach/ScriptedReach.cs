using System;
using System.Globalization;
using Hrt;

namespace HrtSamples
{
    /// <summary>The reach that the library's every host runs: feeds a recorded finger to a session, and hashes the
    /// commands that come out, bit by bit. A simulation: nobody's finger was recorded.</summary>
    public sealed class ScriptedReach
    {
        /// <summary>FNV-1a of the commands, as ReplayReport.hash has it; the same on every host.</summary>
        public ulong Hash { get; private set; } = 0xcbf29ce484222325;

        public ReachSummary Summary { get; private set; }

        /// <summary>Runs the reach of a recording's text.</summary>
        public static ScriptedReach Run(string recording)
        {
            var reach = new ScriptedReach();
            using (var session = new HapticRetargetingSession(Configuration()))
            {
                TargetId cylinder = session.AddTarget(TargetRole.Real, -5, name: "cylinder");
                TargetId cup = session.AddTarget(TargetRole.Virtual, 5, name: "cup");
                session.BeginReach(cylinder, cup);
                reach.Feed(session, recording);
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

        void Feed(HapticRetargetingSession session, string recording)
        {
            string[] columns = null;
            foreach (string line in recording.Split(new[] {'\r', '\n'}, StringSplitOptions.RemoveEmptyEntries))
            {
                if (line[0] == '#') continue;
                string[] cells = line.Split(',');
                if (columns == null) columns = cells;
                if (cells.Length != columns.Length)
                    throw new FormatException("a row of the recording is cut off: " + line);
                if (Cell(columns, cells, "call") == "update") Add(session.Update(ReadSample(columns, cells)));
            }
        }

        static Sample ReadSample(string[] columns, string[] cells) => new Sample
        {
            timeNs = long.Parse(Cell(columns, cells, "time_ns"), CultureInfo.InvariantCulture),
            flags = (SampleFlags)uint.Parse(Cell(columns, cells, "sample_flags"), CultureInfo.InvariantCulture),
            fingerPositionM = new Double3(Number(columns, cells, "sample_x_m"), Number(columns, cells, "sample_y_m"),
                                          Number(columns, cells, "sample_z_m")),
            plateOrientationDeg = Number(columns, cells, "measured_plate_deg")
        };

        // An empty cell is 0, which is right for what the flags do not name. Mono's double.Parse is off in the last
        // bit now and then; a whole number of few digits, divided by a power of ten, is not.
        static double Number(string[] columns, string[] cells, string name)
        {
            string cell = Cell(columns, cells, name);
            if (cell == "") return 0;
            int exponentAt = cell.IndexOf('e'), digitsEnd = exponentAt < 0 ? cell.Length : exponentAt;
            int pointAt = cell.IndexOf('.'), decimals = pointAt < 0 ? 0 : digitsEnd - pointAt - 1;
            string exponentText = exponentAt < 0 ? "0" : cell.Substring(exponentAt + 1);
            string digitsText = cell.Substring(0, digitsEnd).Replace(".", "");
            int exponent = int.Parse(exponentText, CultureInfo.InvariantCulture);
            long digits = long.Parse(digitsText, CultureInfo.InvariantCulture);
            if (Math.Abs(digits) > 1L << 53 || exponent > decimals || decimals - exponent > 22)
                throw new FormatException($"{name} {cell} has more digits than are read exactly");
            double divisor = 1;
            for (int i = exponent; i < decimals; ++i) divisor *= 10;
            return digits / divisor;
        }

        static string Cell(string[] columns, string[] cells, string name)
        {
            int column = Array.IndexOf(columns, name);
            if (column < 0) throw new FormatException($"the recording lacks the column {name}");
            return cells[column];
        }

        void Add(Command command)
        {
            Add((ulong)command.flags);
            Add((ulong)command.step);
            double[] numbers =
            {
                command.plateOrientationDeg, command.fingerDirectionDeg, command.perceivedDirectionDeg, command.aimedDirectionDeg,
                command.distanceToGoM, command.tactileWeight, command.tactileWeightSd, command.timeToGoS, command.feltErrorDeg,
                command.predictedMissDeg, command.misfit, command.missSdDeg
            };
            foreach (double number in numbers) Add((ulong)BitConverter.DoubleToInt64Bits(number));
        }

        void Add(ulong word)
        {
            for (int shift = 0; shift < 64; shift += 8)
                Hash = unchecked((Hash ^ (word >> shift & 0xff)) * 0x100000001b3);
        }
    }
}
