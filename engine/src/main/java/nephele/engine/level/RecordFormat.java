package nephele.engine.level;

import java.lang.reflect.Constructor;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;

/** An object whose keys are a record's components. */
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
        if (problems.count() > before) {
            return null;
        }
        try {
            return constructor.newInstance(values);
        } catch (ReflectiveOperationException impossible) {
            throw new IllegalStateException("cannot make a " + type.getSimpleName(), impossible);
        }
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
        return definitions.reference(type, () -> schemaWith(List.of(), definitions));
    }

    /** @param kinds the value of {@code kind} that chooses this record among others, or none */
    JsonValue.Members schemaWith(List<String> kinds, SchemaDefinitions definitions) {
        var properties = new JsonValue.Members();
        List<String> required = new ArrayList<>();
        if (!kinds.isEmpty()) {
            properties.with("kind", new JsonValue.Members().with("const", new JsonValue.Text(kinds.get(0))));
            required.add("kind");
        }
        MembersFormat beside = null;
        for (FieldFormat field : fields) {
            if (field.beside()) {
                beside = (MembersFormat) field.format();
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
                .with("required", SchemaDefinitions.texts(required))
                .with("unevaluatedProperties", JsonValue.Literal.FALSE);
        return beside == null ? schema : schema.with("allOf", new JsonValue.Array(List.of(beside.schema(definitions))));
    }
}
