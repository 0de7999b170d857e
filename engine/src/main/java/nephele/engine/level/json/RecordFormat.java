package nephele.engine.level.json;

import java.lang.reflect.Constructor;
import java.lang.reflect.Method;
import java.lang.reflect.ParameterizedType;
import java.lang.reflect.RecordComponent;
import java.lang.reflect.Type;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.Set;
import nephele.engine.level.Exposure;
import nephele.engine.level.NumberRange;
import nephele.engine.level.Range;
import nephele.engine.level.Written;
import nephele.engine.math.Vec3;

/** The format of an object whose keys are a record's components. */
final class RecordFormat implements MembersFormat {
    private final Class<?> type;
    private final Constructor<?> constructor;
    private final List<FieldFormat> fields;

    private RecordFormat(Class<?> type, Constructor<?> constructor, List<FieldFormat> fields) {
        this.type = type;
        this.constructor = constructor;
        this.fields = List.copyOf(fields);
    }

    /**
     * Returns the format of a record class, by reflection.
     *
     * @throws IllegalStateException if a component does not say how it is written
     */
    static RecordFormat of(Class<?> type) {
        RecordComponent[] components = type.getRecordComponents();
        Class<?>[] parameters = new Class<?>[components.length];
        List<FieldFormat> fields = new ArrayList<>();
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

    private static FieldFormat field(RecordComponent component) {
        Written written = component.getAnnotation(Written.class);
        if (written == null) {
            throw new IllegalStateException(
                    component.getDeclaringRecord() + "." + component.getName() + " does not say how it is written");
        }
        ValueFormat format = format(component.getGenericType(), component);
        Object absent = written.absent().isEmpty() ? format.absent() : format.parsed(written.absent(), "default value");
        return new FieldFormat(
                component.getName(), component.getAccessor(), format, written.required(), written.beside(), absent);
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
            return written.array() ? new TupleFormat(of(type)) : of(type);
        } else if (type.isSealed()) {
            return variants(type);
        }
        throw new IllegalStateException("no format for " + type);
    }

    private static VariantFormat variants(Class<?> type) {
        List<Class<?>> types = Arrays.asList(type.getPermittedSubclasses());
        types.sort(Comparator.comparing(VariantFormat::kind));
        return new VariantFormat(
                types,
                types.stream().map(VariantFormat::kind).toList(),
                types.stream().map(RecordFormat::of).toList());
    }

    @Override
    public Object readMembers(JsonValue.Members members, Problems problems) {
        Object[] values = new Object[fields.size()];
        int before = problems.count();
        for (int i = 0; i < values.length; i++) {
            values[i] = fields.get(i).read(members, problems);
        }
        return problems.count() > before ? null : make(values);
    }

    Object make(Object[] values) {
        try {
            return constructor.newInstance(values);
        } catch (ReflectiveOperationException impossible) {
            throw new IllegalStateException("cannot make a " + type.getSimpleName(), impossible);
        }
    }

    int fieldCount() {
        return fields.size();
    }

    FieldFormat field(int index) {
        return fields.get(index);
    }

    @Override
    public void writeMembers(Object value, JsonValue.Members members) {
        for (FieldFormat field : fields) {
            Object part = field.get(value);
            if (field.beside()) {
                ((MembersFormat) field.format()).writeMembers(part, members);
            } else if (part != null && (field.required() || !Objects.equals(part, field.absent()))) {
                members.with(field.name(), field.format().write(part));
            }
        }
    }

    @Override
    public List<String> names() {
        List<String> names = new ArrayList<>();
        for (FieldFormat field : fields) {
            if (field.beside()) {
                names.addAll(((MembersFormat) field.format()).names());
            } else {
                names.add(field.name());
            }
        }
        return names;
    }

    @Override
    public JsonValue.Members schema(SchemaDefinitions definitions) {
        return definitions.reference(type, () -> SchemaDefinitions.closed(schemaBeside(definitions)));
    }

    @Override
    public JsonValue.Members schemaBeside(SchemaDefinitions definitions) {
        return schemaOf(new JsonValue.Members(), new ArrayList<>(), definitions);
    }

    /** Returns the schema of the variant that {@code kind} chooses. */
    JsonValue.Members schemaOfVariant(String kind, SchemaDefinitions definitions) {
        var chosen =
                new JsonValue.Members().with("kind", new JsonValue.Members().with("const", new JsonValue.Text(kind)));
        return schemaOf(chosen, new ArrayList<>(List.of("kind")), definitions);
    }

    private JsonValue.Members schemaOf(
            JsonValue.Members properties, List<String> required, SchemaDefinitions definitions) {
        List<JsonValue> beside = new ArrayList<>();
        for (FieldFormat field : fields) {
            if (field.beside()) {
                beside.add(((MembersFormat) field.format()).schemaBeside(definitions));
                continue;
            }
            properties.with(field.name(), field.schema(definitions));
            if (field.required()) {
                required.add(field.name());
            }
        }
        var schema = new JsonValue.Members()
                .with("type", new JsonValue.Text("object"))
                .with("properties", properties)
                .with("required", SchemaDefinitions.texts(required));
        return beside.isEmpty() ? schema : schema.with("allOf", new JsonValue.Array(beside));
    }

    /** A record written as an array of its members, such as {@code [low, high]}. */
    record TupleFormat(RecordFormat members) implements ValueFormat {
        @Override
        public Object read(JsonValue json, Problems problems) {
            int count = members.fieldCount();
            if (!(json instanceof JsonValue.Array array)) {
                return ValueFormat.mismatch("an array: " + names(), json, problems);
            }
            if (array.values().size() != count) {
                return problems.error("this must hold " + count + " numbers, " + names() + ", not "
                        + array.values().size());
            }
            Object[] values = new Object[count];
            int before = problems.count();
            for (int i = 0; i < count; i++) {
                int mark = problems.enter(i);
                values[i] = members.field(i).format().read(array.values().get(i), problems);
                problems.leave(mark);
            }
            return problems.count() > before ? null : members.make(values);
        }

        private String names() {
            return "[" + String.join(", ", members.names()) + "]";
        }

        @Override
        public JsonValue write(Object value) {
            List<JsonValue> values = new ArrayList<>();
            for (int i = 0; i < members.fieldCount(); i++) {
                FieldFormat field = members.field(i);
                values.add(field.format().write(field.get(value)));
            }
            return new JsonValue.Array(values);
        }

        @Override
        public JsonValue.Members schema(SchemaDefinitions definitions) {
            List<JsonValue> items = new ArrayList<>();
            for (int i = 0; i < members.fieldCount(); i++) {
                items.add(members.field(i).format().schema(definitions));
            }
            return new JsonValue.Members()
                    .with("type", new JsonValue.Text("array"))
                    .with("prefixItems", new JsonValue.Array(items))
                    .with("items", JsonValue.Literal.FALSE)
                    .with("minItems", new JsonValue.Number(items.size()));
        }
    }

    /** The format of a sealed interface's records; {@code kind} is the record's name in lower case. */
    record VariantFormat(List<Class<?>> types, List<String> kinds, List<RecordFormat> formats)
            implements MembersFormat {
        private static final String KIND = "kind";

        static String kind(Class<?> type) {
            return type.getSimpleName().toLowerCase(Locale.ROOT);
        }

        @Override
        public Object readMembers(JsonValue.Members members, Problems problems) {
            JsonValue kind = members.ask(KIND);
            int index = kind instanceof JsonValue.Text text ? kinds.indexOf(text.value()) : -1;
            if (index >= 0) {
                return formats.get(index).readMembers(members, problems);
            }
            // The kind decides which keys are known; without a kind, no key is reported as unknown.
            names().forEach(members::ask);
            int mark = problems.enter(KIND);
            String found = kind instanceof JsonValue.Text text ? "'" + JsonTree.shortened(text.value()) + "'" : "this";
            problems.error(
                    kind == null ? "is missing: one of " + kinds : found + " is no kind that is known here: " + kinds);
            problems.leave(mark);
            return null;
        }

        @Override
        public void writeMembers(Object value, JsonValue.Members members) {
            int index = types.indexOf(value.getClass());
            int before = members.size();
            formats.get(index).writeMembers(value, members);
            boolean named = members.size() > before && members.name(before).equals("id");
            members.insert(named ? before + 1 : before, KIND, new JsonValue.Text(kinds.get(index)));
        }

        @Override
        public List<String> names() {
            Set<String> names = new LinkedHashSet<>(List.of(KIND));
            formats.forEach(format -> names.addAll(format.names()));
            return List.copyOf(names);
        }

        @Override
        public JsonValue.Members schema(SchemaDefinitions definitions) {
            List<JsonValue> variants = new ArrayList<>();
            for (int i = 0; i < types.size(); i++) {
                RecordFormat format = formats.get(i);
                String kind = kinds.get(i);
                variants.add(definitions.reference(
                        types.get(i), () -> SchemaDefinitions.closed(format.schemaOfVariant(kind, definitions))));
            }
            return new JsonValue.Members().with("oneOf", new JsonValue.Array(variants));
        }

        @Override
        public JsonValue.Members schemaBeside(SchemaDefinitions definitions) {
            List<JsonValue> variants = new ArrayList<>();
            for (int i = 0; i < types.size(); i++) {
                variants.add(formats.get(i).schemaOfVariant(kinds.get(i), definitions));
            }
            return new JsonValue.Members().with("oneOf", new JsonValue.Array(variants));
        }
    }

    /** The format of one key: a record component with its {@link nephele.engine.level.Written} annotation. */
    record FieldFormat(
            String name, Method accessor, ValueFormat format, boolean required, boolean beside, Object absent) {
        Object read(JsonValue.Members members, Problems problems) {
            if (beside) {
                return ((MembersFormat) format).readMembers(members, problems);
            }
            JsonValue json = members.ask(name);
            if (json == null && !required) {
                return absent;
            }
            int mark = problems.enter(name);
            Object value = json == null ? problems.error("is missing") : format.read(json, problems);
            problems.leave(mark);
            return value;
        }

        Object get(Object owner) {
            try {
                return accessor.invoke(owner);
            } catch (ReflectiveOperationException impossible) {
                throw new IllegalStateException("cannot read " + name, impossible);
            }
        }

        JsonValue.Members schema(SchemaDefinitions definitions) {
            JsonValue.Members schema = format.schema(definitions);
            return absent == null || required ? schema : schema.with("default", format.write(absent));
        }
    }
}
