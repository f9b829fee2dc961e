using System;

namespace Hrt
{
    /// <summary>
    /// Who is this user? Their share of touch, bias and variances, and the tracker's noise, from slides over a
    /// plate that stands still. Have them slide to one target, with the plate at rest at one of -60, -30, 0, 30 and
    /// 60 degrees, eight to ten times at each, in random order, each after half a second at rest; for each slide
    /// begin a trial, add samples, end it; then solve and apply. Tried on simulated people only.
    ///
    /// <see cref="BeginTrial"/>, <see cref="AddSample"/>, <see cref="EndTrial"/> and <see cref="CancelTrial"/> make
    /// no garbage.
    /// </summary>
    public sealed class HapticRetargetingCalibration : NativeObject
    {
        /// <summary>A calibration without trials. It takes the plate's place, the lift height and the step period
        /// from the session's configuration as it is now; the two then know nothing of each other.</summary>
        public HapticRetargetingCalibration(HapticRetargetingSession session)
            : this(session, CalibrationConfig.Default)
        {
        }

        public HapticRetargetingCalibration(HapticRetargetingSession session, CalibrationConfig config)
            : base(value => Native.hrt_calibration_destroy(new CalibrationHandle { value = value }))
        {
            if (session == null) throw new ArgumentNullException(nameof(session));
            config.structSize = SizeOf<CalibrationConfig>.Value;
            session.Check(Native.hrt_calibration_create(session.Handle, ref config, out CalibrationHandle handle));
            Own(handle.value);
        }

        /// <summary>The plate stands at this orientation until the trial ends.</summary>
        public void BeginTrial(double plateOrientationDeg)
        {
            Check(Native.hrt_calibration_begin_trial(Handle, plateOrientationDeg));
        }

        /// <summary>Takes one sample in: the finger at rest, then its slide. A component's is
        /// <see cref="HapticRetargeting.ReadFinger"/>.</summary>
        public void AddSample(Sample sample)
        {
            sample.structSize = SizeOf<Sample>.Value;
            Check(Native.hrt_calibration_add_sample(Handle, ref sample));
        }

        public void EndTrial()
        {
            Check(Native.hrt_calibration_end_trial(Handle));
        }

        /// <summary>Ends the trial and forgets it, as when the user has slipped.</summary>
        public void CancelTrial()
        {
            Check(Native.hrt_calibration_cancel_trial(Handle));
        }

        /// <summary>Fits the user to the trials, which stay. Takes half a second for 20000 samples: call it on a
        /// thread that draws no frames. Throws <see cref="Result.InsufficientData"/>, with what is needed, if the
        /// trials have too little data.</summary>
        public CalibrationResult Solve()
        {
            var result = new CalibrationResult { structSize = SizeOf<CalibrationResult>.Value };
            Check(Native.hrt_calibration_solve(Handle, ref result));
            return result;
        }

        CalibrationHandle Handle => new CalibrationHandle { value = Value };
    }
}
