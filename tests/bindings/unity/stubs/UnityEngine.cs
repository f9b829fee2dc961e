// Stubs of the parts of Unity that the package uses, to compile and run it without Unity. Vectors, quaternions and
// Transforms without scale compute as Unity documents. OnEnable and OnDisable are called as in Unity; tests call
// LateUpdate and the other messages.
using System;
using System.Collections.Generic;
using System.Reflection;

namespace AOT
{
    [AttributeUsage(AttributeTargets.Method)]
    public sealed class MonoPInvokeCallbackAttribute : Attribute
    {
        public MonoPInvokeCallbackAttribute(Type type) => DelegateType = type;

        public Type DelegateType { get; }
    }
}

namespace UnityEngine
{
    public class AddComponentMenu : Attribute
    {
        public AddComponentMenu(string menuName) { }
    }

    public class DefaultExecutionOrder : Attribute
    {
        public DefaultExecutionOrder(int order) => this.order = order;
        public int order { get; }
    }

    public class DisallowMultipleComponent : Attribute
    {
    }

    public class RequireComponent : Attribute
    {
        public RequireComponent(Type type) { }
    }

    public class HeaderAttribute : Attribute
    {
        public HeaderAttribute(string header) { }
    }

    public class TooltipAttribute : Attribute
    {
        public TooltipAttribute(string tooltip) { }
    }

    public class RangeAttribute : Attribute
    {
        public RangeAttribute(float min, float max) { }
    }

    public class MinAttribute : Attribute
    {
        public MinAttribute(float min) { }
    }

    public struct Vector3
    {
        public float x, y, z;

        public Vector3(float x, float y, float z)
        {
            this.x = x;
            this.y = y;
            this.z = z;
        }

        public static Vector3 zero => new Vector3(0, 0, 0);
        public static Vector3 forward => new Vector3(0, 0, 1);
        public static Vector3 right => new Vector3(1, 0, 0);
        public static Vector3 up => new Vector3(0, 1, 0);
        public float magnitude => (float)Math.Sqrt(x * x + y * y + z * z);
        public static Vector3 operator +(Vector3 a, Vector3 b) => new Vector3(a.x + b.x, a.y + b.y, a.z + b.z);
        public static Vector3 operator -(Vector3 a, Vector3 b) => new Vector3(a.x - b.x, a.y - b.y, a.z - b.z);
        public static Vector3 operator *(Vector3 a, float b) => new Vector3(a.x * b, a.y * b, a.z * b);
        public static Vector3 Cross(Vector3 a, Vector3 b) =>
            new Vector3(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
        public override string ToString() => $"({x}, {y}, {z})";
    }

    public struct Quaternion
    {
        public float x, y, z, w;

        public Quaternion(float x, float y, float z, float w)
        {
            this.x = x;
            this.y = y;
            this.z = z;
            this.w = w;
        }

        public static Quaternion AngleAxis(float angle, Vector3 axis)
        {
            double half = angle * Math.PI / 360, sine = Math.Sin(half) / axis.magnitude;
            return new Quaternion((float)(axis.x * sine), (float)(axis.y * sine), (float)(axis.z * sine),
                                  (float)Math.Cos(half));
        }

        // Rotates about z, then x, then y.
        public static Quaternion Euler(float x, float y, float z) =>
            AngleAxis(y, Vector3.up) * AngleAxis(x, Vector3.right) * AngleAxis(z, Vector3.forward);

        public static Quaternion Inverse(Quaternion q) => new Quaternion(-q.x, -q.y, -q.z, q.w);

        public static Quaternion operator *(Quaternion a, Quaternion b) =>
            new Quaternion(a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
                           a.w * b.y + a.y * b.w + a.z * b.x - a.x * b.z,
                           a.w * b.z + a.z * b.w + a.x * b.y - a.y * b.x,
                           a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z);

        public static Vector3 operator *(Quaternion q, Vector3 v)
        {
            var u = new Vector3(q.x, q.y, q.z);
            Vector3 t = Vector3.Cross(u, v) * 2;
            return v + t * q.w + Vector3.Cross(u, t);
        }
    }

    public class Object
    {
        bool destroyed;

        public virtual string name { get; set; } = "";

        // A destroyed object equals null, as in Unity.
        public static bool operator ==(Object a, Object b) => IsGone(a) ? IsGone(b) : ReferenceEquals(a, b);
        public static bool operator !=(Object a, Object b) => !(a == b);
        public override bool Equals(object other) => ReferenceEquals(this, other);
        public override int GetHashCode() => base.GetHashCode();

        public static void DestroyImmediate(Object gone)
        {
            var gameObject = gone as GameObject;
            if (gameObject != null)
            {
                gameObject.SetActive(false);
                gameObject.transform.destroyed = true;
            }
            var behaviour = gone as MonoBehaviour;
            if (behaviour != null) behaviour.enabled = false;
            gone.destroyed = true;
        }

        static bool IsGone(Object a) => ReferenceEquals(a, null) || a.destroyed;
    }

    public class Component : Object
    {
        public T GetComponent<T>() where T : Behaviour => gameObject.GetComponent<T>();
        public override string name
        {
            get => gameObject.name;
            set => gameObject.name = value;
        }

        public GameObject gameObject { get; internal set; }
        public Transform transform => gameObject.transform;
    }

    public class Behaviour : Component
    {
        bool isEnabled;

        public bool enabled
        {
            get => isEnabled;
            set
            {
                if (isEnabled == value) return;
                isEnabled = value;
                if (gameObject.activeInHierarchy) Message(value ? "OnEnable" : "OnDisable")?.Invoke();
            }
        }

        /// <summary>For tests: returns a message method, which Unity calls by its name even if it is private; null if
        /// it does not exist.</summary>
        public Action Message(string name)
        {
            const BindingFlags any = BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic;
            MethodInfo method = GetType().GetMethod(name, any, null, Type.EmptyTypes, null);
            return method == null ? null : (Action)Delegate.CreateDelegate(typeof(Action), this, method);
        }
    }

    public class MonoBehaviour : Behaviour
    {
    }

    public class Transform : Component
    {
        public Transform parent;
        public Vector3 localPosition = Vector3.zero;
        public Quaternion localRotation = new Quaternion(0, 0, 0, 1);
        public Vector3 localScale; // has no effect

        public Vector3 position
        {
            get => parent == null ? localPosition : parent.position + parent.rotation * localPosition;
            set => localPosition = parent == null ? value : Quaternion.Inverse(parent.rotation) * (value - parent.position);
        }

        public Vector3 TransformPoint(Vector3 local) => position + rotation * local;

        public Quaternion rotation
        {
            get => parent == null ? localRotation : parent.rotation * localRotation;
            set => localRotation = parent == null ? value : Quaternion.Inverse(parent.rotation) * value;
        }

        public void SetParent(Transform newParent, bool worldPositionStays)
        {
            if (worldPositionStays) throw new NotSupportedException("the stub keeps local positions only");
            parent = newParent;
        }
    }

    public class GameObject : Object
    {
        readonly List<Behaviour> behaviours = new List<Behaviour>();

        public GameObject(string name)
        {
            this.name = name;
            activeInHierarchy = true;
            transform = new Transform { gameObject = this };
        }

        public static GameObject CreatePrimitive(PrimitiveType type) => new GameObject(type.ToString());

        public Transform transform { get; }
        public bool activeInHierarchy { get; private set; }

        public T AddComponent<T>() where T : Behaviour, new()
        {
            var component = new T { gameObject = this };
            behaviours.Add(component);
            component.enabled = true;
            return component;
        }

        public T GetComponent<T>() where T : Behaviour => (T)behaviours.Find(behaviour => behaviour is T);

        public void SetActive(bool active)
        {
            if (active == activeInHierarchy) return;
            activeInHierarchy = active;
            foreach (Behaviour behaviour in behaviours)
                if (behaviour.enabled) behaviour.Message(active ? "OnEnable" : "OnDisable")?.Invoke();
        }
    }

    public class TextAsset : Object
    {
        public string text { get; set; } = "";
    }

    public enum PrimitiveType
    {
        Sphere,
        Cylinder,
        Cube
    }

    public static class Mathf
    {
        public static float Sqrt(float x) => (float)Math.Sqrt(x);
    }

    public class Camera : Behaviour
    {
        public static Camera main { get; } = new GameObject("camera").AddComponent<Camera>();
        public float nearClipPlane { get; set; }
    }

    public static class Time
    {
        public static double unscaledTimeAsDouble { get; set; }
    }

    public static class Debug
    {
        /// <summary>For tests: receives log messages on the thread that logs them.</summary>
        public static event Action<string, string> Logged;

        public static void Log(object message, Object context) => Logged?.Invoke("log", message.ToString());
        public static void LogWarning(object message) => Logged?.Invoke("warning", message.ToString());
        public static void LogWarning(object message, Object context) => LogWarning(message);
        public static void LogError(object message) => Logged?.Invoke("error", message.ToString());
        public static void LogError(object message, Object context) => LogError(message);
    }
}

namespace UnityEngine.Events
{
    public delegate void UnityAction<T>(T argument);

    [Serializable]
    public class UnityEvent<T>
    {
        readonly List<UnityAction<T>> listeners = new List<UnityAction<T>>();

        public void AddListener(UnityAction<T> listener) => listeners.Add(listener);

        public void Invoke(T argument)
        {
            for (int i = 0; i < listeners.Count; ++i) listeners[i](argument);
        }
    }
}
