using Hrt;
using UnityEngine;

namespace HrtSamples
{
    /// <summary>Creates a plate, centred at this object, a real cylinder and three virtual objects.</summary>
    public sealed class Desk : MonoBehaviour
    {
        const float PlateRadiusM = 0.075f;

        static readonly string[] virtualNames = {"bottle", "goblet", "pawn"};
        static readonly double[] virtualDirectionsDeg = {6, -8, 12};

        public HapticRetargeting Retargeting { get; private set; }

        /// <summary>Called by the editor when the component is added. Places the plate as on a table.</summary>
        void Reset() => transform.position = new Vector3(0, 0.75f, 0.4f);

        void Awake()
        {
            Retargeting = gameObject.AddComponent<HapticRetargeting>();
            Retargeting.plate = Empty("plate", Vector3.zero);
            Retargeting.start = Empty("start", new Vector3(0, 0, -0.05f));
            Retargeting.ridges = MakeRidges();
            Retargeting.finger = Make(PrimitiveType.Sphere, "finger", new Vector3(0.01f, 0.01f, 0.01f), Vector3.zero);
            Retargeting.realTargets.Add(MakeTarget("cylinder", 0));
            for (int i = 0; i < virtualNames.Length; ++i)
                Retargeting.virtualTargets.Add(MakeTarget(virtualNames[i], virtualDirectionsDeg[i]));
        }

        // Returns the parent of all ridges, which HapticRetargeting turns. At orientation 0, the ridges run along x.
        Transform MakeRidges()
        {
            Transform ridges = Empty("ridges", Vector3.zero);
            for (int i = -7; i <= 7; ++i)
            {
                float across = i * 0.01f, length = 2 * Mathf.Sqrt(PlateRadiusM * PlateRadiusM - across * across);
                Transform ridge = Make(PrimitiveType.Cube, "ridge", new Vector3(length, 0.001f, 0.001f),
                                       new Vector3(0, 0, across));
                ridge.SetParent(ridges, false);
            }
            return ridges;
        }

        // Creates a target 10 cm from the start.
        Transform MakeTarget(string targetName, double directionDeg) =>
            Make(PrimitiveType.Cylinder, targetName, new Vector3(0.015f, 0.02f, 0.015f),
                 new Vector3(0, 0, -0.05f) + Axes.Direction(directionDeg) * 0.1f);

        Transform Empty(string objectName, Vector3 place) => Placed(new GameObject(objectName).transform, place);

        Transform Make(PrimitiveType shape, string objectName, Vector3 size, Vector3 place)
        {
            GameObject made = GameObject.CreatePrimitive(shape);
            made.name = objectName;
            made.transform.localScale = size;
            return Placed(made.transform, place);
        }

        Transform Placed(Transform made, Vector3 place)
        {
            made.SetParent(transform, false);
            made.localPosition = place;
            return made;
        }
    }
}
