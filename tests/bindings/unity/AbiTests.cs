using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Reflection;
using System.Runtime.InteropServices;
using NUnit.Framework;

namespace Hrt.HostTests
{
    // The declarations against api.json, which libclang reads from the headers: sizes, offsets, functions.
    public sealed class AbiTests
    {
        static readonly Assembly package = typeof(HapticRetargetingSession).Assembly;

        string[] lines;

        [SetUp]
        public void SetUp() => lines = File.ReadAllLines(Environment.GetEnvironmentVariable("HRT_ABI_TXT"));

        [Test]
        public void StructsHaveTheCompilersSizesAndOffsets()
        {
            Type type = null;
            int structs = 0, fields = 0;
            var seen = new HashSet<string>();
            foreach (string line in lines)
            {
                string[] words = line.Split(new[] {' '}, StringSplitOptions.RemoveEmptyEntries);
                if (line.StartsWith("struct "))
                {
                    string name = Pascal(words[1].Substring("hrt_".Length));
                    if (name == "Target") name = "TargetId";
                    type = package.GetType("Hrt." + name) ?? package.GetType("Hrt." + (name += "Handle"));
                    Assert.IsNotNull(type, line);
                    Assert.AreEqual(int.Parse(words[2]), Marshal.SizeOf(type), line);
                    seen.Add(name);
                    ++structs;
                }
                else if (line.StartsWith("  "))
                {
                    string field = Camel(words[0]);
                    Assert.IsNotNull(type.GetField(field), type + " " + line);
                    Assert.AreEqual(int.Parse(words[1]), (int)Marshal.OffsetOf(type, field), type + " " + line);
                    Assert.AreEqual(int.Parse(words[2]), SizeOf(type.GetField(field).FieldType), type + " " + line);
                    ++fields;
                }
            }
            Assert.Greater(structs, 10);
            Assert.Greater(fields, 100);
        }

        [Test]
        public void FunctionsAreDeclaredAndThere()
        {
            Type native = package.GetType("Hrt.Native");
            int functions = 0;
            foreach (string line in lines.Where(l => l.StartsWith("function ")))
            {
                string name = line.Substring(0, line.IndexOf('(')).Split(' ').Last();
                string parameters = line.Substring(line.IndexOf('(')).Trim('(', ')');
                MethodInfo method = native.GetMethod(name, BindingFlags.Static | BindingFlags.NonPublic);
                Assert.IsNotNull(method, line);
                int expected = parameters == "void" ? 0 : parameters.Split(',').Length;
                Assert.AreEqual(expected, method.GetParameters().Length, line);
                Marshal.Prelink(method); // throws if the library has no such function
                ++functions;
            }
            Assert.AreEqual(functions, native.GetMethods(BindingFlags.Static | BindingFlags.NonPublic).Length);
            foreach (MethodInfo method in package.GetType("Hrt.PlateNative").GetMethods(BindingFlags.Static | BindingFlags.NonPublic))
                Marshal.Prelink(method);
            Assert.AreEqual(480, Marshal.SizeOf(typeof(PlateReport)));
            Assert.Greater(functions, 30);
        }

        // What native code calls back must be static and marked, or it is missing in a build that is compiled ahead.
        [Test]
        public void CallbacksAreCompiledAhead()
        {
            const BindingFlags all =
                BindingFlags.Static | BindingFlags.Instance | BindingFlags.NonPublic | BindingFlags.Public;
            MethodInfo[] marked = package.GetTypes().SelectMany(t => t.GetMethods(all))
                .Where(m => m.GetCustomAttribute<AOT.MonoPInvokeCallbackAttribute>() != null).ToArray();
            Assert.AreEqual(1, marked.Length);
            Assert.IsTrue(marked[0].IsStatic);
            Type callback = marked[0].GetCustomAttribute<AOT.MonoPInvokeCallbackAttribute>().DelegateType;
            Assert.IsNotNull(Delegate.CreateDelegate(callback, marked[0]));
        }

        static int SizeOf(Type type) => Marshal.SizeOf(type.IsEnum ? Enum.GetUnderlyingType(type) : type);

        static string Pascal(string name) => string.Concat(
            name.Split('_').Select(part => part.Substring(0, 1).ToUpper() + part.Substring(1).ToLower()));

        static string Camel(string name) => char.ToLower(name[0]) + Pascal(name).Substring(1);
    }
}
