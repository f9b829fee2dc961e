using System;
using System.Collections.Generic;
using UnityEngine;

namespace Hrt
{
    public sealed partial class HapticRetargeting
    {
        const int EdgeSegments = 48;
        const int RidgesEachSide = 7;
        const double RidgeSpacingM = 0.01;

        static readonly Color plateColour = Color.grey;
        static readonly Color virtualColour = Color.cyan;
        static readonly Color reachableColour = Color.green;
        static readonly Color unreachableColour = Color.red;

        /// <summary>Draws the plate with its ridges, the start, and for each virtual target (cyan) the real one
        /// that serves it best: green if the finger can be held on it; red if not, with a line to where the
        /// finger would settle.</summary>
        void OnDrawGizmosSelected()
        {
            if (plate == null) return;
            DrawPlate();
            foreach (Pairing pairing in PreviewOrNone()) DrawPairing(pairing);
        }

        List<Pairing> PreviewOrNone()
        {
            try
            {
                return Preview();
            }
            catch (Exception)
            {
                // The inspector says what is wrong; a log entry for each repaint would not help.
                return new List<Pairing>();
            }
        }

        void DrawPlate()
        {
            Gizmos.color = plateColour;
            Vector3 last = OnPlate(Axes.Direction(0) * (float)plateRadiusM);
            for (int i = 1; i <= EdgeSegments; ++i)
            {
                Vector3 next = OnPlate(Axes.Direction(360.0 * i / EdgeSegments) * (float)plateRadiusM);
                Gizmos.DrawLine(last, next);
                last = next;
            }
            // Ridges run across the orientation, which is that of their normal.
            Vector3 normal = Axes.Direction(LastCommand.plateOrientationDeg);
            Vector3 along = Axes.Direction(LastCommand.plateOrientationDeg + 90);
            for (int i = -RidgesEachSide; i <= RidgesEachSide; ++i)
            {
                double across = i * RidgeSpacingM;
                double square = plateRadiusM * plateRadiusM - across * across;
                if (square <= 0) continue;
                float half = (float)Math.Sqrt(square);
                Vector3 middle = normal * (float)across;
                Gizmos.DrawLine(OnPlate(middle - along * half), OnPlate(middle + along * half));
            }
        }

        void DrawPairing(Pairing pairing)
        {
            Vector3 from = StartPosition();
            Gizmos.DrawWireSphere(from, 0.003f);
            Gizmos.color = virtualColour;
            Gizmos.DrawLine(from, pairing.virtualTarget.position);
            Authority authority = pairing.authority;
            Gizmos.color = authority.IsReachable ? reachableColour : unreachableColour;
            Gizmos.DrawLine(from, pairing.realTarget.position);
            if (authority.IsReachable) return;
            float length = (pairing.realTarget.position - from).magnitude;
            Gizmos.DrawLine(from, from + plate.rotation * Axes.Direction(authority.settlingDirectionDeg) * length);
        }

        Vector3 StartPosition() =>
            start != null ? start.position : OnPlate(Axes.ToUnity(SessionConfig.Default.startPositionM));

        Vector3 OnPlate(Vector3 position) => plate.position + plate.rotation * position;
    }
}
