// Runs the tests of NUnit fixtures, because Debian's runner depends on desktop packages.
//   mono RunTests.exe ASSEMBLY...    exit code 1 if a test fails or an assembly has no test
using System;
using System.Linq;
using System.Reflection;
using NUnit.Framework;

static class RunTests
{
    static void Call<T>(object fixture) where T : Attribute
    {
        foreach (MethodInfo method in fixture.GetType().GetMethods().Where(m => m.IsDefined(typeof(T)))) method.Invoke(fixture, null);
    }

    // Runs one test between the fixture's SetUp and TearDown methods. Returns its exception, or null.
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
