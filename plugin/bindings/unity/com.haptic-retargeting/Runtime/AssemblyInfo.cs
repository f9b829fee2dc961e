using System.Runtime.CompilerServices;

[assembly: InternalsVisibleTo("HapticRetargeting.Tests")]
