// A double of NUnit, which Debian has no longer: what the tests of the Unity package use of it, and a runner.
//   mono RunTests.exe ASSEMBLY...    ends with 1 if a test fails or an assembly has none
using System;
using System.Collections;
using System.Linq;
using System.Reflection;
using System.Text.RegularExpressions;

namespace NUnit.Framework
{
    [AttributeUsage(AttributeTargets.Method)] public sealed class TestAttribute : Attribute { }
    [AttributeUsage(AttributeTargets.Method)] public sealed class SetUpAttribute : Attribute { }
    [AttributeUsage(AttributeTargets.Method)] public sealed class TearDownAttribute : Attribute { }

    [AttributeUsage(AttributeTargets.Method, AllowMultiple = true)]
    public sealed class TestCaseAttribute : Attribute
    {
        public readonly object[] Arguments;
        public TestCaseAttribute(params object[] arguments) { Arguments = arguments; }
    }

    public delegate void TestDelegate();

    public sealed class AssertionException : Exception
    {
        public AssertionException(string message) : base(message) { }
    }

    public sealed class Near
    {
        public readonly double Expected;
        public double Tolerance;
        public Near(double expected) { Expected = expected; }
        public Near Within(double tolerance) { Tolerance = tolerance; return this; }
    }

    public static class Is
    {
        public static Near EqualTo(double expected) { return new Near(expected); }
    }

    public static class Assert
    {
        internal static void Expect(bool holds, object expected, object actual, string message)
        {
            if (!holds) throw new AssertionException(message + " expected: " + Show(expected) + ", is: " + Show(actual));
        }

        static string Show(object value)
        {
            if (value == null) return "null";
            return value is IEnumerable list && !(value is string) ? "[" + string.Join(", ", list.Cast<object>().Select(Show)) + "]" : value.ToString();
        }

        static bool IsNumber(object value) { return value is IConvertible && !(value is string || value is bool || value is char || value is Enum); }

        // Numbers of any type by value, lists by their elements, as NUnit compares.
        internal static bool Same(object expected, object actual)
        {
            if (expected == null || actual == null) return expected == actual;
            if (IsNumber(expected) && IsNumber(actual))
                return expected is double || actual is double || expected is float || actual is float
                    ? Convert.ToDouble(expected).Equals(Convert.ToDouble(actual)) : Convert.ToDecimal(expected) == Convert.ToDecimal(actual);
            if (expected is string || !(expected is IEnumerable first) || !(actual is IEnumerable second)) return expected.Equals(actual);
            object[] a = first.Cast<object>().ToArray(), b = second.Cast<object>().ToArray();
            return a.Length == b.Length && a.Zip(b, Same).All(same => same);
        }

        public static void AreEqual(object expected, object actual, string message = "") { Expect(Same(expected, actual), expected, actual, message); }
        // Without objects, which tests of garbage would count.
        public static void AreEqual(long expected, long actual, string message = "") { if (expected != actual) Expect(false, expected, actual, message); }
        public static void AreNotEqual(object other, object actual, string message = "") { Expect(!Same(other, actual), "other", actual, message); }
        // The difference must be within: NaN never is.
        public static void AreEqual(double expected, double actual, double tolerance, string message = "") { Expect(expected.Equals(actual) || Math.Abs(expected - actual) <= tolerance, expected, actual, message); }
        public static void That(double actual, Near near, string message = "") { AreEqual(near.Expected, actual, near.Tolerance, message); }
        public static void IsTrue(bool holds, string message = "") { Expect(holds, true, holds, message); }
        public static void IsFalse(bool holds, string message = "") { Expect(!holds, false, holds, message); }
        public static void IsNull(object value, string message = "") { Expect(value == null, null, value, message); }
        public static void IsNotNull(object value, string message = "") { Expect(value != null, "not null", value, message); }
        public static void Greater(double value, double than, string message = "") { Expect(value > than, "> " + than, value, message); }
        public static void GreaterOrEqual(double value, double than, string message = "") { Expect(value >= than, ">= " + than, value, message); }
        public static void Less(double value, double than, string message = "") { Expect(value < than, "< " + than, value, message); }

        public static T Throws<T>(TestDelegate code, string message = "") where T : Exception
        {
            Exception thrown = null;
            try { code(); }
            catch (Exception exception) { thrown = exception; }
            Expect(thrown != null && thrown.GetType() == typeof(T), typeof(T), thrown, message);
            return (T)thrown;
        }
    }

    public static class StringAssert
    {
        public static void Contains(string expected, string actual) { Assert.Expect(actual.Contains(expected), expected, actual, "part"); }
        public static void StartsWith(string expected, string actual) { Assert.Expect(actual.StartsWith(expected, StringComparison.Ordinal), expected, actual, "start"); }
        public static void EndsWith(string expected, string actual) { Assert.Expect(actual.EndsWith(expected, StringComparison.Ordinal), expected, actual, "end"); }
        public static void IsMatch(string pattern, string actual) { Assert.Expect(Regex.IsMatch(actual, pattern), pattern, actual, "match"); }
    }

    public static class CollectionAssert
    {
        public static void AreEqual(IEnumerable expected, IEnumerable actual, string message = "") { Assert.AreEqual(expected, actual, message); }
    }

    static class RunTests
    {
        static void Call<T>(object fixture) where T : Attribute
        {
            foreach (MethodInfo method in fixture.GetType().GetMethods().Where(m => m.IsDefined(typeof(T)))) method.Invoke(fixture, null);
        }

        // One test, in a fixture that its constructor and SetUp methods have made ready.
        static Exception Failure(object fixture, MethodInfo test, object[] arguments)
        {
            try
            {
                Call<SetUpAttribute>(fixture);
                try { test.Invoke(fixture, arguments.Zip(test.GetParameters(), (value, to) => Convert.ChangeType(value, to.ParameterType)).ToArray()); }
                finally { Call<TearDownAttribute>(fixture); }
                return null;
            }
            catch (Exception failure) { return failure.InnerException ?? failure; }
        }

        static int Main(string[] assemblies)
        {
            int failed = 0;
            foreach (string name in assemblies)
            {
                int run = 0;
                foreach (Type type in Assembly.LoadFrom(name).GetTypes().Where(t => t.IsPublic))
                {
                    var tests = (from method in type.GetMethods()
                                 from test in method.IsDefined(typeof(TestAttribute)) ? new[] {new object[0]} : method.GetCustomAttributes<TestCaseAttribute>().Select(c => c.Arguments)
                                 select new {method, test}).ToList();
                    object fixture = tests.Count > 0 ? Activator.CreateInstance(type) : null;
                    foreach (var one in tests)
                    {
                        ++run;
                        Exception failure = Failure(fixture, one.method, one.test);
                        if (failure == null) continue;
                        ++failed;
                        Console.WriteLine("FAILED " + type.Name + "." + one.method.Name + ": " + failure);
                    }
                }
                Console.WriteLine(name + ": " + run + " tests");
                if (run == 0) ++failed;
            }
            return failed > 0 ? 1 : 0;
        }
    }
}
