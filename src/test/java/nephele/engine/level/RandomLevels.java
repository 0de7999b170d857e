package nephele.engine.level;

import java.lang.reflect.Constructor;
import java.lang.reflect.ParameterizedType;
import java.lang.reflect.RecordComponent;
import java.lang.reflect.Type;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.TreeMap;
import nephele.engine.math.Vec3;

/** Random levels that fill every component of every record with any value of its range. */
final class RandomLevels {
    private static final String[] TEXTS = {"", "x", "Grüße, 霧 \"quoted\" \\ / 🌥", "'; -- <b>&amp;", " spaced "};
    private final SplittableRandom random;

    RandomLevels(long seed) {
        random = new SplittableRandom(seed);
    }

    Level next() {
        return (Level) record(Level.class);
    }

    private Object record(Class<?> type) {
        try {
            RecordComponent[] components = type.getRecordComponents();
            Class<?>[] types = new Class<?>[components.length];
            Object[] values = new Object[components.length];
            for (int i = 0; i < components.length; i++) {
                types[i] = components[i].getType();
                values[i] = component(components[i]);
            }
            Constructor<?> constructor = type.getDeclaredConstructor(types);
            return constructor.newInstance(values);
        } catch (ReflectiveOperationException impossible) {
            throw new IllegalStateException(impossible);
        }
    }

    private Object component(RecordComponent component) {
        Written written = component.getAnnotation(Written.class);
        Class<?> type = component.getType();
        boolean mayBeNull = !type.isPrimitive()
                && !written.required()
                && !written.beside()
                && written.absent().isEmpty()
                && type != List.class
                && type != Map.class;
        return mayBeNull && random.nextInt(3) == 0 ? null : value(component.getGenericType(), component);
    }

    private Object value(Type type, RecordComponent component) {
        if (type instanceof ParameterizedType generic) {
            Type[] arguments = generic.getActualTypeArguments();
            return generic.getRawType() == List.class ? list(arguments[0], component) : table(arguments, component);
        }
        Class<?> raw = (Class<?>) type;
        if (raw == Vec3.class) {
            Vec3 vector = new Vec3(number(component), number(component), number(component));
            return range(component).reaches(vector) ? vector : new Vec3(0, 1, 0);
        } else if (raw == Exposure.class) {
            return random.nextInt(3) == 0 ? Exposure.AUTO : Exposure.ofStops(number(component));
        } else if (raw == double.class || raw == Double.class) {
            return number(component);
        } else if (raw == int.class) {
            return (int) Math.rint(number(component));
        } else if (raw == long.class) {
            return (long) Math.rint(number(component));
        } else if (raw == boolean.class || raw == Boolean.class) {
            return random.nextBoolean();
        } else if (raw == String.class) {
            return text(component.getAnnotation(Written.class).text());
        } else if (raw.isEnum()) {
            return raw.getEnumConstants()[random.nextInt(raw.getEnumConstants().length)];
        } else if (raw.isSealed()) {
            Class<?>[] variants = raw.getPermittedSubclasses();
            return record(variants[random.nextInt(variants.length)]);
        }
        return record(raw);
    }

    private List<Object> list(Type element, RecordComponent component) {
        List<Object> list = new ArrayList<>();
        for (int i = random.nextInt(4); i > 0; i--) {
            list.add(value(element, component));
        }
        return list;
    }

    private Map<Object, Object> table(Type[] arguments, RecordComponent component) {
        Map<Object, Object> table = new TreeMap<>();
        for (int i = random.nextInt(3); i > 0; i--) {
            table.put(value(arguments[0], component), value(arguments[1], component));
        }
        return table;
    }

    /** Returns any bits, the ends of the range, zeros of both signs, subnormals, and numbers with few decimals. */
    private double number(RecordComponent component) {
        NumberRange range = range(component);
        double value =
                switch (random.nextInt(6)) {
                    case 0 -> Double.longBitsToDouble(random.nextLong());
                    case 1 -> random.nextBoolean() ? range.min() : range.max();
                    case 2 -> random.nextBoolean() ? -0.0 : 0.0;
                    case 3 -> Double.longBitsToDouble(random.nextLong(1L << 52));
                    case 4 -> random.nextInt(-100_000, 100_000) / 1000.0;
                    default -> range.min() + random.nextDouble() * (range.max() - range.min());
                };
        return range.contains(value) ? value : range.nearest(Double.isNaN(value) ? 1 : value);
    }

    private static NumberRange range(RecordComponent component) {
        return NumberRange.of(component.getAnnotation(Range.class));
    }

    private String text(TextKind rule) {
        return switch (rule) {
            case NAME -> TEXTS[random.nextInt(TEXTS.length)];
            case PROSE -> TEXTS[random.nextInt(TEXTS.length)] + "\n\tmore";
            case ID -> "id " + TEXTS[random.nextInt(TEXTS.length)];
            case SHA256 -> "0123456789abcdef".repeat(4);
            case ASSET -> "textures/a-" + random.nextInt(100) + ".png";
        };
    }
}
