package nephele.engine.level.json;

import java.lang.reflect.Method;

/** The format of one key: a record component with its {@link nephele.engine.level.Written} annotation. */
record FieldFormat(String name, Method accessor, ValueFormat format, boolean required, boolean beside, Object absent) {
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
