using System;
using System.Collections.Generic;
using UnityEditor;
using UnityEngine;

namespace Hrt.Editor
{
    /// <summary>Below the component's fields: what can be held for each virtual target, and during a reach the
    /// command.</summary>
    [CustomEditor(typeof(HapticRetargeting))]
    public sealed class HapticRetargetingEditor : UnityEditor.Editor
    {
        public override bool RequiresConstantRepaint() => Application.isPlaying;

        public override void OnInspectorGUI()
        {
            DrawDefaultInspector();
            var component = (HapticRetargeting)target;
            EditorGUILayout.Space();
            DrawReachability(component);
            if (component.IsReaching) DrawCommand(component.LastCommand);
        }

        static void DrawReachability(HapticRetargeting component)
        {
            EditorGUILayout.LabelField("What can be held", EditorStyles.boldLabel);
            List<HapticRetargeting.Pairing> pairings;
            try
            {
                pairings = component.Preview();
            }
            catch (Exception e)
            {
                EditorGUILayout.HelpBox(e.Message, MessageType.Error);
                return;
            }
            if (pairings.Count == 0)
                EditorGUILayout.HelpBox("Give it at least one real and one virtual target.", MessageType.Info);
            foreach (HapticRetargeting.Pairing pairing in pairings)
                EditorGUILayout.LabelField(pairing.virtualTarget.name, Describe(pairing));
        }

        /// <summary>A pairing in a line, such as "by cylinder: gap +10.0, margin +4.9 deg".</summary>
        public static string Describe(HapticRetargeting.Pairing pairing)
        {
            Authority authority = pairing.authority;
            string text = string.Format(System.Globalization.CultureInfo.InvariantCulture,
                                        "by {0}: gap {1:+0.0;-0.0;0.0}, margin {2:+0.0;-0.0;0.0} deg",
                                        pairing.realTarget.name, authority.gapDeg, authority.marginDeg);
            return authority.IsReachable ? text : text + ", out of reach";
        }

        static void DrawCommand(Command command)
        {
            EditorGUILayout.LabelField("Reach", EditorStyles.boldLabel);
            EditorGUILayout.LabelField("Step", command.step.ToString());
            EditorGUILayout.LabelField("Plate", Degrees(command.plateOrientationDeg));
            EditorGUILayout.LabelField("Finger", Degrees(command.fingerDirectionDeg));
            EditorGUILayout.LabelField("Felt", Degrees(command.perceivedDirectionDeg));
            EditorGUILayout.LabelField("Share of touch", command.tactileWeight.ToString("0.000"));
            EditorGUILayout.LabelField("Flags", command.flags.ToString());
        }

        static string Degrees(double value) => value.ToString("+0.0;-0.0;0.0") + " deg";
    }
}
