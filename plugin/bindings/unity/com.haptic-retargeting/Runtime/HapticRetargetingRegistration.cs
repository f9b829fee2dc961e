using System;

namespace Hrt
{
    /// <summary>
    /// Where the plate is, from touches of marks on it; whether that is still true; where the skin of a finger is; and how
    /// late the tracker is. Positions and rotations are the library's: <see cref="Axes"/> converts Unity's. Tried on
    /// simulated touches only.
    ///
    /// Give the found pose to the plate's Transform, and <see cref="HapticRetargetingSession.Apply(Registration, long)"/>
    /// the registration, whose uncertainty then goes into what a reach reports.
    /// </summary>
    public static class HapticRetargetingRegistration
    {
        /// <summary>Fits the plate's pose. A verdict other than Holds is no error: <see cref="Advice"/> says what to do.
        /// </summary>
        public static Registration Fit(MarkTouch[] touches) => Fit(touches, RegistrationConfig.Default, out _);

        /// <summary>As above; with the distance of each touch from its mark under the pose, 0 if there is none.</summary>
        public static Registration Fit(MarkTouch[] touches, RegistrationConfig config, out double[] residualsM)
        {
            if (touches == null) throw new ArgumentNullException(nameof(touches));
            HapticRetargetingLibrary.Load();
            config.structSize = SizeOf<RegistrationConfig>.Value;
            var registration = new Registration { structSize = SizeOf<Registration>.Value };
            var residuals = new double[touches.Length];
            HapticRetargetingLibrary.Check(Native.hrt_registration_fit(
                ref config, touches, (ulong)touches.Length, (ulong)residuals.Length, residuals, ref registration));
            residualsM = residuals;
            return registration;
        }

        /// <summary>What to do about a verdict, in one line for the user.</summary>
        public static string Advice(RegistrationVerdict verdict)
        {
            HapticRetargetingLibrary.Load();
            return Utf8.Read(Native.hrt_registration_advice((uint)verdict));
        }

        /// <summary>Whether a later touch of a mark agrees, as before a reach.</summary>
        public static TouchCheck CheckTouch(Registration registration, MarkTouch touch)
        {
            HapticRetargetingLibrary.Load();
            registration.structSize = SizeOf<Registration>.Value;
            var check = new TouchCheck { structSize = SizeOf<TouchCheck>.Value };
            HapticRetargetingLibrary.Check(Native.hrt_registration_check(ref registration, ref touch, ref check));
            return check;
        }

        /// <summary>Fits the offset from a joint to the skin to touches of one mark, with the finger held differently
        /// each time. Each hand has its own.</summary>
        public static Fingertip FitFingertip(JointTouch[] touches)
        {
            if (touches == null) throw new ArgumentNullException(nameof(touches));
            RegistrationConfig config = RegistrationConfig.Default;
            var fingertip = new Fingertip { structSize = SizeOf<Fingertip>.Value };
            HapticRetargetingLibrary.Check(
                Native.hrt_fingertip_fit(ref config, touches, (ulong)touches.Length, ref fingertip));
            return fingertip;
        }

        /// <summary>Puts the skin that touches in place of the joint into a sample: for every sample of that hand, and for
        /// the touches of a registration that its reaches use.</summary>
        public static void Place(Fingertip fingertip, JointTouch joint, ref Sample sample)
        {
            HapticRetargetingLibrary.Load();
            fingertip.structSize = SizeOf<Fingertip>.Value;
            sample.structSize = SizeOf<Sample>.Value;
            HapticRetargetingLibrary.Check(Native.hrt_fingertip_place(ref fingertip, ref joint, ref sample));
        }

        /// <summary>Finds the tracker's latency from a finger that rests on the plate while the plate turns to and fro.
        /// Samples need the plate's orientation and a position. Takes about 0.1 s for 8000 samples.</summary>
        public static Latency FitLatency(Sample[] samples)
        {
            if (samples == null) throw new ArgumentNullException(nameof(samples));
            HapticRetargetingLibrary.Load();
            var sized = (Sample[])samples.Clone();
            for (int i = 0; i < sized.Length; ++i) sized[i].structSize = SizeOf<Sample>.Value;
            var latency = new Latency { structSize = SizeOf<Latency>.Value };
            HapticRetargetingLibrary.Check(Native.hrt_latency_fit(sized, (ulong)sized.Length, ref latency));
            return latency;
        }
    }
}
