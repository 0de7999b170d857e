package nephele.engine.level.json;

import java.lang.reflect.Constructor;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;

/** The format of an object whose keys are a record's components. */
final class RecordFormat implements MembersFormat {
    private final Class<?> type;
    private final Constructor<?> constructor;
    private final List<FieldFormat> fields;

    RecordFormat(Class<?> type, Constructor<?> constructor, List<FieldFormat> fields) {
        this.type = type;
        this.constructor = constructor;
        this.fields = List.copyOf(fields);
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
}
