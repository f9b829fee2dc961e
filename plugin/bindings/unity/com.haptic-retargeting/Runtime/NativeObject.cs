using System;

namespace Hrt
{
    /// <summary>
    /// An object of the library, from construction until it is disposed of or collected, or until the scripts are unloaded. A
    /// call that the library refuses throws a <see cref="HapticRetargetingException"/> with the library's text, and
    /// changes nothing. Two threads must not be in calls on one object at the same time: the second gets
    /// <see cref="Result.Busy"/>.
    /// </summary>
    public abstract class NativeObject : IDisposable
    {
        readonly Func<ulong, Result> destroy;
        ulong handle;

        internal NativeObject(Func<ulong, Result> destroy) => this.destroy = destroy;

        ~NativeObject() => Destroy();

        /// <summary>Throws <see cref="Result.Busy"/>, and can be called again, while another thread is in a call
        /// on this.</summary>
        public void Dispose()
        {
            Check(Destroy());
            GC.SuppressFinalize(this);
        }

        public bool IsDisposed => handle == 0;

        // `create` calls the library. At its limit, objects that are no longer used are collected before it is tried again.
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

        // Every call ends here, so that the finaliser cannot run during one.
        internal void Check(Result result)
        {
            GC.KeepAlive(this);
            if (result != Result.Ok) throw new HapticRetargetingException(result, LastError);
        }

        // Of this thread, by the library that the object is of.
        internal virtual string LastError => HapticRetargetingLibrary.LastError;

        // Also what the finaliser calls: throws nothing, and may come second, after a domain's unloading.
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
