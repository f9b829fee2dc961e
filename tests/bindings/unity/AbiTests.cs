using System;
using System.IO;
using System.Linq;
using System.Reflection;
using System.Runtime.InteropServices;
using NUnit.Framework;

namespace Hrt.HostTests
{
    // Tests the generated declarations. HRT_ABI_TXT is written by write_abi from api.json.
    public sealed class AbiTests
    {
        static readonly Assembly package = typeof(HapticRetargetingSession).Assembly;

        [Test]
        public void StructsHaveTheCompilersSizesAndOffsets()
        {
            string[] lines = File.ReadAllLines(Environment.GetEnvironmentVariable("HRT_ABI_TXT"));
            Assert.Greater(lines.Length, 200);
            foreach (string line in lines)
            {
                string[] words = line.Split(' ');
                Type type = package.GetType("Hrt." + words[0], true);
                if (words.Length == 2)
                {
                    Assert.AreEqual(int.Parse(words[1]), Marshal.SizeOf(type), line);
                    continue;
                }
                Assert.AreEqual(int.Parse(words[2]), (int)Marshal.OffsetOf(type, words[1]), line);
                Type field = type.GetField(words[1]).FieldType;
                Assert.AreEqual(int.Parse(words[3]),
                                Marshal.SizeOf(field.IsEnum ? Enum.GetUnderlyingType(field) : field), line);
            }
        }

        [Test]
        public void TheLibrariesExportEveryFunction()
        {
            foreach (string native in new[] {"Hrt.Native", "Hrt.PlateNative"})
                foreach (MethodInfo method in package.GetType(native).GetMethods(BindingFlags.Static | BindingFlags.NonPublic))
                    Marshal.Prelink(method); // throws if the library has no such function
        }

        // Ahead-of-time compilation omits callbacks from native code unless they are static and have this attribute.
        [Test]
        public void CallbacksAreCompiledAhead()
        {
            const BindingFlags all =
                BindingFlags.Static | BindingFlags.Instance | BindingFlags.NonPublic | BindingFlags.Public;
            MethodInfo marked = package.GetTypes().SelectMany(t => t.GetMethods(all))
                .Single(m => m.GetCustomAttribute<AOT.MonoPInvokeCallbackAttribute>() != null);
            Assert.IsTrue(marked.IsStatic);
            Type callback = marked.GetCustomAttribute<AOT.MonoPInvokeCallbackAttribute>().DelegateType;
            Assert.IsNotNull(Delegate.CreateDelegate(callback, marked));
        }
    }
}
