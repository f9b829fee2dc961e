// Makes an assembly that Mono's compiler has made one of .NET Standard 2.1: both have the types that it uses, in assemblies of
// other names. With --facade it writes the netstandard.dll by which Mono finds these types where its own is not installed.
// usage: Retarget.exe ASSEMBLY | Retarget.exe --facade ASSEMBLY NETSTANDARD
using System;
using System.IO;
using System.Linq;
using Mono.Cecil;

static class Retarget
{
    // Of netstandard.dll, as published. Its token is the last 8 bytes of its SHA-1, the last one first.
    const string PublicKey =
        "00240000048000009400000006020000002400005253413100040000010001004b86c4cb78549b34bab61a3b1800e23bfeb5b3ec3900740415" +
        "36a7e3cbd97f5f04cf0f857155a8928eaa29ebfd11cfbbad3ba70efea7bda3226c6a8d370a4cd303f714486b6ebc225985a638471e6ef571cc" +
        "92a4613c00b8fa65d61ccee0cbe5f36330c9a01f4183559f1bef24cc2917c6d913e3a541333a1d05d9bed22b38cb";

    static int Main(string[] arguments)
    {
        if (arguments.Length == 3 && arguments[0] == "--facade")
        {
            WriteFacade(ModuleDefinition.ReadModule(arguments[1]), arguments[2]);
            return 0;
        }
        byte[] bytes = File.ReadAllBytes(arguments[0]);
        ModuleDefinition module = ModuleDefinition.ReadModule(new MemoryStream(bytes));
        AssemblyNameReference[] references = module.AssemblyReferences.ToArray();
        if (references.Length != 1 || references[0].Name != "mscorlib")
        {
            Console.Error.WriteLine("the assembly needs " + string.Join(", ", references.Select(one => one.Name)) +
                                    "; mscorlib alone is allowed");
            return 1;
        }
        references[0].Name = "netstandard";
        references[0].Version = new Version(2, 1, 0, 0);
        references[0].PublicKeyToken = new byte[] {0xcc, 0x7b, 0x13, 0xff, 0xcd, 0x2d, 0xdd, 0x51};
        module.Write(arguments[0]);
        return 0;
    }

    static void WriteFacade(ModuleDefinition user, string path)
    {
        byte[] key = Enumerable.Range(0, PublicKey.Length / 2)
                         .Select(i => Convert.ToByte(PublicKey.Substring(2 * i, 2), 16)).ToArray();
        AssemblyDefinition facade = AssemblyDefinition.CreateAssembly(
            new AssemblyNameDefinition("netstandard", new Version(2, 1, 0, 0)) { PublicKey = key }, "netstandard.dll",
            ModuleKind.Dll);
        AssemblyNameReference mscorlib = new AssemblyNameReference("mscorlib", new Version(4, 0, 0, 0));
        facade.MainModule.AssemblyReferences.Add(mscorlib);
        foreach (TypeReference type in user.GetTypeReferences().Where(type => type.DeclaringType == null))
            facade.MainModule.ExportedTypes.Add(
                new ExportedType(type.Namespace, type.Name, facade.MainModule, mscorlib) { IsForwarder = true });
        facade.Write(path);
    }
}
