using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using NUnit.Framework;

namespace Hrt.HostTests
{
    /// <summary>Runs the scenario of all hosts (../scenario.txt) by HapticRetargetingSession.</summary>
    public sealed class ScenarioTests
    {
        readonly Dictionary<string, TargetId> targets = new Dictionary<string, TargetId>();
        HapticRetargetingSession session;
        Dictionary<string, string> arguments;
        readonly Dictionary<string, double> values = new Dictionary<string, double>();
        string saved;

        [Test]
        public void GivesTheExpectedResults()
        {
            string[] lines = File.ReadAllLines(Environment.GetEnvironmentVariable("HRT_SCENARIO"))
                .Where(line => line != "" && line[0] != '#').ToArray();
            Assert.Greater(lines.Length, 30);
            Dictionary<string, Action> calls = Calls();
            using (session = new HapticRetargetingSession())
                foreach (string line in lines) Play(line, calls);
        }

        void Play(string line, Dictionary<string, Action> calls)
        {
            string[] refused = Split(line, " ! "), gives = Split(refused[0], " -> "), call = Split(gives[0], " ");
            arguments = Pairs(call[1]);
            values.Clear();
            Assert.IsTrue(calls.TryGetValue(call[0], out Action make), line);
            if (refused[1] == "")
            {
                make();
            }
            else
            {
                string[] wanted = Split(refused[1], " ");
                var refusal = Assert.Throws<HapticRetargetingException>(() => make());
                Assert.AreEqual(wanted[0].Replace("_", ""), refusal.Result.ToString().ToUpperInvariant());
                StringAssert.Contains(wanted[1], refusal.Message);
            }
            foreach (KeyValuePair<string, string> pair in Pairs(gives[1]))
                if (pair.Key == "flags") Assert.AreNotEqual(0, (int)values[pair.Key] & int.Parse(pair.Value));
                else Assert.AreEqual(Parse(pair.Value), values[pair.Key], 1e-4);
        }

        // Returns the calls of the scenario by name. They read `arguments` and write results to `values`.
        Dictionary<string, Action> Calls() => new Dictionary<string, Action>
        {
            { "configure", () => session.Config = With(session.Config, Number("tactile_weight")) },
            {
                "target", () => targets[arguments["name"]] =
                    session.AddTarget(arguments["role"] == "real" ? TargetRole.Real : TargetRole.Virtual,
                                      Number("direction_deg"), Number("distance_m"), arguments["name"])
            },
            { "remove", () => session.RemoveTarget(Target("name")) },
            { "gap", () => Give(session.QueryGap(Target("real"), Target("virtual"))) },
            { "begin", () => session.BeginReach(Target("real"), Target("virtual")) },
            { "retarget", () => session.RetargetReach(Target("real"), Target("virtual")) },
            { "touched", () => session.ReachTouched(new Contact { flags = ContactFlags.PlatePosition, positionM = Place("at"), sdM = Number("sd_m") }) },
            { "cancel", () => session.CancelReach() },
            { "end", () => values["samples"] = session.EndReach().samples },
            { "update", () => Update(SampleFlags.PlatePosition, (long)Number("time_ns"), Place("at")) },
            { "lost", () => Update(SampleFlags.None, (long)Number("time_ns"), new Double3()) },
            { "slide", Slide },
            { "set_up", SetUp },
            { "save_profile", () => saved = session.SaveProfile() },
            { "load_profile", () => session.LoadProfile(arguments.ContainsKey("text") ? arguments["text"] : saved) }
        };

        static SessionConfig With(SessionConfig config, double tactileWeight)
        {
            config.tactileWeight = tactileWeight;
            return config;
        }

        void Give(Gap gap)
        {
            values["gap_deg"] = gap.gapDeg;
            values["max_gap_deg"] = gap.maxGapDeg;
            values["margin_deg"] = gap.marginDeg;
            values["reachable"] = gap.IsReachable ? 1 : 0;
        }

        void Update(SampleFlags flags, long timeNs, Double3 fingerM) => values["flags"] =
            (double)session.Update(new Sample { flags = flags, timeNs = timeNs, fingerPositionM = fingerM }).flags;

        void Slide()
        {
            int frames = (int)Number("frames"), copies = (int)Number("copies", 1);
            long begin = (long)Number("begin_ns", 0), every = (long)Number("every_ns", 11111111);
            Double3 to = Place("to"), from = arguments.ContainsKey("from") ? Place("from") : new Double3(0, 0, 0.05);
            for (int i = 0; i < frames; ++i)
            {
                if (arguments.ContainsKey("real")) session.RetargetReach(Target("real"), Target("virtual"));
                double share = (i - i % copies) / (frames - 1.0);
                Update(SampleFlags.PlatePosition, begin + every * i,
                       new Double3(from.x + share * (to.x - from.x), from.y + share * (to.y - from.y),
                                   from.z + share * (to.z - from.z)));
            }
        }

        void SetUp()
        {
            session.BeginSetup((SetupFlags)Number("what"), SetupConfig.Default);
            using (var person = new HapticRetargetingPerson(1))
            {
                person.Begin(session, default(TargetId));
                var result = new SetupResult { left = (SetupFlags)Number("what") };
                double plateDeg = 0;
                for (long i = 0; i < Number("frames") && result.left != 0; ++i)
                {
                    SetupStep step = session.UpdateSetup(person.Move(i * 11111111, plateDeg));
                    plateDeg = step.plateOrientationDeg;
                    if (step.instruction == Step.Finish) result = session.FinishSetup();
                }
                values["done"] = (double)result.done;
                values["left"] = (double)result.left;
                values["dropped"] = (double)result.dropped;
            }
        }

        TargetId Target(string key) => targets[arguments[key]];

        double Number(string key) => Parse(arguments[key]);

        double Number(string key, double otherwise) => arguments.ContainsKey(key) ? Number(key) : otherwise;

        Double3 Place(string key)
        {
            double[] parts = arguments[key].Split(',').Select(Parse).ToArray();
            return new Double3(parts[0], parts[1], parts[2]);
        }

        static double Parse(string text) =>
            text == "nan" ? double.NaN : double.Parse(text, CultureInfo.InvariantCulture);

        // Returns the text before and after the separator.
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
