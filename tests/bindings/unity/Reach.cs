// Runs the package's sample of the scripted reach without Unity. usage: Reach.exe RECORDING_CSV
using System;
using System.IO;
using HrtSamples;

static class Reach
{
    static int Main(string[] arguments)
    {
        if (arguments.Length != 1)
        {
            Console.Error.WriteLine("usage: Reach.exe RECORDING_CSV");
            return 2;
        }
        ScriptedReach reach = ScriptedReach.Run(File.ReadAllText(arguments[0]));
        Console.WriteLine("hash 0x{0:x16}", reach.Hash);
        Console.WriteLine("samples {0}, miss {1:0.00} deg of bearing (simulated)", reach.Summary.samples,
                          reach.Summary.missDeg);
        return 0;
    }
}
