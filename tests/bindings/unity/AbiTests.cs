using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Reflection;
using System.Runtime.InteropServices;
using NUnit.Framework;

namespace Hrt.HostTests
{
    // The declarations against generated/abi.txt, with which the C compiler agrees: sizes, offsets, values, functions.
    public sealed class AbiTests
    {
        static readonly Assembly package = typeof(HapticRetargetingSession).Assembly;

        // Whose names in C# are not those of the headers.
        static readonly Dictionary<string, string> enums = new Dictionary<string, string>
        {
            {"ERROR", "Result"}, {"LOG", "LogLevel"}, {"TARGET", "TargetRole"}
        };

        string[] lines;

        [SetUp]
        public void SetUp()
        {
            lines = File.ReadAllLines(Environment.GetEnvironmentVariable("HRT_ABI_TXT"));
        }

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

        // Blittable: pinned for a call and not copied, under Mono and IL2CPP alike.
        [Test]
        public void StructsCanBePinned()
        {
            Type[] structs = package.GetTypes().Where(t => t.GetField("structSize") != null).ToArray();
            Assert.Greater(structs.Length, 8);
            foreach (Type type in structs)
                GCHandle.Alloc(Activator.CreateInstance(type), GCHandleType.Pinned).Free();
        }

        [Test]
        public void ConstantsHaveTheHeadersValues()
        {
            int constants = 0;
            foreach (string line in lines.Where(l => l.StartsWith("constant ")))
            {
                string[] words = line.Split(' ');
                string value = words[2].Replace("UINT32_C", "");
                string digits = new string(value.Where(c => c == '-' || char.IsDigit(c)).ToArray());
                Assert.AreEqual(long.Parse(digits), Value(words[1].Substring("HRT_".Length)), line);
                ++constants;
            }
            Assert.Greater(constants, 40);
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

        static long Value(string name)
        {
            if (name == "OK") return (long)Result.Ok;
            FieldInfo field = typeof(Constants).GetField(Pascal(name));
            if (field != null) return Convert.ToInt64(field.GetValue(null));
            // Of which words are the enum's: LACK_OF_FIT_ANGLE is LackOfFitFlags.Angle.
            for (int end = name.IndexOf('_'); end > 0; end = name.IndexOf('_', end + 1))
            {
                string prefix = name.Substring(0, end), member = Pascal(name.Substring(end + 1)), known;
                string start = enums.TryGetValue(prefix, out known) ? known : Pascal(prefix);
                Type type = package.GetTypes().FirstOrDefault(
                    t => t.IsEnum && t.Name.StartsWith(start) && Enum.IsDefined(t, member));
                if (type != null) return Convert.ToInt64(Enum.Parse(type, member));
            }
            throw new AssertionException(name + " is in no enum");
        }

        static int SizeOf(Type type) => Marshal.SizeOf(type.IsEnum ? Enum.GetUnderlyingType(type) : type);

        static string Pascal(string name) => string.Concat(
            name.Split('_').Select(part => part.Substring(0, 1).ToUpper() + part.Substring(1).ToLower()));

        static string Camel(string name) => char.ToLower(name[0]) + Pascal(name).Substring(1);
    }
}
