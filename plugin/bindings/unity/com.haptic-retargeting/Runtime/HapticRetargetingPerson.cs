namespace Hrt
{
    /// <summary>
    /// A simulated person, who feels the plate and is bent by it: a finger for first programs and tests. A model, and no
    /// measurement of people. The same seed is the same person on every host.
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
            Check(Native.hrt_person_create(ref config, seed, out PersonHandle handle));
            Own(handle.value);
        }

        internal PersonHandle Handle => new PersonHandle { value = Value };
    }
}
