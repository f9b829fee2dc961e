using NUnit.Framework;
using UnityEngine;

namespace Hrt.Editor.Tests
{
    public sealed class EditorTests
    {
        GameObject gameObject;

        [SetUp]
        public void SetUp()
        {
            gameObject = new GameObject("retargeting");
        }

        [TearDown]
        public void TearDown()
        {
            Object.DestroyImmediate(gameObject);
        }

        [Test]
        public void TheComponentHasAnInspectorOfItsOwn()
        {
            UnityEditor.Editor editor = UnityEditor.Editor.CreateEditor(gameObject.AddComponent<HapticRetargeting>());
            Assert.IsInstanceOf<HapticRetargetingEditor>(editor);
            Object.DestroyImmediate(editor);
        }

        [Test]
        public void PairingsAreDescribedInALine()
        {
            gameObject.name = "cylinder";
            var pairing = new HapticRetargeting.Pairing
            {
                realTarget = gameObject.transform,
                authority = new Authority { reachable = 1, gapDeg = -10, marginDeg = 4.911 }
            };
            Assert.AreEqual("by cylinder: gap -10.0, margin +4.9 deg", HapticRetargetingEditor.Describe(pairing));
            pairing.authority = new Authority { reachable = 0, gapDeg = 20, marginDeg = -5.09 };
            Assert.AreEqual("by cylinder: gap +20.0, margin -5.1 deg, out of reach",
                            HapticRetargetingEditor.Describe(pairing));
        }
    }
}
