// Written by plugin/bindings/generate from the C headers. The headers say what each call does.
using System;
using System.Runtime.InteropServices;

namespace Hrt
{
    /// <summary>What a plate is doing.</summary>
    public enum PlateState : uint
    {
        /// <summary>being greeted: up to 6 s, because boards start when their line is opened</summary>
        Opening = 1,
        /// <summary>takes commands</summary>
        Ready = 2,
        /// <summary>was stopped if it still heard; PlateReport.message has the reason</summary>
        Failed = 3,
    }

    /// <summary>Why a plate has failed.</summary>
    public enum PlateFault : uint
    {
        /// <summary>it has not failed</summary>
        None = 0,
        /// <summary>the line cannot be opened or set up, or is in use</summary>
        Line = 1,
        /// <summary>nothing answers as such a plate</summary>
        NoAnswer = 2,
        /// <summary>the line is gone, or takes nothing in</summary>
        Unplugged = 3,
        /// <summary>not heard for half a second</summary>
        Silent = 4,
        /// <summary>does not report its orientation</summary>
        NoReport = 5,
        /// <summary>reports an angle beyond its limits, or refused one</summary>
        Limits = 6,
        /// <summary>commanded, and not moving</summary>
        Stuck = 7,
        /// <summary>restarted, or announced itself anew</summary>
        Restarted = 8,
        /// <summary>its emergency stop is open</summary>
        Emergency = 9,
        /// <summary>reports a fault: voltage, temperature, overload ...</summary>
        Device = 10,
        /// <summary>answers what the protocol does not allow</summary>
        Protocol = 11,
        /// <summary>out of memory, or a defect of this library</summary>
        Internal = 12,
    }

    /// <summary>What a report holds.</summary>
    [Flags]
    public enum PlateReportFlags : uint
    {
        None = 0,
        /// <summary>the orientation is known</summary>
        Orientation = 1,
        /// <summary>by a sensor; else it is assumed from the commands</summary>
        Measured = 2,
        /// <summary>the line was measured</summary>
        RoundTrip = 4,
        /// <summary>a command holds; else the plate stays where it is</summary>
        Commanded = 8,
        /// <summary>stopped by PlateOptions.hostTimeoutNs</summary>
        HostSilent = 16,
    }

    /// <summary>A plate. Zero is never one.</summary>
    [Serializable, StructLayout(LayoutKind.Sequential)]
    public partial struct PlateHandle
    {
        public ulong value;
    }

    /// <summary>How to treat a plate. hrt_plate_options_default() fills every field.</summary>
    [Serializable, StructLayout(LayoutKind.Sequential)]
    public partial struct PlateOptions
    {
        public uint structSize;
        public uint reserved;
        /// <summary>After this time without hrt_plate_set(), hrt_plate_stop() or hrt_plate_get() the plate
        /// stops where it is: an application that hangs leaves no moving plate. The next hrt_plate_set()
        /// moves it again. 50 ms to 10 s, default 300 ms.</summary>
        public long hostTimeoutNs;

        /// <summary>Every field with its default.</summary>
        public static PlateOptions Default
        {
            get
            {
                PlateLibrary.Load();
                var config = default(PlateOptions);
                uint size = SizeOf<PlateOptions>.Value;
                PlateLibrary.Check(PlateNative.hrt_plate_options_default(ref config, size));
                return config;
            }
        }
    }

    /// <summary>What is known of a plate. All numbers are finite, and 0 while they are unknown.</summary>
    [Serializable, StructLayout(LayoutKind.Sequential)]
    public partial struct PlateReport
    {
        public uint structSize;
        /// <summary>What it is doing: PlateState.</summary>
        public PlateState state;
        /// <summary>Why it has failed: PlateFault.</summary>
        public PlateFault fault;
        /// <summary>What the report holds: PlateReportFlags.</summary>
        public PlateReportFlags flags;
        /// <summary>As last reported, degrees, -360 to 360; base.h defines it. For
        /// Sample.plateOrientationDeg.</summary>
        public double orientationDeg;
        /// <summary>Orientation that was last sent, within the stops.</summary>
        public double commandDeg;
        /// <summary>Time since the report of the orientation arrived.</summary>
        public long ageNs;
        /// <summary>From a command to the plate's motion: the plate's own, and half of the round trip. For
        /// SessionConfig.plateLatencyNs, if it is not 0.</summary>
        public long latencyNs;
        /// <summary>Of a message and its answer on the line, median.</summary>
        public long roundTripNs;
        /// <summary>The plate's own, or less if it was seen to turn slower. For
        /// SessionConfig.plateMaxSpeedDegS.</summary>
        public double maxSpeedDegS;
        /// <summary>Stops, or both 0 if the plate turns freely. For SessionConfig, if they are 180 degrees
        /// apart or more.</summary>
        public double lowerStopDeg;
        public double upperStopDeg;
        /// <summary>Messages that the plate refused, or that were damaged on their way.</summary>
        public ulong refusedMessages;
        /// <summary>The device, in one line of UTF-8: "protocol 2, firmware 1.0.0, serial number
        /// 000042".</summary>
        public PlateReportDescription description;
        /// <summary>Why the plate has failed, in one line of UTF-8: "the plate at /dev/ttyACM0 is
        /// unplugged".</summary>
        public PlateReportMessage message;
    }

    /// <summary>The device, in one line of UTF-8: "protocol 2, firmware 1.0.0, serial number
    /// 000042".</summary>
    [Serializable, StructLayout(LayoutKind.Sequential)]
    public struct PlateReportDescription
    {
        public ulong word0, word1, word2, word3, word4, word5, word6, word7, word8, word9, word10,
            word11, word12, word13, word14, word15;

        public override string ToString() => Utf8.Read(
            word0, word1, word2, word3, word4, word5, word6, word7, word8, word9, word10, word11, word12,
            word13, word14, word15);
    }

    /// <summary>Why the plate has failed, in one line of UTF-8: "the plate at /dev/ttyACM0 is
    /// unplugged".</summary>
    [Serializable, StructLayout(LayoutKind.Sequential)]
    public struct PlateReportMessage
    {
        public ulong word0, word1, word2, word3, word4, word5, word6, word7, word8, word9, word10,
            word11, word12, word13, word14, word15, word16, word17, word18, word19, word20, word21,
            word22, word23, word24, word25, word26, word27, word28, word29, word30, word31;

        public override string ToString() => Utf8.Read(
            word0, word1, word2, word3, word4, word5, word6, word7, word8, word9, word10, word11, word12,
            word13, word14, word15, word16, word17, word18, word19, word20, word21, word22, word23,
            word24, word25, word26, word27, word28, word29, word30, word31);
    }

    internal static class PlateNative
    {
        internal const string Library = "hrt_plate";

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result hrt_plate_options_default(ref PlateOptions outOptions, uint structSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result hrt_plate_open(
            [In] byte[] device, ref PlateOptions options, out PlateHandle outPlate);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result hrt_plate_set(PlateHandle plate, double orientationDeg);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result hrt_plate_stop(PlateHandle plate);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result hrt_plate_get(PlateHandle plate, ref PlateReport outReport);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern Result hrt_plate_close(PlateHandle plate);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern IntPtr hrt_plate_last_error();
    }
}
