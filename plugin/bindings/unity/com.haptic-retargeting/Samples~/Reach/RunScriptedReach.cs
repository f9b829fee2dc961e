using System;
using UnityEngine;

namespace HrtSamples
{
    /// <summary>Add this to any object, assign reach_hash.txt, and press play: the console shows whether the commands
    /// equal those of the library in other engines and languages.</summary>
    public sealed class RunScriptedReach : MonoBehaviour
    {
        public TextAsset expectedHash;

        void Start()
        {
            ScriptedReach reach = ScriptedReach.Run();
            string hash = "0x" + reach.Hash.ToString("x16");
            string text = $"Scripted reach (simulated): hash {hash}; the hand ended " +
                          $"{reach.Summary.distanceToTargetM * 1000:0.0} mm from the real target, " +
                          $"{Math.Abs(reach.Summary.missDeg):0.00} degrees off its bearing";
            if (hash == expectedHash.text.Trim()) Debug.Log(text + ", as on every host", this);
            else Debug.LogError(text + ", but every other host has the hash " + expectedHash.text.Trim() + "; check the library's version", this);
        }
    }
}
