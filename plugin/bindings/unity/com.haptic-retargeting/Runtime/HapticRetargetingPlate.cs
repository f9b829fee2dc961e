using System;
using System.Threading;

namespace Hrt
{
    /// <summary>
    /// The device that turns the plate, driven by libhrt_plate: a plate with the line protocol, or a Dynamixel servo. A
    /// thread of that library communicates with the plate, so calls do not wait, except <see cref="WaitUntilReady"/>
    /// and <see cref="NativeObject.Dispose"/>, which stops the plate within half a second. The plate stops if there is
    /// no call for <see cref="PlateOptions.hostTimeoutNs"/>. For Linux and Windows on x64.
    ///
    /// <see cref="Set"/>, <see cref="Stop"/> and <see cref="Get"/> allocate no managed memory, unless they throw.
    /// </summary>
    public sealed partial class HapticRetargetingPlate : NativeObject
    {
        /// <summary>Starts to open a plate: "serial:/dev/ttyACM0", "serial:COM3", "dynamixel:/dev/ttyUSB0?id=1", or
        /// the file that hrt-plate commission writes.</summary>
        public HapticRetargetingPlate(string device) : this(device, PlateOptions.Default)
        {
        }

        public HapticRetargetingPlate(string device, PlateOptions options)
            : base(value => PlateNative.hrt_plate_close(new PlateHandle { value = value }))
        {
            Load();
            byte[] name = Utf8.NullTerminated(device, nameof(device));
            options.structSize = SizeOf<PlateOptions>.Value;
            Own((out ulong created) => PlateNative.hrt_plate_open(name, ref options, out created));
        }

        /// <summary>Waits up to 6 s until the plate is open. Throws <see cref="InvalidOperationException"/> with the
        /// reason if it cannot be opened. A frame loop should call <see cref="Get"/> instead.</summary>
        public PlateReport WaitUntilReady()
        {
            PlateReport report = Get();
            for (; report.state == PlateState.Opening; report = Get()) Thread.Sleep(10);
            if (report.state == PlateState.Failed) throw new InvalidOperationException(report.message.ToString());
            return report;
        }

        internal override string LastError => Utf8.Read(PlateNative.hrt_plate_last_error());

        internal PlateHandle Handle => new PlateHandle { value = Value };

        // Call it before any other call of libhrt_plate. Throws if the library is missing.
        static void Load()
        {
            HapticRetargetingLibrary.Load();
            try
            {
                PlateNative.hrt_plate_last_error();
            }
            catch (DllNotFoundException e)
            {
                throw new DllNotFoundException(
                    $"The native library {PlateNative.Library} was not found. It exists for Linux and Windows on x64: see " +
                    "\"The native libraries\" in the manual (Unity), or \"Installing\" in the README (.NET).",
                    e);
            }
        }
    }

    public partial struct SessionConfig
    {
        /// <summary>Copies speed, acceleration, latency and stops of a ready plate. Stops that are less than 180
        /// degrees apart are copied as 0: the session then assumes that the plate turns freely.</summary>
        public void TakePlate(PlateReport report)
        {
            bool hasStops = report.upperStopDeg - report.lowerStopDeg >= 180;
            plateMaxSpeedDegS = report.maxSpeedDegS;
            plateMaxAccelerationDegS2 = report.maxAccelerationDegS2;
            plateLatencyNs = report.latencyNs;
            plateLowerStopDeg = hasStops ? report.lowerStopDeg : 0;
            plateUpperStopDeg = hasStops ? report.upperStopDeg : 0;
        }
    }
}
