// Runs the package's sample of the scripted reach without Unity.
using System;
using HrtSamples;

static class Reach
{
    static void Main()
    {
        ScriptedReach reach = ScriptedReach.Run();
        Console.WriteLine("hash 0x{0:x16}", reach.Hash);
        Console.WriteLine("samples {0}, miss {1:0.00} deg of bearing (simulated)", reach.Summary.samples,
                          reach.Summary.missDeg);
    }
}
