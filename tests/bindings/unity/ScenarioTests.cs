using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using NUnit.Framework;

namespace Hrt.HostTests
{
    /// <summary>The scenario of all hosts (../scenario.txt), through HapticRetargetingSession.</summary>
    public sealed class ScenarioTests
    {
        readonly Dictionary<string, TargetId> targets = new Dictionary<string, TargetId>();
        HapticRetargetingSession session;
        Dictionary<string, string> arguments;
        string saved;

        [Test]
        public void IsPlayed()
        {
            string[] lines = File.ReadAllLines(Environment.GetEnvironmentVariable("HRT_SCENARIO"))
                .Where(line => line != "" && line[0] != '#').ToArray();
            Assert.Greater(lines.Length, 30);
            using (session = new HapticRetargetingSession())
                foreach (string line in lines) Play(line);
        }

        void Play(string line)
        {
            string[] refused = Split(line, " ! "), gives = Split(refused[0], " -> "), call = Split(gives[0], " ");
            arguments = Pairs(call[1]);
            Dictionary<string, double> values = null;
            if (refused[1] == "")
            {
                values = Made(call[0]);
            }
            else
            {
                string[] wanted = Split(refused[1], " ");
                var refusal = Assert.Throws<HapticRetargetingException>(() => Made(call[0]));
                Assert.AreEqual(wanted[0].Replace("_", ""), refusal.Result.ToString().ToUpperInvariant());
                StringAssert.Contains(wanted[1], refusal.Message);
            }
            foreach (KeyValuePair<string, string> pair in Pairs(gives[1]))
                if (pair.Key == "flags") Assert.AreNotEqual(0, (int)values[pair.Key] & int.Parse(pair.Value));
                else Assert.AreEqual(Parse(pair.Value), values[pair.Key], 1e-4);
        }

        Dictionary<string, double> Made(string call)
        {
            switch (call)
            {
                case "configure":
                    SessionConfig config = session.Config;
                    config.tactileWeight = Number("tactile_weight");
                    session.Config = config;
                    return null;
                case "target":
                    TargetRole role = arguments["role"] == "real" ? TargetRole.Real : TargetRole.Virtual;
                    targets[arguments["name"]] =
                        session.AddTarget(role, Number("direction_deg"), Number("distance_m"), arguments["name"]);
                    return null;
                case "remove":
                    session.RemoveTarget(Target("name"));
                    return null;
                case "gap":
                    return Values(session.QueryGap(Target("real"), Target("virtual")));
                case "begin":
                    session.BeginReach(Target("real"), Target("virtual"));
                    return null;
                case "retarget":
                    session.RetargetReach(Target("real"), Target("virtual"));
                    return null;
                case "touched":
                    session.ReachTouched(new Contact { flags = ContactFlags.PlatePosition, positionM = Place("at"), sdM = Number("sd_m") });
                    return null;
                case "cancel":
                    session.CancelReach();
                    return null;
                case "end":
                    return new Dictionary<string, double> { { "samples", session.EndReach().samples } };
                case "update":
                    return Update(SampleFlags.PlatePosition, (long)Number("time_ns"), Place("at"));
                case "lost":
                    return Update(SampleFlags.None, (long)Number("time_ns"), new Double3());
                case "slide":
                    return Slide(Place("to"), (int)Number("frames"));
                case "save_profile":
                    saved = session.SaveProfile();
                    return null;
                case "load_profile":
                    session.LoadProfile(arguments.ContainsKey("text") ? arguments["text"] : saved);
                    return null;
                default:
                    throw new NotSupportedException(call);
            }
        }

        static Dictionary<string, double> Values(Gap gap)
        {
            return new Dictionary<string, double>
            {
                { "gap_deg", gap.gapDeg }, { "max_gap_deg", gap.maxGapDeg },
                { "margin_deg", gap.marginDeg }, { "reachable", gap.IsReachable ? 1 : 0 }
            };
        }

        Dictionary<string, double> Update(SampleFlags flags, long timeNs, Double3 fingerM)
        {
            Command command = session.Update(new Sample { flags = flags, timeNs = timeNs, fingerPositionM = fingerM });
            return new Dictionary<string, double> { { "flags", (double)command.flags } };
        }

        Dictionary<string, double> Slide(Double3 to, int frames)
        {
            for (int i = 0; i < frames; ++i)
            {
                double share = i / (frames - 1.0);
                Update(SampleFlags.PlatePosition, 11111111L * i,
                       new Double3(share * to.x, share * to.y, 0.05 + share * (to.z - 0.05)));
            }
            return null;
        }

        TargetId Target(string key) => targets[arguments[key]];

        double Number(string key) => Parse(arguments[key]);

        Double3 Place(string key)
        {
            double[] parts = arguments[key].Split(',').Select(Parse).ToArray();
            return new Double3(parts[0], parts[1], parts[2]);
        }

        static double Parse(string text) =>
            text == "nan" ? double.NaN : double.Parse(text, CultureInfo.InvariantCulture);

        // What is before the separator, and behind it.
        static string[] Split(string text, string separator)
        {
            int at = text.IndexOf(separator, StringComparison.Ordinal);
            return at < 0 ? new[] {text, ""} : new[] {text.Substring(0, at), text.Substring(at + separator.Length)};
        }

        static Dictionary<string, string> Pairs(string words) =>
            words.Split(new[] {' '}, StringSplitOptions.RemoveEmptyEntries).Select(word => Split(word, "="))
                .ToDictionary(pair => pair[0], pair => pair[1]);
    }
}
