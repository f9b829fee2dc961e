// As much of Unity's editor as the package uses.
using System;
using System.Collections.Generic;
using System.Reflection;

namespace UnityEditor
{
    public class CustomEditor : Attribute
    {
        public CustomEditor(Type inspectedType)
        {
            InspectedType = inspectedType;
        }

        public Type InspectedType { get; }
    }

    public class Editor : UnityEngine.Object
    {
        public UnityEngine.Object target { get; private set; }

        /// <summary>Of the loaded class that says that it is this target's; null if none does.</summary>
        public static Editor CreateEditor(UnityEngine.Object target)
        {
            foreach (Assembly assembly in AppDomain.CurrentDomain.GetAssemblies())
            foreach (Type type in assembly.GetTypes())
            {
                var custom = (CustomEditor)Attribute.GetCustomAttribute(type, typeof(CustomEditor));
                if (custom == null || custom.InspectedType != target.GetType()) continue;
                var editor = (Editor)Activator.CreateInstance(type);
                editor.target = target;
                return editor;
            }
            return null;
        }

        public virtual void OnInspectorGUI()
        {
        }

        public virtual bool RequiresConstantRepaint() => false;
        public bool DrawDefaultInspector() => false;
    }

    public enum MessageType
    {
        None,
        Info,
        Warning,
        Error
    }

    public class GUIStyle
    {
    }

    public static class EditorStyles
    {
        public static GUIStyle boldLabel { get; } = new GUIStyle();
    }

    public static class EditorGUILayout
    {
        /// <summary>Of the stub: what was drawn.</summary>
        public static readonly List<string> Drawn = new List<string>();

        public static void Space()
        {
        }

        public static void LabelField(string label, GUIStyle style) => Drawn.Add(label);
        public static void LabelField(string label, string text) => Drawn.Add(label + ": " + text);
        public static void HelpBox(string message, MessageType type) => Drawn.Add(type + ": " + message);
    }
}
