package nephele.engine.level.json;

import java.util.List;

/** The format of an object in the file, alone or with its members among those of another. */
interface MembersFormat extends ValueFormat {
    /** Reads its own members and leaves the others unread. */
    Object readMembers(JsonValue.Members members, Problems problems);

    void writeMembers(Object value, JsonValue.Members members);

    /** Returns the schema of these members among others: it leaves the object open. */
    JsonValue.Members schemaBeside(SchemaDefinitions definitions);

    /** Returns every key that may occur. */
    List<String> names();

    @Override
    default Object read(JsonValue json, Problems problems) {
        if (!(json instanceof JsonValue.Members members)) {
            return ValueFormat.mismatch("an object", json, problems);
        }
        int before = problems.count();
        Object value = readMembers(members, problems);
        for (String unknown : members.unknown()) {
            int mark = problems.enter(unknown);
            problems.error("unknown key; known here: " + String.join(", ", names()));
            problems.leave(mark);
        }
        return problems.count() > before ? null : value;
    }

    @Override
    default JsonValue write(Object value) {
        var members = new JsonValue.Members();
        writeMembers(value, members);
        return members;
    }
}
