package nephele.editor.record;

import java.lang.reflect.ParameterizedType;
import java.lang.reflect.Type;
import java.util.List;
import java.util.Map;
import nephele.engine.level.Exposure;
import nephele.engine.level.TextKind;
import nephele.engine.level.Written;
import nephele.engine.math.Vec3;

/** The kind of a component's value, which decides its editor. */
public enum FieldKind {
    NUMBER,
    WHOLE,
    TRUTH,
    TEXT,
    /** A text that names another record. */
    REFERENCE,
    /** A text that names a file. */
    ASSET,
    CHOICE,
    VECTOR,
    /** A number or a word, see {@link Exposure}. */
    EXPOSURE,
    RECORD,
    /** One of several records, chosen by {@code kind}. */
    VARIANT,
    LIST,
    TABLE;

    static FieldKind of(Type type, Written written) {
        Class<?> raw = rawClass(type);
        if (raw == List.class) {
            return LIST;
        } else if (raw == Map.class) {
            return TABLE;
        } else if (raw == Vec3.class) {
            return VECTOR;
        } else if (raw == Exposure.class) {
            return EXPOSURE;
        } else if (raw == double.class || raw == Double.class) {
            return NUMBER;
        } else if (raw == int.class || raw == long.class) {
            return WHOLE;
        } else if (raw == boolean.class || raw == Boolean.class) {
            return TRUTH;
        } else if (raw == String.class) {
            return text(written);
        } else if (raw.isEnum()) {
            return CHOICE;
        }
        return raw.isRecord() ? RECORD : VARIANT;
    }

    private static FieldKind text(Written written) {
        if (!written.refersTo().isEmpty()) {
            return REFERENCE;
        }
        return written.text() == TextKind.ASSET ? ASSET : TEXT;
    }

    static Class<?> rawClass(Type type) {
        return (Class<?>) (type instanceof ParameterizedType generic ? generic.getRawType() : type);
    }

    /** Returns the type of a list's elements or a table's values. */
    static Class<?> elementClass(Type type) {
        Type[] arguments = ((ParameterizedType) type).getActualTypeArguments();
        return rawClass(arguments[arguments.length - 1]);
    }
}
