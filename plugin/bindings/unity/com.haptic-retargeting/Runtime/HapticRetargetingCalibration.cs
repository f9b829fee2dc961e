using System;

namespace Hrt
{
    /// <summary>
    /// Who is this user? The curve of their illusion, bias and habit, and the tracker's noise, from slides over a
    /// plate that stands still. <see cref="NextAngle"/> has the plate's orientation for each slide; each is after half a
    /// second at rest. Solve and NextAngle take up to half a second: call them on a thread that draws no frames. Tried on
    /// simulated people only.
    /// </summary>
    public sealed partial class HapticRetargetingCalibration : NativeObject
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

        internal CalibrationHandle Handle => new CalibrationHandle { value = Value };
    }
}
