package nephele.engine.level.json;

import java.util.List;

/** A value that is an object in the file, alone or with its members among another's. */
interface MembersFormat extends ValueFormat {
    /** Reads what it knows out of {@code members} and leaves the rest unasked. */
    Object readMembers(JsonValue.Members members, Problems problems);

    void writeMembers(Object value, JsonValue.Members members);

    /** Schema of these members among others: it leaves the object open. */
    JsonValue.Members schemaBeside(SchemaDefinitions definitions);

    /** Every key that may occur. */
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
