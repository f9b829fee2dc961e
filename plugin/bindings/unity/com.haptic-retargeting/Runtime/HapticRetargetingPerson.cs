namespace Hrt
{
    /// <summary>
    /// A simulated person, who feels the ridges of the plate and is deflected by them: a model, not a measurement of
    /// people. The same seed and configuration give the same person on every platform.
    /// </summary>
    public sealed partial class HapticRetargetingPerson : NativeObject
    {
        public HapticRetargetingPerson(ulong seed) : this(default(PersonConfig), seed)
        {
        }

        public HapticRetargetingPerson(PersonConfig config, ulong seed)
            : base(value => Native.hrt_person_destroy(new PersonHandle { value = value }))
        {
            HapticRetargetingLibrary.Load();
            config.structSize = SizeOf<PersonConfig>.Value;
            Own((out ulong created) => Native.hrt_person_create(ref config, seed, out created));
        }

        internal PersonHandle Handle => new PersonHandle { value = Value };
    }
}
