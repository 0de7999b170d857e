package nephele.engine.level.json;

import java.lang.reflect.ParameterizedType;
import java.lang.reflect.RecordComponent;
import java.lang.reflect.Type;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import nephele.engine.level.Exposure;
import nephele.engine.level.NumberRange;
import nephele.engine.level.Range;
import nephele.engine.level.Written;
import nephele.engine.math.Vec3;

/** Makes the formats of record classes, by reflection. */
final class FormatBuilder {
    private FormatBuilder() {}

    static RecordFormat record(Class<?> type) {
        RecordComponent[] components = type.getRecordComponents();
        Class<?>[] parameters = new Class<?>[components.length];
        List<RecordFormat.FieldFormat> fields = new ArrayList<>();
        for (int i = 0; i < components.length; i++) {
            parameters[i] = components[i].getType();
            fields.add(field(components[i]));
        }
        try {
            return new RecordFormat(type, type.getDeclaredConstructor(parameters), fields);
        } catch (NoSuchMethodException impossible) {
            throw new IllegalStateException(impossible);
        }
    }

    private static RecordFormat.FieldFormat field(RecordComponent component) {
        Written written = component.getAnnotation(Written.class);
        if (written == null) {
            throw new IllegalStateException(
                    component.getDeclaringRecord() + "." + component.getName() + " does not say how it is written");
        }
        ValueFormat format = format(component.getGenericType(), component);
        Object absent = written.absent().isEmpty() ? format.absent() : parsed(written.absent(), format);
        return new RecordFormat.FieldFormat(
                component.getName(), component.getAccessor(), format, written.required(), written.beside(), absent);
    }

    private static Object parsed(String json, ValueFormat format) {
        Problems problems = new Problems();
        JsonValue tree = JsonTree.read(json.getBytes(java.nio.charset.StandardCharsets.UTF_8), problems);
        Object value = tree == null ? null : format.read(tree, problems);
        problems.throwIfAny("default value " + json);
        return value;
    }

    /** @param type of the component, or of the entries that it holds */
    private static ValueFormat format(Type type, RecordComponent component) {
        if (type instanceof ParameterizedType generic) {
            Type[] arguments = generic.getActualTypeArguments();
            int most = component.getAnnotation(Written.class).most();
            return generic.getRawType() == List.class
                    ? new CollectionFormats.Entries(format(arguments[0], component), most)
                    : new CollectionFormats.Table(keys((Class<?>) arguments[0]), format(arguments[1], component));
        }
        return single((Class<?>) type, component);
    }

    /** Returns the range of a component of numbers. */
    private static NumberRange range(RecordComponent component) {
        Range range = component.getAnnotation(Range.class);
        if (range == null) {
            throw new IllegalStateException(
                    component.getDeclaringRecord() + "." + component.getName() + " does not say its range");
        }
        return NumberRange.of(range);
    }

    private static WordFormats.Choice keys(Class<?> type) {
        return type.isEnum() ? WordFormats.Choice.of(type) : null;
    }

    private static ValueFormat single(Class<?> type, RecordComponent component) {
        Written written = component.getAnnotation(Written.class);
        if (type == Vec3.class) {
            return new NumberFormats.Vector(range(component));
        } else if (type == double.class || type == Double.class) {
            return new NumberFormats.Real(range(component), type == double.class ? 0.0 : null);
        } else if (type == Exposure.class) {
            return new NumberFormats.RealOrAuto(new NumberFormats.Real(range(component), null));
        } else if (type == int.class || type == long.class) {
            return new NumberFormats.Whole(range(component), type == int.class);
        } else if (type == boolean.class || type == Boolean.class) {
            return new WordFormats.Truth(type == boolean.class ? false : null);
        } else if (type == String.class) {
            return new WordFormats.TextFormat(written.text(), null);
        } else if (type.isEnum()) {
            return WordFormats.Choice.of(type);
        } else if (type.isRecord()) {
            return written.array() ? new RecordFormat.TupleFormat(record(type)) : record(type);
        } else if (type.isSealed()) {
            return variants(type);
        }
        throw new IllegalStateException("no format for " + type);
    }

    private static RecordFormat.VariantFormat variants(Class<?> type) {
        List<Class<?>> types = Arrays.asList(type.getPermittedSubclasses());
        types.sort(Comparator.comparing(RecordFormat.VariantFormat::kind));
        return new RecordFormat.VariantFormat(
                types,
                types.stream().map(RecordFormat.VariantFormat::kind).toList(),
                types.stream().map(FormatBuilder::record).toList());
    }
}
