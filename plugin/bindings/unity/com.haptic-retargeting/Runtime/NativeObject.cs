using System;

namespace Hrt
{
    /// <summary>
    /// An object of the library, which exists until it is disposed of or collected, or until the scripts are unloaded.
    /// If the library refuses a call, the method throws a <see cref="HapticRetargetingException"/>, unless its name
    /// begins with Try. Of calls of two threads at the same time, one fails with <see cref="Result.Busy"/>.
    /// </summary>
    public abstract class NativeObject : IDisposable
    {
        readonly Func<ulong, Result> destroy;
        ulong handle;

        internal NativeObject(Func<ulong, Result> destroy) => this.destroy = destroy;

        ~NativeObject() => Destroy();

        /// <summary>Destroys the object. Throws with <see cref="Result.Busy"/> while another thread is in a call of the
        /// object; call Dispose() again then.</summary>
        public void Dispose()
        {
            Check(Destroy());
            GC.SuppressFinalize(this);
        }

        public bool IsDisposed => handle == 0;

        // Calls `create`, which creates the native object. At the library's limit, collects unused objects and repeats.
        internal void Own(Creation create)
        {
            Result result = create(out ulong created);
            if (result == Result.LimitReached)
            {
                GC.Collect();
                GC.WaitForPendingFinalizers();
                result = create(out created);
            }
            Check(result);
            handle = created;
            HapticRetargetingLibrary.Opened(created, destroy);
        }

        internal delegate Result Creation(out ulong created);

        internal ulong Value
        {
            get
            {
                if (handle == 0) throw new ObjectDisposedException(GetType().Name);
                return handle;
            }
        }

        // KeepAlive() prevents that the finaliser runs during the call that returned `result`.
        internal void Check(Result result)
        {
            GC.KeepAlive(this);
            if (result != Result.Ok) throw new HapticRetargetingException(result, LastError);
        }

        // Last error of this thread in the library that owns the object.
        internal virtual string LastError => HapticRetargetingLibrary.LastError;

        // Also called by the finaliser, even after Shutdown() has destroyed the object. Throws nothing.
        Result Destroy()
        {
            if (handle == 0) return Result.Ok;
            Result result = destroy(handle);
            if (result == Result.Busy) return result;
            HapticRetargetingLibrary.Closed(handle);
            handle = 0;
            return Result.Ok;
        }
    }
}
